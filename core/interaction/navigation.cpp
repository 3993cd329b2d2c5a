#include "core/interaction/navigation.h"

namespace fff {

namespace {

DragKind ofLeft(const Modifiers &modifiers)
{
    if (modifiers.space)
        return DragKind::Pan;
    return modifiers.control ? DragKind::Orbit : DragKind::Edit;
}

DragKind ofMiddle(NavigationPreset preset, const Modifiers &modifiers)
{
    if (preset != NavigationPreset::Blender || modifiers.shift)
        return DragKind::Pan;
    return modifiers.control ? DragKind::Zoom : DragKind::Orbit;
}

DragKind ofRight(NavigationPreset preset, const Modifiers &modifiers)
{
    const bool movesWithControl =
        preset == NavigationPreset::FreeCad || preset == NavigationPreset::Onshape;
    return movesWithControl && modifiers.control ? DragKind::Pan : DragKind::Orbit;
}

} // namespace

DragKind dragKind(NavigationPreset preset, Button button, const Modifiers &modifiers)
{
    switch (button) {
    case Button::Middle:
        return ofMiddle(preset, modifiers);
    case Button::Right:
        return ofRight(preset, modifiers);
    case Button::Left:
    case Button::None:
        break;
    }
    return ofLeft(modifiers);
}

bool turnsWithSecondButton(NavigationPreset preset)
{
    return preset == NavigationPreset::FreeCad;
}

} // namespace fff
