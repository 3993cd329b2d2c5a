# The sheet materials that stocks are made of. Embedded in fff_io as :/materials/materials.json.
qt_add_resources(fff_io materials PREFIX /materials BASE ${CMAKE_CURRENT_LIST_DIR} FILES
    ${CMAKE_CURRENT_LIST_DIR}/materials.json)
