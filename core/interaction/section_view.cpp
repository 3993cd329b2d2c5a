#include "core/interaction/section_view.h"

#include "core/interaction/facing.h"

#include <algorithm>

namespace fff {

namespace {

/// Part of the view that a section may fill.
constexpr double kLargest = 0.9;

Vec3 middleOf(const Section &section)
{
    return section.frame.toWorld(section.shape->bounds().center());
}

bool isWithin(const Vec2 &at, const Vec2 &viewport)
{
    return (at.array() > 0.0).all() && (at.array() < viewport.array()).all();
}

Box2 seenBox(const Section &section, const Camera &camera, const Vec2 &viewport)
{
    const Box2 &bounds = section.shape->bounds();
    Box2 box;
    for (const double x : {bounds.min.x(), bounds.max.x()})
        for (const double y : {bounds.min.y(), bounds.max.y()})
            box.extend(camera.toScreen(section.frame.toWorld({x, y}), viewport));
    return box;
}

} // namespace

bool isSeenFaced(const Section &section, const Camera &camera, const Vec2 &viewport)
{
    const Vec3 middle = middleOf(section);
    return isWithin(camera.toScreen(middle, viewport), viewport) &&
           isFaced(section.frame.normal(), camera.towardsEye(middle, viewport));
}

std::optional<Camera> cameraAtSection(const Section &section, const Camera &camera,
                                      const Vec2 &viewport)
{
    const Box2 seen = seenBox(section, camera, viewport);
    if (isSeenFaced(section, camera, viewport) && isWithin(seen.min, viewport) &&
        isWithin(seen.max, viewport))
        return {};
    const Vec3 middle = middleOf(section);
    Camera there = turned(camera, facingOrientation(camera.orientation, section.frame.normal()),
                          middle, viewport);
    there = pinned(there, middle, 0.5 * viewport, viewport);
    const Vec2 size = seenBox(section, there, viewport).size();
    const double part = size.cwiseQuotient(viewport).maxCoeff();
    return part > kLargest ? zoomed(there, kLargest / part, 0.5 * viewport, viewport) : there;
}

} // namespace fff
