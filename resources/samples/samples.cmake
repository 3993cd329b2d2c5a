# The models that come with the program. Embedded in fff_ui as :/samples/NAME.fff; their names for people are in
# ui/start/samples.cpp.
qt_add_resources(fff_ui samples PREFIX /samples BASE ${CMAKE_CURRENT_LIST_DIR} FILES
    ${CMAKE_CURRENT_LIST_DIR}/chair.fff
    ${CMAKE_CURRENT_LIST_DIR}/dachshund.fff
    ${CMAKE_CURRENT_LIST_DIR}/fish.fff
    ${CMAKE_CURRENT_LIST_DIR}/glass_holder.fff
    ${CMAKE_CURRENT_LIST_DIR}/lamp.fff
    ${CMAKE_CURRENT_LIST_DIR}/organiser.fff
    ${CMAKE_CURRENT_LIST_DIR}/tree.fff)
