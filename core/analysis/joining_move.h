// How sections that nothing holds are moved so that a joint holds them.
#pragma once

#include "core/analysis/analysis.h"

#include <optional>
#include <vector>

namespace fff {

struct JoiningMove
{
    std::vector<SectionId> sections; // that move, all by the same way
    Vec3 way = Vec3::Zero();         // world, mm
};

/// Brings a loose group (sections that are joined with each other at most) to `other`, which is not
/// of them, without turning it: straight to where the two touch, and from there further into each
/// other, just so far that their joint holds. That is: it has slits, an overlap of twice the
/// thicker one's thickness, and beside its slits no less than the stock's thickness stays. From
/// where they touch it goes on in the same direction, along the normal of either plane or along the
/// axis, whichever is shortest. Sections that were drawn on those of the group go with them unless
/// `other` is joined with them.
///
/// Nothing when no joint comes of that: for planes nearer to parallel than kMinJointAngle, for
/// sections that are too small, and where what moves would be in other sections without a slit or
/// below the ground. Nothing for sections that operations
/// made either: those are not moved one by one.
///
/// A pure function. O(edges of the nearest two) and a few dozen trials of one joint.
std::optional<JoiningMove> joiningMove(const Analysis &analysis,
                                       const std::vector<SectionRef> &group,
                                       const SectionRef &other);

/// One section that is in the other already, moved with what was drawn on it along a direction
/// (world, unit) just so far that their joint holds; see there. Nothing as there.
std::optional<JoiningMove> moveAlong(const Analysis &analysis, const SectionRef &section,
                                     const SectionRef &other, const Vec3 &direction);

/// The sections that are not of the group, by how near their boxes are to those of the group, at
/// most so many.
std::vector<SectionRef> nearestSections(const Analysis &analysis,
                                        const std::vector<SectionRef> &group, std::size_t most);

/// The document after it.
Document moved(Document document, const JoiningMove &move);

} // namespace fff
