// Triangles of a plate for finite elements: what remains of a section after its slits are cut out.
#pragma once

#include "core/base/result.h"
#include "core/geometry/polygon.h"
#include "core/base/long_work.h"

#include <array>
#include <vector>

namespace fff {

struct PlateMeshOptions
{
    double fineness = 1.0;    // edges are this many times shorter than what suits the plate
    int wantedCorners = 260;  // about as many where nothing asks for more
    int mostCorners = 4000;   // refinement ends there, whatever it wanted
    double linesAcross = 2.5; // edges across the narrowest places
};

/// Quadratic triangles with straight sides. The first `corners` points are their corners, the
/// others the middles of their sides.
struct PlateMesh
{
    std::vector<Vec2> points; // mm
    int corners = 0;
    /// Counter-clockwise corners 0 1 2, then the middles of the sides 1-2, 2-0, 0-1.
    std::vector<std::array<int, 6>> triangles;
    std::vector<Vec2> sharp; // re-entrant corners, where stress of an elastic plate has no bound
    bool isComplete = true;  // false: mostCorners ended it
};

/// A constrained Delaunay mesh of the region, mm.
///
/// Edges are about min(size / 15, √(area / wantedCorners)) / fineness, shorter at re-entrant
/// corners and where the region is narrow, growing by a third of the distance from there. Angles
/// are at least 20° but for those of the region itself. What the boundary turns by less than a two
/// hundredth of an edge's length is straightened, without changing what lies inside what.
/// Errors  EmptyContour for a region without area, NonFinite, NotWorkedOut where CGAL fails,
///         Cancelled.
/// Source  J. Shewchuk 2002, Delaunay refinement algorithms for triangular mesh generation, as
///         CGAL's Mesh_2 has it.
Result<PlateMesh> plateMesh(const Region &region, const PlateMeshOptions &options = {},
                            const LongWork &work = {});

} // namespace fff
