#include "core/interaction/sight.h"

#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/interaction/clip_gesture.h"

#include <cmath>

namespace fff {

std::vector<Hit> Sight::hitsAt(const Vec2 &position) const
{
    return pick(model, camera.rayThrough(position, viewport), view);
}

bool Sight::isOnEdge(const Hit &hit) const
{
    const Vec3 eye = camera.towardsEye(hit.point, viewport);
    const Section &section = *model.section(static_cast<std::size_t>(hit.section));
    return std::abs(section.frame.normal().dot(eye)) < std::sin(kMinDrawAngle);
}

bool Sight::isOnHandle(const Vec2 &position) const
{
    if (!view.clip)
        return false;
    const Vec3 handle = clipHandle(*view.clip, model.bounds());
    return (camera.toScreen(handle, viewport) - position).norm() <= kHandleReach;
}

std::optional<CubePart> Sight::cubePartAt(const Vec2 &position) const
{
    return fff::cubePartAt(position, camera.orientation, viewport);
}

std::optional<PlacedMark> Sight::markAt(const Vec2 &position) const
{
    const std::vector<PlacedMark> placed = placeMarks(marks, camera, viewport, view, covered);
    const PlacedMark *there = fff::markAt(position, placed);
    return there ? std::optional(*there) : std::nullopt;
}

bool Sight::isOnNumber(const Vec2 &position) const
{
    const std::optional<PlacedMark> there = markAt(position);
    return there && !there->isDot;
}

Vec3 Sight::pivotAt(const Vec2 &position) const
{
    const std::vector<Hit> hits = hitsAt(position);
    return hits.empty() ? middleOf({}) : hits.front().point;
}

Camera Sight::cameraAt(const Vec2 &position) const
{
    return camera.isPerspective() ? retargeted(camera, pivotAt(position), viewport) : camera;
}

Vec3 Sight::middleOf(const std::vector<SectionRef> &sections) const
{
    Box3 box;
    for (const SectionRef &ref : sections) {
        if (const int index = model.indexOf(ref); index >= 0) {
            const Section &section = *model.section(static_cast<std::size_t>(index));
            box.extend(worldBounds(*section.shape, section.frame));
        }
    }
    if (box.isEmpty())
        box = model.bounds();
    return box.isEmpty() ? Vec3(0.0, kFirstPlaneHeight, 0.0) : box.center();
}

} // namespace fff
