// Points and directions. Columns of Eigen; mm unless said otherwise.
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <vector>

namespace fff {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

/// z of the cross product: positive when b is counter-clockwise of a.
inline double cross(const Vec2 &a, const Vec2 &b)
{
    return a.x() * b.y() - a.y() * b.x();
}
/// a turned counter-clockwise by a right angle.
inline Vec2 perpendicular(const Vec2 &a)
{
    return {-a.y(), a.x()};
}

struct Box2
{
    Vec2 min = Vec2::Constant(std::numeric_limits<double>::infinity());
    Vec2 max = Vec2::Constant(-std::numeric_limits<double>::infinity());

    void extend(const Vec2 &p)
    {
        min = min.cwiseMin(p);
        max = max.cwiseMax(p);
    }
    void extend(const Box2 &b)
    {
        min = min.cwiseMin(b.min);
        max = max.cwiseMax(b.max);
    }
    bool isEmpty() const { return !(min.x() <= max.x()); }
    /// On its edge is inside.
    bool contains(const Vec2 &p) const
    {
        return (p.array() >= min.array()).all() && (p.array() <= max.array()).all();
    }
    bool intersects(const Box2 &b) const
    {
        return (min.array() <= b.max.array()).all() && (b.min.array() <= max.array()).all();
    }
    Vec2 size() const { return max - min; }
    Vec2 center() const { return 0.5 * (min + max); }
};

struct Box3
{
    Vec3 min = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 max = Vec3::Constant(-std::numeric_limits<double>::infinity());

    void extend(const Vec3 &p)
    {
        min = min.cwiseMin(p);
        max = max.cwiseMax(p);
    }
    void extend(const Box3 &b)
    {
        min = min.cwiseMin(b.min);
        max = max.cwiseMax(b.max);
    }
    bool isEmpty() const { return !(min.x() <= max.x()); }
    Vec3 size() const { return max - min; }
    Vec3 center() const { return 0.5 * (min + max); }
    bool intersects(const Box3 &b) const
    {
        return (min.array() <= b.max.array()).all() && (b.min.array() <= max.array()).all();
    }
};

} // namespace fff
