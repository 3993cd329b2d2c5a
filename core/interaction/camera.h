// A camera, orthographic or perspective, as plain math: no window, no OpenGL. Screen points are in
// pixels with the origin at the top left and y down, as Qt has them; the viewport's size is given
// with each call that needs it.
#pragma once

#include "core/geometry/vector.h"

#include <Eigen/Geometry>
#include <string_view>

namespace fff {

struct Ray
{
    Vec3 origin;    // on the near side of everything
    Vec3 direction; // unit, away from the eye
};

enum class Projection { Orthographic, Perspective };

struct Camera
{
    Vec3 target = Vec3::Zero(); // shown at the viewport's middle
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity(); // camera axes -> world axes
    double millimetresPerPixel = 0.5; // at the target's depth, so that a switch keeps its size
    Projection projection = Projection::Orthographic;

    Vec3 right() const { return orientation * Vec3::UnitX(); }
    Vec3 up() const { return orientation * Vec3::UnitY(); }
    Vec3 backward() const { return orientation * Vec3::UnitZ(); } // towards the eye
    Vec3 forward() const { return -backward(); }

    bool isPerspective() const { return projection == Projection::Perspective; }
    /// The very same view.
    bool operator==(const Camera &other) const
    {
        return target == other.target && orientation.coeffs() == other.orientation.coeffs() &&
               millimetresPerPixel == other.millimetresPerPixel && projection == other.projection;
    }
    /// From the target back to the eye, mm. In an orthographic view, far beyond everything.
    double eyeDistance(const Vec2 &viewport) const;
    Vec3 eye(const Vec2 &viewport) const { return target + eyeDistance(viewport) * backward(); }
    /// Unit, from a world point to the eye.
    Vec3 towardsEye(const Vec3 &world, const Vec2 &viewport) const;
    /// mm per pixel at the depth of a world point; of one behind the eye, as if it stood just
    /// before it.
    double scaleAt(const Vec3 &world, const Vec2 &viewport) const;

    Vec2 toScreen(const Vec3 &world, const Vec2 &viewport) const;
    Ray rayThrough(const Vec2 &screen, const Vec2 &viewport) const;
    /// The world point under `screen` in the plane through `target` that faces the eye.
    Vec3 pointAt(const Vec2 &screen, const Vec2 &viewport) const;
};

/// The camera moved in its own plane so that `world` is seen at `screen`.
Camera pinned(Camera camera, const Vec3 &world, const Vec2 &screen, const Vec2 &viewport);
/// Zoomed by `factor` (> 1 is nearer) about the point under the cursor.
Camera zoomed(const Camera &camera, double factor, const Vec2 &cursor, const Vec2 &viewport);
/// Moved so that what was under `from` is under `to`.
Camera panned(const Camera &camera, const Vec2 &from, const Vec2 &to, const Vec2 &viewport);
/// The same picture with the target at the depth of `world`, where pixels count from then on:
/// zooming comes up to it, panning keeps it under the cursor. Unchanged when it is behind the eye.
Camera retargeted(const Camera &camera, const Vec3 &world, const Vec2 &viewport);
/// Turned to an orientation; `pivot` keeps its place and size on the screen and gives the target
/// its depth.
Camera turned(const Camera &camera, const Eigen::Quaterniond &orientation, const Vec3 &pivot,
              const Vec2 &viewport);
/// Turned as on a turntable: horizontally about the world's Y through `pivot`, vertically about the
/// camera's right; the vertical angle stops at straight up and straight down. The pivot keeps its
/// place on the screen and its distance from the eye.
Camera orbited(const Camera &camera, const Vec2 &pixels, const Vec3 &pivot, const Vec2 &viewport);
/// Between two cameras, u from 0 to 1: orientation by slerp, scale geometrically, the projection
/// that of `to`.
Camera interpolated(const Camera &from, const Camera &to, double u);

/// Names: front right back left top bottom iso1 iso2 iso3 iso4 (DESIGN.md, "Units and frames").
/// False and untouched when the name is none of them.
bool orientationOfView(std::string_view name, Eigen::Quaterniond &orientation);

/// Scales that zooming and fitting do not leave, mm per px.
inline constexpr double kFinestScale = 1e-5, kCoarsestScale = 1e4;
/// Vertical angle of a perspective view, radians (30°): that of a person before a desk.
inline constexpr double kFieldOfView = 0.5235987755982988;

} // namespace fff
