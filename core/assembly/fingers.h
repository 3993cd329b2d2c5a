// Where two sections end on each other, at a corner: fingers of each reach between those of the
// other. A form that joints of kind Tabs have. Internal to assembly.
#pragma once

#include "core/assembly/tabs.h"

namespace fff {

/// How a section is cut in its mid-plane where fingers hold it, mm from the axis.
struct FingerCut
{
    double beyond = 0.0; // so far its own fingers reach beyond it
    double back = 0.0;   // so far it is cut back where the other one has a finger
};

/// half       of its thickness, mm
/// otherHalf  of the other one's
/// cosine     of the angle between what of both lies beside the axis, which is neither 0 nor π
FingerCut fingerCut(double half, double otherHalf, double cosine);

/// Fingers of two sections that end along their axis, each from one side, at whatever angle their
/// material meets (30° … 150°, kMinTabAngle).
///
/// Seen along the axis the two slabs are half strips that start at the corner. A finger ends,
/// square, before its first edge would stand out of the other's outer face; opposite of it the
/// other section is cut back, square too, as far as any corner of the finger comes. With half
/// thicknesses p of the one and q of the other, and the angle a between what of both lies beside
/// the axis:
///
///     finger of the one   e = (q − p |cos a|) / sin a            beyond the axis
///     the other, cut back r = (p + q cos a) / sin a              for a ≤ 90°
///                         r = −e cos a + p sin a                 beyond that, while no corner of
///                                                                the finger comes through
///
/// mm from the axis in each one's mid-plane. At a right angle that fills the corner; at others
/// wedges stay open, as sheets are cut square. Fingers take turns, an odd number of them, about
/// kShareOfFinger thicknesses wide, with both stocks' larger clearance between them; a begins and
/// ends. They keep off the ends of the edge so far that fingers of other edges, that start at the
/// same corner of either section, have their own room. How each section was drawn there does not
/// matter, if it ends at most kEdgeReach before where it is cut back.
///
/// Errors  TooOblique; EndsNowhere, where one of them goes past the other or does not reach it;
///         NoRoom for an edge that is too short for three fingers.
/// Source  the lines above follow from the two slabs alone; the construction is that of finger
///         joints in boxes, carried to other angles.
tl::expected<TabJoint, NoTabs> cutFingers(const JointSide &a, const JointSide &b);

/// Whether these are the slits of a joint of kind Tabs that has fingers, in either section.
bool areFingers(std::span<const Slit> slits);

} // namespace fff
