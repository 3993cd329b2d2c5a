// A camera on its way from one place to another, by the time that events carry.
#pragma once

#include "core/base/easing.h"
#include "core/interaction/camera.h"

namespace fff {

struct CameraAnimation
{
    Camera from, to;
    double start = 0.0;    // ms
    double duration = 0.0; // ms

    bool isOver(double time) const { return time >= start + duration; }
    Camera at(double time) const
    {
        return isOver(time) ? to
                            : interpolated(from, to, easeInOutCubic((time - start) / duration));
    }
};

} // namespace fff
