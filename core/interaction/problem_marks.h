// Numbers in the view: each stands beside the place of a problem, with the number that its row has
// in the list of checks.
#pragma once

#include "core/interaction/camera.h"
#include "core/interaction/view_state.h"

#include <span>
#include <vector>

namespace fff {

struct ProblemMark
{
    int number = 0;                   // from 1 on; 0 is none
    Vec3 at = Vec3::Zero();           // world, mm
    std::vector<SectionRef> sections; // whom it is about; empty: the whole model
    bool isError = true;              // else a warning

    bool operator==(const ProblemMark &other) const
    {
        return number == other.number && at == other.at && sections == other.sections &&
               isError == other.isError;
    }
};

struct PlacedMark
{
    int number = 0;
    Vec2 anchor = Vec2::Zero(); // of the problem, px
    Vec2 centre = Vec2::Zero(); // of the number, px
    bool isError = true;
};

/// Half the width of a mark, and what stays free between two of them, px.
inline constexpr double kMarkRadius = 11.0, kMarkGap = 3.0;

/// Where the marks are seen: above their anchors, moved round them as far as it takes not to cover
/// another mark, the view cube or the view's edge. In the order given, the first ones nearest to
/// where they belong. Left out: what lies outside the view or behind the eye, and problems of
/// hidden sections only.
std::vector<PlacedMark> placeMarks(std::span<const ProblemMark> marks, const Camera &camera,
                                   const Vec2 &viewport, const ViewState &view);

/// Number of the mark under the cursor, 0 when there is none.
int markAt(const Vec2 &screen, std::span<const PlacedMark> marks);

} // namespace fff
