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
        SetStock,
        EditStock
    };
    Kind kind = Kind::DrawSection;
    std::vector<std::string> names; // of the sections or stocks it was done to
};

} // namespace fff
