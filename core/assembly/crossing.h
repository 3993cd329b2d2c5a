// Two placed shapes and what they share; and the boxes by which most pairs are told apart at once.
#pragma once

#include "core/assembly/joint.h"

#include <utility>

namespace fff {

/// Axis and overlaps of two placed shapes; no overlaps when they do not meet, also for planes
/// nearer to parallel than kMinJointAngle. Overlaps shorter than kMinOverlap are left out. Touching
/// only is none. Slits meet in the middle of an overlap, rounded to a µm from where B ends.
Crossing findCrossing(const Shape &shapeA, const Frame &frameA, const Shape &shapeB,
                      const Frame &frameB);

/// Whether slits meet in the middle of the overlap, as they do by themselves.
bool meetsInMiddle(const Overlap &overlap);

/// Pairs (i < j) of boxes that meet, in lexicographic order: sweep along the longest extent.
/// O(n log n + pairs that overlap in the sweep).
std::vector<std::pair<int, int>> meetingPairs(const std::vector<Box3> &boxes);

} // namespace fff
