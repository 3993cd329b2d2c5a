qt_add_resources(fff_view loads PREFIX /loads BASE ${CMAKE_CURRENT_LIST_DIR} FILES
    ${CMAKE_CURRENT_LIST_DIR}/presets.json)
