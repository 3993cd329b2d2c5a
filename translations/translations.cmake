# Embedded in fff_ui as :/i18n/flatfitfab_LANGUAGE.qm; the window offers each that is there (ui/settings/languages.h). A
# further language is its file here, which translations/update fills, its pages in resources/help, and its words in
# glossary.md. After a change of texts run translations/update.
file(GLOB translated_texts CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/flatfitfab_*.ts)
set_source_files_properties(${translated_texts}
    PROPERTIES OUTPUT_LOCATION ${CMAKE_CURRENT_BINARY_DIR}/i18n)
qt_add_lrelease(fff_ui TS_FILES ${translated_texts} QM_FILES_OUTPUT_VARIABLE translation_files)
qt_add_resources(fff_ui translations PREFIX /i18n BASE ${CMAKE_CURRENT_BINARY_DIR}/i18n
    FILES ${translation_files})
