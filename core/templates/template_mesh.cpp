#include "core/templates/template_mesh.h"

#include "core/base/tolerances.h"

#include <algorithm>

namespace fff {

Result<TemplateMeshPointer> makeTemplateMesh(TriangleMeshPointer mesh, MeshReport report,
                                             const LongWork &work)
{
    Result<MeshTree> tree = MeshTree::make(*mesh, work);
    if (!tree)
        return tl::unexpected(std::move(tree.error()));
    auto made = std::make_shared<TemplateMesh>();
    made->surface = surfaceOf(*mesh, work);
    made->thinning = std::make_shared<const ThinnedMesh>(mesh, kCoarseTriangles);
    if (!made->thinning->isWhole())
        made->coarse = surfaceOf(*made->thinning->mesh(), work);
    if (work.isStopped())
        return failure(ErrorCode::Cancelled);
    made->mesh = std::move(mesh);
    made->tree = *std::move(tree);
    made->report = std::move(report);
    return made;
}

Result<TemplateMeshPointer> movedTemplateMesh(const TemplateMesh &original,
                                              TriangleMeshPointer mesh, const LongWork &work)
{
    auto made = std::make_shared<TemplateMesh>();
    made->tree = original.tree.refitted(*mesh);
    if (work.isStopped())
        return failure(ErrorCode::Cancelled);
    made->surface = movedSurface(original.surface, *mesh);
    if (work.isStopped())
        return failure(ErrorCode::Cancelled);
    made->thinning = original.thinning;
    if (!made->thinning->isWhole())
        made->coarse = movedSurface(original.coarse, *made->thinning->moved(mesh));
    made->mesh = std::move(mesh);
    made->report = original.report;
    return made;
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

Template stood(Template one, const TemplateMesh &mesh, UpAxis up, double size)
{
    one.frame = Frame();
    if (up == UpAxis::Z)
        one.frame.y = -Vec3::UnitZ(); // so that its normal, along the file's z, is upwards
    const double extent = mesh.mesh->size();
    if (size > 0.0)
        one.scale = size / extent;
    else if (mesh.mesh->unit() && extent <= kMaxCoordinate)
        one.scale = 1.0;
    else
        one.scale = kTemplateSize / extent;
    one.scale = std::clamp(one.scale, kLeastTemplateScale, kMostTemplateScale);
    return onGround(std::move(one), mesh);
}

Template onGround(Template one, const TemplateMesh &mesh)
{
    one.frame.origin.y() -= worldBounds(one, mesh).min.y();
    return one;
}

} // namespace fff
