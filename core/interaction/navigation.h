// Which button and keys turn, move and zoom the view: this program's own way and those that people
// know from others.
#pragma once

#include "core/interaction/pointer_event.h"

namespace fff {

/// What a drag with a button does. Edit: what lies under the cursor decides (ui/UI.md, section 3).
enum class DragKind { Edit, Orbit, Pan, Zoom };

enum class NavigationPreset { FlatFitFab, Blender, FreeCad, Onshape };

/// In all presets Ctrl+left turns and Space+left moves the view, for trackpads and mice with one
/// button, and the wheel zooms to the cursor.
///
///     FlatFitFab  right turns, middle moves
///     Blender     middle turns, Shift+middle moves, Ctrl+middle zooms; right turns too
///     FreeCad     (its CAD navigation) middle moves, middle with left turns; Shift+right turns,
///                 Ctrl+right moves; right alone turns too
///     Onshape     right turns, middle or Ctrl+right moves
DragKind dragKind(NavigationPreset preset, Button button, const Modifiers &modifiers);

/// Whether the left button, pressed while a drag with the middle one moves the view, makes it turn
/// until it is released.
bool turnsWithSecondButton(NavigationPreset preset);

} // namespace fff
