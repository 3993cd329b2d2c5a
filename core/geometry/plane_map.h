// How the plane of a section is stretched.
#pragma once

#include "core/geometry/stretch_band.h"

#include <optional>

namespace fff {

/// A map of a section's own plane, frame coordinates, mm: p → about + matrix (p − about), or, in
/// place of that, what a band makes of it.
struct PlaneMap
{
    Eigen::Matrix2d matrix = Eigen::Matrix2d::Identity();
    Vec2 about = Vec2::Zero();
    std::optional<StretchBand> band = {};

    Vec2 operator()(const Vec2 &p) const
    {
        return band ? (*band)(p) : Vec2(about + matrix * (p - about));
    }
    bool isIdentity() const { return !band && matrix == Eigen::Matrix2d::Identity(); }

    /// About the frame's origin.
    static PlaneMap scaled(double scale) { return {.matrix = scale * Eigen::Matrix2d::Identity()}; }
};

} // namespace fff
