// Which way the slits of a joint open, and the slits themselves.
#pragma once

#include "core/assembly/joint.h"
#include "core/base/result.h"

#include <optional>

namespace fff {

/// Width of the slit in `host` through which `guest` can slide.
///
///     width = (t_guest + t_host |cos a|) / sin a + clearance,   a = angle between the two planes
///
/// Units   thicknesses, clearance and result in mm; a in radians. Kerf is not in here: it
///         offsets every cut path.
/// Errors  NearlyParallel when a < kMinJointAngle: the slit would be wider than the part;
///         BadValue, place "clearance", when a negative clearance leaves no width.
/// Source  the slab of the guest, seen on both faces of the host's: walls are cut square to the
///         sheet, so the slit must hold the guest's trace on the upper and the lower face at once.
Result<double> slitWidth(double hostThickness, double guestThickness, double angle,
                         double clearance);

/// What the choice of sides and the slits follow from; a is the joint's a, b its b.
struct JointSide
{
    const Section &section;
    const Stock &stock; // its own
};

/// What is wanted of a joint in place of its defaults; what cannot be had is passed over.
struct JointWish
{
    std::optional<JointKind> kind;
    int sign = 0;               // +1: a opens along the axis' direction, −1: against it, 0: any
    std::vector<double> shares; // of a's slit, one an overlap; empty: halves
};

struct JointSlits
{
    JointKind kind = JointKind::None;
    std::vector<Slit> a, b; // joint, guest are left for the caller to set
};

/// The default slits of a crossing with at least one overlap, to which it says where they meet.
///
/// Slid together along the axis, one section keeps its material below the meeting point, the other
/// above it. With a open upwards (along the axis' direction), a's slit runs from the meeting point
/// to the upper end of a's interval and b's from the lower end of b's interval to the meeting
/// point, whatever the intervals; where a section ends inside the other, that is the ordinary half
/// slit, where it reaches beyond, the slit is extended. So of the two ways the one is taken that
/// cuts less beyond the overlaps (summed over all of them: they slide one way), with what must be
/// cut beside the axis where the two slabs meet there, too. Slits open to the
/// outside, never into a hole: where a section's own end lies on a hole, it stays uncut and the
/// other's slit takes the whole overlap; at least one overlap must keep two slits, or nothing
/// holds. Both ways equal to kEqualEnds: the section with the lower id (`aIsLower`) opens upwards
/// in the world. No way open: the section that passes through goes uncut through a mortise, where
/// its end fits; else None, as for slits that a negative clearance leaves no width. Local: it
/// depends on these two sections and what is wanted of them only, so an edit elsewhere never flips
/// a slit.
JointSlits cutSlits(Crossing &crossing, const JointSide &a, const JointSide &b, bool aIsLower,
                    const JointWish &wish = {});

/// Why a joint has no slits.
enum class NoSlit {
    Wanted,       // its kind is None
    NoWidth,      // a negative clearance leaves them none
    OppositeWays, // some of its overlaps could only slide one way, others only the other
    NothingHolds, // they could slide together, but nowhere would both have a slit
    Enclosed,     // ends lie on holes, or enclose each other: none comes from outside, and neither
                  // section fits through a mortise
};

/// Of a crossing with overlaps for which cutSlits() has none, with the same sides and wish.
NoSlit whyNoSlit(const Crossing &crossing, const JointSide &a, const JointSide &b,
                 const JointWish &wish);

} // namespace fff
