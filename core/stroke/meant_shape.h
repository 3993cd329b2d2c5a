// What a hand meant that drew nearly a circle, an ellipse, straight lines or right angles.
#pragma once

#include "core/geometry/contour.h"
#include "core/geometry/figure.h"
#include "core/geometry/mirror_axis.h"

#include <optional>

namespace fff {

struct MeantShape
{
    enum class Kind { Circle, Ellipse, StraightLines, RightAngles };

    Kind kind = Kind::Circle;
    std::optional<Figure> figure; // of a circle and an ellipse, to a tenth of a mm
    Contour contour;              // in place of the drawn one, free of crossings
};

/// None where nothing is to be made better, or nothing of this kind was meant:
///   - a circle lies within a few per cent of its radius about the line, everywhere, and the line
///     is not clearly longer one way; an ellipse the same, and not as slim as a needle. Neither has
///     a corner or a bay. A blob or an egg is off by more;
///   - straight lines run from corner to corner, bent by a few per cent at most. Those that are
///     lines already are none to be offered;
///   - right angles are corners between two such lines that are off by kNearlyRight at most. All
///     lines that nearly lie along or across each other do so then, and level where they nearly
///     are. Corners go to where the lines meet; curves stay, but for the end that such a line has.
///
/// drawn      free of crossings, canvas coordinates; tolerance: that it was fitted to, mm
/// axis       of what was mirrored across it: what was meant is the same on both of its sides, too
std::optional<MeantShape> meantShape(const Contour &drawn, double tolerance,
                                     const std::optional<MirrorAxis> &axis = {});

inline constexpr double kNearlyRight = 0.24; // radians

} // namespace fff
