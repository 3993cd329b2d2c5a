#include "core/geometry/frame.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace fff {

namespace {
// Sine of the smallest angle between two axes that still names a plane; below it, rounding decides.
constexpr double kMinAxesSine = 1e-6;
/// A plane that rises by less (sine) counts as level.
constexpr double kLevelSine = 0.02;
} // namespace

Vec3 Frame::normal() const
{
    return x.cross(y);
}

bool Frame::operator==(const Frame &other) const
{
    return origin == other.origin && x == other.x && y == other.y;
}

Result<Frame> makeFrame(const Vec3 &origin, const Vec3 &x, const Vec3 &y)
{
    if (!origin.allFinite() || !x.allFinite() || !y.allFinite())
        return failure(ErrorCode::DegenerateFrame);
    // stableNorm: axes of any magnitude that a double holds are directions.
    const double xLength = x.stableNorm();
    const double yLength = y.stableNorm();
    if (!(xLength > 0.0) || !(yLength > 0.0) || !std::isfinite(xLength) || !std::isfinite(yLength))
        return failure(ErrorCode::DegenerateFrame);
    Frame frame;
    frame.origin = origin;
    frame.x = (x / xLength).normalized();
    const Vec3 towardsY = y / yLength;
    const Vec3 across = towardsY - frame.x.dot(towardsY) * frame.x;
    if (across.norm() < kMinAxesSine)
        return failure(ErrorCode::DegenerateFrame);
    // Twice is enough: the second pass takes away what the first left by rounding.
    frame.y = across.normalized();
    frame.y = (frame.y - frame.x.dot(frame.y) * frame.x).normalized();
    return frame;
}

bool isLevel(const Frame &frame)
{
    return frame.directionToLocal(Vec3::UnitY()).norm() <= kLevelSine;
}

double uprightTurn(const Frame &frame)
{
    const Vec2 up = frame.directionToLocal(Vec3::UnitY());
    return isLevel(frame) ? 0.0 : std::atan2(up.y(), up.x()) - 0.5 * std::numbers::pi;
}

} // namespace fff
