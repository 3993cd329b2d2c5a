// The camera of a view, its way to where it was sent, and where it was before.
#pragma once

#include "core/interaction/camera_animation.h"
#include "core/interaction/view_history.h"

#include <optional>

namespace fff {

struct ViewMotion
{
    Camera camera;
    Vec2 viewport{1280.0, 800.0}; // px
    std::optional<CameraAnimation> animation;
    ViewHistory history;
    bool isTouched = false; // until then it follows the viewport's size
    /// As it was fitted; as long as it is still that one, nobody has looked closer.
    std::optional<Camera> fit;

    const Camera &target() const { return animation ? animation->to : camera; }
    bool isAsFitted() const { return fit && *fit == target(); }
    /// Another fit in place of that one: also an animation ends there.
    void refit(const Camera &to);
    /// At once for a duration of 0 ms.
    void animate(const Camera &to, double start, double duration);
    void finish();
    /// True when an animation came to its end.
    bool advance(double time);
};

} // namespace fff
