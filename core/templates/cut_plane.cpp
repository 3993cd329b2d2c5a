#include "core/templates/cut_plane.h"

#include <CGAL/MP_Float.h>

namespace fff {

Result<CutPlane> makeCutPlane(const Vec3 &origin, const Vec3 &normal)
{
    const double length = normal.stableNorm();
    if (!origin.allFinite() || !normal.allFinite() || !(length > 0.0) || !std::isfinite(length))
        return failure(ErrorCode::DegenerateFrame);
    const Vec3 unit = (normal / length).normalized();
    if (!unit.allFinite() || unit.squaredNorm() == 0.0)
        return failure(ErrorCode::DegenerateFrame);
    return CutPlane{origin, unit};
}

Frame frameOn(const CutPlane &plane)
{
    const Vec3 normal = plane.normal.normalized();
    // Level is what is square to the upward Y; of a plane that lies, x runs along the world's.
    const Vec3 level = Vec3::UnitY().cross(normal);
    constexpr double kLying = 1e-6; // sine of the angle to the ground
    const Vec3 x = level.norm() > kLying ? level.normalized()
                                         : Vec3((Vec3::UnitX() - normal.x() * normal).normalized());
    return {plane.origin, x, normal.cross(x)};
}

int PlaneSides::near(const Vec3 &p) const
{
    const auto isNothing = [this, &p](int i) {
        return m_plane.normal[i] == 0.0 || p[i] == m_plane.origin[i];
    };
    if (isNothing(0) && isNothing(1) && isNothing(2))
        return 0;                 // of planes along the axes, which go through many vertices
    using Exact = CGAL::MP_Float; // needs no library; additions and products of it are exact
    Exact sum(0);
    for (int i = 0; i < 3; ++i)
        sum += Exact(m_plane.normal[i]) * (Exact(p[i]) - Exact(m_plane.origin[i]));
    return static_cast<int>(CGAL::sign(sum));
}

} // namespace fff
