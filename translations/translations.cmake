# Embedded in fff_ui as :/i18n/flatfitfab_LANGUAGE.qm. After a change of texts run translations/update.
set_source_files_properties(
    ${CMAKE_CURRENT_LIST_DIR}/flatfitfab_de.ts ${CMAKE_CURRENT_LIST_DIR}/flatfitfab_en.ts
    PROPERTIES OUTPUT_LOCATION ${CMAKE_CURRENT_BINARY_DIR}/i18n)
qt_add_lrelease(fff_ui
    TS_FILES ${CMAKE_CURRENT_LIST_DIR}/flatfitfab_de.ts ${CMAKE_CURRENT_LIST_DIR}/flatfitfab_en.ts
    QM_FILES_OUTPUT_VARIABLE translation_files)
qt_add_resources(fff_ui translations PREFIX /i18n BASE ${CMAKE_CURRENT_BINARY_DIR}/i18n
    FILES ${translation_files})
