// What a person reads of a joint: how deep and wide its slits are, and which way they may open.
#pragma once

#include "core/assembly/joint_state.h"

#include <array>

namespace fff {

struct SlitMeasure
{
    enum class Form { Open, Closed, Tab };

    Form form = Form::Open;
    double length = 0.0; // mm: how deep an open one is, or a closed one from end to end; a tab: 0
    double width = 0.0;  // mm
};

/// One for each slit of a, or of b, in their order; shoulders, which hold nothing, have none. The
/// depth of a slit is from the contour to where it meets the other one, as far as its axis tells.
std::vector<SlitMeasure> measuresOfA(const JointState &state);
std::vector<SlitMeasure> measuresOfB(const JointState &state);

/// The world's axis that a direction is nearest to: upwards before sideways where two are as near.
struct NearestAxis
{
    int axis = 1; // 0 … 2
    bool isPositive = true;
};
NearestAxis nearestAxis(const Vec3 &direction);

/// Where the slits of b may open to; those of a open to the other side.
struct Openings
{
    /// Unit vectors of the world; the first one is along a world's axis rather than against it.
    std::array<Vec3, 2> ways;
    std::size_t current = 0;
};
/// Nothing where there is no side.
std::optional<Openings> openingsOfB(const JointState &state);

} // namespace fff
