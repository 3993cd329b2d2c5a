#include "core/templates/pulled_templates.h"

#include "core/templates/vertex_normals.h"

#include <algorithm>

namespace fff {

namespace {

std::vector<MagneticPlane> planesOf(const Model &model, const Template &one)
{
    std::vector<MagneticPlane> planes;
    const Similarity toMesh = worldPlacement(one, *one.mesh).inverse();
    for (const Magnet &magnet : one.magnets) {
        const int section = model.indexOf(magnet.section);
        if (section < 0)
            continue;
        const Frame &frame = model.section(static_cast<std::size_t>(section))->frame;
        if (const Result<CutPlane> plane =
                makeCutPlane(toMesh(frame.origin), toMesh.turn * frame.normal()))
            planes.push_back({*plane, magnet.radius / one.scale});
    }
    return planes;
}

bool isSamePlane(const MagneticPlane &a, const MagneticPlane &b)
{
    return a.plane == b.plane && a.reach == b.reach;
}

const PulledTemplate *find(const PulledTemplates &all, TemplateId id)
{
    const auto found = std::find_if(all.all.begin(), all.all.end(),
                                    [id](const PulledTemplate &one) { return one.of == id; });
    return found == all.all.end() ? nullptr : &*found;
}

} // namespace

const TemplateMeshPointer &PulledTemplates::meshOf(const Template &one) const
{
    const PulledTemplate *pulled = find(*this, one.id);
    return pulled && pulled->original == one.mesh ? pulled->mesh : one.mesh;
}

Result<PulledTemplates> pullTemplates(const Model &model, const PulledTemplates *before,
                                      const LongWork &work)
{
    PulledTemplates pulled;
    for (const TemplatePointer &one : model.document.templates) {
        if (one->magnets.empty() || !one->mesh)
            continue;
        std::vector<MagneticPlane> planes = planesOf(model, *one);
        if (planes.empty())
            continue;
        const PulledTemplate *known = before ? find(*before, one->id) : nullptr;
        if (known && known->original != one->mesh)
            known = nullptr;
        if (known && std::equal(planes.begin(), planes.end(), known->planes.begin(),
                                known->planes.end(), isSamePlane)) {
            pulled.all.push_back(*known);
            continue;
        }
        const TriangleMesh &mesh = *one->mesh->mesh;
        PulledTemplate next{one->id, one->mesh, std::move(planes),
                            known ? known->normals
                                  : std::make_shared<const std::vector<Vec3>>(vertexNormals(mesh)),
                            nullptr};
        if (work.isStopped())
            return failure(ErrorCode::Cancelled);
        Result<TemplateMeshPointer> made = movedTemplateMesh(
            *one->mesh, magneticCut(mesh, *next.normals, next.planes), {work.stop, {}});
        if (!made)
            return tl::unexpected(std::move(made.error()));
        next.mesh = *std::move(made);
        pulled.all.push_back(std::move(next));
    }
    return pulled;
}

} // namespace fff
