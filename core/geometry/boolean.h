// Booleans of curved contours. Clipper works on chords snapped to a 1 nm grid (kClipGrid); every
// vertex is looked up afterwards (snapped point -> segment and parameter) and runs of vertices of
// one segment are rebuilt by de Casteljau splitting, so what was a curve before is the same curve
// after.
#pragma once

#include "core/geometry/contour.h"

#include <vector>

namespace fff {

/// One connected piece with true curves and as the chords it was computed on.
struct CurvedRegion
{
    Contour outer;              // counter-clockwise
    std::vector<Contour> holes; // clockwise
    Region region;              // the same boundary as chords within the tolerance asked for
};

/// (outer non-zero) minus (each hole) minus (each cut), as connected pieces, largest first; pieces
/// below kMinArea are left out. What hangs together by a point only is two pieces.
///
/// contour   counter-clockwise or not, must not cross itself (resolveCrossings mends that)
/// holes     any winding; may touch or overlap each other and the contour
/// cuts      closed polygons of any winding (slits); may overlap each other
/// chord     largest distance of the chords from the curves, mm
/// Where a cut crosses a curve, the vertex lies on both to 1e-9 mm or the chord tolerance allows no
/// better; the edges that cuts leave are straight. Adjacent pieces of one straight segment are one.
/// Errors  NonFinite for points that are nowhere, NotWorkedOut when Clipper fails. Empty is only
///         what nothing is left of.
Result<std::vector<CurvedRegion>> subtract(const Contour &contour,
                                           const std::vector<Contour> &holes,
                                           const std::vector<Polygon> &cuts, double chord);

/// The same with cuts of any curves, which are kept where they bound what stays.
Result<std::vector<CurvedRegion>> subtractContours(const Contour &contour,
                                                   const std::vector<Contour> &holes,
                                                   const std::vector<Contour> &cuts, double chord);

enum class WindingRule { NonZero, Positive };

/// What the contours together wind round, by that rule (counter-clockwise counts up), as connected
/// pieces, largest first, without dust. Contours may cross themselves and each other; curves are
/// kept as `subtract` keeps them. Errors  as there.
Result<std::vector<CurvedRegion>> windingRegions(const std::vector<Contour> &contours,
                                                 WindingRule rule, double chord);

struct ResolvedContour
{
    Contour contour;
    bool wasCrossing = false; // the contour crossed itself: something was left out or cut apart
    Polyline chords;          // of kCutChord, where they are at hand
    bool isPlain = false;     // known to be (see below), on those chords
};

/// The largest region that the contour winds round (non-zero), its outer boundary. A contour that
/// does not cross itself comes back as it is, bit for bit. Errors  EmptyContour when no region of
/// at least kMinArea is there; as windingRegions().
Result<ResolvedContour> resolveCrossings(const Contour &contour);

/// How two contours lie to each other, as chords within `chord` mm on the grid. Meeting: they
/// cross, or touch, or it takes a boolean to tell.
enum class Nesting { Apart, FirstInside, SecondInside, Meeting };

/// Exact for the chords. Neither may cross itself. Far cheaper than `subtract`.
Nesting nesting(const Contour &first, const Contour &second, double chord);

/// Whether the contours, on their chords, neither touch themselves nor each other. Exact.
bool isPlain(const Contour &contour, const std::vector<Contour> &others, double chord);

} // namespace fff
