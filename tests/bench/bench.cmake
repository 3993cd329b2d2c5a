# flatfitfab-bench: not a test, so that nothing hangs on a clock; README.md here says how to run it.
add_executable(flatfitfab-bench
    ${CMAKE_CURRENT_LIST_DIR}/adjust_cost.cpp
    ${CMAKE_CURRENT_LIST_DIR}/bench_main.cpp
    ${CMAKE_CURRENT_LIST_DIR}/counted_memory.cpp
    ${CMAKE_CURRENT_LIST_DIR}/drawing_growth.cpp
    ${CMAKE_CURRENT_LIST_DIR}/edited_section.cpp
    ${CMAKE_CURRENT_LIST_DIR}/fabrication_cost.cpp
    ${CMAKE_CURRENT_LIST_DIR}/generated_models.cpp
    ${CMAKE_CURRENT_LIST_DIR}/kernel.cpp
    ${CMAKE_CURRENT_LIST_DIR}/measure.cpp
    ${CMAKE_CURRENT_LIST_DIR}/mesh_cost.cpp
    ${CMAKE_CURRENT_LIST_DIR}/nesting_cost.cpp
    ${CMAKE_CURRENT_LIST_DIR}/peer.cpp
    ${CMAKE_CURRENT_LIST_DIR}/gizmo_event.cpp
    ${CMAKE_CURRENT_LIST_DIR}/point_event.cpp
    ${CMAKE_CURRENT_LIST_DIR}/report.cpp
    ${CMAKE_CURRENT_LIST_DIR}/strength_cost.cpp
    ${CMAKE_CURRENT_LIST_DIR}/stroke_event.cpp
    ${CMAKE_CURRENT_LIST_DIR}/text_table.cpp
    ${CMAKE_CURRENT_LIST_DIR}/value_cost.cpp)
target_link_libraries(flatfitfab-bench PRIVATE fff::session)
target_precompile_headers(flatfitfab-bench REUSE_FROM fff_session)
if(TARGET fff::view) # its arrays need no display
    target_link_libraries(flatfitfab-bench PRIVATE fff::view)
    target_compile_definitions(flatfitfab-bench PRIVATE FFF_BENCH_VIEW)
endif()

# What a frame costs beside a large mesh; on whatever OpenGL there is.
if(TARGET fff::view)
    add_executable(frame_bench EXCLUDE_FROM_ALL ${CMAKE_CURRENT_LIST_DIR}/frame_bench.cpp)
    target_link_libraries(frame_bench PRIVATE fff::view fff::session Qt6::OpenGL)
    target_precompile_headers(frame_bench REUSE_FROM fff_session)
endif()
