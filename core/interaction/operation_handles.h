// Handles of the selected operation in the view: where along its track some of its parameters are.
#pragma once

#include "core/interaction/camera.h"
#include "core/model/model.h"

#include <string>
#include <vector>

namespace fff {

struct OperationHandle
{
    OperationId operation;
    std::string key; // of its parameter
    double value = 0.0;
    Vec3 at = Vec3::Zero(); // world, mm

    bool operator==(const OperationHandle &) const = default;
};

struct OperationMarks
{
    std::vector<std::pair<Vec3, double>> track; // as OperationResult has it
    std::vector<OperationHandle> handles;
    int hovered = -1; // index of one, or dragged

    /// The track ends where it begins: a range may go on from its end to its beginning.
    bool isRing() const;
    bool operator==(const OperationMarks &) const = default;
};

/// None where the operation has no track, or its kind no parameters with handles.
OperationMarks operationMarks(const Model &model, OperationId id);
/// The place of a value along a track, and the value of the place that is nearest on the screen.
/// The track has two points at least.
Vec3 placeOnTrack(const std::vector<std::pair<Vec3, double>> &track, double value);
double valueOnTrack(const std::vector<std::pair<Vec3, double>> &track, const Camera &camera,
                    const Vec2 &viewport, const Vec2 &position);
/// Index of the handle that is nearest to a place of the screen, within reach (px); −1: none. Of
/// two at one place, the one that can be drawn away from the other: the first at the track's end,
/// else the last.
int handleAt(const OperationMarks &marks, const Camera &camera, const Vec2 &viewport,
             const Vec2 &position, double reach);

} // namespace fff
