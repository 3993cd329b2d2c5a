// What of a shape's boundary a line comes near to.
#pragma once

#include "core/assembly/intervals.h"
#include "core/model/shape.h"

#include <vector>

namespace fff {

/// The rings of a shape as a strip about a line sees them: what lies beside it in runs is thinned
/// out (ThinnedRing), so that a question about the strip costs the work of what is in it, and has
/// the same answer. Boundaries of a few vertices stay as they are.
class RingsNear
{
public:
    /// halfWidth   of the strip, mm
    RingsNear(const PlaneLine &line, const Shape &shape, double halfWidth);
    /// boundaries   of the region, asked for where it has many vertices
    template <class Boundaries>
    RingsNear(const PlaneLine &line, const Region &region, Boundaries boundaries, double halfWidth)
        : m_region(&region)
    {
        if (!isShort(region))
            thinOut(line, boundaries(), halfWidth);
    }
    RingsNear(const RingsNear &) = delete;
    RingsNear &operator=(const RingsNear &) = delete;

    /// Without holes that lie beside the strip.
    const Region &region() const { return *m_region; }
    /// The same end by the numbers of the shape's own rings and edges. Edges that come into the
    /// strip are the shape's.
    AxisEnd inShape(const AxisEnd &end) const;

    /// Of so few vertices that to look at all is as fast as to choose among them.
    static bool isShort(const Region &region);

private:
    void thinOut(const PlaneLine &line, const RegionTree &boundaries, double halfWidth);

    struct Ring
    {
        int index = 0; // of the shape's
        std::vector<int> vertices;
    };

    Region m_thinned;
    const Region *m_region; // that one, or the shape's
    std::vector<Ring> m_rings;
};

} // namespace fff
