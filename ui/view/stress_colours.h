// What colour a stress has.
#pragma once

#include <QColor>

namespace fff::ui {

/// Of what a sheet bears: the colours begin here, evenly spaced up to 1.
inline constexpr double kFirstStressColour = 0.2;
inline constexpr int kStressColours = 5;

/// From 20 % to 100 % of what the sheet bears: from blue to red, or from yellow to dark blue.
QColor stressColour(double use, bool isForColourBlind);

} // namespace fff::ui
