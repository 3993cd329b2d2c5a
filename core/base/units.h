// Inside and in files: mm, radians, kg, N, MPa. The paper's abstract unit is one inch.
#pragma once

#include <numbers>

namespace fff {

inline constexpr double kPaperUnit = 25.4; // mm
inline constexpr double kFirstPlaneHeight =
    3.3 * kPaperUnit; // mm above the origin (paper: 3.3 units)

constexpr double degrees(double radians)
{
    return radians * 180.0 / std::numbers::pi;
}
constexpr double radians(double degrees)
{
    return degrees * std::numbers::pi / 180.0;
}

} // namespace fff
