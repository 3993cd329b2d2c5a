// A plane stretched between two of its places, along the line from one to the other: what lies
// before the first and behind the second is only moved. Where it is mirrored, the same happens on
// the other side of a line across that.
#pragma once

#include "core/geometry/contour.h"

#include <optional>

namespace fff {

/// A map of the plane, mm. `from` and `to` differ; afterwards they are `length` (> 0) apart.
struct StretchBand
{
    Vec2 from = Vec2::Zero(), to = Vec2::UnitX();
    double length = 1.0;
    Vec2 stays = Vec2::Zero(); // which is where it was
    /// On the line to which all is symmetric, across `along`; none of the two places is beyond it.
    std::optional<Vec2> mirroredAt = {};

    Vec2 operator()(const Vec2 &p) const;
    /// By so much all of the box is moved; nothing where some of it is stretched.
    std::optional<Vec2> shiftOf(const Box2 &box) const;

    /// 0 … 1: of the way from the first place to the second, of a place beyond the line of its
    /// image.
    double shareAt(const Vec2 &p) const;
    Vec2 along() const { return (to - from).normalized(); }
    /// How many times as long lines along it become between the two places.
    double factor() const { return length / (to - from).norm(); }

private:
    bool isBeyond(const Vec2 &p) const;
    Vec2 wayOf(const Vec2 &p) const;
};

/// Anchors where the map puts them, with handles that are stretched as the plane is around them: a
/// smooth point stays smooth, a line one. Errors  as Contour::fromPoints().
Result<Contour> mapped(const Contour &contour, const StretchBand &band);

} // namespace fff
