#include "core/geometry/placement.h"

namespace fff {

Placement Placement::inverse() const
{
    const Eigen::Matrix3d back = turn.transpose();
    return {back, 1.0 / scale, -(back * shift) / scale};
}

Placement Placement::operator*(const Placement &first) const
{
    return {turn * first.turn, scale * first.scale, (*this)(first.shift)};
}

Frame placed(const Frame &frame, const Placement &placement)
{
    return {placement(frame.origin), placement.turn * frame.x, placement.turn * frame.y};
}

} // namespace fff
