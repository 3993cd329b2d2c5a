// Drags a load without its tool.
#pragma once

#include "core/interaction/load_drag.h"

namespace fff {

class LoadGesture : public Gesture
{
public:
    LoadGesture(const LoadAt &at, const GestureContext &context);

    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    Hint hint() const override;
    Cursor cursor() const override { return Cursor::MoveCross; }

private:
    LoadDrag m_drag;
    std::string m_lockedBy; // the section that keeps it where it is; empty: none does
};

} // namespace fff
