# The models of three lessons (resources/help/lessons.md): what a class starts with, and what may come of it. Embedded in
# fff_ui as :/lessons/NAME.fff; packaging/install.cmake installs them as files, which a teacher copies.
qt_add_resources(fff_ui lessons PREFIX /lessons BASE ${CMAKE_CURRENT_LIST_DIR} FILES
    ${CMAKE_CURRENT_LIST_DIR}/1_toy_animal_finished.fff
    ${CMAKE_CURRENT_LIST_DIR}/1_toy_animal_start.fff
    ${CMAKE_CURRENT_LIST_DIR}/2_shelf_finished.fff
    ${CMAKE_CURRENT_LIST_DIR}/2_shelf_start.fff
    ${CMAKE_CURRENT_LIST_DIR}/3_lamp_finished.fff
    ${CMAKE_CURRENT_LIST_DIR}/3_lamp_start.fff)
