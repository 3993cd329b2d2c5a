#include "ui/bench/hint_text.h"

#include "core/geometry/figure.h"
#include "core/session/operation_text.h"

#include <QCoreApplication>
#include <QLocale>

namespace fff::ui {

namespace {

struct HintText
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::HintText)
};

/// By the name of the view cube's part.
QString lookFrom(const QString &part)
{
    if (part == QLatin1String("front"))
        return HintText::tr("Click to look from the front; drag to turn the view.");
    if (part == QLatin1String("back"))
        return HintText::tr("Click to look from the back; drag to turn the view.");
    if (part == QLatin1String("left"))
        return HintText::tr("Click to look from the left; drag to turn the view.");
    if (part == QLatin1String("right"))
        return HintText::tr("Click to look from the right; drag to turn the view.");
    if (part == QLatin1String("top"))
        return HintText::tr("Click to look from the top; drag to turn the view.");
    if (part == QLatin1String("bottom"))
        return HintText::tr("Click to look from below; drag to turn the view.");
    if (part == QLatin1String("edge"))
        return HintText::tr("Click to look at this edge; drag to turn the view.");
    return HintText::tr("Click to look at this corner; drag to turn the view.");
}

/// By the name of the plane.
QString drawOn(const QString &plane)
{
    if (plane == QLatin1String("ground"))
        return HintText::tr("Draw a section on the ground in one go. <kbd>Esc</kbd> cancels.");
    if (plane == QLatin1String("front"))
        return HintText::tr("Draw a section on the front plane in one go. <kbd>Esc</kbd> cancels.");
    return HintText::tr("Draw a section on the side plane in one go. <kbd>Esc</kbd> cancels.");
}

QString figureName(const std::string &key)
{
    const FigureKind *kind = figureKind(key);
    return kind ? QCoreApplication::translate("Figure", kind->name) : QString();
}

/// What of a drawing came, and what was left out of it.
QString drawingRead(const Hint &hint, const QString &name)
{
    const int texts = hint.counts.empty() ? 0 : hint.counts[0];
    const int pictures = hint.counts.size() < 2 ? 0 : hint.counts[1];
    const QString skippedTexts = HintText::tr("%n texts", nullptr, texts);
    const QString skippedPictures = HintText::tr("%n pictures", nullptr, pictures);
    const QString lines = HintText::tr("%n lines were read", nullptr, hint.number);
    if (texts == 0 || pictures == 0)
        //: %1 is a file, %2 "3 texts", %3 "5 lines were read"
        return HintText::tr("%1: %2 skipped; %3.")
            .arg(name, texts > 0 ? skippedTexts : skippedPictures, lines);
    //: %1 is a file, %2 "3 texts", %3 "1 picture", %4 "5 lines were read"
    return HintText::tr("%1: %2 and %3 skipped; %4.")
        .arg(name, skippedTexts, skippedPictures, lines);
}

/// What an operation asks for; of a list that is long enough, how to end it.
QString pickInput(const Hint &hint)
{
    const OperationKind *kind = operationKind(hint.section);
    const InputSpec *input = kind ? kind->input(hint.other) : nullptr;
    if (!input)
        return HintText::tr("<kbd>Enter</kbd> makes it. <kbd>Esc</kbd> cancels.");
    const QString prompt = operationText(input->prompt);
    if (input->most == 1)
        //: %1 is a sentence: "Click the section to repeat."
        return HintText::tr("%1 <kbd>Esc</kbd> cancels.").arg(prompt);
    if (hint.number < input->least)
        //: %1 is a sentence, %2 a number of sections
        return HintText::tr("%1 So far: %2. <kbd>Esc</kbd> cancels.").arg(prompt).arg(hint.number);
    //: %1 is a sentence, %2 a number of sections
    return HintText::tr("%1 So far: %2. <kbd>Enter</kbd> makes it.").arg(prompt).arg(hint.number);
}

} // namespace

