// Where things go in space: turned, mirrored, scaled and shifted alike.
#pragma once

#include "core/geometry/frame.h"

namespace fff {

/// p → scale · turn · p + shift. `turn` is orthogonal: a rotation, or a reflection, which a section
/// follows by its frame alone, since both of its faces are alike.
struct Similarity
{
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    double scale = 1.0;
    Vec3 shift = Vec3::Zero(); // mm

    Vec3 operator()(const Vec3 &p) const { return scale * (turn * p) + shift; }
    Similarity inverse() const;
    /// First the other one.
    Similarity operator*(const Similarity &first) const;

    static Similarity moved(const Vec3 &way) { return {.shift = way}; }
    static Similarity scaled(double scale, const Vec3 &about)
    {
        return {.scale = scale, .shift = (1.0 - scale) * about};
    }
    static Similarity turned(const Eigen::Matrix3d &turn, const Vec3 &about)
    {
        return {.turn = turn, .shift = about - turn * about};
    }
};

/// From the coordinates of a frame (x, y, along its normal) to those of the space that it is in.
Similarity placementOf(const Frame &frame);

/// A reflection keeps the coordinates in the frame; its normal is the other one then.
Frame placed(const Frame &frame, const Similarity &placement);

} // namespace fff
