// The handles with which sections are moved, turned and scaled: arrows, rings and boxes round a
// point, of one size on the screen.
#pragma once

#include "core/interaction/camera.h"
#include "core/model/model.h"
#include "core/model/template.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace fff {

enum class GizmoPart {
    None,
    MoveX, // along its axes
    MoveY,
    MoveZ,
    MoveFree, // in its plane, or facing the eye
    TurnX,    // about its axes
    TurnY,
    TurnZ,
    ScaleX, // along its axes
    ScaleY,
    ScaleAll
};

/// The axis of a part, 0 … 2; −1 for one that has none.
int axisOf(GizmoPart part);
bool isTurn(GizmoPart part);
bool isScale(GizmoPart part);

struct Gizmo
{
    /// Of one section: its plane, x and y as they lie in it, y the more upright one as it is seen;
    /// of one that is held by another one, one of them is that one's normal, so that moves along
    /// the other one and z keep it on its face. In space: the world's axes.
    Frame frame;
    bool isInSpace = false;
    std::vector<GizmoPart> parts; // that it has; none: nothing can be moved

    Vec3 axis(int index) const
    {
        return index == 0 ? frame.x : index == 1 ? frame.y : frame.normal();
    }
    bool has(GizmoPart part) const;
    bool operator==(const Gizmo &other) const = default;
};

/// Of these sections, of which each has an origin (core/model/origin.h). A single one that is held
/// by what it is on (Parent::isFree) stands on the middle of its slit, and has no ring that would
/// tilt it; all else on the middle of the sections. In the plane there is it for a single one only.
/// orientation: of the camera, for which way x goes.
Gizmo gizmoOf(const Model &model, const std::vector<SectionRef> &sections, bool isInSpace,
              const Eigen::Quaterniond &orientation);
/// Of a template, on its middle. What is flat is moved along its own axes, and turned and scaled in
/// its plane, which it leaves only where it lies on no section; a mesh along the world's axes, and
/// turned about all of them. None of one that is not read, or whose section is not there.
Gizmo gizmoOf(const Model &model, const Template &one, const Eigen::Quaterniond &orientation);

/// As it is drawn.
struct GizmoMarks
{
    Gizmo gizmo;
    GizmoPart lit = GizmoPart::None; // hovered, or dragged
    struct Value
    {
        double number = 0.0; // mm, radians or a factor, as the lit part has it
        bool operator==(const Value &) const = default;
    };
    std::optional<Value> value = {}; // while it is dragged
    /// From points of what is moved to those with which they are level.
    std::vector<std::pair<Vec3, Vec3>> guides = {};
    int copies = 0; // that are left behind

    bool operator==(const GizmoMarks &other) const = default;
};

/// Sizes on the screen, px.
inline constexpr double kGizmoArrow = 84.0, kGizmoRing = 58.0, kGizmoBox = 104.0, kGizmoDisc = 8.0;
inline constexpr int kRingSides = 64;

/// How a gizmo is seen: where its parts are on the screen, px.
class GizmoLook
{
public:
    GizmoLook(const Gizmo &gizmo, const Camera &camera, const Vec2 &viewport);

    /// What is seen too much on end to be held is not there.
    bool isSeen(GizmoPart part) const;
    Vec2 centre() const { return m_centre; }
    /// Of an arrow.
    Vec2 tip(int axis) const { return at(kGizmoArrow, axis); }
    /// Of a box; of ScaleAll between those of x and y, in space to the right and up.
    Vec2 box(GizmoPart part) const;
    /// A closed line.
    std::vector<Vec2> ring(int axis) const;
    /// Nearest to the place within reach, boxes and arrows before rings; None: nothing is.
    GizmoPart partAt(const Vec2 &position, double reach) const;

private:
    Vec2 at(double distance, int axis) const;

    const Gizmo &m_gizmo;
    const Camera &m_camera;
    const Vec2 m_viewport;
    double m_scale; // mm per px at its middle
    Vec2 m_centre;
    std::array<double, 3> m_facing; // |cosine| between axes and the line of sight
};

} // namespace fff
