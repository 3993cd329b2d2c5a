#include "core/fabrication/outer_chords.h"

#include "core/base/tolerances.h"

#include <optional>

namespace fff {

namespace {

/// Where the tangents at the ends of a short curve meet that lies to the right of its chord, if its
/// handles are on the way there: the curve is in the triangle, as it is in the hull of its handles.
std::optional<Vec2> tangentsMeet(const CubicBezier &curve)
{
    const Vec2 from = curve.p1 - curve.p0, to = curve.p3 - curve.p2, chord = curve.p3 - curve.p0;
    const double turn = cross(from, to);
    if (!(turn > 0.0)) // a curve to the right of its chord turns left
        return std::nullopt;
    const double first = cross(chord, to) / turn, second = cross(from, chord) / turn;
    if (!(first >= 1.0 && second >= 1.0))
        return std::nullopt;
    const Vec2 meet = curve.p0 + first * from;
    const double off = -cross(chord, meet - curve.p0) / chord.norm();
    return off <= 2.0 * kCutChord ? std::optional(meet) : std::nullopt;
}

/// All but the end of a short curve.
void append(const CubicBezier &curve, Polygon &ring)
{
    ring.push_back(curve.p0);
    const Vec2 chord = curve.p3 - curve.p0;
    const bool isFirstOut = cross(chord, curve.p1 - curve.p0) < 0.0,
               isSecondOut = cross(chord, curve.p2 - curve.p0) < 0.0;
    if (isFirstOut && isSecondOut)
        if (const std::optional<Vec2> meet = tangentsMeet(curve)) {
            ring.push_back(*meet);
            return;
        }
    if (isFirstOut)
        ring.push_back(curve.p1);
    if (isSecondOut)
        ring.push_back(curve.p2);
}

/// The part is on the left, of outer contours and of holes.
Polygon ringOf(const Contour &contour)
{
    Polygon ring;
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const CubicBezier segment = contour.segment(i);
        if (segment.isStraight(kClipGrid)) {
            ring.push_back(segment.p0);
            continue;
        }
        const int count = segment.chordCount(kCutChord);
        for (int k = 0; k < count; ++k)
            append(segment.piece(static_cast<double>(k) / count, (k + 1.0) / count), ring);
    }
    return ring;
}

} // namespace

Region outerChords(const CurvedRegion &outline)
{
    Region region{ringOf(outline.outer), {}};
    for (const Contour &hole : outline.holes)
        region.holes.push_back(ringOf(hole));
    return region;
}

} // namespace fff
