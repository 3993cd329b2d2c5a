#include "core/interaction/camera.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

/// The eye stands this far from the target, mm: beyond anything that a document may hold.
constexpr double kEyeDistance = 8.0 * kMaxCoordinate;
/// Nothing is nearer to the eye of a perspective view than this part of its distance.
constexpr double kNearest = 1e-3;
/// Offset in the camera's plane, mm, of a screen point from the viewport's middle.
Vec2 planeOffset(const Camera &camera, const Vec2 &screen, const Vec2 &viewport)
{
    const Vec2 pixels = screen - 0.5 * viewport;
    return camera.millimetresPerPixel * Vec2(pixels.x(), -pixels.y());
}

Eigen::Quaterniond lookingFrom(const Vec3 &backward)
{
    const Vec3 z = backward.normalized();
    const Vec3 x = Vec3::UnitY().cross(z).normalized();
    Eigen::Matrix3d axes;
    axes << x, z.cross(x), z;
    return Eigen::Quaterniond(axes);
}

} // namespace

double Camera::eyeDistance(const Vec2 &viewport) const
{
    if (!isPerspective())
        return kEyeDistance;
    return 0.5 * millimetresPerPixel * viewport.y() / std::tan(0.5 * kFieldOfView);
}

Vec3 Camera::towardsEye(const Vec3 &world, const Vec2 &viewport) const
{
    return isPerspective() ? Vec3((eye(viewport) - world).normalized()) : backward();
}

double Camera::scaleAt(const Vec3 &world, const Vec2 &viewport) const
{
    if (!isPerspective())
        return millimetresPerPixel;
    const double depth = 1.0 - backward().dot(world - target) / eyeDistance(viewport);
    return millimetresPerPixel * std::max(depth, kNearest);
}

Vec2 Camera::toScreen(const Vec3 &world, const Vec2 &viewport) const
{
    const Vec3 d = world - target;
    return 0.5 * viewport + Vec2(right().dot(d), -up().dot(d)) / scaleAt(world, viewport);
}

Ray Camera::rayThrough(const Vec2 &screen, const Vec2 &viewport) const
{
    const Vec3 point = pointAt(screen, viewport);
    if (!isPerspective())
        return {point + kEyeDistance * backward(), forward()};
    const Vec3 from = eye(viewport);
    return {from, (point - from).normalized()};
}

Vec3 Camera::pointAt(const Vec2 &screen, const Vec2 &viewport) const
{
    const Vec2 offset = planeOffset(*this, screen, viewport);
    return target + offset.x() * right() + offset.y() * up();
}

Camera pinned(Camera camera, const Vec3 &world, const Vec2 &screen, const Vec2 &viewport)
{
    // Only the part of the way that lies in the camera's plane: the depth of the target stays.
    const Vec3 d = world - camera.target;
    const Vec2 offset = planeOffset(camera, screen, viewport) *
                        (camera.scaleAt(world, viewport) / camera.millimetresPerPixel);
    const Vec3 right = camera.right(), up = camera.up();
    camera.target += (right.dot(d) - offset.x()) * right + (up.dot(d) - offset.y()) * up;
    return camera;
}

Camera zoomed(const Camera &camera, double factor, const Vec2 &cursor, const Vec2 &viewport)
{
    if (!(std::isfinite(factor) && factor > 0.0))
        return camera;
    Camera result = camera;
    result.millimetresPerPixel =
        std::clamp(camera.millimetresPerPixel / factor, kFinestScale, kCoarsestScale);
    // Everything nears the point under the cursor; so the eye of a perspective view moves along the
    // cursor's ray, and all that is on it stays under the cursor.
    const Vec3 point = camera.pointAt(cursor, viewport);
    result.target =
        point + result.millimetresPerPixel / camera.millimetresPerPixel * (camera.target - point);
    return result;
}

Camera panned(const Camera &camera, const Vec2 &from, const Vec2 &to, const Vec2 &viewport)
{
    Camera result = camera;
    result.target -= camera.pointAt(to, viewport) - camera.pointAt(from, viewport);
    return result;
}

