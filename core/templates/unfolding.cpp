#include "core/templates/unfolding.h"

#include "core/geometry/frame.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace fff {

namespace {

/// mm: a vertex so near to the line between the ends of a stretch is on it.
constexpr double kOnStretch = kCoplanarDepth;

double distanceToLine(const Vec3 &p, const Vec3 &from, const Vec3 &to)
{
    const Vec3 way = to - from;
    const double length = way.norm();
    return length > 0.0 ? way.cross(p - from).norm() / length : (p - from).norm();
}

/// Whether edges [first, first + count) of a loop go straight on.
bool isStraight(const std::vector<FacetEdge> &loop, std::size_t first, std::size_t count,
                const std::vector<Vec3> &positions)
{
    const Vec3 &from = positions[loop[first].from];
    const Vec3 &to = positions[loop[(first + count - 1) % loop.size()].to];
    for (std::size_t k = 1; k < count; ++k)
        if (distanceToLine(positions[loop[(first + k) % loop.size()].from], from, to) > kOnStretch)
            return false;
    return true;
}

/// An edge of the loop where a stretch begins: it turns there, or another facet begins beyond.
std::size_t cornerOf(const std::vector<FacetEdge> &loop, const std::vector<Vec3> &positions)
{
    for (std::size_t e = 0; e < loop.size(); ++e) {
        const std::size_t before = (e + loop.size() - 1) % loop.size();
        if (loop[before].beyond != loop[e].beyond || !isStraight(loop, before, 2, positions))
            return e;
    }
    return 0;
}

} // namespace

Unfolding::Unfolding(const TriangleMesh &mesh, const std::vector<MeshFacet> &facets)
    : m_mesh(mesh), m_facets(facets), m_hingesOf(facets.size()), m_rings(facets.size())
{
    findHinges();
    pairHinges();
}

/// A stretch goes on as long as the same facet is beyond it and it goes straight on.
void Unfolding::findHinges()
{
    const std::vector<Vec3> &positions = m_mesh.positions();
    for (std::size_t facet = 0; facet < m_facets.size(); ++facet)
        for (std::size_t k = 0; k < m_facets[facet].loops.size(); ++k) {
            const std::vector<FacetEdge> &loop = m_facets[facet].loops[k];
            const std::size_t corner = cornerOf(loop, positions);
            for (std::size_t done = 0, count = 1; done < loop.size(); done += count, count = 1) {
                Hinge hinge;
                hinge.facet = facet;
                hinge.loop = k;
                hinge.first = (corner + done) % loop.size();
                const int beyond = loop[hinge.first].beyond;
                if (beyond < 0 || beyond == static_cast<int>(facet))
                    continue;
                while (done + count < loop.size() &&
                       loop[(hinge.first + count) % loop.size()].beyond == beyond &&
                       isStraight(loop, hinge.first, count + 1, positions))
                    ++count;
                hinge.beyond = static_cast<std::size_t>(beyond);
                hinge.count = count;
                hinge.length = (positions[endOf(hinge)] - positions[startOf(hinge)]).norm();
                m_hinges.push_back(hinge);
            }
        }
}

std::uint32_t Unfolding::startOf(const Hinge &hinge) const
{
    return loopOf(hinge)[hinge.first].from;
}

std::uint32_t Unfolding::endOf(const Hinge &hinge) const
{
    const std::vector<FacetEdge> &loop = loopOf(hinge);
    return loop[(hinge.first + hinge.count - 1) % loop.size()].to;
}

/// Those that have no other side with the same ends are none.
void Unfolding::pairHinges()
{
    using Ends =
        std::pair<std::pair<std::size_t, std::size_t>, std::pair<std::uint32_t, std::uint32_t>>;
    const auto endsOf = [this](const Hinge &h) {
        return Ends({h.facet, h.beyond}, {startOf(h), endOf(h)});
    };
    const auto turnedEndsOf = [this](const Hinge &h) {
        return Ends({h.beyond, h.facet}, {endOf(h), startOf(h)});
    };
    std::map<Ends, std::size_t> known;
    for (const Hinge &hinge : m_hinges)
        known.emplace(endsOf(hinge), 0);
    std::erase_if(m_hinges,
                  [&](const Hinge &hinge) { return !known.contains(turnedEndsOf(hinge)); });
    for (std::size_t i = 0; i < m_hinges.size(); ++i) {
        known[endsOf(m_hinges[i])] = i;
        m_hingesOf[m_hinges[i].facet].push_back(i);
    }
    for (Hinge &hinge : m_hinges)
        hinge.opposite = known.at(turnedEndsOf(hinge));
}

void Unfolding::place(std::size_t facet)
{
    const MeshFacet &of = m_facets[facet];
    const Hinge longest = [&] {
        Hinge found;
        for (const std::size_t i : m_hingesOf[facet])
            if (m_hinges[i].length > found.length)
                found = m_hinges[i];
        return found;
    }();
    const Vec3 way =
        longest.length > 0.0
            ? Vec3(m_mesh.positions()[endOf(longest)] - m_mesh.positions()[startOf(longest)])
            : Vec3(m_mesh.positions()[of.loops.front().front().to] -
                   m_mesh.positions()[of.loops.front().front().from]);
    const Vec3 x = (way - way.dot(of.normal) * of.normal).normalized();
    const Frame frame{of.middle, x, of.normal.cross(x)};
    m_rings[facet].clear();
    for (const auto &loop : of.loops) {
        m_rings[facet].emplace_back();
        for (const FacetEdge &edge : loop)
            m_rings[facet].back().push_back(frame.toLocal(m_mesh.positions()[edge.from]));
    }
}

NetLine Unfolding::lineOf(const Hinge &hinge) const
{
    const Polygon &ring = m_rings[hinge.facet][hinge.loop];
    return {ring[hinge.first], ring[(hinge.first + hinge.count) % ring.size()]};
}

void Unfolding::placeBeyond(const Hinge &hinge)
{
    place(hinge.beyond);
    const Hinge &other = m_hinges[hinge.opposite];
    const NetLine wanted = lineOf(hinge), is = lineOf(other);
    // The other one runs along it the other way.
    const Vec2 from = is.to - is.from, to = wanted.from - wanted.to;
    const double turn = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
    const Eigen::Rotation2Dd rotation(turn);
    const Vec2 about = 0.5 * (is.from + is.to), middle = 0.5 * (wanted.from + wanted.to);
    for (Polygon &ring : m_rings[hinge.beyond])
        for (Vec2 &p : ring)
            p = middle + rotation * (p - about);
    // Vertices of the mesh that both have are at one place.
    const Polygon &placed = m_rings[hinge.facet][hinge.loop];
    Polygon &beside = m_rings[hinge.beyond][other.loop];
    const std::vector<FacetEdge> &loop = loopOf(hinge), &otherLoop = loopOf(other);
    for (std::size_t i = 0; i <= hinge.count; ++i) {
        const std::size_t at = (hinge.first + i) % loop.size();
        for (std::size_t k = 0; k <= other.count; ++k) {
            const std::size_t there = (other.first + k) % otherLoop.size();
            if (loop[at].from == otherLoop[there].from)
                beside[there] = placed[at];
        }
    }
}

bool Unfolding::isValley(const Hinge &hinge) const
{
    const MeshFacet &a = m_facets[hinge.facet], &b = m_facets[hinge.beyond];
    const Vec3 along = m_mesh.positions()[endOf(hinge)] - m_mesh.positions()[startOf(hinge)];
    const Vec3 intoBeyond = along.cross(b.normal);
    return a.normal.dot(intoBeyond) > 0.0;
}

} // namespace fff
