// Drags a handle of the selected operation along its track.
#pragma once

#include "core/interaction/gesture.h"

namespace fff {

/// Every move starts from the committed document. The value goes in the steps of its field. A
/// handle that comes to another one stays there, so that a range does not turn round; but in a ring
/// it may, and where it is so already.
class OperationGesture : public Gesture
{
public:
    OperationGesture(const OperationMarks &marks, int handle, const PointerEvent &press,
                     const GestureContext &context);

    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    bool marksOperation() const override { return true; }
    Hint hint() const override;
    Cursor cursor() const override { return Cursor::MoveCross; }

private:
    double valueAt(const PointerEvent &event, const GestureContext &context) const;

    OperationMarks m_marks; // as committed
    std::size_t m_handle = 0;
    std::string m_name; // of the operation
    double m_step = 0.0, m_least = 0.0, m_most = 0.0;
    double m_grip = 0.0; // of the press, beside the handle's value
    std::optional<double> m_shown;
    Document m_last; // with the value that is shown
};

} // namespace fff
