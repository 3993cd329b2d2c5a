#include "core/templates/stood_mesh.h"

#include "core/base/tolerances.h"
#include "core/templates/mesh_facets.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fff {

namespace {

bool isBelowAll(const MeshFacet &facet, const TriangleMesh &mesh)
{
    return std::all_of(mesh.positions().begin(), mesh.positions().end(), [&](const Vec3 &p) {
        return facet.normal.dot(p - facet.middle) <= kCoplanarDepth;
    });
}

/// Null: none.
const MeshFacet *footIn(const std::vector<MeshFacet> &facets, const TriangleMesh &mesh)
{
    const MeshFacet *foot = nullptr;
    for (const MeshFacet &facet : facets)
        if (-facet.normal.y() >= std::cos(kMostLean) && (!foot || facet.area > foot->area) &&
            isBelowAll(facet, mesh))
            foot = &facet;
    return foot;
}

} // namespace

TriangleMeshPointer stoodOnFacet(const TriangleMesh &mesh)
{
    const std::vector<MeshFacet> facets = meshFacets(mesh);
    const MeshFacet *foot = footIn(facets, mesh);
    if (!foot)
        return nullptr;
    const double lean = std::atan2(foot->normal.cross(-Vec3::UnitY()).norm(), -foot->normal.y());
    if (lean <= kSameDirection)
        return nullptr;
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond::FromTwoVectors(foot->normal, -Vec3::UnitY());
    std::vector<Vec3> positions;
    positions.reserve(mesh.positions().size());
    Box3 box;
    for (const Vec3 &p : mesh.positions()) {
        positions.push_back(turn * p);
        box.extend(positions.back());
    }
    const Box3 before = mesh.bounds();
    Vec3 way = before.center() - box.center();
    way.y() = before.min.y() - box.min.y();
    for (Vec3 &p : positions)
        p += way;
    return std::make_shared<const TriangleMesh>(std::move(positions), mesh.triangles(), 1.0);
}

} // namespace fff
