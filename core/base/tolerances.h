// Every tolerance of the program, by name and with its unit. Lengths in mm, angles in radians.
#pragma once

namespace fff {

/// Largest distance between a curve and the chords that stand for it in what is cut and analysed.
inline constexpr double kCutChord = 0.01;
/// The same where a contour that crosses itself is taken apart, once, when it comes in.
inline constexpr double kResolveChord = 4e-4;
/// The same for what is only looked at.
inline constexpr double kDrawChord = 0.05;
/// Largest distance of a fitted curve from the offset curve that it stands for.
inline constexpr double kOffsetError = 0.002;
/// By how much a tool that follows its path may enter a part, or stay away from it.
inline constexpr double kSweepError = 0.005;

/// Booleans snap their input to this grid: 1 nm.
inline constexpr double kClipGrid = 1e-6;
/// How far from its edge a vertex may be that the booleans put there: both ends of the edge and the
/// vertex itself are rounded to the grid.
inline constexpr double kClipSlack = 3.0 * kClipGrid;
/// Two curves are taken to cross where they are this near.
inline constexpr double kCrossingError = 1e-10;
/// A point this near to the line that a shape is clipped at lies on it.
inline constexpr double kOnLine = 1e-9;
/// Sine of the angle below which two edges are parallel: where they cross is rounding (no unit).
inline constexpr double kParallelSine = 1e-9;
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

/// Parts that are in each other by less than this only touch: 1 µm, which rounding of frames and of
/// the booleans' grid stays well below.
inline constexpr double kTouchingDepth = 1e-3;

/// Smallest area of a contour, a hole or a part, in mm²; below it is dust.
inline constexpr double kMinArea = 1e-3;
/// What slits cut off a section that is smaller, in mm², is waste, not a part: nobody finds it
/// again on a machine's bed.
inline constexpr double kWasteArea = 1.0;

/// Points found along rays, which start beyond everything, are off by no more than this.
inline constexpr double kRayRounding = 1e-7;
/// A section that is seen at less than this is seen on edge: nothing is drawn on it (3°).
inline constexpr double kMinDrawAngle = 0.05235987755982989;
/// Turns and directions that differ by less than this, in radians, are the same.
inline constexpr double kSameDirection = 1e-9;
/// Axes and planes that differ by less, in radians, are parallel to whoever puts them together: a
/// slit has more play (0.1°).
inline constexpr double kPracticallyParallel = 1.7e-3;
/// A view that is turned from a named one by less than this, in radians, is that view to the eye.
inline constexpr double kSameView = 1e-3;

/// A section point this near to Y = 0 stands on the ground.
inline constexpr double kGroundContact = 0.05;
/// A model that reaches below the ground by more than this is in it, one that is higher above it
/// hangs there. By no more it stands on it all the same: FlatFab cuts its models 0.005 units (0.127 mm) below the ground.
inline constexpr double kGroundSunk = 0.2;

/// Deviation from orthonormal axes that is rounding of a file, not a skew frame (no unit).
inline constexpr double kFrameRounding = 1e-4;
/// Axes this near to orthonormal are what rounding in double leaves: kept bit for bit (no unit).
inline constexpr double kExactFrame = 1e-9;

} // namespace fff
