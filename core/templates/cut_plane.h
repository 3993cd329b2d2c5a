// A plane to cut meshes with, and on which side of it a point lies, exactly.
#pragma once

#include "core/base/result.h"
#include "core/geometry/frame.h"

namespace fff {

struct CutPlane
{
    Vec3 origin = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ(); // of any length but 0

    double height(const Vec3 &p) const { return normal.dot(p - origin); }
    bool operator==(const CutPlane &other) const
    {
        return origin == other.origin && normal == other.normal;
    }
};

/// With a normal of length 1. Errors  DegenerateFrame when it has none, or a number is not finite.
Result<CutPlane> makeCutPlane(const Vec3 &origin, const Vec3 &normal);

/// A frame on the plane with its origin, seen from the normal's tip; x lies level where the plane
/// has one direction that does.
Frame frameOn(const CutPlane &plane);

/// The sign of N·(P − O) for the numbers as they are: 1 on the normal's side, −1 on the other, 0 on
/// the plane. In floating point where that is certain.
class PlaneSides
{
public:
    explicit PlaneSides(const CutPlane &plane) : m_plane(plane) {}

    int of(const Vec3 &p) const
    {
        const double x = m_plane.normal.x() * (p.x() - m_plane.origin.x());
        const double y = m_plane.normal.y() * (p.y() - m_plane.origin.y());
        const double z = m_plane.normal.z() * (p.z() - m_plane.origin.z());
        const double height = x + y + z;
        const double bound = kError * (std::abs(x) + std::abs(y) + std::abs(z)) + kSmallest;
        if (std::abs(height) > bound)
            return height > 0.0 ? 1 : -1;
        return near(p);
    }

private:
    // Each term is rounded twice, and added twice: less than 4 roundings, taken as 8.
    static constexpr double kError = 8.0 * std::numeric_limits<double>::epsilon();
    static constexpr double kSmallest = 16.0 * std::numeric_limits<double>::min(); // underflow

    int near(const Vec3 &p) const;

    CutPlane m_plane;
};

} // namespace fff
