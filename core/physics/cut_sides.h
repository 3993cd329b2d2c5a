// On which side of each cut the forces on a piece are: needed again only when forces move.
#pragma once

#include "core/physics/applied_force.h"
#include "core/physics/line_cut.h"

#include <vector>

namespace fff {

/// Where a force acts, as cuts see it.
struct ForceSite
{
    HeldPoint held; // decides the side; of a link a little inside the material beyond its root
    Vec2 at = Vec2::Zero();
    double radius = 0.0; // mm; of a link at least half its slit's width
};

/// `thickness` of the sheet, mm: a foot stands on so much of its outline.
std::vector<ForceSite> forceSites(const SectionOutline &outline,
                                  const std::vector<AppliedForce> &forces, double thickness);

/// How much of a force is on the plus side of a cut, and where.
struct PlusShare
{
    double share = 0.0; // 0 … 1
    Vec2 at = Vec2::Zero();
};

/// A force that is spread over a disc is parted by a cut through that: else where it acts would
/// jump from one side to the other as the cut passes its middle.
PlusShare plusShare(const LineCut &cut, const ForceSite &site);

} // namespace fff
