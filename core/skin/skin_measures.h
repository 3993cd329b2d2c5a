// What near, short and the same are for the skin.
#pragma once

namespace fff {

/// Where two sections cross, their outlines are meant to meet when their ends on the common axis
/// are no farther from each other than this, mm: the skin has a corner there. Drawn by hand they
/// miss each other by some millimetres.
inline constexpr double kSkinReach = 6.0;
/// Corners of the skin that are nearer to each other along an outline, mm, are one.
inline constexpr double kSkinShort = 0.5;
/// Outlines that meet at less than this, in radians, touch and do not cross (8°).
inline constexpr double kSkinTouch = 0.13962634015954636;
/// A point of an outline this near to another one that the skin keeps is not needed, mm.
inline constexpr double kSkinSame = 1e-3;

/// A sum of unit normals that is shorter has no direction (no unit).
inline constexpr double kSkinNoNormal = 1e-6;

/// By so much a number of pieces may be above a whole one by rounding (no unit).
inline constexpr double kSkinCountRounding = 1e-6;

} // namespace fff
