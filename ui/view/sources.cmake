target_sources(fff_view PRIVATE
    view/gl.cpp
    view/ground_shadow.cpp
    view/offscreen_image.cpp
    view/overlay_painter.cpp
    view/renderer.cpp
    view/scene.cpp
    view/slab_buffers.cpp
    view/slab_mesh.cpp
    view/stock_look.cpp
)
include(${CMAKE_SOURCE_DIR}/resources/shaders/shaders.cmake)
