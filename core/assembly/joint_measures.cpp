#include "core/assembly/joint_measures.h"

#include <cmath>

namespace fff {

namespace {

/// What is this much longer decides between two axes, so that rounding does not.
constexpr double kLonger = 1e-6;

SlitMeasure measureOf(const JointState &state, bool isA, const Slit &slit)
{
    using Form = SlitMeasure::Form;
    if (slit.role == SlitRole::Tab)
        return {Form::Tab, 0.0, slit.width};
    const double rectangle = (slit.mouth - slit.inner).norm();
    if (!slit.isOpen)
        return {Form::Closed, rectangle, slit.width};
    if (slit.overlap < 0) // beside the axis
        return {Form::Open, rectangle, slit.width};
    const Overlap &o = state.crossing.overlaps[static_cast<std::size_t>(slit.overlap)];
    const int sign = isA ? state.sign : -state.sign;
    // The crossing has intervals in the order of the model.
    const Interval &interval = isA == (state.a < state.b) ? o.a : o.b;
    return {Form::Open, sign > 0 ? interval.to.at - o.meet : o.meet - interval.from.at, slit.width};
}

std::vector<SlitMeasure> measuresOf(const JointState &state, bool isA)
{
    std::vector<SlitMeasure> measures;
    for (const Slit &slit : isA ? state.slitsOfA : state.slitsOfB)
        if (slit.role != SlitRole::Shoulder)
            measures.push_back(measureOf(state, isA, slit));
    return measures;
}

} // namespace

std::vector<SlitMeasure> measuresOfA(const JointState &state)
{
    return measuresOf(state, true);
}

std::vector<SlitMeasure> measuresOfB(const JointState &state)
{
    return measuresOf(state, false);
}

NearestAxis nearestAxis(const Vec3 &direction)
{
    int nearest = 1;
    for (const int axis : {0, 2})
        if (std::abs(direction[axis]) > std::abs(direction[nearest]) + kLonger)
            nearest = axis;
    return {nearest, direction[nearest] > 0.0};
}

std::optional<Openings> openingsOfB(const JointState &state)
{
    if (state.sign == 0)
        return {};
    const Vec3 now = state.openingOfB();
    if (nearestAxis(now).isPositive)
        return Openings{{now, -now}, 0};
    return Openings{{-now, now}, 1};
}

} // namespace fff
