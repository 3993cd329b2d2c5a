#include "core/templates/mesh_facets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace fff {

namespace {

constexpr int kNoFacet = -1;

/// A corner of a face by its number, 3 × face + corner: also the edge that begins there.
using FacetCorner = std::size_t;

FacetCorner nextCorner(FacetCorner corner)
{
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

class FacetFinder
{
public:
    explicit FacetFinder(const TriangleMesh &mesh);
    std::vector<MeshFacet> find();

private:
    std::uint32_t vertex(FacetCorner corner) const
    {
        return m_mesh.triangles()[corner / 3][corner % 3];
    }
    const Vec3 &point(FacetCorner corner) const { return m_mesh.positions()[vertex(corner)]; }
    void findOpposites();
    bool isFlatWith(std::size_t face, std::size_t seed) const;
    void grow(std::size_t seed, int facet);
    void giveAwaySlivers();
    int facetBeyond(FacetCorner edge) const
    {
        return m_opposite[edge] == kNone ? kNoFacet : m_facet[m_opposite[edge] / 3];
    }
    bool isBoundary(FacetCorner edge) const { return facetBeyond(edge) != m_facet[edge / 3]; }
    FacetCorner boundaryAfter(FacetCorner edge) const;
    void findLoops(std::vector<MeshFacet> &facets) const;
    void sum(std::vector<MeshFacet> &facets) const;

    static constexpr FacetCorner kNone = static_cast<FacetCorner>(-1);

    const TriangleMesh &m_mesh;
    std::vector<Vec3> m_normals; // of the faces, as long as twice their areas
    std::vector<char> m_isSliver;
    std::vector<FacetCorner> m_opposite; // of each edge
    std::vector<int> m_facet;            // of each face
};

FacetFinder::FacetFinder(const TriangleMesh &mesh)
    : m_mesh(mesh), m_facet(mesh.triangles().size(), kNoFacet)
{
    for (std::size_t face = 0; face < mesh.triangles().size(); ++face) {
        const Vec3 &a = point(3 * face), &b = point(3 * face + 1), &c = point(3 * face + 2);
        m_normals.emplace_back((b - a).cross(c - a));
        const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
        m_isSliver.push_back(m_normals.back().norm() <= kSliverHeight * longest);
    }
    findOpposites();
}

void FacetFinder::findOpposites()
{
    m_opposite.assign(3 * m_mesh.triangles().size(), kNone);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<FacetCorner>> edges;
    for (FacetCorner edge = 0; edge < m_opposite.size(); ++edge)
        edges[std::minmax(vertex(edge), vertex(nextCorner(edge)))].push_back(edge);
    for (const auto &[ends, all] : edges) {
        if (all.size() != 2 || vertex(all[0]) == vertex(all[1])) // open, crowded, one-sided
            continue;
        m_opposite[all[0]] = all[1];
        m_opposite[all[1]] = all[0];
    }
}

bool FacetFinder::isFlatWith(std::size_t face, std::size_t seed) const
{
    const Vec3 normal = m_normals[seed].normalized();
    const Vec3 &own = m_normals[face];
    if (!m_isSliver[face] &&
        std::atan2(normal.cross(own).norm(), normal.dot(own)) >= kCoplanarAngle)
        return false;
    for (const std::size_t corner : {0U, 1U, 2U})
        if (std::abs(normal.dot(point(3 * face + corner) - point(3 * seed))) > kCoplanarDepth)
            return false;
    return true;
}

void FacetFinder::grow(std::size_t seed, int facet)
{
    std::vector<std::size_t> open{seed};
    m_facet[seed] = facet;
    while (!open.empty()) {
        const std::size_t face = open.back();
        open.pop_back();
        for (FacetCorner edge = 3 * face; edge < 3 * face + 3; ++edge) {
            if (m_opposite[edge] == kNone)
                continue;
            const std::size_t next = m_opposite[edge] / 3;
            if (m_facet[next] == kNoFacet && isFlatWith(next, seed)) {
                m_facet[next] = facet;
                open.push_back(next);
            }
        }
    }
}

/// What is left of them goes over its longest side.
void FacetFinder::giveAwaySlivers()
{
    const auto lengthOf = [this](FacetCorner edge) {
        return (point(nextCorner(edge)) - point(edge)).norm();
    };
    for (bool isDone = false; !isDone;) {
        isDone = true;
        for (std::size_t face = 0; face < m_facet.size(); ++face) {
            if (m_facet[face] != kNoFacet)
                continue;
            FacetCorner best = kNone;
            for (FacetCorner edge = 3 * face; edge < 3 * face + 3; ++edge)
                if (facetBeyond(edge) != kNoFacet &&
                    (best == kNone || lengthOf(edge) > lengthOf(best)))
                    best = edge;
            if (best == kNone)
                continue;
            m_facet[face] = facetBeyond(best);
            isDone = false;
        }
    }
}

/// Round the vertex where the edge ends, within its piece.
FacetCorner FacetFinder::boundaryAfter(FacetCorner edge) const
{
    FacetCorner next = nextCorner(edge);
    while (!isBoundary(next))
        next = nextCorner(m_opposite[next]);
    return next;
}

void FacetFinder::findLoops(std::vector<MeshFacet> &facets) const
{
    std::vector<char> isDone(m_opposite.size(), char(false));
    for (FacetCorner first = 0; first < m_opposite.size(); ++first) {
        const int facet = m_facet[first / 3];
        if (facet == kNoFacet || isDone[first] || !isBoundary(first))
            continue;
        std::vector<FacetEdge> loop;
        for (FacetCorner edge = first; !isDone[edge]; edge = boundaryAfter(edge)) {
            isDone[edge] = true;
            loop.push_back({vertex(edge), vertex(nextCorner(edge)), facetBeyond(edge)});
        }
        if (loop.size() > 2)
            facets[static_cast<std::size_t>(facet)].loops.push_back(std::move(loop));
    }
    const auto extent = [this](const std::vector<FacetEdge> &loop) {
        Box3 box;
        for (const FacetEdge &edge : loop)
            box.extend(m_mesh.positions()[edge.from]);
        return box.size().norm();
    };
    for (MeshFacet &facet : facets)
        std::stable_sort(facet.loops.begin(), facet.loops.end(),
                         [&](const auto &a, const auto &b) { return extent(a) > extent(b); });
}

void FacetFinder::sum(std::vector<MeshFacet> &facets) const
{
    std::vector<Vec3> normals(facets.size(), Vec3::Zero());
    for (std::size_t face = 0; face < m_facet.size(); ++face) {
        if (m_facet[face] == kNoFacet)
            continue;
        const auto index = static_cast<std::size_t>(m_facet[face]);
        const double area = 0.5 * m_normals[face].norm();
        facets[index].area += area;
        facets[index].middle +=
            area / 3.0 * (point(3 * face) + point(3 * face + 1) + point(3 * face + 2));
        normals[index] += m_normals[face];
    }
    for (std::size_t i = 0; i < facets.size(); ++i) {
        facets[i].middle /= facets[i].area;
        facets[i].normal = normals[i].normalized();
    }
}

std::vector<MeshFacet> FacetFinder::find()
{
    std::vector<std::size_t> seeds(m_facet.size());
    std::iota(seeds.begin(), seeds.end(), std::size_t(0));
    std::erase_if(seeds, [this](std::size_t face) { return m_isSliver[face]; });
    std::stable_sort(seeds.begin(), seeds.end(), [this](std::size_t a, std::size_t b) {
        return m_normals[a].squaredNorm() > m_normals[b].squaredNorm();
    });
    int count = 0;
    for (const std::size_t seed : seeds)
        if (m_facet[seed] == kNoFacet)
            grow(seed, count++);
    giveAwaySlivers();
    std::vector<MeshFacet> facets(static_cast<std::size_t>(count));
    sum(facets);
    findLoops(facets);
    return facets;
}

} // namespace

std::vector<MeshFacet> meshFacets(const TriangleMesh &mesh)
{
    return FacetFinder(mesh).find();
}

} // namespace fff
