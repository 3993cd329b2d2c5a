# The wall between core and Qt is held by the compiler; this shows that it stands.
add_library(wall_qt OBJECT EXCLUDE_FROM_ALL core/base/wall_qt.cpp)
target_link_libraries(wall_qt PRIVATE fff::core)
add_test(NAME core/base/no_qt_in_core
    COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR} --target wall_qt)
set_tests_properties(core/base/no_qt_in_core PROPERTIES
    PASS_REGULAR_EXPRESSION "QtCore/QObject.*(No such file|not found)")

# No room uses one below it.
find_program(FFF_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(FFF_PYTHON python3 REQUIRED)
add_test(NAME walls COMMAND ${FFF_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/walls.py ${PROJECT_SOURCE_DIR})
