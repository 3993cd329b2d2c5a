#include "core/templates/template_cut.h"

#include "core/templates/guide_curve.h"

#include <algorithm>
#include <cmath>

namespace fff {

std::vector<TemplateLoop> loopsOn(const Frame &frame, const Template &one, const TemplateMesh &mesh)
{
    const Similarity toWorld = worldPlacement(one, one.mesh ? *one.mesh : mesh),
                     toMesh = toWorld.inverse();
    const Result<CutPlane> plane = makeCutPlane(toMesh(frame.origin), toMesh.turn * frame.normal());
    if (!plane)
        return {};
    std::vector<TemplateLoop> loops;
    for (const CutLoop &cut : planeCut(*mesh.mesh, *plane, &mesh.tree).loops) {
        TemplateLoop loop{one.id, {}, cut.isHole, !cut.isClosed()};
        loop.points.reserve(cut.points.size());
        for (const Vec3 &p : cut.points)
            loop.points.push_back(frame.toLocal(toWorld(p)));
        if ((signedArea(loop.points) < 0.0) != loop.isHole) // the template is flipped
            std::reverse(loop.points.begin(), loop.points.end());
        loops.push_back(std::move(loop));
    }
    // The smallest that it is in: those after the first are smaller.
    for (TemplateLoop &hole : loops)
        for (std::size_t k = 0; hole.isHole && k < loops.size(); ++k)
            if (!loops[k].isHole && locate(hole.points.front(), loops[k].points) == Side::Inside)
                hole.around = static_cast<int>(k);
    return loops;
}

Result<Contour> curveOf(const TemplateLoop &loop)
{
    CutLoop flat;
    flat.isHole = loop.isHole;
    flat.area = std::abs(signedArea(loop.points));
    for (const Vec2 &p : loop.points)
        flat.points.emplace_back(p.x(), p.y(), 0.0);
    return guideCurve(flat, Frame());
}

} // namespace fff
