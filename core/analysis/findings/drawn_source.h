// A section that can be edited in place of a copy of it.
#pragma once

#include "core/model/model.h"

#include <Eigen/LU>

#include <optional>

namespace fff {

/// The drawn section that another one is, or is a copy of.
struct DrawnSource
{
    const Section *section = nullptr;
    Eigen::Matrix2d matrix = Eigen::Matrix2d::Identity(); // from its frame to that of the copy
    Vec2 shift = Vec2::Zero();

    /// From the copy's frame coordinates to its own.
    Vec2 placeOf(const Vec2 &onCopy) const { return matrix.inverse() * (onCopy - shift); }
};

/// Nothing of a section that an operation made in another way, and where a person wants it to stay
/// as it is.
std::optional<DrawnSource> drawnSourceOf(const Model &model, std::size_t index);

} // namespace fff
