#include "core/geometry/similarity.h"

namespace fff {

Similarity Similarity::inverse() const
{
    const Eigen::Matrix3d back = turn.transpose();
    return {back, 1.0 / scale, -(back * shift) / scale};
}

Similarity Similarity::operator*(const Similarity &first) const
{
    return {turn * first.turn, scale * first.scale, (*this)(first.shift)};
}

Similarity placementOf(const Frame &frame)
{
    Similarity placement;
    placement.turn.col(0) = frame.x;
    placement.turn.col(1) = frame.y;
    placement.turn.col(2) = frame.normal();
    placement.shift = frame.origin;
    return placement;
}

Frame placed(const Frame &frame, const Similarity &placement)
{
    return {placement(frame.origin), placement.turn * frame.x, placement.turn * frame.y};
}

} // namespace fff
