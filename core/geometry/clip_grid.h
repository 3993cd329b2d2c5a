// The integer grid that booleans are computed on, and Clipper behind it. Internal to geometry: the
// public functions are in boolean.h and offset.h.
#pragma once

#include "core/base/result.h"
#include "core/base/tolerances.h"
#include "core/geometry/polygon.h"

#include <compare>
#include <cstdint>
#include <vector>

namespace fff {

/// In steps of kClipGrid from the grid's origin.
struct GridPoint
{
    std::int64_t x = 0, y = 0;

    auto operator<=>(const GridPoint &) const = default;
};

using GridRing = std::vector<GridPoint>;

/// Spreads neighbouring points over all bits.
inline std::size_t hashOf(const GridPoint &p)
{
    std::uint64_t h = static_cast<std::uint64_t>(p.x) * 0x9e3779b97f4a7c15ull;
    h = (h ^ (h >> 32) ^ static_cast<std::uint64_t>(p.y)) * 0xd6e8feb86659fd93ull;
    return static_cast<std::size_t>(h ^ (h >> 32));
}

struct GridRegion
{
    GridRing outer;              // counter-clockwise
    std::vector<GridRing> holes; // clockwise
};

/// Snaps mm to the grid. Its origin is a multiple of kClipGrid near the middle of what it is for:
/// numbers stay small (Clipper is faster then) and a point snaps alike wherever the middle is.
class ClipGrid
{
public:
    explicit ClipGrid(const Box2 &box);

    GridPoint snap(const Vec2 &point) const
    {
        return {rounded(point.x() / kClipGrid) - m_x, rounded(point.y() / kClipGrid) - m_y};
    }
    Vec2 position(const GridPoint &point) const
    {
        return {static_cast<double>(point.x + m_x) * kClipGrid,
                static_cast<double>(point.y + m_y) * kClipGrid};
    }
    Polygon positions(const GridRing &ring) const;

private:
    /// As std::llround for what a grid can hold, without a call: all points go through here.
    static std::int64_t rounded(double steps)
    {
        return static_cast<std::int64_t>(steps < 0.0 ? steps - 0.5 : steps + 0.5);
    }

    std::int64_t m_x = 0, m_y = 0;
};

/// In steps squared, positive for counter-clockwise. Rounded once.
double signedArea(const GridRing &ring);
/// Of the outer ring without its holes, in steps squared.
double area(const GridRegion &region);

enum class Winding { NonZero, Positive, Negative };

/// Apart where they hang together by a point only: where a corner of a ring comes so near to an
/// edge of the same ring (kClipSlack) that rounding alone is between them. What rings of booleans
/// share as a corner is apart already.
std::vector<GridRegion> apartAtPoints(std::vector<GridRegion> regions);

/// (what `subjects` wind round, by that rule) minus (what any of `clips` encloses, non-zero).
/// Rings that touch themselves at a corner come back as several. Errors  NotWorkedOut when Clipper
/// fails, as it does for coordinates beyond 2^62 steps.
Result<std::vector<GridRegion>> clip(const std::vector<GridRing> &subjects, Winding rule,
                                     const std::vector<GridRing> &clips);

} // namespace fff
