// What dragging a part of the gizmo comes to: a way, an angle or a factor, drawn to round values
// and to other sections.
#pragma once

#include "core/geometry/similarity.h"
#include "core/interaction/alignment.h"
#include "core/interaction/gesture.h"
#include "core/interaction/gizmo.h"

#include <optional>
#include <utility>
#include <vector>

namespace fff {

/// How sections are moved, turned and scaled, all about one point of the world, mm.
struct Transform
{
    Vec3 pivot = Vec3::Zero();
    Vec3 way = Vec3::Zero();
    Vec3 axis = Vec3::UnitY();
    double angle = 0.0; // about the axis, radians
    double factor = 1.0;
    /// Of one section in its plane, along two of its directions; else 1 and 1.
    Vec2 stretch = Vec2::Ones();

    /// Done so many times; without the stretch.
    Similarity times(int count) const;
    bool isNothing() const;
};

class GizmoDrag
{
public:
    /// snaps: what to align with; null: to nothing, and values are not rounded. refs: that move.
    GizmoDrag(Gizmo gizmo, GizmoPart part, const Vec2 &press, const GestureContext &context,
              const std::optional<Alignment> &snaps);

    GizmoPart part() const { return m_part; }
    /// holds: of a way that may go anywhere, only along the nearest of its axes.
    void moveTo(const Vec2 &position, bool holds, const GestureContext &context);

    const Transform &transform() const { return m_transform; }
    /// What it is said to be: mm, radians or a factor.
    double value() const;
    /// From points of what is moved to those with which they are level now.
    const std::vector<std::pair<Vec3, Vec3>> &guides() const { return m_guides; }
    const Gizmo &gizmo() const { return m_gizmo; }

private:
    double along(const Vec3 &axis, const Vec2 &position, const GestureContext &context) const;
    std::optional<double> angleAt(const Vec2 &position, const GestureContext &context) const;
    Vec3 freeWay(const Vec2 &position, const GestureContext &context) const;
    double snappedAlong(std::size_t line, double way, const Vec3 &before, double scale);
    void move(const Vec2 &position, bool holds, const GestureContext &context);
    void turn(const Vec2 &position, const GestureContext &context);
    void scale(const Vec2 &position, const GestureContext &context);

    const Gizmo m_gizmo;
    const GizmoPart m_part;
    const Vec2 m_press;
    const bool m_snaps;
    std::vector<Alignment::Line> m_lines; // along which it moves; none without snapping
    Frame m_plane;                        // of a way that may go anywhere
    double m_turned = 0.0, m_lastAngle = 0.0;
    Transform m_transform;
    std::vector<std::pair<Vec3, Vec3>> m_guides;
};

} // namespace fff
