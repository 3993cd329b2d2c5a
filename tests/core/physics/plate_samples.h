// Plates that the tests of finite elements share.
#pragma once

#include "core/physics/plate_attachment.h"
#include "core/physics/plate_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff::test {

/// 6 mm of acrylic.
inline const PlateMaterial kSixMillimetres{6.0, 3200.0, 0.37, 1.19e-6};

inline Polygon rectangle(double x0, double y0, double x1, double y1)
{
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline Polygon wavyRing(int count, double radius, double wave)
{
    Polygon ring;
    for (int i = 0; i < count; ++i) {
        const double a = 2.0 * std::numbers::pi * i / count;
        ring.emplace_back((radius + wave * std::sin(40.0 * a)) * Vec2(std::cos(a), std::sin(a)));
    }
    return ring;
}

/// A plate with a slit from above and a hole.
inline Region slitPlate()
{
    Region region{{{0, 0}, {120, 0}, {120, 60}, {63, 60}, {63, 30}, {57, 30}, {57, 60}, {0, 60}},
                  {}};
    Polygon hole = wavyRing(24, 8.0, 0.0);
    for (Vec2 &p : hole)
        p += Vec2(25, 30);
    std::reverse(hole.begin(), hole.end());
    region.holes = {hole};
    return region;
}

inline PlateModel modelOf(const Region &region, const PlateMaterial &material,
                          const std::vector<PlateClamp> &clamps = {}, double fineness = 1.0)
{
    PlateMeshOptions options;
    options.fineness = fineness;
    return PlateModel::make(plateMesh(region, options).value(), material, clamps).value();
}

/// A slit joint at the slit of slitPlate(), and two feet of it, turned.
inline std::vector<PlateAttachment> holdsOf(const PlateModel &model, double angle, const Vec2 &move)
{
    const Eigen::Rotation2Dd turn(angle);
    const auto at = [&](double x, double y) { return Vec2(turn * Vec2(x, y) + move); };
    return {slitAttachment(model, {at(60, 30), turn * Vec2(0, 1), 30.0, 6.0, 30.0, 6.0}),
            discAttachment(model, at(5, 0), 3.0), discAttachment(model, at(115, 0), 3.0)};
}

} // namespace fff::test
