// Drags control points, a handle or a piece of the contour of one section.
#pragma once

#include "core/interaction/gesture.h"
#include "core/interaction/point_editing.h"
#include "core/interaction/point_sight.h"
#include "core/interaction/template_guides.h"

namespace fff {

/// A point that comes near to where the plane cuts a template is caught by that, and on it by where
/// planes of other sections cross it (kSnapReach), as long as Snap is on.
///
/// Every move starts from the committed shape. What would cross itself is not shown: the drag stays
/// at the last place where the shape was whole, and says so. Ctrl: anchors leave their handles
/// where they are, and a handle its opposite one. Shift: anchors move along one axis of the frame,
/// a handle along its direction, a piece of the contour square to it.
class PointGesture : public Gesture
{
public:
    /// A point that is not selected is taken alone, else all that are selected move with it.
    PointGesture(const PointTarget &target, const PointerEvent &press, const SectionRef &section,
                 const GestureContext &context);

    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    bool marksPoints() const override { return true; }
    Hint hint() const override;
    Cursor cursor() const override { return Cursor::MoveCross; }

private:
    PointEdit edited(const Vec2 &by, bool breaks, const Document &document,
                     const PointRules &rules) const;
    Vec2 straightened(const Vec2 &by) const;
    Vec2 drawnTo(const Vec2 &by, const GestureContext &context);

    /// What the newest move asked for.
    struct Shown
    {
        Vec2 by;
        bool breaks = false;
    };

    PointTarget m_target;
    Document m_document;               // that every move starts from
    std::optional<Halfplane> m_mirror; // of a section that is symmetric
    SectionId m_section;
    std::string m_name; // of the section
    ShapePointer m_shape;
    Frame m_frame;
    TemplateGuides m_guides;
    std::optional<SnapTargets> m_targets;        // on them; without Snap none
    Snap m_snap;                                 // that the newest move was caught by
    std::vector<PointAddress> m_before, m_moved; // selected
    Vec2 m_pressed = Vec2::Zero();               // frame coordinates
    std::optional<EditedPoints> m_last;          // the newest that is whole
    std::optional<Shown> m_shown;
    std::optional<Hint> m_refusal; // of the newest move
};

} // namespace fff
