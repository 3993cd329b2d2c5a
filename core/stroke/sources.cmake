target_sources(fff_core PRIVATE
    stroke/closed_fit.cpp
    stroke/leaving.cpp
    stroke/pen_path.cpp
    stroke/steady_hand.cpp
    stroke/stroke.cpp
    stroke/stroke_contour.cpp
    stroke/symmetry.cpp
    stroke/thinned_line.cpp
)
