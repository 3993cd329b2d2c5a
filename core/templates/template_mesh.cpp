#include "core/templates/template_mesh.h"

namespace fff {

Result<TemplateMeshPointer> makeTemplateMesh(TriangleMeshPointer mesh, MeshReport report,
                                             const LongWork &work)
{
    Result<MeshTree> tree = MeshTree::make(*mesh, work);
    if (!tree)
        return tl::unexpected(std::move(tree.error()));
    return std::make_shared<const TemplateMesh>(
        TemplateMesh{std::move(mesh), *std::move(tree), std::move(report)});
}

Similarity worldPlacement(const Template &one, const TemplateMesh &mesh)
{
    return one.placement() * Similarity::moved(-mesh.middle());
}

Box3 worldBounds(const Template &one, const TemplateMesh &mesh)
{
    const Similarity placement = worldPlacement(one, mesh);
    Box3 box;
    for (const Vec3 &p : mesh.mesh->positions())
        box.extend(placement(p));
    return box;
}

} // namespace fff
