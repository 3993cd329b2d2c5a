// The control points of a contour as a person moves them: anchors with a handle to each side, and
// the pure edits of them. Of one boundary; core/model/point_edits.h has those of a whole shape.
//
// Anchor i is where segment i starts; its in handle ends segment i − 1, its out handle begins
// segment i. Frame coordinates, mm. Indices are valid ones.
// Errors of all edits: NonFinite, BadValue where a point would lie beyond kMaxCoordinate.
#pragma once

#include "core/geometry/contour.h"

#include <span>

namespace fff {

/// How the curve goes through an anchor. Follows from the handles and is not stored.
enum class PointKind {
    Corner,
    Smooth,    // both handles lie on one line
    Symmetric, // and are equally long
};

enum class HandleSide { In, Out };

/// Handles that differ from one line by less than this are on it: half a degree, in radians. Files
/// carry six digits; nobody sees less.
inline constexpr double kSmoothAngle = 0.0087;
/// Share by which handles of a symmetric point may differ in length.
inline constexpr double kSymmetricShare = 0.005;
/// A handle shorter than this is none, mm.
inline constexpr double kNoHandle = 1e-4;
/// How near to the thirds of its chord the handles of a line are, as a share of the chord.
inline constexpr double kLineShare = 1e-5;
/// A contour of fewer segments encloses nothing.
inline constexpr int kFewestSegments = 2;

/// A segment that was drawn as a line, and stays one when its ends are moved: handles at the thirds
/// of its chord, or in its ends. A straight curve whose handles are elsewhere is none: a handle of
/// it was pulled, and what it is pulled to stays. Pieces of lines are lines.
bool isLine(const CubicBezier &segment);

Vec2 anchor(const Contour &contour, int index);
/// Position of a handle (absolute).
Vec2 handle(const Contour &contour, int index, HandleSide side);
/// Both handles on one line, to kSmoothAngle: smooth; equally long besides: symmetric. A corner
/// where a handle is missing, and between two lines also where these go straight on: moved, it is a
/// corner.
PointKind kindOf(const Contour &contour, int index);

/// Moves anchors, each by `by`; handles travel along. Lines stay lines, and a handle that lay in
/// the direction of a line turns with it. `breaks`: handles stay where they are, but those of
/// lines.
Result<Contour> movedAnchors(const Contour &contour, std::span<const int> indices, const Vec2 &by,
                             bool breaks = false);
/// Moves one anchor to this place, to the bit.
Result<Contour> movedAnchor(const Contour &contour, int index, const Vec2 &to);

/// Moves a handle. A smooth point stays smooth: the other handle turns along and keeps its length;
/// where a line is on the other side, the handle stays in its direction. Of a symmetric point the
/// other handle mirrors it. `breaks`: the other handle stays where it is.
Result<Contour> movedHandle(const Contour &contour, int index, HandleSide side, const Vec2 &to,
                            bool breaks);
/// Pulls the point at `t` (0 … 1) of a segment by `by`, with the least change of its two handles;
/// points at its ends that are smooth stay smooth, unless told to break. Next to an end, where
/// handles would fly off, the nearer handle moves as if it were pulled at kNearestPull.
Result<Contour> movedSegment(const Contour &contour, int segment, double t, const Vec2 &by,
                             bool breaks);
inline constexpr double kNearestPull = 0.15;

/// A new anchor at `t` of a segment (0 < t < 1), by de Casteljau: the curve stays. Its index is
/// segment + 1.
Result<Contour> insertedPoint(const Contour &contour, int segment, double t);

/// Takes anchors out. What was between the remaining ones becomes one segment each: the cubic with
/// the tangents of the stretch at its ends that is nearest to it (least squares, P. Schneider 1990,
/// Graphics Gems, An Algorithm for Automatically Fitting Digitized Curves); a line where all of the
/// stretch was lines. A point that was put in before goes without a trace.
/// Errors  also TooFewPoints when less than kFewestSegments would be left.
Result<Contour> withoutPoints(const Contour &contour, std::span<const int> indices);

/// Makes the point smooth, symmetric or a corner; as it is when it is that already.
///
/// Smooth: the tangent is that of a line on one side, else halfway between the handles; these keep
/// their lengths, and a line that becomes a curve gets a handle of kHandleShare of its chord.
/// Symmetric: the same with both handles as long as their mean, or the line's. Corner: both handles
/// turn to the neighbouring anchors, at a third of the way; where these lie on one line with the
/// point, the handles go.
Result<Contour> withKind(const Contour &contour, int index, PointKind kind);
inline constexpr double kHandleShare = 0.39; // that of a quarter of a circle

/// The place of the contour that is nearest to a point.
struct NearestPlace
{
    CurvePoint at;
    Vec2 position = Vec2::Zero();
    double distance = 0.0; // mm
};
/// Exact to rounding for the nearest of the curve's chords' stretches; O(segments), those whose
/// control points are all further away are not looked at.
NearestPlace nearestPlace(const Contour &contour, const Vec2 &point);

} // namespace fff
