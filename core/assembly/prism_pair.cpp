#include "core/assembly/prism_pair.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fff {

namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
/// Squared sine below which two edges are parallel: their common normal is rounding.
constexpr double kParallel = 1e-18;

/// Prisms of a pair of solids that are looked at.
constexpr std::size_t kMostlyFewer = 16;

/// The unit vector square to both; none when they are parallel.
std::optional<Vec3> square(const Vec3 &u, const Vec3 &v)
{
    const Vec3 axis = u.cross(v);
    const double length = axis.squaredNorm();
    if (!(length > kParallel * u.squaredNorm() * v.squaredNorm()))
        return {};
    return Vec3(axis / std::sqrt(length));
}

} // namespace

PrismPairs::PrismPairs(const Plate &mover, const Plate &other, const Vec3 &direction)
    : m_mover(mover), m_other(other), m_direction(direction)
{
    m_common[0] = axisAlong(m_mover.normal);
    m_common[1] = axisAlong(m_other.normal);
    if (const auto axis = square(m_mover.normal, m_other.normal))
        m_common[m_commonCount++] = axisAlong(*axis);
}

int PrismPairs::see(PairedPrism &prism, const Plate &plate)
{
    if (prism.seen < 0) {
        prism.seen = static_cast<int>(m_seen.size());
        if (m_seen.empty())
            m_seen.reserve(kMostlyFewer);
        Seen &seen = m_seen.emplace_back();
        for (std::size_t i = 0; i < m_commonCount; ++i)
            seen.common[i] = plate.extent(prism.corners, m_common[i].along);
    }
    return prism.seen;
}

const PrismPairs::Seen &PrismPairs::withEdges(const PairedPrism &prism, const Plate &plate,
                                              const Plate &mate)
{
    Seen &seen = m_seen[static_cast<std::size_t>(prism.seen)];
    if (seen.edgeCount >= 0)
        return seen;
    seen.edgeCount = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 edge = prism.edge(i);
        for (const Vec3 *normal : {&plate.normal, &mate.normal})
            if (const auto axis = square(edge, *normal))
                seen.edges[static_cast<std::size_t>(seen.edgeCount++)] = {
                    axisAlong(*axis), plate.extent(prism.corners, *axis), mate.more(*axis)};
    }
    return seen;
}

template <typename Look>
bool PrismPairs::forEachAxis(PairedPrism &mover, PairedPrism &other, const Look &look)
{
    const auto ofMover = static_cast<std::size_t>(see(mover, m_mover));
    const auto ofOther = static_cast<std::size_t>(see(other, m_other));
    for (std::size_t i = 0; i < m_commonCount; ++i)
        if (!look(m_seen[ofMover].common[i], m_seen[ofOther].common[i], m_common[i].speed))
            return false;
    const Seen &moverSeen = withEdges(mover, m_mover, m_other);
    for (int i = 0; i < moverSeen.edgeCount; ++i) {
        const Seen::Edge &edge = moverSeen.edges[static_cast<std::size_t>(i)];
        const Extent extent = wider(extentOf(other.corners, edge.axis.along), edge.moreOfMate);
        if (!look(edge.extent, extent, edge.axis.speed))
            return false;
    }
    const Seen &otherSeen = withEdges(other, m_other, m_mover);
    for (int i = 0; i < otherSeen.edgeCount; ++i) {
        const Seen::Edge &edge = otherSeen.edges[static_cast<std::size_t>(i)];
        const Extent extent = wider(extentOf(mover.corners, edge.axis.along), edge.moreOfMate);
        if (!look(extent, edge.extent, edge.axis.speed))
            return false;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 edge = mover.edge(i);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = square(edge, other.edge(k));
            if (axis && !look(m_mover.extent(mover.corners, *axis),
                              m_other.extent(other.corners, *axis), axis->dot(m_direction)))
                return false;
        }
    }
    return true;
}

bool PrismPairs::keepMeeting(PairedPrism &mover, PairedPrism &other, double depth, Travel &way)
{
    return forEachAxis(mover, other, [&](const Extent &a, const Extent &b, double speed) {
        return keepShared(a, b, speed, depth, way);
    });
}

double PrismPairs::depthOf(PairedPrism &mover, PairedPrism &other)
{
    double least = kEndless;
    forEachAxis(mover, other, [&](const Extent &a, const Extent &b, double) {
        least = std::min({least, a.max - b.min, b.max - a.min});
        return true;
    });
    return least;
}

} // namespace fff
