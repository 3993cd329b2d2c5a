target_sources(fff_core PRIVATE
    skin/contour_network.cpp
    skin/coons_patch.cpp
    skin/cycle_filling.cpp
    skin/network_curves.cpp
    skin/outline_meetings.cpp
    skin/patch_judge.cpp
    skin/ring_tubes.cpp
    skin/skin.cpp
    skin/skin_curve.cpp
    skin/skin_outline.cpp
)
