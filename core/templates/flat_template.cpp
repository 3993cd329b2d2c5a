#include "core/templates/flat_template.h"

#include "core/base/tolerances.h"
#include "core/templates/template_curves.h"
#include "core/templates/template_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fff {

namespace {

/// x to the right, and up, or on the ground away from who looks.
Frame standardFrame(StandardPlane plane)
{
    switch (plane) {
    case StandardPlane::Ground:
        return {Vec3::Zero(), Vec3::UnitX(), -Vec3::UnitZ()};
    case StandardPlane::Front:
        break;
    case StandardPlane::Side:
        return {Vec3::Zero(), -Vec3::UnitZ(), Vec3::UnitY()};
    }
    return {};
}

bool isScale(double scale)
{
    return scale >= kLeastTemplateScale && scale <= kMostTemplateScale;
}

/// No larger than what a document holds.
bool isFitting(const Template &one)
{
    return isScale(one.scale) && flatSize(one).maxCoeff() <= kMaxCoordinate &&
           one.frame.origin.cwiseAbs().maxCoeff() <= kMaxCoordinate;
}

void turnAxes(Frame &frame, double by)
{
    const Vec3 x = std::cos(by) * frame.x + std::sin(by) * frame.y;
    frame.y = std::cos(by) * frame.y - std::sin(by) * frame.x;
    frame.x = x;
}

/// So that the box stands on the ground, its middle above the plane's origin.
Template stoodByBox(Template one, StandardPlane plane, const Box2 &box)
{
    one.on = {};
    one.frame = standardFrame(plane);
    const double across = (one.isFlipped ? -1.0 : 1.0) * box.center().x();
    one.frame.origin = -one.scale * (across * one.frame.x + box.min.y() * one.frame.y);
    return one;
}

} // namespace

Vec2 flatExtent(const Template &one)
{
    if (one.picture)
        return {one.picture->width, one.picture->height};
    return one.curves ? one.curves->size : Vec2(Vec2::Zero());
}

Vec2 flatSize(const Template &one)
{
    return one.scale * flatExtent(one);
}

std::optional<Similarity> worldPlacement(const Template &one, const Model &model)
{
    if (one.on == SectionRef())
        return one.placement();
    const Section *section = model.find(one.on);
    if (!section)
        return std::nullopt;
    return placementOf(section->frame) * one.placement();
}

std::optional<Frame> worldFrame(const Template &one, const Model &model)
{
    if (one.on == SectionRef())
        return one.frame;
    const Section *section = model.find(one.on);
    if (!section)
        return std::nullopt;
    return placed(one.frame, placementOf(section->frame));
}

std::array<Vec3, 4> cornersOf(const Template &one, const Similarity &placement)
{
    const Vec2 half = 0.5 * flatExtent(one);
    return {placement({-half.x(), -half.y(), 0.0}), placement({half.x(), -half.y(), 0.0}),
            placement({half.x(), half.y(), 0.0}), placement({-half.x(), half.y(), 0.0})};
}

Template laidOn(Template one, StandardPlane plane)
{
    one.on = {};
    one.frame = standardFrame(plane);
    return plane == StandardPlane::Ground ? one : flatOnGround(std::move(one));
}

Template laidOn(Template one, const Section &section)
{
    one.on = section.ref();
    const Vec2 middle = section.shape->bounds().center();
    one.frame = {{middle.x(), middle.y(), 0.0}, Vec3::UnitX(), Vec3::UnitY()};
    turnAxes(one.frame, uprightTurn(section.frame));
    return one;
}

Template flatOnGround(Template one)
{
    if (one.on != SectionRef())
        return one;
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec3 &corner : cornersOf(one, one.placement()))
        lowest = std::min(lowest, corner.y());
    one.frame.origin.y() -= lowest;
    return one;
}

double turnOf(const Frame &world)
{
    if (!isLevel(world))
        return std::remainder(-uprightTurn(world), 2.0 * std::numbers::pi);
    const Vec2 right = world.directionToLocal(Vec3::UnitX());
    return -std::atan2(right.y(), right.x());
}

Template turned(Template one, double by)
{
    turnAxes(one.frame, by);
    return one;
}

Template sizedTo(Template one, double size)
{
    if (const double extent = flatExtent(one).maxCoeff(); extent > 0.0)
        one.scale = std::clamp(size / extent, kLeastTemplateScale, kMostTemplateScale);
    return one;
}

Box2 drawnBox(const Template &one)
{
    if (one.picture)
        return drawnBox(*one.picture);
    const Vec2 half = 0.5 * flatExtent(one);
    return {-half, half};
}

Result<std::pair<Template, Template>> aligned(Template front, const Box2 &frontBox, Template side,
                                              const Box2 &sideBox)
{
    if (!(frontBox.size().y() > 0.0))
        return failure(ErrorCode::BadValue, "front");
    if (!(sideBox.size().y() > 0.0))
        return failure(ErrorCode::BadValue, "side");
    side.scale = front.scale * frontBox.size().y() / sideBox.size().y();
    front = stoodByBox(std::move(front), StandardPlane::Front, frontBox);
    side = stoodByBox(std::move(side), StandardPlane::Side, sideBox);
    if (!isFitting(front))
        return failure(ErrorCode::BadValue, "front");
    if (!isFitting(side))
        return failure(ErrorCode::BadValue, "side");
    return std::pair(std::move(front), std::move(side));
}

} // namespace fff
