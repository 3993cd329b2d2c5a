// Draws the view cube (core/interaction/view_cube.h).
#pragma once

#include "core/interaction/view_cube.h"
#include "ui/view/view_style.h"

#include <QPainter>

namespace fff::ui {

/// `lit`: the part under the cursor.
void paintViewCube(QPainter &painter, const Eigen::Quaterniond &orientation, const Vec2 &viewport,
                   const std::optional<CubePart> &lit, const ViewStyle &style);

} // namespace fff::ui
