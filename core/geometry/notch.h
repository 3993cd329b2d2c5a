// Slits cut into the side of a boundary, without a boolean of everything: what nearly every section
// of nearly every model needs.
#pragma once

#include "core/geometry/boolean.h"

#include <memory>
#include <optional>

namespace fff {

/// What `subtract` gives where each cut takes a bite out of the contour's side: the contour enters
/// it once and leaves it once, through two different sides. Each bite replaces a stretch of the
/// boundary and all else stays as it is, so the cost is that of the cuts and of copying the curves.
///
/// contour, holes   counter-clockwise and clockwise; none touches itself or another (isApart)
/// cuts             convex polygons, counter-clockwise
/// Nothing where it is not that plain: cuts that meet each other or a hole, that lie inside or
/// outside, or whose sides meet the contour within rounding of a corner. Then `subtract` tells.
/// Topology is decided exactly on the same grid as there; ends of curves are where they cross the
/// cuts' lines, as there. The chords of the result are those given, not moved to the grid.
std::optional<CurvedRegion> cutNotches(const Contour &contour, const std::vector<Contour> &holes,
                                       const std::vector<Polygon> &cuts, double chord);

/// Where one cut goes through a contour's side. Follows from contour, chords and cut alone.
struct Notch;
using NotchPointer = std::shared_ptr<const Notch>;

/// For those who cut one contour again and again: notches that are known need no finding.
class NotchFinder
{
public:
    /// Both outlive it.
    NotchFinder(const Contour &contour, const Polyline &chords);
    ~NotchFinder();

    /// Null where it is not that plain.
    NotchPointer find(Polygon cut) const;
    /// A cut of any shape, counter-clockwise, that does not cross itself, on chords of `chord` mm;
    /// its curves are kept. The contour has to go through straight segments of it.
    NotchPointer find(const Contour &cut, double chord) const;

private:
    struct Data;
    std::unique_ptr<Data> m_data;
};

/// The same of notches that were found in this contour with these chords.
std::optional<CurvedRegion> cutNotches(const Contour &contour, const Polyline &chords,
                                       const std::vector<Contour> &holes,
                                       const std::vector<NotchPointer> &notches, double chord);

} // namespace fff
