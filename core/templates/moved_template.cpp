#include "core/templates/moved_template.h"

#include "core/base/tolerances.h"
#include "core/templates/flat_template.h"
#include "core/templates/template_mesh.h"

#include <cmath>

namespace fff {

namespace {

tl::unexpected<Error> badPlacement(const char *place)
{
    return failure(ErrorCode::BadValue, place);
}

/// mm, its largest extent.
double extentOf(const Template &one)
{
    return one.mesh ? one.scale * one.mesh->mesh->size() : flatSize(one).maxCoeff();
}

/// The same to the last bit where it only should be: rounding is not a way.
Vec3 moved(const Vec3 &from, const Vec3 &to)
{
    Vec3 next = to;
    for (int i = 0; i < 3; ++i)
        if (std::abs(to[i] - from[i]) <= kExactFrame)
            next[i] = from[i];
    return next;
}

/// At right angles again, after so many turns.
Frame straightened(Frame frame)
{
    frame.x.normalize();
    frame.y = (frame.y - frame.y.dot(frame.x) * frame.x).normalized();
    return frame;
}

} // namespace

Result<Template> movedBy(Template one, const Similarity &by, const Model &model)
{
    const Vec3 before = one.frame.origin;
    if (one.on == SectionRef()) {
        one.frame = placed(one.frame, by);
    } else {
        const Section *section = model.find(one.on);
        if (!section)
            return badPlacement("on");
        const Similarity plane = placementOf(section->frame);
        one.frame = placed(one.frame, plane.inverse() * by * plane);
    }
    one.frame.origin = moved(before, one.frame.origin);
    if (!by.turn.isIdentity(0.0))
        one.frame = straightened(one.frame);
    one.scale *= by.scale;
    const bool isFitting = one.scale >= kLeastTemplateScale && one.scale <= kMostTemplateScale &&
                           extentOf(one) <= kMaxCoordinate &&
                           one.frame.origin.cwiseAbs().maxCoeff() <= kMaxCoordinate;
    if (!isFitting)
        return badPlacement("size");
    return one;
}

Result<Template> sizedByLine(Template one, const Vec3 &from, const Vec3 &to, double length,
                             const Model &model)
{
    const double now = (to - from).norm();
    if (!(now > kClipGrid) || !std::isfinite(now))
        return badPlacement("line");
    if (!(length > 0.0))
        return badPlacement("length");
    return movedBy(std::move(one), Similarity::scaled(length / now, from), model);
}

std::vector<Vec3> alignedPointsOf(const Template &one, const Model &model)
{
    std::vector<Vec3> points;
    if (one.mesh) {
        const Box3 box = worldBounds(one, *one.mesh);
        points.push_back(box.center());
        for (int corner = 0; corner < 8; ++corner)
            points.emplace_back((corner & 1) ? box.max.x() : box.min.x(),
                                (corner & 2) ? box.max.y() : box.min.y(),
                                (corner & 4) ? box.max.z() : box.min.z());
    } else if (const auto placement = worldPlacement(one, model)) {
        points.push_back((*placement)(Vec3::Zero()));
        for (const Vec3 &corner : cornersOf(one, *placement))
            points.push_back(corner);
    }
    return points;
}

} // namespace fff