QString hintSentence(const Hint &hint, const QString &undoKeys)
{
    const QString name =
        QStringLiteral("<b>%1</b>").arg(QString::fromStdString(hint.section).toHtmlEscaped());
    const QString other =
        QStringLiteral("<b>%1</b>").arg(QString::fromStdString(hint.other).toHtmlEscaped());
    switch (hint.kind) {
    case Hint::Kind::DrawFirstSection:
        return HintText::tr("Draw the first section: press, draw its shape in one go, release.");
    case Hint::Kind::TurnView:
        return HintText::tr("Drag to turn the view; <kbd>Shift</kbd> drag selects a group.");
    case Hint::Kind::DragOutOfSection:
        return HintText::tr("Drag out of %1 to draw a section across it; click to select it.")
            .arg(name);
    case Hint::Kind::SeenOnEdge:
        return HintText::tr(
                   "Click to select %1. Drag to turn the view: on its edge nothing is drawn.")
            .arg(name);
    case Hint::Kind::LeaveSection:
        return HintText::tr(
                   "Drag on to leave %1; the slit ends at its edge. <kbd>Esc</kbd> cancels.")
            .arg(name);
    case Hint::Kind::Turning:
        return HintText::tr("Turning to the new plane; move on when it stops.");
    case Hint::Kind::LeaveDeadZone:
        return HintText::tr(
            "Leave the grey zone where the contour shall begin. Release here cancels.");
    case Hint::Kind::DrawContour:
        return HintText::tr("Draw the contour, release to close it. <kbd>Esc</kbd> cancels.");
    case Hint::Kind::ReleaseToMake:
        return HintText::tr("<b>Release</b> to make the section. <kbd>Esc</kbd> cancels.");
    case Hint::Kind::ReleaseToCutHole:
        return HintText::tr("<b>Release</b> to cut the hole into %1. <kbd>Esc</kbd> cancels.")
            .arg(name);
    case Hint::Kind::ReleaseToRedraw:
        return HintText::tr("<b>Release</b> to give %1 this contour. <kbd>Esc</kbd> keeps the old "
                            "one.")
            .arg(name);
    case Hint::Kind::ReleaseToMirror:
        return HintText::tr("<b>Release</b> to make the section, mirrored across the slit. Hold "
                            "<kbd>Shift</kbd> to keep only this side. <kbd>Esc</kbd> cancels.");
    case Hint::Kind::ReleaseToMirrorByShift:
        return HintText::tr(
            "<b>Release</b> to make the section, mirrored. Let <kbd>Shift</kbd> go to "
            "keep only this side. <kbd>Esc</kbd> cancels.");
    case Hint::Kind::ReleaseToRedrawMirrored:
        return HintText::tr("<b>Release</b> to give %1 this contour, mirrored across its slit. "
                            "<kbd>Shift</kbd> switches mirroring over.")
            .arg(name);
    case Hint::Kind::ReleaseToMirrorFirst:
        return HintText::tr(
            "<b>Release</b> to make the section, mirrored across the vertical. Hold "
            "<kbd>Shift</kbd> to keep only this side.");
    case Hint::Kind::DrawOnPlane:
        return drawOn(QString::fromStdString(hint.section));
    case Hint::Kind::DrawParallel:
        return HintText::tr("Draw a section parallel to %1 in one go. <kbd>Esc</kbd> cancels.")
            .arg(name);
    case Hint::Kind::DrawNewContour:
        return HintText::tr(
                   "Draw the new contour of %1 in one go. <kbd>Esc</kbd> keeps the old one.")
            .arg(name);
    case Hint::Kind::DrawHole:
        return HintText::tr("Draw a hole in %1 in one go. <kbd>Esc</kbd> cancels.").arg(name);
    case Hint::Kind::PenWithoutCanvas:
        return HintText::tr("Drag out of a section to draw across it with the pen; drag here to "
                            "turn the view. <kbd>Esc</kbd> lays the pen down.");
    case Hint::Kind::PenOnSection:
        return HintText::tr("Drag out of %1 to draw across it with the pen; click to select it.")
            .arg(name);
    case Hint::Kind::CanvasOnEdge:
        return HintText::tr("The plane is seen on its edge: turn the view to go on drawing.");
    case Hint::Kind::PenFirstPoint:
        return HintText::tr(
            "Click to set the first point, drag to bend. <kbd>Esc</kbd> lays the pen down.");
    case Hint::Kind::PenPoint:
        return HintText::tr("Click to set a point, drag to bend; <kbd>Enter</kbd> closes, "
                            "<kbd>Backspace</kbd> takes one back.");
    case Hint::Kind::PenSnapped:
        return HintText::tr("Click to set a point, drag to bend; <kbd>Enter</kbd> closes, "
                            "<kbd>Backspace</kbd> takes one back. <kbd>Ctrl</kbd> click does not "
                            "snap.");
    case Hint::Kind::PenCrosses:
        return HintText::tr("The contour crosses itself: <kbd>Enter</kbd> keeps the largest loop, "
                            "<kbd>Backspace</kbd> takes a point back.");
    case Hint::Kind::PenBending:
        return HintText::tr("Drag to bend; <kbd>Ctrl</kbd> makes a corner, <kbd>Shift</kbd> holds "
                            "the direction.");
    case Hint::Kind::PenOnPoint:
        return HintText::tr("Drag to move the point; <kbd>Ctrl</kbd> does not snap, "
                            "<kbd>Shift</kbd> holds the direction.");
    case Hint::Kind::PenOnHandle:
        return HintText::tr("Drag the handle to bend; <kbd>Ctrl</kbd> makes a corner.");
    case Hint::Kind::PenClosing:
        return HintText::tr("Click to close the contour; drag to move the point.");
    case Hint::Kind::PenNumbers:
        return HintText::tr("<kbd>Enter</kbd> sets the point, <kbd>Tab</kbd> goes to the next "
                            "number. <kbd>Esc</kbd> closes the bar.");
    case Hint::Kind::Orbiting:
        return HintText::tr("Move to turn the view, release to stop.");
    case Hint::Kind::Panning:
        return HintText::tr("Move to shift the view, release to stop.");
    case Hint::Kind::Zooming:
        return HintText::tr("Move up to come nearer, down to go away; release to stop.");
    case Hint::Kind::RubberBand:
        return HintText::tr("Release to select all that is wholly inside. <kbd>Esc</kbd> cancels.");
    case Hint::Kind::LookFrom:
        return lookFrom(QString::fromStdString(hint.section));
    case Hint::Kind::MoveCut:
        return HintText::tr("Drag to move the cut through the model; Esc closes it.");
    case Hint::Kind::MovingCut:
        return HintText::tr("Move to shift the cut, release to leave it there. Esc puts it back.");
    case Hint::Kind::ChooseProblem:
        return HintText::tr("Click to select problem %1; drag to turn the view.").arg(name);
    case Hint::Kind::ShowSteps:
        return HintText::tr("Drag to turn the view; <kbd>Space</kbd> plays, <kbd>\u2190</kbd> and "
                            "<kbd>\u2192</kbd> go step by step. <kbd>Esc</kbd> closes the steps.");
    case Hint::Kind::StepsClosed:
        return HintText::tr("The model has changed, so the view of its steps was closed.");
    case Hint::Kind::MoveMeetingPoint:
        return HintText::tr("Drag to make the slit of %1 deeper and that of %2 shallower; click "
                            "to select the joint.")
            .arg(other, name);
    case Hint::Kind::MoveSelectedMeetingPoint:
        return HintText::tr("Drag to make the slit of %1 deeper and that of %2 shallower; arrow "
                            "keys move 1\u202fmm.")
            .arg(other, name);
    case Hint::Kind::SelectJoint:
        return HintText::tr("Click to select the joint of %1 and %2.").arg(name, other);
    case Hint::Kind::MovingMeetingPoint:
        return HintText::tr("Release to leave it here: the slit of %1 takes %2\u202f%. "
                            "<kbd>Esc</kbd> cancels.")
            .arg(other, QString::number(hint.number));
    case Hint::Kind::NoMeetingPoint:
        return HintText::tr("Nothing moved: where %1 and %2 meet, two slits do not share the way.")
            .arg(name, other);
    case Hint::Kind::JointCannotBe:
        return HintText::tr("Nothing changed: %1 and %2 cannot be joined like that.")
            .arg(name, other);
    case Hint::Kind::JointCannotFlip:
        return HintText::tr("Nothing turned: the slits of %1 and %2 cannot open to the other side.")
            .arg(name, other);
    case Hint::Kind::CannotTrim:
        return HintText::tr("Nothing trimmed: %1 is not in %2, or nothing of it would stay.")
            .arg(name, other);
    case Hint::Kind::JointNotDeleted:
        return HintText::tr("Nothing deleted: a joint is where two sections meet. Delete one of "
                            "them, or choose the kind \u201cNone\u201d.");
    case Hint::Kind::MovePoint:
        return HintText::tr(
            "Drag to move the point; <kbd>Ctrl</kbd> makes a corner, arrow keys move 1\u202fmm.");
    case Hint::Kind::MoveHandle:
        return HintText::tr("Drag to bend the curve; <kbd>Ctrl</kbd> makes a corner, "
                            "<kbd>Shift</kbd> keeps the direction.");
    case Hint::Kind::AddPoint:
        return HintText::tr("Double-click to add a point here; drag to bend the contour.");
    case Hint::Kind::MovingPoint:
        return HintText::tr("Release to leave it here. <kbd>Ctrl</kbd> makes a corner, "
                            "<kbd>Shift</kbd> keeps the direction.");
    case Hint::Kind::MovingHandle:
        return HintText::tr("Release to leave it so. <kbd>Ctrl</kbd> makes a corner, "
                            "<kbd>Shift</kbd> keeps the direction.");
    case Hint::Kind::BendingContour:
        return HintText::tr("Release to leave it so. <kbd>Ctrl</kbd> makes corners at its ends. "
                            "<kbd>Esc</kbd> cancels.");
    case Hint::Kind::PointBand:
        return HintText::tr("Release to select the points inside. <kbd>Esc</kbd> cancels.");
    case Hint::Kind::WouldCrossItself:
        return HintText::tr("Here the contour would cross itself; it stays at the last place where "
                            "it does not.");
    case Hint::Kind::WouldMeetHole:
        return HintText::tr("Here a hole would not lie inside by itself; it stays at the last "
                            "place where it does.");
    case Hint::Kind::WouldBeEmpty:
        return HintText::tr("Here nothing would be left of %1; it stays as it was.").arg(name);
    case Hint::Kind::WouldBeBelowGround:
        return HintText::tr("Here all of %1 would be cut off at the ground; it stays as it was.")
            .arg(name);
    case Hint::Kind::TooFewPoints:
        return HintText::tr("Nothing deleted: a contour needs two points at least.");
    case Hint::Kind::EditFailed:
        return HintText::tr("Nothing changed: this cannot be done here.");
    case Hint::Kind::SelectOperation:
        return HintText::tr("%1 is made by %2: click to edit them all, click again for this one.")
            .arg(name, other);
    case Hint::Kind::SelectInstance:
        return HintText::tr("Click to select %1 alone; drag out of it to draw a section across it.")
            .arg(name);
    case Hint::Kind::MoveRange:
        return HintText::tr("Drag a round handle to move the beginning or the end of %1; click one "
                            "section to select it.")
            .arg(name);
    case Hint::Kind::MoveHandleOf:
        return (hint.other == "from"
                    ? HintText::tr("Drag to move the beginning of %1; click to type it.")
                    : HintText::tr("Drag to move the end of %1; click to type it."))
            .arg(name);
    case Hint::Kind::MovingHandleOf:
        //: %1 is the name of an operation, %2 a number
        return (hint.other == "from"
                    ? HintText::tr(
                          "Release to let %1 begin here: %2\u202f%. <kbd>Esc</kbd> cancels.")
                    : HintText::tr(
                          "Release to let %1 end here: %2\u202f%. <kbd>Esc</kbd> cancels."))
            .arg(name, QLocale().toString(0.1 * hint.number, 'f', 1));
    case Hint::Kind::PickParent:
        return HintText::tr("Click the section that %1 shall be on. <kbd>Esc</kbd> cancels.")
            .arg(name);
    case Hint::Kind::PickMirror:
        return HintText::tr("Click the section to mirror across; drag to turn the view. "
                            "<kbd>Esc</kbd> cancels.");
    case Hint::Kind::TransformPick:
        return HintText::tr("Click the section to move or turn, or drag it. <kbd>Esc</kbd> lays "
                            "the handles down.");
    case Hint::Kind::Transform:
        return HintText::tr("Drag an arrow to move, a ring to turn, a box to scale; or type "
                            "numbers. <kbd>Esc</kbd> lays the handles down.");
    case Hint::Kind::TransformDrag:
        return HintText::tr("Drag to move %1; click to select it.").arg(name);
    case Hint::Kind::DragToMove:
        return HintText::tr("Drag to move; <kbd>Ctrl</kbd> leaves a copy, <kbd>Shift</kbd> keeps "
                            "to one direction.");
    case Hint::Kind::DragToTurn:
        return HintText::tr("Drag to turn; <kbd>Ctrl</kbd> leaves a copy.");
    case Hint::Kind::DragToScale:
        return HintText::tr("Drag to scale; <kbd>Ctrl</kbd> leaves a copy.");
    case Hint::Kind::Transforming:
        return HintText::tr("Release to leave it so. <kbd>Ctrl</kbd> leaves a copy, "
                            "<kbd>Esc</kbd> cancels.");
    case Hint::Kind::LeavingCopy:
        return HintText::tr("Release to leave a copy so. <kbd>Esc</kbd> cancels.");
    case Hint::Kind::TransformNumbers:
        return hint.number > 0
                   ? HintText::tr("<kbd>Enter</kbd> makes %n copies like this, each a step "
                                  "further. <kbd>Esc</kbd> cancels.",
                                  nullptr, hint.number)
                   : HintText::tr("<kbd>Enter</kbd> leaves it like this. <kbd>Esc</kbd> cancels.");
    case Hint::Kind::PickMarked:
        return HintText::tr("Click the section to engrave. <kbd>Esc</kbd> cancels.");
    case Hint::Kind::DrawMark:
        return HintText::tr("Drag to draw a line on %1; <kbd>Shift</kbd> keeps it straight. Click "
                            "to set words.")
            .arg(name);
    case Hint::Kind::DrawingMark:
        return HintText::tr("Release to leave the line so. <kbd>Esc</kbd> cancels.");
    case Hint::Kind::PlaceFigure:
        return hint.section.empty()
                   //: %1 is a shape ("Circle")
                   ? HintText::tr("%1: drag from its middle outwards; a click makes one of the "
                                  "usual size.")
                         .arg(figureName(hint.other))
                   //: %1 is a shape ("Circle"), %2 the name of a section
                   : HintText::tr("%1: drag from its middle outwards to cut it out of %2.")
                         .arg(figureName(hint.other), name);
    case Hint::Kind::SizeFigure:
        return HintText::tr("Release to make it so large; <kbd>Shift</kbd> keeps both sides alike. "
                            "<kbd>Esc</kbd> cancels.");
    case Hint::Kind::MeasureFrom:
        return HintText::tr("Drag from one place to another to measure; <kbd>Ctrl</kbd> snaps to "
                            "nothing. <kbd>Esc</kbd> ends.");
    case Hint::Kind::MeasureTo:
    case Hint::Kind::DimensionTo:
        return HintText::tr("Go to the second place. <kbd>Esc</kbd> cancels.");
    case Hint::Kind::Measured:
        return HintText::tr("Drag again to measure something else. <kbd>Esc</kbd> puts it away.");
    case Hint::Kind::DimensionFrom:
        return HintText::tr("Drag along something whose length you know; the whole model follows. "
                            "<kbd>Esc</kbd> ends.");
    case Hint::Kind::DimensionType:
        return HintText::tr("Type how long this shall be; <kbd>Enter</kbd> scales the whole model. "
                            "<kbd>Esc</kbd> cancels.");
    case Hint::Kind::DrawingRead:
        return drawingRead(hint, name);
    case Hint::Kind::DrawingOpen:
        return HintText::tr("Nothing imported: no line of %1 closes to an outline. It can be "
                            "engraved.")
            .arg(name);
    case Hint::Kind::DrawingLeft:
        return HintText::tr("%n outlines of %1 did not fit and were left out.", nullptr,
                            hint.number)
            .arg(name);
    case Hint::Kind::LetterUnknown:
        return HintText::tr("There is no letter \u201c%1\u201d to engrave.").arg(other);
    case Hint::Kind::MarkOutside:
        return HintText::tr("Nothing engraved: that lies beside %1.").arg(name);
    case Hint::Kind::NotScaled:
        return hint.other.empty()
                   ? HintText::tr("The model cannot be made that large or small.")
                   : HintText::tr("The model cannot be scaled so far: %1 would leave its bounds.")
                         .arg(other);
    case Hint::Kind::Locked:
        return HintText::tr("%1 is locked. Unlock it in the Outline to change it.").arg(name);
    case Hint::Kind::HeldByParent:
        return HintText::tr("%1 keeps its angle to %2. Free it to turn it any way.")
            .arg(name, other);
    case Hint::Kind::OnNothing:
        return HintText::tr("%1 is on no other section, so it has no angle to one.").arg(name);
    case Hint::Kind::CannotBeOn:
        return HintText::tr("%1 cannot be on %2, which is on it.").arg(name, other);
    case Hint::Kind::DoNotMeet:
        return HintText::tr("%1 and %2 do not meet: move one of them across the other first.")
            .arg(name, other);
    case Hint::Kind::NothingToPaste:
        return HintText::tr("Nothing pasted: nothing that was copied has sections in it.");
    case Hint::Kind::MadeByOperation:
        return HintText::tr("%1 is made by %2: edit its source, or detach this one.")
            .arg(name, other);
    case Hint::Kind::AlreadySymmetric:
        return HintText::tr("Nothing copied: the model is symmetric already.");
    case Hint::Kind::PickInput:
        return pickInput(hint);
    case Hint::Kind::NeverLeft:
        return HintText::tr(
                   "Nothing drawn: the slit never left %1. Start inside and drag across its edge.")
            .arg(name);
    case Hint::Kind::TooShort:
        return HintText::tr("Nothing drawn: the line is too short to enclose anything.");
    case Hint::Kind::NoArea:
        return HintText::tr("Nothing drawn: the line goes there and back and encloses nothing.");
    case Hint::Kind::CrossesWithoutLoop:
        return HintText::tr(
            "Nothing drawn: the line crosses itself, and no loop of it is large enough.");
    case Hint::Kind::HalvesDoNotMeet:
        return HintText::tr("%1 was not mirrored: the two halves would not meet.").arg(name);
    case Hint::Kind::CrossesItself:
        return undoKeys.isEmpty()
                   ? HintText::tr("The contour crosses itself; the largest loop was kept.")
                   : HintText::tr("The contour crosses itself; the largest loop was kept. "
                                  "<kbd>%1</kbd> undoes it.")
                         .arg(undoKeys.toHtmlEscaped());
    case Hint::Kind::NothingToClose:
        return HintText::tr("Not closed: the points enclose nothing yet.");
    case Hint::Kind::PathIsOpen:
        return HintText::tr("A contour is still open: <kbd>Enter</kbd> closes it, <kbd>Esc</kbd> "
                            "takes it back.");
    case Hint::Kind::CanvasGone:
        return HintText::tr("The points are gone, for the section that they stood on is.");
    case Hint::Kind::CutAtAxis:
        return HintText::tr("%1 was mirrored; what came over its axis and back was left out.")
            .arg(name);
    case Hint::Kind::CutAtGround:
        return HintText::tr("%1 was cut flat at the ground.").arg(name);
    case Hint::Kind::LargestPiece:
        return HintText::tr("Cut flat at the ground, %1 fell apart; the largest piece was kept.")
            .arg(name);
    case Hint::Kind::BelowGround:
        return HintText::tr("Nothing drawn: all of it lies below the ground, where it is cut off.");
    case Hint::Kind::HoleOutside:
        return HintText::tr("No hole made: it must lie in %1 and leave it in one piece.").arg(name);
    case Hint::Kind::HoleIsNotch:
        return HintText::tr("The hole reaches over the edge of %1 and was cut out of it.")
            .arg(name);
    case Hint::Kind::HolesMerged:
        return HintText::tr("The hole met others in %1; they are one hole now.").arg(name);
    case Hint::Kind::HolesLeftOut:
        return HintText::tr("Holes of %1 that lie outside of its new contour were left out.")
            .arg(name);
    case Hint::Kind::Failed:
        return HintText::tr(
            "Nothing drawn: no section can be made of this line. Draw it as one open loop.");
    }
    return {};
}

} // namespace fff::ui
