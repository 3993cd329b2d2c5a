// Where a section ends on the other's face: tabs of it reach through slots in the other. Where both
// end at a corner: fingers (fingers.h).
#pragma once

#include "core/assembly/slits.h"

#include <tl/expected.hpp>

namespace fff {

/// A section that ends this near to the other's face (mm) ends on it, be it before the face or
/// beyond the other one.
inline constexpr double kEdgeReach = 0.5;
/// Planes that meet at less than this take no tabs: what is cut square would stand out too far
/// (30°).
inline constexpr double kMinTabAngle = 0.52359877559829887;
/// By so much less is rounding: a twelve-sided prism is as sharp as it may be (0.01°).
inline constexpr double kTabAngleRounding = 1.7e-4;

/// Why two sections cannot be joined by tabs.
enum class NoTabs {
    TooOblique,  // at less than kMinTabAngle
    NoWidth,     // a negative clearance leaves the slots none
    EndsNowhere, // neither ends on the other's face: it goes past it, or does not reach it
    NoRoom,      // it is too short, or the other has no material all round the slots
};

struct TabJoint
{
    Crossing crossing; // its overlaps: where the one ends on the other
    JointSlits slits;  // of kind Tabs: slots in the one; tabs, and a shoulder for each overlap, in
                       // the other, or in both
};

/// Seen in the plane of the section that ends, the other's slab is a strip along the axis. The
/// section is cut back to the strip's edge and tabs are added that reach through the strip. Per
/// stretch on which it ends: one tab for each eight thicknesses of its length, at least one, half
/// of its share wide (so between its own thickness and six of them), in the middle of its share.
/// Slots keep half of a thickness from everything else of the section that they are in; a tab whose
/// slot would not is left out. It does not matter whether the section ended on, in or just behind
/// the other's slab; where it ends before it, that gap stays and tabs reach over it. All that ends
/// must come from one side.
///
/// Of two that could, the one with more tabs, measured along the axis, has them; of equal ones b.
/// Where neither could, and both end at a corner, both have fingers: there are no slots then.
tl::expected<TabJoint, NoTabs> cutTabs(const JointSide &a, const JointSide &b);

} // namespace fff
