// What is under the cursor, by plain math on the mid-planes.
#pragma once

#include "core/interaction/camera.h"
#include "core/interaction/view_state.h"
#include "core/model/model.h"

#include <optional>
#include <vector>

namespace fff {

struct Hit
{
    int section = -1;          // index in the model
    double distance = 0.0;     // along the ray, mm
    Vec3 point = Vec3::Zero(); // on the section's mid-plane
    Vec2 local = Vec2::Zero(); // the same in its frame
};

/// All sections whose slab the ray meets inside the contour, nearest first. Exact in the plane; for
/// grazing views the slab's side walls count too, and where the view cuts a slab open, its cut.
/// Hidden sections and ghosts are looked through. O(sections in the ray's way).
std::vector<Hit> pick(const Model &model, const Ray &ray, const ViewState &view = {});

/// The nearest of these; none where there is none.
std::optional<SectionRef> sectionUnder(const Model &model, const Ray &ray,
                                       const ViewState &view = {});

/// Where the ray through a screen point meets a plane, in its frame. None where the plane is seen
/// on edge (below kMinDrawAngle) or the place is behind the eye.
std::optional<Vec2> pointOnPlane(const Camera &camera, const Vec2 &viewport, const Frame &plane,
                                 const Vec2 &screen);

} // namespace fff
