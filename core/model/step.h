// What a commit did, for the history.
#pragma once

#include "core/model/joint_override.h"
#include "core/model/operation.h"

#include <optional>
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
        TurnSection,
        ScaleSection,
        CopySections,
        MirrorSections, // copies of them
        PasteSections,
        CutSections,
        InsertModel,   // names: of its file
        ImportDrawing, // names: of its file
        AddMark,       // names: of the section, as for the next two
        ChangeMark,
        DeleteMark,
        AddDimension,
        DeleteDimension,
        ScaleModel, // count: percent
        SetNumber,  // names: of the number, as for the next one
        DeleteNumber,
        MakeOrthogonal,
        AlignSection, // to an axis
        PutOn,        // another section, or nothing
        FreeSection,
        HoldSection, // no longer free
        LockSection,
        UnlockSection,
        MoveToSection, // names: of those that go, then of the one that they come to
        DropToGround,
        StretchToGround, // names: of the sections that reach it now
        MovePoints,      // count: of points, of the first section
        MoveHandle,
        BendContour,
        AddPoint,
        DeletePoints,
        ChangeFigure, // its numbers
        ChangePoints, // their kind, or their handles
        RemoveHoles,
        SetStock,
        EditStock,
        MakeAssemblable, // slits of joints turned round
        SetJointKind,    // names: of its two sections, as for the next three
        FlipSlits,
        MoveMeetingPoint, // count: percent of the second one's slit
        ResetJoint,
        JoinSections, // that were not to be joined; names: of the two
        TrimSection,  // names: of it, and of the one that it was cut back to
        AddOperation, // names: of the operation, as for all of them
        ChangeOperation,
        RenameOperation,
        SwitchOnOperation,
        SwitchOffOperation,
        MoveOperation,
        DeleteOperation,
        BakeOperation,
        MakeSymmetric,
        HideInstance, // names: of the section
        ShowInstance,
        DetachInstance
    };
    Kind kind = Kind::DrawSection;
    std::vector<std::string> names; // of the sections or stocks it was done to
    int count = 1;                  // of points, or percent
    /// Not empty: with a step before it of the same it makes one (an arrow key pressed again).
    std::string merges = {};
    JointKind joint = JointKind::None; // SetJointKind
    /// ChangeOperation: of one parameter, what it was and is; none where it follows from the
    /// inputs.
    struct Change
    {
        std::string kind, key; // of the operation, of the parameter
        std::optional<ParameterValue> before = {}, after = {};
    };
    std::optional<Change> change = {};
};

} // namespace fff
