// What the next click or drag does, or why one came to nothing.
#pragma once

#include "core/base/result.h"

#include <string>
#include <vector>

namespace fff {

/// ui makes the sentence (ui/UI.md, section 8).
struct Hint
{
    enum class Kind {
        DrawFirstSection,
        TurnView,
        DragOutOfSection,
        SeenOnEdge, // too slanted to draw on
        LeaveSection,
        Turning,
        LeaveDeadZone,
        DrawContour,
        ReleaseToMake,
        ReleaseToCutHole,
        ReleaseToRedraw,
        ReleaseToMirror,         // to make it, mirrored across the slit
        ReleaseToMirrorByShift,  // Shift is held
        ReleaseToRedrawMirrored, // the section
        ReleaseToMirrorFirst,    // across the vertical through its start
        DrawOnPlane,             // section: ground, front or side
        DrawParallel,            // to the section
        DrawNewContour,          // of the section
        DrawHole,                // in the section
        PenWithoutCanvas,        // beside all sections
        PenOnSection,
        CanvasOnEdge,  // it cannot be drawn on as it is seen now
        PenFirstPoint, // section: what it is about; may be empty
        PenPoint,
        PenSnapped, // the same, held by something
        PenCrosses, // the same, the path crosses itself
        PenBending,
        PenOnPoint,
        PenOnHandle,
        PenClosing, // over the first point
        PenNumbers, // the next point is typed
        Orbiting,
        Panning,
        Zooming,
        RubberBand,
        LookFrom,    // section: nameOfPart() of the cube's part
        MoveCut,     // over the handle
        MovingCut,   // dragging it
        MovePoint,   // over a control point
        MoveHandle,  // over a handle of one
        AddPoint,    // over the contour of the selected section
        MovingPoint, // dragging it
        MovingHandle,
        BendingContour, // dragging a piece of it
        PointBand,
        ChooseProblem,            // section: the number of its mark
        ShowSteps,                // of the assembly
        StepsClosed,              // since the model has changed
        MoveMeetingPoint,         // over the mark of a joint; section, other: whose it is
        MoveSelectedMeetingPoint, // the same, of the selected joint
        SelectJoint,              // the same, where nothing can be moved
        MovingMeetingPoint,       // dragging it; number: percent that is of the other's slit
        SelectOperation,          // over a section that the operation `other` made
        SelectInstance,           // the same, of the operation that is selected
        MoveRange,                // an operation is selected that has handles for its range
        MoveHandleOf,   // over such a handle; section: the operation, other: the parameter
        MovingHandleOf, // dragging it; number: what it is at, in tenths of percent
        PickInput,     // of an operation; section: its kind, other: the role, number: picked for it
        PickParent,    // of section; clicked
        PickMirror,    // of copies; clicked
        TransformPick, // nothing is selected that could be moved
        Transform,     // over nothing of the gizmo; section: the one that is selected, or empty
        TransformDrag, // over a section that is not selected
        DragToMove,    // over a part of the gizmo, and the next two
        DragToTurn,
        DragToScale,
        Transforming,     // dragging it
        LeavingCopy,      // the same while Ctrl is held; number: of copies
        TransformNumbers, // they are typed; number: of copies
        PickMarked,       // the section to engrave
        DrawMark,         // on section; a line is dragged, words are clicked
        DrawingMark,      // dragging it
        PlaceFigure,      // section: that it will be a hole in, or empty; other: its kind
        SizeFigure,       // dragging it
        MeasureFrom,      // the first place
        MeasureTo,        // the second one
        Measured,         // it is shown
        DimensionFrom,    // the first place of a length that shall become another one
        DimensionTo,
        DimensionType, // type what it shall be
        // Notes and refusals
        NeverLeft,
        TooShort,
        NoArea,             // the line goes there and back
        CrossesWithoutLoop, // it crosses itself, but no loop of it is large enough
        HalvesDoNotMeet,    // it was not mirrored: it would be two pieces
        CrossesItself,
        CutAtAxis,        // mirrored, it came over the axis and back; that is left out
        NothingToClose,   // the pen's points enclose nothing
        PathIsOpen,       // another canvas was picked
        CanvasGone,       // what the pen drew on is not there any more
        CutAtGround,      // what was drawn below the ground was left out
        LargestPiece,     // cutting there took it apart: the largest piece was kept
        BelowGround,      // nothing of it is above
        HoleOutside,      // the hole lies beside the section
        HoleIsNotch,      // it was cut out of the section's edge
        HolesMerged,      // it became one with others
        HolesLeftOut,     // of a redrawn section: those outside of it
        WouldCrossItself, // an edited contour: it stays at the last place where it does not
        WouldMeetHole,    // or leave a hole beside it
        WouldBeEmpty,
        WouldBeBelowGround,
        TooFewPoints,   // would be left of a contour
        NoMeetingPoint, // of the joint of section and other
        JointCannotBe,  // of that kind
        JointCannotFlip,
        CannotTrim,
        JointNotDeleted,
        Locked,          // section
        HeldByParent,    // it keeps its angle; other: to which one
        OnNothing,       // it was drawn on no other one
        CannotBeOn,      // section, since it carries other
        DoNotMeet,       // section and other
        NothingToPaste,  // the clipboard has no sections
        DrawingRead,     // section: the file; number: of lines, counts: of texts and pictures left
        DrawingOpen,     // section: the file, in which nothing is enclosed
        DrawingLeft,     // section: the file; number: of outlines that were left out
        LetterUnknown,   // other: the letter
        MarkOutside,     // it would lie beside section
        NotScaled,       // other: what would be out of its range
        MadeByOperation, // section: which one, other: by which; it cannot be edited by itself
        AlreadySymmetric,
        EditFailed,
        Failed
    };
    Kind kind = Kind::TurnView;
    std::string section;    // the name that the sentence speaks of
    bool isRefusal = false; // amber, stays for 6 s or until the next press
    std::string other = {}; // a second name
    int number = 0;
    std::vector<int> counts = {};
    bool operator==(const Hint &) const = default;
};

/// Why an edit is not made: of which section, and which other one.
inline tl::unexpected<Hint> refused(Hint::Kind kind, const std::string &section = {},
                                    const std::string &other = {})
{
    return tl::unexpected<Hint>(Hint{kind, section, true, other});
}

} // namespace fff
