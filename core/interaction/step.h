// What a commit did, for the history.
#pragma once

#include <string>
#include <vector>

namespace fff {

/// ui makes the words ("Draw Section 3") of it.
struct Step
{
    enum class Kind {
        DrawSection,
        RedrawSection,
        AddHole,
        DeleteSections,
        RenameSection,
        MoveSection,
        DropToGround,
        MovePoints, // count: of points, of the first section
        MoveHandle,
        BendContour,
        AddPoint,
        DeletePoints,
        ChangePoints, // their kind, or their handles
        RemoveHoles,
        SetStock,
        EditStock,
        MakeAssemblable // slits of joints turned round
    };
    Kind kind = Kind::DrawSection;
    std::vector<std::string> names; // of the sections or stocks it was done to
    int count = 1;                  // of points
    /// Not empty: with a step before it of the same it makes one (an arrow key pressed again).
    std::string merges = {};
};

} // namespace fff
