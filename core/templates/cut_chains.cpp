#include "core/templates/cut_chains.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <span>

namespace fff {

namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFu;
/// Points that are no further from each other, beside the mesh's size, are one: around a vertex
/// that all but lies on the plane rounding would make a bundle of them.
constexpr double kSamePlace = 1e-12;

/// The edges that are crossed, numbered as they are first met.
class CrossedEdges
{
public:
    explicit CrossedEdges(std::size_t segments)
        : m_slots(std::bit_ceil(4 * segments + 4), kNone), m_mask(m_slots.size() - 1)
    {
    }

    std::uint32_t add(const CrossedEdge &edge)
    {
        constexpr std::uint64_t kMix = 0x9E3779B97F4A7C15u;
        const std::uint64_t key = (std::uint64_t(edge.low) << 32) | edge.high;
        for (std::size_t slot = ((key * kMix) >> 24) & m_mask;; slot = (slot + 1) & m_mask) {
            if (m_slots[slot] == kNone) {
                m_slots[slot] = static_cast<std::uint32_t>(m_edges.size());
                m_edges.push_back(edge);
                return m_slots[slot];
            }
            if (m_edges[m_slots[slot]] == edge)
                return m_slots[slot];
        }
    }
    const std::vector<CrossedEdge> &all() const { return m_edges; }

private:
    std::vector<CrossedEdge> m_edges;
    std::vector<std::uint32_t> m_slots;
    std::size_t m_mask;
};

/// On the line of the edge; a vertex that lies on the plane is itself the place.
Vec3 crossing(const Vec3 &a, const Vec3 &b, const CutPlane &plane)
{
    const double from = plane.height(a), to = plane.height(b);
    const double between = from - to;
    if (from == 0.0 || between == 0.0)
        return a;
    if (to == 0.0)
        return b;
    const double share = std::clamp(from / between, 0.0, 1.0);
    // From the nearer end, which rounding follows.
    return share <= 0.5 ? Vec3(a + share * (b - a))
                        : Vec3(b + std::clamp(to / -between, 0.0, 1.0) * (a - b));
}

/// Ends of segments are numbered: 2 s where segment s starts, 2 s + 1 where it ends.
class Chaining
{
public:
    Chaining(const TriangleMesh &mesh, const CutPlane &plane,
             const std::vector<CutSegment> &segments)
        : m_mesh(mesh), m_segments(segments), m_frame(frameOn(plane)),
          m_nearest(kSamePlace * mesh.size()), m_ends(2 * segments.size()),
          m_partners(2 * segments.size(), kNone), m_isDone(segments.size(), 0)
    {
        CrossedEdges edges(segments.size());
        for (std::size_t s = 0; s < segments.size(); ++s) {
            m_ends[2 * s] = edges.add(segments[s].from);
            m_ends[2 * s + 1] = edges.add(segments[s].to);
        }
        m_places.reserve(edges.all().size());
        for (const CrossedEdge &edge : edges.all())
            m_places.push_back(
                crossing(mesh.positions()[edge.low], mesh.positions()[edge.high], plane));
        cancelWalls();
        pairUp();
    }

    std::vector<CutChain> chains()
    {
        std::vector<CutChain> found;
        for (std::uint32_t end = 0; end < m_ends.size(); ++end)
            if (m_partners[end] == kNone && !m_isDone[end / 2])
                add(found, walk(end));
        for (std::uint32_t s = 0; s < m_isDone.size(); ++s)
            if (!m_isDone[s])
                add(found, walk(2 * s));
        return found;
    }

private:
    /// Two segments that lie on each other and run against each other are a wall between solids
    /// that touch there, each with a face of its own: what is cut goes on through it. Where there
    /// is nothing but such walls, it is a sheet with two sides, and they stay.
    void cancelWalls()
    {
        std::vector<std::uint32_t> degrees(m_places.size(), 0);
        for (const std::uint32_t edge : m_ends)
            ++degrees[edge];
        std::vector<std::uint32_t> inCrowds;
        for (std::uint32_t s = 0; s < m_isDone.size(); ++s)
            if (degrees[m_ends[2 * s]] > 2 || degrees[m_ends[2 * s + 1]] > 2)
                inCrowds.push_back(s);
        const auto ends = [this](std::uint32_t s) {
            return std::minmax({m_ends[2 * s], m_ends[2 * s + 1]});
        };
        std::sort(inCrowds.begin(), inCrowds.end(), [&ends](std::uint32_t a, std::uint32_t b) {
            return std::pair(ends(a), a) < std::pair(ends(b), b);
        });
        std::size_t cancelled = 0;
        for (std::size_t from = 0, to = 0; from < inCrowds.size(); from = to) {
            std::int64_t excess = 0;
            for (to = from; to < inCrowds.size() && ends(inCrowds[to]) == ends(inCrowds[from]);
                 ++to)
                excess += runsUp(inCrowds[to]) ? 1 : -1;
            // Of those that run the way of the greater part so many stay as there are more.
            for (std::size_t i = from; i < to; ++i) {
                const bool stays = excess != 0 && runsUp(inCrowds[i]) == (excess > 0);
                excess -= stays ? (excess > 0 ? 1 : -1) : 0;
                m_isDone[inCrowds[i]] = stays ? 0 : 1;
                cancelled += stays ? 0 : 1;
            }
        }
        if (cancelled == m_isDone.size())
            std::fill(m_isDone.begin(), m_isDone.end(), std::uint8_t(0));
    }
    bool runsUp(std::uint32_t s) const { return m_ends[2 * s] < m_ends[2 * s + 1]; }

