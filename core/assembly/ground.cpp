#include "core/assembly/ground.h"

#include <Eigen/Geometry>

namespace fff {

Vec3 Ground::acrossX() const
{
    return Eigen::Quaterniond::FromTwoVectors(Vec3::UnitY(), up) * Vec3::UnitX();
}

Vec3 Ground::acrossZ() const
{
    return Eigen::Quaterniond::FromTwoVectors(Vec3::UnitY(), up) * Vec3::UnitZ();
}

} // namespace fff
