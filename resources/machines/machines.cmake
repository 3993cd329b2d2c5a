# The machines that files are made for. Embedded in fff_io as :/machines/machines.json.
qt_add_resources(fff_io machines PREFIX /machines BASE ${CMAKE_CURRENT_LIST_DIR} FILES
    ${CMAKE_CURRENT_LIST_DIR}/machines.json)
