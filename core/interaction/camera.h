// An orthographic camera, as plain math: no window, no OpenGL. Screen points are in pixels with the
// origin at the top left and y down, as Qt has them; the viewport's size is given with each call
// that needs it.
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

struct Camera
{
    Vec3 target = Vec3::Zero(); // shown at the viewport's middle
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity(); // camera axes -> world axes
    double millimetresPerPixel = 0.5;

    Vec3 right() const { return orientation * Vec3::UnitX(); }
    Vec3 up() const { return orientation * Vec3::UnitY(); }
    Vec3 backward() const { return orientation * Vec3::UnitZ(); } // towards the eye
    Vec3 forward() const { return -backward(); }

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
/// Turned as on a turntable: horizontally about the world's Y through `pivot`, vertically about the
/// camera's right; the vertical angle stops at straight up and straight down.
Camera orbited(const Camera &camera, const Vec2 &pixels, const Vec3 &pivot, const Vec2 &viewport);
/// Target and scale so that the box fills the viewport but for a margin; an empty box: the ground's
/// 20 cm.
Camera fitted(const Camera &camera, const Box3 &box, const Vec2 &viewport);
/// Between two cameras, u from 0 to 1: orientation by slerp, scale geometrically.
Camera interpolated(const Camera &from, const Camera &to, double u);

/// Names: front right back left top bottom iso1 iso2 iso3 iso4 (DESIGN.md, "Units and frames").
/// False and untouched when the name is none of them.
bool orientationOfView(std::string_view name, Eigen::Quaterniond &orientation);

} // namespace fff
