// A camera whose view is filled by what is seen of a model: by its outline on the screen, which is
// much smaller than its box when that is turned.
#pragma once

#include "core/interaction/camera.h"
#include "core/interaction/view_state.h"
#include "core/model/model.h"

#include <span>
#include <vector>

namespace fff {

/// What stays free at each side of a view, px.
struct ViewMargins
{
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
    std::vector<Box2> upright = {}; // what stands over the view and is higher than wide: it leaves
                                    // room beside it
};

/// 8 % at each side; more where something stands over the view along its upper or lower edge.
/// covered  boxes of all that does, px: those that are wider than high and cross the view's middle
///          do not count
ViewMargins fitMargins(const Vec2 &viewport, std::span<const Box2> covered);

/// So much more at each side that what fits between them takes this part of the room that they
/// leave, in its middle. share: 0 to 1, not 0
ViewMargins withRoomAround(const ViewMargins &margins, const Vec2 &viewport, double share);

/// World points whose outline on the screen is that of the sections, both sides of their slabs:
/// those that are not hidden, or of these the ones that are named.
std::vector<Vec3> outlinePoints(const Model &model, const ViewState &view);
std::vector<Vec3> outlinePoints(const Model &model, const std::vector<SectionRef> &sections);

/// Target and scale so that the points fill the view between the margins: they touch both of them
/// in one direction and lie between them in the other. The target is as deep as their middle.
/// points: world, mm; none: the ground's 20 cm.
Camera fitted(const Camera &camera, std::span<const Vec3> points, const Vec2 &viewport,
              const ViewMargins &margins);
/// The same, and none of the points under the view cube: beside or below it, where more is seen;
/// nor, as far as that leaves room, under what stands upright.
Camera fittedClear(const Camera &camera, std::span<const Vec3> points, const Vec2 &viewport,
                         const ViewMargins &margins);
/// The corners of a box; empty as no points. margins: as of a view that nothing stands over.
Camera fitted(const Camera &camera, const Box3 &box, const Vec2 &viewport);

} // namespace fff
