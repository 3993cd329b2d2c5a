#include "core/interaction/view_cube.h"

#include "core/interaction/camera.h"

#include <cmath>

namespace fff {

namespace {

constexpr double kMargin = 10.0;        // px to the view's edges
constexpr double kSmallestView = 240.0; // px; a smaller one has no cube
constexpr double kEdgeZone = 0.30;      // of half an edge, from its end, that belongs to the edge
constexpr double kCornerHeight = 0.8;   // of the eye, as in iso1 … iso4
constexpr double kFacing = 1e-6;        // cosine from which on a face is seen

struct FaceAxes
{
    CubePart part;
    const char *name;
    Vec3 right, up; // of its letters
};

const std::array<FaceAxes, 6> &faces()
{
    static const std::array<FaceAxes, 6> all{
        {{{0, 0, 1}, "front", Vec3::UnitX(), Vec3::UnitY()},
         {{1, 0, 0}, "right", -Vec3::UnitZ(), Vec3::UnitY()},
         {{0, 0, -1}, "back", -Vec3::UnitX(), Vec3::UnitY()},
         {{-1, 0, 0}, "left", Vec3::UnitZ(), Vec3::UnitY()},
         {{0, 1, 0}, "top", Vec3::UnitX(), -Vec3::UnitZ()},
         {{0, -1, 0}, "bottom", Vec3::UnitX(), Vec3::UnitZ()}}};
    return all;
}

Vec3 direction(const CubePart &part)
{
    return {static_cast<double>(part.x), static_cast<double>(part.y), static_cast<double>(part.z)};
}

const FaceAxes &axesOf(const CubePart &face)
{
    for (const FaceAxes &axes : faces()) {
        if (axes.part == face)
            return axes;
    }
    return faces().front();
}

/// Part of a face that rounding may take from it: no gap opens between two of them.
constexpr double kRounding = 1e-6;

/// -1, 0 or 1: the zone of a coordinate that runs from -1 to 1 over a face.
int zone(double u)
{
    return u > 1.0 - kEdgeZone ? 1 : u < kEdgeZone - 1.0 ? -1 : 0;
}

CubePart partOf(const Vec3 &sides)
{
    return {static_cast<int>(std::lround(sides.x())), static_cast<int>(std::lround(sides.y())),
            static_cast<int>(std::lround(sides.z()))};
}

} // namespace

std::optional<Vec2> cubeCentre(const Vec2 &viewport)
{
    if (viewport.minCoeff() < kSmallestView)
        return {};
    return Vec2(viewport.x() - kMargin - 0.5 * kCubeRoom, kMargin + 0.5 * kCubeRoom);
}

std::vector<CubeFace> visibleFaces(const Eigen::Quaterniond &orientation, const Vec2 &viewport)
{
    std::vector<CubeFace> result;
    const std::optional<Vec2> centre = cubeCentre(viewport);
    if (!centre)
        return result;
    const Eigen::Quaterniond toView = orientation.conjugate();
    const auto onScreen = [&](const Vec3 &v) {
        const Vec3 seen = toView * v;
        return Vec2(0.5 * kCubeEdge * Vec2(seen.x(), -seen.y()));
    };
    for (const FaceAxes &face : faces()) {
        const Vec3 normal = direction(face.part);
        if ((toView * normal).z() > kFacing)
            result.push_back(
                {face.part, *centre + onScreen(normal), onScreen(face.right), onScreen(face.up)});
    }
    return result;
}

std::optional<std::array<Vec2, 4>> partOnFace(const CubeFace &face, const CubePart &part)
{
    const FaceAxes &axes = axesOf(face.part);
    const Vec3 sides = direction(part);
    if (sides.dot(direction(face.part)) < 0.5)
        return {};
    const auto range = [](double side) {
        const double inner = 1.0 - kEdgeZone;
        return side > 0.5    ? std::pair(inner, 1.0)
               : side < -0.5 ? std::pair(-1.0, -inner)
                             : std::pair(-inner, inner);
    };
    const auto [left, right] = range(sides.dot(axes.right));
    const auto [bottom, top] = range(sides.dot(axes.up));
    const auto at = [&](double u, double v) {
        return Vec2(face.centre + u * face.right + v * face.up);
    };
    return std::array<Vec2, 4>{at(left, bottom), at(right, bottom), at(right, top), at(left, top)};
}

std::optional<CubePart> cubePartAt(const Vec2 &screen, const Eigen::Quaterniond &orientation,
                                   const Vec2 &viewport)
{
    for (const CubeFace &face : visibleFaces(orientation, viewport)) {
        const Vec2 d = screen - face.centre;
        const double area = cross(face.right, face.up);
        if (area == 0.0)
            continue;
        const double u = cross(d, face.up) / area, v = cross(face.right, d) / area;
        if (std::abs(u) > 1.0 + kRounding || std::abs(v) > 1.0 + kRounding)
            continue;
        const FaceAxes &axes = axesOf(face.part);
        return partOf(direction(face.part) + zone(u) * axes.right + zone(v) * axes.up);
    }
    return {};
}

std::vector<CubePart> cubeParts()
{
    std::vector<CubePart> parts;
    for (int i = 0; i < 27; ++i) {
        const CubePart part{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
        if (part.rank() > 0)
            parts.push_back(part);
    }
    return parts;
}

Eigen::Quaterniond orientationOfPart(const CubePart &part)
{
    if (part.rank() == 1) {
        Eigen::Quaterniond orientation;
        orientationOfView(axesOf(part).name, orientation);
        return orientation;
    }
    Vec3 backward = direction(part);
    if (part.rank() == 3)
        backward.y() *= kCornerHeight;
    backward.normalize();
    const Vec3 right = Vec3::UnitY().cross(backward).normalized();
    Eigen::Matrix3d axes;
    axes << right, backward.cross(right), backward;
    return Eigen::Quaterniond(axes);
}

std::string_view nameOfPart(const CubePart &part)
{
    switch (part.rank()) {
    case 1:
        return axesOf(part).name;
    case 2:
        return "edge";
    default:
        return "corner";
    }
}

} // namespace fff
