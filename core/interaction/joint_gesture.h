// Drags the place where the slits of a joint meet, along its axis.
#pragma once

#include "core/assembly/joint_editing.h"
#include "core/interaction/gesture.h"
#include "core/interaction/joint_marks.h"

namespace fff::hints {

inline constexpr Text kMovingMeetingPoint = FFF_TEXT(
    "Hint", "Release to leave it here: the slit of %1 takes %2\u202f%. <kbd>Esc</kbd> cancels.");

} // namespace fff::hints

namespace fff {

/// Every move starts from the committed document. The place is told in whole percents of the
/// overlap, as it is in the fields. What cannot be moved stays, and says why.
class JointGesture : public Gesture
{
public:
    JointGesture(const JointMark &mark, const PointerEvent &press, GestureContext &context);

    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    Hint hint() const override;
    Cursor cursor() const override { return Cursor::Hand; }
    bool marksJoints() const override { return true; }

private:
    /// mm along the axis, of the place of it that is nearest to the cursor; none where one looks
    /// along it.
    std::optional<double> along(const Vec2 &position, const GestureContext &context) const;
    void show(const Model &model, Overlay &overlay) const;

    JointRef m_joint;
    int m_overlap = 0;
    std::optional<JointState> m_state; // as committed
    std::string m_nameA, m_nameB;
    double m_grip = 0.0; // of the press, mm from the meeting point
    double m_share = 0.5;
    std::optional<EditedJoint> m_last; // the newest
    double m_shown = -1.0;             // the share that it has
};

} // namespace fff
