// Sheets of a stock besides whole ones: of another size, or what is left of one that was cut
// before.
#pragma once

#include "core/base/result.h"
#include "core/geometry/outlines.h"
#include "core/model/shape.h"

#include <optional>

namespace fff {

struct SpareSheet
{
    ShapePointer shape; // mm, the lower left of its box at (0, 0); of any outline, with holes
    int count = 1;      // how many of it there are

    /// Same outlines.
    bool operator==(const SpareSheet &other) const;
    Vec2 size() const { return shape->bounds().size(); }
};

/// What is more is nonsense: so many kinds, so many sheets of all of them.
inline constexpr std::size_t kMostSpareKinds = 100;
inline constexpr int kMostSpares = 1000;

/// Errors  EmptyContour, BadValue where no shape is so small, or so large.
Result<SpareSheet> rectangularSheet(const Vec2 &size, int count = 1);
/// Where it lies does not matter. Errors  as Shape::make(); BadContour where it touches itself.
Result<SpareSheet> spareSheet(const Outline &outline, int count = 1);

/// Width and height of one that has nothing but four square corners, along the axes.
std::optional<Vec2> rectangleOf(const SpareSheet &sheet);
/// It can be laid on: a shape in its place, some of it.
bool isUsable(const SpareSheet &sheet);

} // namespace fff
