qt_add_resources(fff_ui style PREFIX /style BASE ${CMAKE_CURRENT_LIST_DIR} FILES
    ${CMAKE_CURRENT_LIST_DIR}/window.qss ${CMAKE_CURRENT_LIST_DIR}/contrast.qss)
