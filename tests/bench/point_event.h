// One move of a control point that is dragged, with all that follows.
#pragma once

#include "core/model/model.h"

#include <memory>

namespace fff::bench {

/// Milliseconds of CPU time, in the order in which things follow.
struct PointEvent
{
    double shape = 0.0;  // the contour with the point moved, whole or not; its document and model
    double slits = 0.0;  // joints and slits, of it and of all its mates
    double parts = 0.0;  // cut sections that differ, and their triangles
    double checks = 0.0; // all verdicts
    double arrays = 0.0; // the scene, and what is uploaded of the sections that differ
    int section = -1;    // where: index in the model
    int touched = 0;     // sections that are cut anew

    double sum() const { return shape + slits + parts + checks + arrays; }
};

/// The worst of some points of some sections: of those with most joints, with the most points, with
/// the largest area and of a middle one; of each several anchors and a handle. Of every one the
/// median of some moves, each of which no cache has seen.
PointEvent worstPointEvent(const std::shared_ptr<const Model> &model);

} // namespace fff::bench
