// Which gesture a press begins (ui/UI.md, section 3): the keys and the button first, then what lies
// under the cursor.
#pragma once

#include "core/interaction/gesture.h"
#include "core/interaction/sight.h"

#include <memory>

namespace fff {

/// Over the view itself: its cube, the numbers of problems, the handle of the cut. Left presses
/// there are nobody else's. Dots of problems take clicks alone: one may draw across them.
bool isOnViewMark(const Sight &sight, const Vec2 &position);

/// The gesture of a press that became a drag. The camera's target comes to the depth of what was
/// pressed, so that pixels count there.
std::unique_ptr<Gesture> gestureFor(const PointerEvent &press, const Sight &sight,
                                    GestureContext &context);

/// The same for whoever only looks: the view is turned, pushed or zoomed, whatever lies there.
std::unique_ptr<Gesture> viewGestureFor(const PointerEvent &press, const Sight &sight,
                                        GestureContext &context);

} // namespace fff
