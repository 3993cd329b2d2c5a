target_sources(fff_core PRIVATE
    geometry/bezier.cpp
    geometry/boolean.cpp
    geometry/clip_grid.cpp
    geometry/contour.cpp
    geometry/convex_hull.cpp
    geometry/curve_crossing.cpp
    geometry/curve_recovery.cpp
    geometry/fit.cpp
    geometry/frame.cpp
    geometry/moments.cpp
    geometry/offset.cpp
    geometry/polygon.cpp
    geometry/simple_ring.cpp
    geometry/source_edges.cpp
    geometry/triangulation.cpp
    geometry/turning.cpp
)
