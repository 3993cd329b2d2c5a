// On which side of each cut the forces on a piece are: needed again only when forces move.
#pragma once

#include "core/physics/applied_force.h"
#include "core/physics/line_cut.h"

#include <array>
#include <vector>

namespace fff {

/// A wall of a slit.
struct SlitWall
{
    HeldPoint root, mouth; // its ends
};

/// Where a force acts, as cuts see it.
struct ForceSite
{
    HeldPoint held; // decides the side; of a link a little inside the material beyond its root
    Vec2 at = Vec2::Zero();
    double radius = 0.0; // mm; of a link at least half its slit's width
    /// Of a link whose slit has some depth: to the left and to the right of its opening. Where the
    /// material has but one of them, that one twice.
    bool hasWalls = false;
    std::array<SlitWall, 2> walls;
};

/// `thickness` of the sheet, mm: a foot stands on so much of its outline.
std::vector<ForceSite> forceSites(const SectionOutline &outline,
                                  const std::vector<AppliedForce> &forces, double thickness);

/// From one share of a slit's depth to another: 0 at its root, 1 at its mouth.
struct WallStretch
{
    double from = 0.0, to = 0.0;
};

/// How much of a force is on the plus side of a cut, and where; of what presses on the walls of a
/// slit, on which stretch of each.
struct PlusShare
{
    double share = 0.0; // 0 … 1
    Vec2 at = Vec2::Zero();
    bool hasWalls = false;
    std::array<WallStretch, 2> walls;

    /// One wall is on this side, or a part of one: how tight the slit is makes a difference.
    bool isPartOfSlit() const
    {
        const double left = walls[0].to - walls[0].from, right = walls[1].to - walls[1].from;
        return hasWalls && left + right > 0.0 && left + right < 2.0;
    }
};

/// A force that is spread over a disc is parted by a cut through that: else where it acts would
/// jump from one side to the other as the cut passes its middle.
PlusShare plusShare(const LineCut &cut, const ForceSite &site);

} // namespace fff
