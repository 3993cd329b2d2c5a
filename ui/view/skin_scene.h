// The skin of a model in a scene.
#pragma once

#include "ui/view/template_painter.h"

namespace fff::ui {

/// As sections are seen through it. mesh: in the world, mm; never null
SceneTemplate sceneSkin(TemplateMeshPointer mesh);

} // namespace fff::ui
