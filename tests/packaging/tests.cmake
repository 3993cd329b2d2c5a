# What is installed, and what was made of the programs' own words.
if(FFF_BUILD_WINDOW AND UNIX AND NOT APPLE)
    add_test(NAME packaging/pages COMMAND ${FFF_PYTHON} ${CMAKE_SOURCE_DIR}/packaging/linux/pages.py
        $<TARGET_FILE:flatfitfab-cli> $<TARGET_FILE:flatfitfab> --check)
    add_test(NAME packaging/installed COMMAND ${FFF_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/packaging/check_installed.py
        ${CMAKE_COMMAND} ${CMAKE_BINARY_DIR} ${CMAKE_SOURCE_DIR} ${PROJECT_VERSION})
    set_tests_properties(packaging/installed PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")
endif()
