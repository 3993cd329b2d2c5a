target_sources(fff_core PRIVATE
    geometry/bezier.cpp
    geometry/contour.cpp
    geometry/frame.cpp
    geometry/moments.cpp
    geometry/polygon.cpp
    geometry/triangulation.cpp
)
