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
    std::vector<Known> known; // of the last time
};

/// The groups (heldGroups() of bodies and joints), with those joined to the first one that cannot
/// get away from all others: wherever they are shifted to, something is in their way before they
/// have come kEscape. What gets away itself is in nobody's way. The order of the others stays.
///
/// Shifts are tried in the 26 directions to faces, edges and corners of a cube, in the frame of
/// each body of the group and of each that it touches, and along the line that both planes have. So
/// a group that could only get away by turning, or between these directions, is taken to be caught:
/// it is not said to be loose. Groups of more than kMostInGroup bodies, and all beyond kMostGroups,
/// are not looked at. O(groups · neighbours · directions) of looks at pairs of solids, once more
/// after each that gets away; nothing for a group that is among the same bodies as the last time.
std::vector<std::vector<int>>
withCaptives(const Analysis &analysis, std::vector<std::vector<int>> groups, CaptiveCache &cache);

/// mm; a press fit gives less.
inline constexpr double kEscape = 0.3;
inline constexpr std::size_t kMostInGroup = 8, kMostGroups = 32;

} // namespace fff
