#include "core/geometry/source_edges.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace fff {

namespace {

constexpr double kSlackSteps = kClipSlack / kClipGrid;

struct NearbyEdge
{
    int ring = 0, edge = 0;
    double along = 0.0;    // of the point's foot, steps from the edge's start
    double distance = 0.0; // steps
};

/// A point whose edges are looked for.
struct Query
{
    GridPoint point;
    std::vector<NearbyEdge> edges;
};

/// Where the point lies about the edge, if within the slack.
std::optional<NearbyEdge> onEdge(const GridPoint &p, const GridPoint &a, const GridPoint &b)
{
    // Differences first: they are small and exact, the coordinates are not small.
    const Vec2 edge(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
    const Vec2 to(static_cast<double>(p.x - a.x), static_cast<double>(p.y - a.y));
    const double length = edge.norm();
    const double along = edge.dot(to) / length;
    if (along < -kSlackSteps || along > length + kSlackSteps)
        return std::nullopt;
    const double distance = std::abs(cross(edge, to)) / length;
    if (distance > kSlackSteps)
        return std::nullopt;
    return NearbyEdge{0, 0, along, distance};
}

/// Adds to each query (sorted by point) the source edges through it.
void collectEdges(const std::vector<SourceRing> &sources, std::vector<Query> &queries)
{
    const auto slack = static_cast<std::int64_t>(kSlackSteps);
    for (std::size_t r = 0; r < sources.size(); ++r) {
        const GridRing &ring = sources[r].snapped;
        for (std::size_t e = 0; e < ring.size(); ++e) {
            const GridPoint &a = ring[e];
            const GridPoint &b = ring[(e + 1) % ring.size()];
            const std::int64_t last = std::max(a.x, b.x) + slack;
            const auto [low, high] = std::minmax(a.y, b.y);
            auto it =
                std::lower_bound(queries.begin(), queries.end(), std::min(a.x, b.x) - slack,
                                 [](const Query &q, std::int64_t x) { return q.point.x < x; });
            for (; it != queries.end() && it->point.x <= last; ++it) {
                if (it->point.y < low - slack || it->point.y > high + slack)
                    continue;
                if (auto found = onEdge(it->point, a, b)) {
                    found->ring = static_cast<int>(r);
                    found->edge = static_cast<int>(e);
                    it->edges.push_back(*found);
                }
            }
        }
    }
}

/// The edge that both points lie on: a curve rather than a cut, then the nearest, then the first.
SourceEdge commonEdge(const std::vector<SourceRing> &sources, const Query &from, const Query &to)
{
    SourceEdge best;
    bool bestIsCut = true;
    double bestDistance = 0.0;
    for (const NearbyEdge &a : from.edges) {
        for (const NearbyEdge &b : to.edges) {
            if (a.ring != b.ring || a.edge != b.edge || a.along == b.along)
                continue;
            const bool isCut = sources[static_cast<std::size_t>(a.ring)].isCut;
            const double distance = a.distance + b.distance;
            if (best.isKnown() && (isCut != bestIsCut ? isCut : distance >= bestDistance))
                continue;
            best = {a.ring, a.edge, b.along > a.along ? 1 : -1};
            bestIsCut = isCut;
            bestDistance = distance;
        }
    }
    return best;
}

} // namespace

SourceIndex::SourceIndex(const std::vector<SourceRing> &sources) : m_sources(sources)
{
    std::size_t count = 0;
    for (const SourceRing &source : sources)
        count += source.snapped.size();
    m_corners.reserve(count);
    for (std::size_t r = 0; r < sources.size(); ++r) {
        for (std::size_t i = 0; i < sources[r].snapped.size(); ++i)
            m_corners.push_back({sources[r].snapped[i], static_cast<int>(r), static_cast<int>(i)});
    }
    m_hasDouble.reserve(sources.size());
    for (const SourceRing &source : sources)
        m_hasDouble.emplace_back(source.snapped.size(), char(false));
    const auto mark = [this](const Corner &c) {
        m_hasDouble[static_cast<std::size_t>(c.ring)][static_cast<std::size_t>(c.index)] = true;
    };
    // From the last one on, so that the first stands first in its chain.
    m_first.assign(std::bit_ceil(m_corners.size() + 1), 0);
    m_next.assign(m_corners.size(), 0);
    for (std::size_t i = m_corners.size(); i-- > 0;) {
        const Corner &corner = m_corners[i];
        const bool isDouble = anyCornerAt(corner.point, [&](const Corner &other) {
            mark(other);
            return true; // those behind it are marked
        });
        if (isDouble)
            mark(corner);
        std::uint32_t &first = m_first[hashOf(corner.point) & (m_first.size() - 1)];
        m_next[i] = first;
        first = static_cast<std::uint32_t>(i + 1);
    }
}

SourceEdge SourceIndex::edgeBetween(const GridPoint &from, const GridPoint &to) const
{
    SourceEdge edge;
    anyCornerAt(from, [&](const Corner &a) {
        const GridRing &ring = m_sources[static_cast<std::size_t>(a.ring)].snapped;
        const int count = static_cast<int>(ring.size());
        const int next = (a.index + 1) % count;
        const int previous = (a.index + count - 1) % count;
        if (ring[static_cast<std::size_t>(next)] == to)
            edge = {a.ring, a.index, 1};
        else if (ring[static_cast<std::size_t>(previous)] == to)
            edge = {a.ring, previous, -1};
        return edge.isKnown();
    });
    return edge;
}

SourceEdge SourceIndex::edgeAfter(const SourceEdge &before, const GridPoint &from,
                                  const GridPoint &to) const
{
    if (!before.isKnown())
        return edgeBetween(from, to);
    const GridRing &ring = m_sources[static_cast<std::size_t>(before.ring)].snapped;
    const int count = static_cast<int>(ring.size());
    const auto after = [count](int i) { return i + 1 < count ? i + 1 : 0; };
    const auto ahead = [count](int i) { return i > 0 ? i - 1 : count - 1; };
    // The vertex that the edge before leads to, if it is this one and the only one here.
    const int corner = before.direction > 0 ? after(before.edge) : before.edge;
    const auto at = static_cast<std::size_t>(corner);
    if (ring[at] != from || m_hasDouble[static_cast<std::size_t>(before.ring)][at])
        return edgeBetween(from, to);
    if (ring[static_cast<std::size_t>(after(corner))] == to)
        return {before.ring, corner, 1};
    if (ring[static_cast<std::size_t>(ahead(corner))] == to)
        return {before.ring, ahead(corner), -1};
    return {};
}

std::vector<std::vector<SourceEdge>> findSourceEdges(const std::vector<SourceRing> &sources,
                                                     const SourceIndex &index,
                                                     const std::vector<GridRing> &rings)
{
    std::vector<std::vector<SourceEdge>> result(rings.size());
    std::vector<Query> queries;
    for (std::size_t r = 0; r < rings.size(); ++r) {
        const GridRing &ring = rings[r];
        result[r].reserve(ring.size());
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const GridPoint &next = ring[i + 1 < ring.size() ? i + 1 : 0];
            result[r].push_back(
                index.edgeAfter(i > 0 ? result[r].back() : SourceEdge(), ring[i], next));
            if (!result[r].back().isKnown()) {
                queries.push_back({ring[i], {}});
                queries.push_back({next, {}});
            }
        }
    }
    const auto byPoint = [](const Query &a, const Query &b) { return a.point < b.point; };
    std::sort(queries.begin(), queries.end(), byPoint);
    queries.erase(std::unique(queries.begin(), queries.end(),
                              [](const Query &a, const Query &b) { return a.point == b.point; }),
                  queries.end());
    collectEdges(sources, queries);

    const auto query = [&](const GridPoint &p) -> const Query & {
        return *std::lower_bound(queries.begin(), queries.end(), Query{p, {}}, byPoint);
    };
    for (std::size_t r = 0; r < rings.size(); ++r) {
        for (std::size_t i = 0; i < rings[r].size(); ++i) {
            if (!result[r][i].isKnown())
                result[r][i] = commonEdge(sources, query(rings[r][i]),
                                          query(rings[r][(i + 1) % rings[r].size()]));
        }
    }
    return result;
}

} // namespace fff
