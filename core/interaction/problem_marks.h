// Marks of problems in the view: few numbers, those that their rows have in the list of checks, and
// for all else dots that say what they are when the cursor is on them. What lies near is one mark.
#pragma once

#include "core/interaction/camera.h"
#include "core/interaction/view_state.h"

#include <span>
#include <string>
#include <vector>

namespace fff {

struct ProblemMark
{
    int number = 0;                   // of its row, from 1 on; 0 is none
    Vec3 at = Vec3::Zero();           // world, mm
    std::vector<SectionRef> sections; // whom it is about; empty: the whole model
    bool isError = true;              // else a warning
    int place = 0;                    // which of its row's places, from 0 on
    bool isChosen = false;            // the one that is looked at
    std::string words = {};           // its verdict, as people read it

    bool operator==(const ProblemMark &other) const
    {
        return number == other.number && at == other.at && sections == other.sections &&
               isError == other.isError && place == other.place && isChosen == other.isChosen &&
               words == other.words;
    }
};

struct PlacedMark
{
    std::vector<std::size_t> marks; // whom it stands for, indices: the first is whose number it has
    int number = 0;
    Vec2 anchor = Vec2::Zero(); // of the problem, px
    Vec2 centre = Vec2::Zero(); // of the number, px; of a dot its anchor
    bool isError = true;
    bool isDot = false;
};

/// Half the width of a number, of a dot and of the room that is kept for that; what stays free
/// between two numbers; px.
inline constexpr double kMarkRadius = 11.0, kDotRadius = 4.5, kDotsRadius = 6.0, kMarkGap = 3.0;
/// What lies nearer to each other than this is one mark, px.
inline constexpr double kMergeReach = 16.0;
/// More numbers than these are not read, but in the way.
inline constexpr std::size_t kMostNumbers = 5;

/// Where the marks are seen. Numbers have the chosen problem and errors, one of each row, at most
/// kMostNumbers: above their anchors, moved round them as far as it takes not to cover another one,
/// the view cube, what covers the view or its edge. All else are dots on their anchors. In this
/// order; left out: what lies outside the view, behind the eye, behind the cube or what covers the
/// view, and problems of hidden sections.
/// covered  boxes of what stands over the view, px
std::vector<PlacedMark> placeMarks(std::span<const ProblemMark> marks, const Camera &camera,
                                   const Vec2 &viewport, const ViewState &view,
                                   std::span<const Box2> covered = {});

/// The mark under the cursor, null when there is none.
const PlacedMark *markAt(const Vec2 &screen, std::span<const PlacedMark> marks);
/// Whom a click on it chooses, an index: of several the one after the chosen one, so that clicks
/// step through them.
std::size_t chosenBy(const PlacedMark &placed, std::span<const ProblemMark> marks);

} // namespace fff
