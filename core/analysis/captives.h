// Pieces that no single joint holds, but all others together.
#pragma once

#include "core/analysis/analysis.h"

#include <vector>

namespace fff {

/// What was found out about groups, each with all bodies near to it. Not for several threads at
/// once.
struct CaptiveCache
{
    struct Known
    {
        std::vector<BodyPointer> own, near;
        bool getsAway = false;
    };
    struct KnownTogether
    {
        std::vector<std::vector<BodyPointer>> groups; // that touch each other
        std::vector<BodyPointer> near;
        std::vector<char> getAway; // of each group
    };
    // Of the last time.
    std::vector<Known> known;
    std::vector<KnownTogether> together;
};

/// The groups (heldGroups() of bodies and joints), with those joined to the first one that cannot
/// get away from it: whatever they do, alone or all at once, shifted and turned, they do not come
/// far before something is in the way that cannot get out of it, either. What gets away
/// itself is in nobody's way. The order of the others stays.
///
/// Each is first shifted alone, in the 26 directions to faces, edges and corners of a cube, in the
/// frame of each body of the group and of each that it touches, and along the line that both planes
/// have. What is stopped is looked at together with all others that are, as rigid things that press
/// on each other and on the first group (coming_away.h). Groups of more than kMostInGroup bodies,
/// all beyond kMostGroups, and more than kMostTogether that touch each other are not looked at:
/// they stay by themselves. O(groups · neighbours · directions) of looks at pairs of solids, once
/// more after each that gets away; nothing for a group that is among the same bodies as the last
/// time.
std::vector<std::vector<int>>
withCaptives(const Analysis &analysis, std::vector<std::vector<int>> groups, CaptiveCache &cache);

/// mm; a press fit gives less.
inline constexpr double kEscape = 0.3;
inline constexpr std::size_t kMostInGroup = 8, kMostGroups = 32, kMostTogether = 6;

} // namespace fff
