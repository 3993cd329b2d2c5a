// One outline among others that stay where they are, slid along an axis: how somebody's hand finds
// the nearest place where it is just as far from them as it has to be.
#pragma once

#include "core/geometry/polygon.h"
#include "core/nesting/posed.h"

#include <optional>
#include <span>
#include <vector>

namespace fff::nest {

class Sliding
{
public:
    /// outline  where `by` is zero
    /// others   where they lie
    /// apart    mm, between it and each of them, above a few steps of kClipGrid; it keeps so much
    ///          off and up to kSlidingSlack more
    Sliding(const Region &outline, std::span<const Region> others, double apart);

    /// Whether it has its distance from all.
    bool isFree(const Vec2 &by) const;
    /// The shortest way along one axis to where it is free, mm; none that is as short as `most`.
    std::optional<Vec2> wayOut(const Vec2 &by, double most) const;
    /// Where it is free: the shortest way along that axis, either way, to where it comes as near to
    /// another one as it may; none within `most`. axis: 0 or 1
    std::optional<double> wayTo(const Vec2 &by, int axis, double most) const;

private:
    std::optional<double> wayOut(const Vec2 &by, int axis, bool isForward, double most) const;

    Posed m_outline; // grown by that distance
    std::vector<Posed> m_others;
};

/// mm
inline constexpr double kSlidingSlack = 2e-3;

} // namespace fff::nest
