#include "core/templates/moved_template.h"

#include "core/base/tolerances.h"
#include "core/templates/flat_template.h"
#include "core/templates/template_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

tl::unexpected<Error> badPlacement(const char *place)
{
    return failure(ErrorCode::BadValue, place);
}

/// mm: what is no higher above the ground is on it.
constexpr double kOnGround = 0.01;

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

Vec3 turnsOf(const Template &one)
{
    const Vec3 &x = one.frame.x, &y = one.frame.y, n = one.frame.normal();
    // Where x points straight up or down the first turn and the third are about one line.
    if (std::hypot(x.x(), x.y()) <= kExactFrame)
        return {std::atan2(-n.y(), y.y()), std::copysign(std::numbers::pi / 2.0, -x.z()), 0.0};
    return {std::atan2(y.z(), n.z()), std::asin(std::clamp(-x.z(), -1.0, 1.0)),
            std::atan2(x.y(), x.x())};
}

Template turnedTo(Template one, const Vec3 &turns)
{
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(turns.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(turns.y(), Vec3::UnitY()) *
         Eigen::AngleAxisd(turns.x(), Vec3::UnitX()))
            .toRotationMatrix();
    // Right angles leave axes along axes, to the last bit.
    const auto cleaned = [](Vec3 axis) {
        for (double &value : axis)
            if (const double whole = std::round(value); std::abs(value - whole) <= kExactFrame)
                value = whole;
        return axis;
    };
    one.frame.x = cleaned(turn.col(0));
    one.frame.y = cleaned(turn.col(1));
    one.frame = straightened(one.frame);
    return one;
}

Vec3 keptInSizing(const Template &one, const Vec3 &otherwise, const Model &model)
{
    if (one.on != SectionRef())
        return otherwise;
    Box3 box;
    for (const Vec3 &p : alignedPointsOf(one, model))
        box.extend(p);
    const bool isFlatOnIt = box.size().y() <= kOnGround;
    const bool isOnGround = box.min.y() <= kOnGround && box.max.y() > kOnGround;
    return isOnGround && !isFlatOnIt ? Vec3(one.frame.origin.x(), 0.0, one.frame.origin.z())
                                     : otherwise;
}

Result<Template> sizedInPlace(Template one, double size, const Model &model)
{
    const double now = extentOf(one);
    const std::optional<Frame> lies = worldFrame(one, model);
    if (!(now > 0.0) || !(size > 0.0))
        return badPlacement("size");
    if (!lies)
        return badPlacement("on");
    const Vec3 kept = keptInSizing(one, lies->origin, model);
    return movedBy(std::move(one), Similarity::scaled(size / now, kept), model);
}

Result<Template> sizedByLine(Template one, const Vec3 &from, const Vec3 &to, double length,
                             const Model &model)
{
    const double now = (to - from).norm();
    if (!(now > kClipGrid) || !std::isfinite(now))
        return badPlacement("line");
    if (!(length > 0.0))
        return badPlacement("length");
    const Vec3 kept = keptInSizing(one, from, model);
    return movedBy(std::move(one), Similarity::scaled(length / now, kept), model);
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
