// How one section is seen, and from where it is seen well.
#pragma once

#include "core/interaction/camera.h"
#include "core/model/section.h"

#include <optional>

namespace fff {

/// Whether its middle is in the view, and its plane faced (facing.h), from either side.
bool isSeenFaced(const Section &section, const Camera &camera, const Vec2 &viewport);

/// The view straight at it from its nearer side, its middle in the middle, and from farther away
/// where it would reach beyond the view. None where all of it is in the view and faced already.
std::optional<Camera> cameraAtSection(const Section &section, const Camera &camera,
                                      const Vec2 &viewport);

} // namespace fff
