// Flat pieces of a mesh laid into one plane, each over an edge of another one. Internal to
// templates.
#pragma once

#include "core/geometry/polygon.h"
#include "core/templates/mesh_facets.h"
#include "core/templates/mesh_nets.h"

#include <cstddef>
#include <vector>

namespace fff {

/// A stretch of a facet's boundary beyond which another one is, as straight as facets are flat;
/// seen from one of the two.
struct Hinge
{
    std::size_t facet = 0, beyond = 0;
    std::size_t loop = 0, first = 0, count = 0; // edges of the facet's loop, the first one on
    double length = 0.0;                        // mm, from end to end
    std::size_t opposite = 0;                   // the same from the other side
};

class Unfolding
{
public:
    Unfolding(const TriangleMesh &mesh, const std::vector<MeshFacet> &facets);

    std::size_t hingeCount() const { return m_hinges.size(); }
    const Hinge &hinge(std::size_t i) const { return m_hinges[i]; }
    const std::vector<std::size_t> &hingesOf(std::size_t facet) const { return m_hingesOf[facet]; }
    bool hasRings(std::size_t facet) const { return !m_facets[facet].loops.empty(); }

    /// As it lies by itself.
    void place(std::size_t facet);
    /// What is beyond a hinge of one that is placed, so that they share its line to the last digit.
    void placeBeyond(const Hinge &hinge);
    /// Where it was placed last, as its loops.
    const std::vector<Polygon> &rings(std::size_t facet) const { return m_rings[facet]; }
    /// In the plane, from the facet's side.
    NetLine lineOf(const Hinge &hinge) const;
    /// The two facets lean towards who sees them from outside.
    bool isValley(const Hinge &hinge) const;

private:
    void findHinges();
    void pairHinges();
    const std::vector<FacetEdge> &loopOf(const Hinge &hinge) const
    {
        return m_facets[hinge.facet].loops[hinge.loop];
    }
    std::uint32_t startOf(const Hinge &hinge) const;
    std::uint32_t endOf(const Hinge &hinge) const;

    const TriangleMesh &m_mesh;
    const std::vector<MeshFacet> &m_facets;
    std::vector<Hinge> m_hinges;
    std::vector<std::vector<std::size_t>> m_hingesOf; // by facets
    std::vector<std::vector<Polygon>> m_rings;        // by facets
};

} // namespace fff
