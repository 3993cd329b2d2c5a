// How the view comes to look at the canvas of a stroke: turned about the slit's end, which stays
// under the cursor, unless the canvas is faced as it is (facing.h), then moved to where there is
// room to draw.
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
    /// False: the canvas is faced already, and the view stays as it is.
    bool isTurning() const { return m_isTurning; }
    /// To the right in the view that it ends with.
    Vec3 right() const { return m_to.right(); }
    /// Where it begins.
    const Camera &view() const { return m_from; }
    /// The view after a part of the turn, 0 … 1, with the slit's end under the cursor (px).
    Camera at(double progress, const Vec2 &cursor, const Vec2 &viewport) const;

private:
    Frame m_canvas;
    Vec3 m_slitEnd;
    Camera m_from, m_to;
    bool m_isTurning = true;
};

/// The rest of a turn for a hand that does not wait: soon over, and the slit's end goes back to
/// where the hand left it, under what is drawn since.
struct QuickTurn
{
    CanvasTurn turn;
    double progress = 0.0;          // of the turn when it began
    Vec2 from = Vec2::Zero();       // where the slit's end was seen then, px
    Vec2 pin = Vec2::Zero();        // and shall be
    double start = 0.0, time = 0.0; // it begins, and lasts; ms

    double end() const { return start + time; }
    Camera at(double now, const Vec2 &viewport) const;
    /// The view that it ends with: what the hand draws meanwhile is meant as seen in there.
    Camera ended(const Vec2 &viewport) const { return turn.at(1.0, pin, viewport); }
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
