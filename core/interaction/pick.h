// What is under the cursor, by plain math on the mid-planes.
#pragma once

#include "core/interaction/camera.h"
#include "core/interaction/view_state.h"
#include "core/model/model.h"

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

} // namespace fff
