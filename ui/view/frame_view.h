// How one frame is looked at, worked out once for all that draws in it.
#pragma once

#include "core/interaction/camera.h"
#include "core/interaction/view_state.h"

#include <Eigen/Core>

#include <optional>

namespace fff::ui {

struct FrameView
{
    Camera camera;
    Vec2 viewport = Vec2::Ones();                         // device-independent pixels
    Vec2 pixels = Vec2::Ones();                           // those that are drawn
    Eigen::Matrix4d toClip = Eigen::Matrix4d::Identity(); // world to clip space
    std::optional<ClipPlane> clip;

    /// Drawn pixels a device-independent one.
    double ratio() const { return pixels.x() / viewport.x(); }
    /// Towards the eye: a direction (w = 0) in an orthographic view, the eye's place (w = 1) in a
    /// perspective one.
    Eigen::Vector4d eye() const
    {
        const Vec3 at = camera.isPerspective() ? camera.eye(viewport) : camera.backward();
        return {at.x(), at.y(), at.z(), camera.isPerspective() ? 1.0 : 0.0};
    }
};

} // namespace fff::ui
