// How the sections of a picture look besides what they are: what the hand and the tools do to them.
#pragma once

#include "ui/view/scene.h"

#include <QString>

namespace fff {
struct Overlay;
}

namespace fff::ui {

class Workbench;

/// A path is begun: as with a stroke, the rest stands back.
bool hasPath(const Overlay &overlay);

/// Which sections are hovered, selected, or stand back. Nothing for a scene that is older than the
/// model: another one comes at once.
void markScene(Scene &scene, const Workbench &bench);

/// Of the section under the cursor. Empty without one, and for the one that is selected alone: its
/// name stands in Properties.
QString nameUnderCursor(const Workbench &bench);

} // namespace fff::ui
