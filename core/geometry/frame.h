// Where a section lies: an origin with two orthonormal axes; normal = x × y. World is mm, Y up.
#pragma once

#include "core/base/result.h"
#include "core/geometry/vector.h"

namespace fff {

struct Frame
{
    Vec3 origin = Vec3::Zero();
    Vec3 x = Vec3::UnitX();
    Vec3 y = Vec3::UnitY();

    Vec3 normal() const;
    Vec3 toWorld(const Vec2 &p) const { return origin + p.x() * x + p.y() * y; }
    Vec3 directionToWorld(const Vec2 &d) const { return d.x() * x + d.y() * y; }
    /// Coordinates of the foot of p on the plane.
    Vec2 toLocal(const Vec3 &p) const { return {x.dot(p - origin), y.dot(p - origin)}; }
    Vec2 directionToLocal(const Vec3 &d) const { return {x.dot(d), y.dot(d)}; }
    double height(const Vec3 &p) const { return normal().dot(p - origin); }

    bool operator==(const Frame &other) const;
};

/// The frame with this origin whose x runs along `x` and whose plane contains `y` (Gram-Schmidt).
/// Errors  DegenerateFrame when an axis has no length, both are parallel, or a number is not
/// finite.
Result<Frame> makeFrame(const Vec3 &origin, const Vec3 &x, const Vec3 &y);

/// Too level to tell which way is up in it.
bool isLevel(const Frame &frame);
/// Which way is up in the plane, as an angle from its y, radians; 0 for a level one.
double uprightTurn(const Frame &frame);

} // namespace fff
