# The licences of FlatFitFab and of what it is built with. Embedded in fff_ui as :/licences/NAME.txt.
set(licence_folder ${CMAKE_CURRENT_LIST_DIR})
set_source_files_properties(${CMAKE_SOURCE_DIR}/LICENSE PROPERTIES QT_RESOURCE_ALIAS gpl-3.0.txt)
qt_add_resources(fff_ui licences PREFIX /licences BASE ${licence_folder} FILES
    ${CMAKE_SOURCE_DIR}/LICENSE
    ${licence_folder}/bsd-3-clause.txt
    ${licence_folder}/bsl-1.0.txt
    ${licence_folder}/cc0-1.0.txt
    ${licence_folder}/lgpl-3.0.txt
    ${licence_folder}/mit.txt
    ${licence_folder}/mpl-2.0.txt
    ${licence_folder}/zlib.txt)
