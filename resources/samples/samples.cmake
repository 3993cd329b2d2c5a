# The models that come with the program. Embedded in fff_ui as :/samples/NAME.fff; their names for people are in
# ui/start/samples.cpp.
qt_add_resources(fff_ui samples PREFIX /samples BASE ${CMAKE_CURRENT_LIST_DIR} FILES
    ${CMAKE_CURRENT_LIST_DIR}/acrylic_thick_four.fff
    ${CMAKE_CURRENT_LIST_DIR}/acrylic_thick_three.fff
    ${CMAKE_CURRENT_LIST_DIR}/acrylic_thin_four.fff
    ${CMAKE_CURRENT_LIST_DIR}/acrylic_thin_three.fff
    ${CMAKE_CURRENT_LIST_DIR}/bear.fff
    ${CMAKE_CURRENT_LIST_DIR}/beetle.fff
    ${CMAKE_CURRENT_LIST_DIR}/bony_fish.fff
    ${CMAKE_CURRENT_LIST_DIR}/bridge.fff
    ${CMAKE_CURRENT_LIST_DIR}/chair.fff
    ${CMAKE_CURRENT_LIST_DIR}/cutlery_man.fff
    ${CMAKE_CURRENT_LIST_DIR}/dachshund.fff
    ${CMAKE_CURRENT_LIST_DIR}/dinosaur.fff
    ${CMAKE_CURRENT_LIST_DIR}/drawer_organiser.fff
    ${CMAKE_CURRENT_LIST_DIR}/fish.fff
    ${CMAKE_CURRENT_LIST_DIR}/gears.fff
    ${CMAKE_CURRENT_LIST_DIR}/glass_four_legs.fff
    ${CMAKE_CURRENT_LIST_DIR}/glass_holder.fff
    ${CMAKE_CURRENT_LIST_DIR}/glass_three_legs.fff
    ${CMAKE_CURRENT_LIST_DIR}/growing_tree.fff
    ${CMAKE_CURRENT_LIST_DIR}/hedgehog.fff
    ${CMAKE_CURRENT_LIST_DIR}/lamp.fff
    ${CMAKE_CURRENT_LIST_DIR}/name_plate.fff
    ${CMAKE_CURRENT_LIST_DIR}/organiser.fff
    ${CMAKE_CURRENT_LIST_DIR}/owl.fff
    ${CMAKE_CURRENT_LIST_DIR}/shelf.fff
    ${CMAKE_CURRENT_LIST_DIR}/tree.fff
    ${CMAKE_CURRENT_LIST_DIR}/two_poses.fff
    ${CMAKE_CURRENT_LIST_DIR}/whale.fff)
