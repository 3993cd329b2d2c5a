// Every tolerance of the program, by name and with its unit. Lengths in mm, angles in radians.
#pragma once

namespace fff {

/// Largest distance between a curve and the chords that stand for it in what is cut and analysed.
inline constexpr double kCutChord = 0.01;
/// The same for what is only looked at.
inline constexpr double kDrawChord = 0.05;

/// Booleans snap their input to this grid: 1 nm.
inline constexpr double kClipGrid = 1e-6;
/// Largest coordinate that a document may hold: 1 km. Keeps every product in the integer booleans
/// exact.
inline constexpr double kMaxCoordinate = 1e6;

/// Two ends of intervals on an axis closer than this are "equal": the ends of sections that stand
/// on the same ground differ by rounding and by the six digits of imported files.
inline constexpr double kEqualEnds = 0.05;
/// An overlap shorter than this holds nothing and is no joint.
inline constexpr double kMinOverlap = 0.05;
/// Planes that meet at less than this make no joint: the slit would be wider than the part (10°).
inline constexpr double kMinJointAngle = 0.17453292519943295;

/// Smallest area of a contour, a hole or a part, in mm²; below it is dust.
inline constexpr double kMinArea = 1e-3;

/// A section point this near to Y = 0 stands on the ground.
inline constexpr double kGroundContact = 0.05;

/// Deviation from orthonormal axes that is rounding of a file, not a skew frame (no unit).
inline constexpr double kFrameRounding = 1e-4;

} // namespace fff
