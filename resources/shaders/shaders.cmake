# Embedded in fff_view as :/shaders/NAME.
qt_add_resources(fff_view shaders PREFIX /shaders BASE ${CMAKE_CURRENT_LIST_DIR} FILES
    ${CMAKE_CURRENT_LIST_DIR}/background.frag
    ${CMAKE_CURRENT_LIST_DIR}/blur.frag
    ${CMAKE_CURRENT_LIST_DIR}/cap.frag
    ${CMAKE_CURRENT_LIST_DIR}/cap.vert
    ${CMAKE_CURRENT_LIST_DIR}/copy.frag
    ${CMAKE_CURRENT_LIST_DIR}/edge.frag
    ${CMAKE_CURRENT_LIST_DIR}/edge.vert
    ${CMAKE_CURRENT_LIST_DIR}/field.frag
    ${CMAKE_CURRENT_LIST_DIR}/field.vert
    ${CMAKE_CURRENT_LIST_DIR}/ground.frag
    ${CMAKE_CURRENT_LIST_DIR}/ground.vert
    ${CMAKE_CURRENT_LIST_DIR}/marks.frag
    ${CMAKE_CURRENT_LIST_DIR}/marks.vert
    ${CMAKE_CURRENT_LIST_DIR}/occlusion.frag
    ${CMAKE_CURRENT_LIST_DIR}/occlusion_apply.frag
    ${CMAKE_CURRENT_LIST_DIR}/occlusion_blur.frag
    ${CMAKE_CURRENT_LIST_DIR}/picture.frag
    ${CMAKE_CURRENT_LIST_DIR}/picture.vert
    ${CMAKE_CURRENT_LIST_DIR}/screen.vert
    ${CMAKE_CURRENT_LIST_DIR}/shadow.frag
    ${CMAKE_CURRENT_LIST_DIR}/slab.frag
    ${CMAKE_CURRENT_LIST_DIR}/slab.vert
    ${CMAKE_CURRENT_LIST_DIR}/template.frag
    ${CMAKE_CURRENT_LIST_DIR}/template.vert
    ${CMAKE_CURRENT_LIST_DIR}/thing.frag
    ${CMAKE_CURRENT_LIST_DIR}/thing.vert)
