// Boundaries beside a weak place of a section, pushed out.
#pragma once

#include "core/base/ids.h"
#include "core/model/section.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace fff {

/// A weak place is at least so many thicknesses long: lines of the grid are farther apart than a
/// hair is wide.
inline constexpr double kLeastPlace = 4.0;

/// What would break first, on the section that it was drawn as.
struct WeakNeck
{
    SectionId section;
    double length = 0.0;    // mm
    double thickness = 0.0; // mm
    double use = 0.0;       // of what it may be used, more than 1
    double size() const { return std::max(length, kLeastPlace * thickness); } // mm
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();
    std::vector<std::pair<Vec2, Vec2>> lines; // that one, and those beside it that are weak, too
};

/// Which ends of the neck are pushed out.
enum class NeckSides { Both, First, Last };

/// The section's shape with its neck longer by so much, mm, over all of the weak place. Slits are
/// not looked at. Nothing where an end that is to be pushed out lies in a slit's wall, and where a
/// boundary would cross itself or another one.
std::optional<ShapePointer> grownShape(const Section &section, const WeakNeck &weak,
                                       NeckSides sides, double growth);

} // namespace fff
