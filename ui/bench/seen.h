// All that is seen in the view but for the model and what a gesture shows: what it is painted anew
// for.
#pragma once

#include "core/analysis/problem_look.h"
#include "core/interaction/interaction.h"

namespace fff::ui {

class Workbench;

struct Seen
{
    Camera camera;
    ViewState view;
    std::vector<SectionRef> selection, outlined;
    std::vector<SectionPointer> ghosts;
    Hovered hovered;
    Signs selected, held, offered;
    Signs traced;          // what would be made of a picture
    bool isDrawn = false;  // a gesture shows something: that is not compared
    OperationId operation; // in focus
    bool hasGesture = false, isBusy = false, isGhosted = false;
    std::vector<ProblemMark> marks;
    int litMark = 0;
    ProblemLook problems;

    /// But for outlines and marks.
    bool isSamePicture(const Seen &other) const;
    bool operator==(const Seen &other) const = default;
};

Seen seenOn(const Workbench &bench);

/// The signs of what is selected; handles of an operation whose numbers are dragged elsewhere where
/// they are then.
Signs selectedSigns(const Workbench &bench);
/// The problem under the cursor, or with the cursor on its row; 0: none.
int litMark(const Workbench &bench);

} // namespace fff::ui
