// How the view comes to look at the canvas of a stroke: turned about the slit's end, which stays
// under the cursor, then moved to where there is room to draw.
#pragma once

#include "core/geometry/frame.h"
#include "core/interaction/camera.h"

namespace fff {

/// The canvas of a new slit on a section: origin at the slit's start, x along it, y along the
/// section's normal, to the side from which the canvas is looked at; and the view of it.
class CanvasTurn
{
public:
    /// ground: the section's frame; the slit from → to in its coordinates, not of length 0.
    /// angle: between the section and the line of sight at the end, radians; a right angle sees the
    /// canvas frontoparallel, less leaves the side of the section to be seen that is seen now.
    CanvasTurn(const Camera &now, const Frame &ground, const Vec2 &from, const Vec2 &to,
               double angle, const Vec2 &viewport);

    const Frame &canvas() const { return m_canvas; }
    /// The view after a part of the turn, 0 … 1, with the slit's end under the cursor (px).
    Camera at(double progress, const Vec2 &cursor, const Vec2 &viewport) const;

private:
    Frame m_canvas;
    Vec3 m_slitEnd;
    Camera m_from, m_to;
};

/// Moves a view so that a slit comes away from the viewport's edge. The cursor stays in the dead
/// zone: where it would get out, the view waits for it to follow.
struct RoomPan
{
    Frame canvas;            // origin at the slit's start, x along it
    double slitLength = 0.0; // mm
    double deadZone = 0.0;   // radius, mm
    double speed = 0.0;      // px a ms; infinite: jumps

    /// The view after so many ms more with the cursor at rest. Steps of time add up: two short
    /// ones come to where the long one comes.
    Camera after(double elapsed, Camera camera, const Vec2 &cursor, const Vec2 &viewport) const;
    /// px from where the slit is seen to where it shall be; zero when there is room enough.
    Vec2 way(const Camera &camera, const Vec2 &viewport) const;
};

} // namespace fff
