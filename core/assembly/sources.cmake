target_sources(fff_core PRIVATE
    assembly/assembly.cpp
    assembly/blocking.cpp
    assembly/crossing.cpp
    assembly/found_joint.cpp
    assembly/intervals.cpp
    assembly/joint.cpp
    assembly/joint_state.cpp
    assembly/joint_wish.cpp
    assembly/planning.cpp
    assembly/playback.cpp
    assembly/slab.cpp
    assembly/slit_form.cpp
    assembly/slits.cpp
    assembly/solid.cpp
    assembly/stability.cpp
    assembly/webs.cpp
)
