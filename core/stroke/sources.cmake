target_sources(fff_core PRIVATE
    stroke/leaving.cpp
    stroke/pen_path.cpp
    stroke/stroke.cpp
    stroke/stroke_contour.cpp
    stroke/symmetry.cpp
)
