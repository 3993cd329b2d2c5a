#include "core/templates/template_cut.h"

#include "core/base/tolerances.h"
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
        TemplateLoop loop;
        loop.of = one.id;
        loop.isHole = cut.isHole;
        loop.isBridged = !cut.isClosed();
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

namespace {

/// Straight through all of it, from the drawing to the plane.
struct OntoPlane
{
    const Frame &frame;
    const Similarity &placement;

    Vec2 operator()(const Vec2 &p) const { return frame.toLocal(placement({p.x(), p.y(), 0.0})); }
    std::vector<Vec2> operator()(std::vector<Vec2> points) const
    {
        for (Vec2 &p : points)
            p = (*this)(p);
        return points;
    }
};

bool liesIn(const Frame &frame, const Similarity &placement, const Vec2 &size)
{
    for (const Vec2 &corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
        const Vec2 p = 0.5 * corner.cwiseProduct(size);
        if (!(std::abs(frame.height(placement({p.x(), p.y(), 0.0}))) <= kInPlane))
            return false;
    }
    return true;
}

/// None where nothing of it is left.
std::optional<TemplateLoop> loopOf(TemplateId id, const Contour &contour, bool isHole,
                                   const OntoPlane &map)
{
    Result<Contour> there = Contour::fromPoints(map(contour.points()));
    if (!there)
        return std::nullopt;
    if ((there->signedArea() < 0.0) != isHole) // the drawing is seen from behind
        there = there->reversed();
    TemplateLoop loop;
    loop.of = id;
    loop.isHole = isHole;
    loop.points = there->polygon(kCutChord);
    loop.curve = CurvePath::around(*there);
    return loop;
}

} // namespace

std::vector<TemplateLoop> loopsOn(const Frame &frame, const Template &one,
                                  const Similarity &placement, const TemplateCurves &curves)
{
    if (!liesIn(frame, placement, curves.size))
        return {};
    const OntoPlane map{frame, placement};
    std::vector<TemplateLoop> loops;
    for (const Outline &outline : curves.outlines) {
        std::optional<TemplateLoop> outer = loopOf(one.id, outline.outer, false, map);
        if (!outer)
            continue;
        const auto around = static_cast<int>(loops.size());
        loops.push_back(*std::move(outer));
        for (const Contour &contour : outline.holes)
            if (std::optional<TemplateLoop> hole = loopOf(one.id, contour, true, map)) {
                hole->around = around;
                loops.push_back(*std::move(hole));
            }
    }
    for (const CurvePath &line : curves.open) {
        Result<CurvePath> there = CurvePath::fromPoints(map(line.points()));
        if (!there)
            continue;
        TemplateLoop loop;
        loop.of = one.id;
        loop.isOpen = true;
        loop.points = there->flatten(kCutChord);
        loop.curve = *std::move(there);
        loops.push_back(std::move(loop));
    }
    return loops;
}

Result<Contour> curveOf(const TemplateLoop &loop)
{
    if (loop.isOpen)
        return failure(ErrorCode::EmptyContour);
    if (loop.curve)
        return loop.curve->ring();
    CutLoop flat;
    flat.isHole = loop.isHole;
    flat.area = std::abs(signedArea(loop.points));
    for (const Vec2 &p : loop.points)
        flat.points.emplace_back(p.x(), p.y(), 0.0);
    return guideCurve(flat, Frame());
}

} // namespace fff
