// How a scene is to be shown, whatever is in it.
#pragma once

#include "core/interaction/view_state.h"
#include "ui/view/frame_quality.h"

#include <optional>

namespace fff::ui {

struct RenderOptions
{
    FrameQuality quality = FrameQuality::Full;
    bool isXray = false;           // everything lets light through
    bool hasGround = true;         // grid and shadow
    std::optional<ClipPlane> clip; // cut open, with filled cuts
    double leastStress = 0.2;      // of what a sheet bears: fields of stress show no less
    double stressAlpha = 1.0;      // of these fields

    bool operator==(const RenderOptions &other) const = default;
};

} // namespace fff::ui
