// Gives the curves back to boundaries that were computed on chords. Internal to geometry.
//
// Every ring that went into a boolean is kept with the curve parameter of each vertex. A vertex of
// the result is either one of those (found by its grid point) or lies on a chord where two
// boundaries cross. Each edge of the result lies on one source edge; a run of edges along one curve
// is that curve between two parameters, cut out by de Casteljau's construction.
#pragma once

#include "core/geometry/clip_grid.h"
#include "core/geometry/contour.h"

#include <vector>

namespace fff {

/// What the edge from one vertex of a source ring to the next stands for.
struct EdgeSpan
{
    int segment = 0;
    double from = 0.0, to = 1.0; // parameters, from < to
};

/// The segment, and where on it, of the chord from one vertex of the contour's to the next.
/// Segments of no length have no vertex of their own, so the origins of neighbours may be several
/// apart.
EdgeSpan spanBetween(const Contour &contour, const CurvePoint &from, const CurvePoint &to);

/// One closed curve that goes into a boolean.
struct SourceRing
{
    Contour contour;
    bool isCut = false; // a polygon whose collinear edges may be joined
    std::vector<Vec2> points;
    GridRing snapped;            // of the points; neighbours differ
    std::vector<EdgeSpan> spans; // of the edge that starts at each point
};

/// Chords of the contour within `chord` mm, on the grid. Empty rings when nothing is left there.
SourceRing makeSourceRing(const Contour &contour, double chord, const ClipGrid &grid, bool isCut);
/// The same of chords that are at hand.
SourceRing makeSourceRing(const Contour &contour, const Polyline &chords, const ClipGrid &grid,
                          bool isCut);

/// A ring of a boolean's result with its curves.
struct RecoveredRing
{
    Contour contour;
    Polygon chords; // as the boolean gave it, without splinters of the grid's size, mm
};

/// In the order of `rings`, each keeping its winding. Where an edge cannot be traced to a source it
/// is a straight line. A ring that the grid's rounding made of nothing has neither contour nor
/// chords; one whose curves fall together has its chords as contour, which are as near to them as
/// they were asked for. Errors  as Contour::fromSegments().
Result<std::vector<RecoveredRing>> recoverCurves(const std::vector<SourceRing> &sources,
                                                 const ClipGrid &grid,
                                                 const std::vector<GridRing> &rings);

} // namespace fff