    void pairUp()
    {
        // The ends at each edge, in rows.
        std::vector<std::uint32_t> starts(m_places.size() + 1, 0), rows(m_ends.size());
        for (std::uint32_t end = 0; end < m_ends.size(); ++end)
            starts[m_ends[end] + 1] += m_isDone[end / 2] ? 0 : 1;
        std::partial_sum(starts.begin(), starts.end(), starts.begin());
        std::vector<std::uint32_t> filled(starts.begin(), starts.end() - 1);
        for (std::uint32_t end = 0; end < m_ends.size(); ++end)
            if (!m_isDone[end / 2])
                rows[filled[m_ends[end]]++] = end;
        for (std::size_t edge = 0; edge < m_places.size(); ++edge) {
            const std::span<std::uint32_t> row =
                std::span(rows).subspan(starts[edge], starts[edge + 1] - starts[edge]);
            if (row.size() == 2)
                join(row[0], row[1]);
            else if (row.size() > 2)
                pairCrowd(row);
        }
    }

    void join(std::uint32_t a, std::uint32_t b)
    {
        m_partners[a] = b;
        m_partners[b] = a;
    }

    /// Around the place: where a segment starts, and the next one counter-clockwise ends, what is
    /// enclosed lies between these two.
    void pairCrowd(std::span<std::uint32_t> row)
    {
        struct Way
        {
            double angle = 0.0;
            std::uint32_t end = 0;
        };
        std::vector<Way> ways;
        for (const std::uint32_t end : row) {
            const Vec2 way = wayInto(end);
            ways.push_back({std::atan2(way.y(), way.x()), end});
        }
        std::stable_sort(ways.begin(), ways.end(),
                         [](const Way &a, const Way &b) { return a.angle < b.angle; });
        for (const bool mustFit : {true, false}) {
            for (std::size_t i = 0; ways.size() > 1 && i < ways.size();) {
                const std::size_t next = (i + 1) % ways.size();
                const bool fits = ways[i].end % 2 == 0 && ways[next].end % 2 == 1;
                if (!fits && mustFit) {
                    ++i;
                    continue;
                }
                join(ways[i].end, ways[next].end);
                ways.erase(ways.begin() + static_cast<std::ptrdiff_t>(std::max(i, next)));
                ways.erase(ways.begin() + static_cast<std::ptrdiff_t>(std::min(i, next)));
                i = 0; // those on both sides are neighbours now
            }
        }
    }

    /// From the end of a segment along it: by the triangle, since the other end may be in the very
    /// same place, where the edges of a vertex on the plane are crossed.
    Vec2 wayInto(std::uint32_t end) const
    {
        const Triangle &t = m_mesh.triangles()[m_segments[end / 2].face];
        const Vec3 &a = m_mesh.positions()[t[0]];
        const Vec3 outwards = (m_mesh.positions()[t[1]] - a).cross(m_mesh.positions()[t[2]] - a);
        const Vec2 along = m_frame.directionToLocal(m_frame.normal().cross(outwards));
        return end % 2 == 0 ? along : Vec2(-along);
    }

    bool areApart(const Vec3 &a, const Vec3 &b) const { return (a - b).norm() > m_nearest; }

    /// From this end of a segment on. Closed where it comes back to it.
    CutChain walk(std::uint32_t first)
    {
        CutChain chain;
        std::int64_t forwards = 0, backwards = 0;
        std::uint32_t end = first;
        chain.points.push_back(m_places[m_ends[end]]);
        while (true) {
            m_isDone[end / 2] = 1;
            ++(end % 2 == 0 ? forwards : backwards);
            const std::uint32_t behind = end ^ 1u;
            const Vec3 &place = m_places[m_ends[behind]];
            if (areApart(place, chain.points.back()))
                chain.points.push_back(place);
            end = m_partners[behind];
            if (end == kNone || end == first)
                break;
        }
        chain.isClosed = end == first;
        chain.isOriented = forwards == 0 || backwards == 0;
        if (chain.isClosed)
            while (chain.points.size() > 1 && !areApart(chain.points.back(), chain.points.front()))
                chain.points.pop_back();
        if (backwards > forwards)
            std::reverse(chain.points.begin(), chain.points.end());
        return chain;
    }

    static void add(std::vector<CutChain> &found, CutChain chain)
    {
        // Around a vertex that the plane only touches.
        const std::size_t least = chain.isClosed ? 3 : 2;
        if (chain.points.size() >= least)
            found.push_back(std::move(chain));
    }

    const TriangleMesh &m_mesh;
    const std::vector<CutSegment> &m_segments;
    const Frame m_frame;
    const double m_nearest;                // mm of two points of a chain
    std::vector<std::uint32_t> m_ends;     // the crossed edge of each end
    std::vector<std::uint32_t> m_partners; // the end of another segment there
    std::vector<std::uint8_t> m_isDone;    // segments
    std::vector<Vec3> m_places;            // of the crossed edges
};

} // namespace

std::vector<CutChain> cutChains(const TriangleMesh &mesh, const CutPlane &plane,
                                const std::vector<CutSegment> &segments)
{
    return Chaining(mesh, plane, segments).chains();
}

} // namespace fff
