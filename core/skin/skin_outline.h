// The outline of a section as the skin sees it: a closed line in the world, measured along itself.
#pragma once

#include "core/assembly/joint.h"
#include "core/geometry/frame.h"
#include "core/geometry/polygon.h"
#include "core/model/section.h"

#include <vector>

namespace fff {

/// Where an outline passes through the plane of another section.
struct PlaneCrossing
{
    double along = 0.0;  // of the outline, mm
    double at = 0.0;     // of the axis of both planes, mm
    bool leaves = false; // who goes along the axis leaves the section here; else enters it
};

/// The contour as chords of kDrawChord, counter-clockwise; holes are not of the skin.
class SkinOutline
{
public:
    SkinOutline(const Shape &shape, const Frame &frame);

    const Frame &frame() const { return m_frame; }
    double length() const { return m_along.back(); }
    /// along: mm from the first point, of any turn round
    Vec2 at(double along) const;
    Vec3 worldAt(double along) const { return m_frame.toWorld(at(along)); }
    /// Unit, of the chord from `reach` mm before to as much after, 0 < reach.
    Vec2 tangentAt(double along, double reach) const;

    /// In order along the outline. axis: in the outline's plane and that of `other`
    std::vector<PlaneCrossing> crossings(const Frame &other, const Axis &axis) const;
    /// What lies strictly between two places, from < to, as mm along the outline, rising.
    std::vector<double> cornersBetween(double from, double to) const;

private:
    std::size_t edgeAt(double along) const;

    Frame m_frame;
    Polygon m_points;
    std::vector<double> m_along; // n + 1
};

} // namespace fff
