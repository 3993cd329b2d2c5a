// Local symmetry: a stroke drawn on one side of the slit means both (paper, "Single stroke planar
// section creation", figure 6). Pure; canvas coordinates, mm.
#pragma once

#include "core/geometry/bezier.h"
#include "core/geometry/mirror_axis.h"

#include <optional>
#include <vector>

namespace fff {

/// Of the larger distance to the smaller one from which on a stroke is mirrored (paper: 6.0).
inline constexpr double kMirrorRatio = 6.0;

/// How far a stroke reaches on both sides of the axis, and what follows.
struct SymmetryVerdict
{
    double left = 0.0, right = 0.0; // largest distances of samples, seen along the direction; mm
    double limit = 0.0;      // mm; reaching further than this on the nearer side is no symmetry
    bool isOneSided = false; // the larger is at least `ratio` times the smaller

    bool isLeft() const { return left >= right; } // the side that is mirrored
};

/// Samples that are not finite are left out. A stroke on the axis is on no side of it.
///
/// What the ends of an open stroke draw past the axis, as a hand does that stops late, is no second
/// side, unless it is long, comes back or begins to close the outline; nor are hooks there.
/// tolerance: of the fit, mm
SymmetryVerdict judgeSymmetry(const std::vector<Vec2> &samples, const MirrorAxis &axis,
                              double ratio = kMirrorRatio, double tolerance = 0.0);

/// One half of a mirrored contour. The chain of opening, fitted and closing starts and ends on the
/// axis; it and its mirror image enclose the section.
struct MirroredHalf
{
    std::vector<CubicBezier> fitted;    // along the samples
    std::optional<CubicBezier> opening; // from the axis to where the samples begin
    std::optional<CubicBezier> closing; // from where they end to the axis
    /// The whole half without crossings, from the axis to the axis; what the contour is made of.
    std::vector<CubicBezier> outline;
    /// Its mirror image, from the outline's end back to its start: control points mirrored, not
    /// fitted again.
    std::vector<CubicBezier> mirrored;
    bool wasCrossing = false; // the half crossed itself; the outline is that of its largest loop
    bool wasCut = false;      // the stroke came over the axis and back: the largest half was kept
};

/// The half on the verdict's side, fitted to `tolerance` mm.
///
/// Of a stroke that crosses the axis several times the run that encloses most with it is the half,
/// so what strays over at the ends is cut off at the axis. Where it only touches the axis between
/// two parts, both are of the half (waists.h). An end that
///   - runs into the axis at kTipAngle or more is bent, within the tolerance, to meet it at a right
///     angle: both halves join smoothly there (G1);
///   - runs into it at less is a tip that is meant, like that of a leaf, and stays sharp: to smooth
///     it would take more than the tolerance. It is sharp as well when it stops short of the axis
///     by no more than the fit's reach; it is drawn out to it in a straight line;
///   - stops short of the axis otherwise gets a join: as near to the arc of a circle as a cubic
///     comes, on in its direction, onto the axis at a right angle.
/// A hook at an end, that goes back from the axis as the hand is lifted or put down, is left out.
/// A stroke that runs along the axis, within the fit's reach of it, as one does who draws the whole
/// half, is cut off where it comes to it: the run along the axis is left out.
/// A stroke that closes beside the axis (a wing, a wheel) is opened where it comes next to it: what
/// is within twice its least distance is left out, and joins make a neck.
/// None when nothing of the halves is in touch: on the axis they have less than two tolerances in
/// common.
std::optional<MirroredHalf> mirroredHalf(const std::vector<Vec2> &samples, const MirrorAxis &axis,
                                         const SymmetryVerdict &verdict, double tolerance);

} // namespace fff