Camera retargeted(const Camera &camera, const Vec3 &world, const Vec2 &viewport)
{
    Camera result = camera;
    if (!camera.isPerspective()) {
        result.target -= camera.backward().dot(camera.target - world) * camera.backward();
        return result;
    }
    const Vec3 eye = camera.eye(viewport);
    const double part = camera.backward().dot(eye - world) / camera.eyeDistance(viewport);
    const double scale = part * camera.millimetresPerPixel;
    if (!(part > kNearest && scale >= kFinestScale && scale <= kCoarsestScale))
        return camera;
    result.millimetresPerPixel = scale;
    result.target = eye + part * (camera.target - eye);
    return result;
}

Camera turned(const Camera &camera, const Eigen::Quaterniond &orientation, const Vec3 &pivot,
              const Vec2 &viewport)
{
    const Vec2 place = camera.toScreen(pivot, viewport);
    Camera result = retargeted(camera, pivot, viewport);
    result.orientation = orientation;
    result.target = pivot;
    return pinned(result, pivot, place, viewport);
}

Camera orbited(const Camera &camera, const Vec2 &pixels, const Vec3 &pivot, const Vec2 &viewport)
{
    // Half a turn for a drag across the shorter side.
    const double perPixel = std::numbers::pi / std::max(1.0, viewport.minCoeff());
    const Vec2 screen = camera.toScreen(pivot, viewport);

    // Turning by b about the camera's right takes `height`, the angle at which the eye stands
    // above the horizon (measured in the plane of up and backward, so that it has a meaning for a
    // rolled camera too), to height - b. It stops at straight down and up; a camera that starts
    // beyond them may only come back.
    const double height = std::atan2(camera.backward().y(), camera.up().y());
    const double limit = std::max(0.5 * std::numbers::pi, std::abs(height));
    const double wanted = std::clamp(height + perPixel * pixels.y(), -limit, limit);

    Camera result = camera;
    result.orientation = (Eigen::AngleAxisd(-perPixel * pixels.x(), Vec3::UnitY()) *
                          camera.orientation * Eigen::AngleAxisd(height - wanted, Vec3::UnitX()))
                             .normalized();
    result.target =
        pivot + result.orientation * (camera.orientation.conjugate() * Vec3(camera.target - pivot));
    return pinned(result, pivot, screen, viewport);
}

Camera interpolated(const Camera &from, const Camera &to, double u)
{
    if (u <= 0.0)
        return from;
    if (u >= 1.0)
        return to;
    Camera result = to;
    result.target = (1.0 - u) * from.target + u * to.target;
    result.orientation = from.orientation.slerp(u, to.orientation).normalized();
    result.millimetresPerPixel =
        from.millimetresPerPixel * std::pow(to.millimetresPerPixel / from.millimetresPerPixel, u);
    return result;
}

bool orientationOfView(std::string_view name, Eigen::Quaterniond &orientation)
{
    const double quarter = 0.5 * std::numbers::pi;
    const auto aboutY = [](double angle) {
        return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vec3::UnitY()));
    };
    const auto aboutX = [](double angle) {
        return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vec3::UnitX()));
    };
    struct View
    {
        std::string_view name;
        Eigen::Quaterniond orientation;
    };
    const std::array<View, 10> views{{{"front", Eigen::Quaterniond::Identity()},
                                      {"right", aboutY(quarter)},
                                      {"back", aboutY(2.0 * quarter)},
                                      {"left", aboutY(-quarter)},
                                      {"top", aboutX(-quarter)},
                                      {"bottom", aboutX(quarter)},
                                      {"iso1", lookingFrom({1.0, 0.8, 1.0})},
                                      {"iso2", lookingFrom({1.0, 0.8, -1.0})},
                                      {"iso3", lookingFrom({-1.0, 0.8, -1.0})},
                                      {"iso4", lookingFrom({-1.0, 0.8, 1.0})}}};
    const auto found =
        std::find_if(views.begin(), views.end(), [&](const View &v) { return v.name == name; });
    if (found == views.end())
        return false;
    orientation = found->orientation;
    return true;
}

} // namespace fff
