#include "core/assembly/rings_near.h"

#include "core/base/tolerances.h"

#include <utility>

namespace fff {

namespace {

constexpr std::size_t kFewVertices = 128;

/// More than rounding says of where a vertex is beside a line, mm.
constexpr double kBesideRounding = kTouchingDepth;

} // namespace

RingsNear::RingsNear(const PlaneLine &line, const Shape &shape, double halfWidth)
    : RingsNear(
          line, shape.region(), [&]() -> const RegionTree & { return shape.boundaries(); },
          halfWidth)
{
}

bool RingsNear::isShort(const Region &region)
{
    std::size_t count = region.outer.size();
    for (const Polygon &hole : region.holes)
        count += hole.size();
    return count <= kFewVertices;
}

void RingsNear::thinOut(const PlaneLine &line, const RegionTree &boundaries, double halfWidth)
{
    const std::vector<PolygonTree> &rings = boundaries.rings();
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const double reach = halfWidth + kBesideRounding;
        if (i > 0 && rings[i].isBeside(line.point, line.direction, reach))
            continue;
        ThinnedRing ring = rings[i].thinned(line.point, line.direction, reach);
        m_rings.push_back({static_cast<int>(i), std::move(ring.indices)});
        if (i == 0)
            m_thinned.outer = std::move(ring.points);
        else
            m_thinned.holes.push_back(std::move(ring.points));
    }
    m_region = &m_thinned;
}

AxisEnd RingsNear::inShape(const AxisEnd &end) const
{
    if (m_rings.empty())
        return end;
    const Ring &ring = m_rings[static_cast<std::size_t>(end.ring)];
    return {end.at, ring.index, ring.vertices[static_cast<std::size_t>(end.edge)]};
}

} // namespace fff
