// The one modeless way of working: turns events into camera moves, previews and commits. Pure of
// window, widgets and clocks: the window and `replay` feed it the same events, time comes with each
// of them.
#pragma once

#include "core/interaction/camera.h"
#include "core/interaction/navigation.h"
#include "core/interaction/overlay.h"
#include "core/interaction/pick.h"
#include "core/interaction/point_editing.h"
#include "core/interaction/pointer_event.h"
#include "core/interaction/problem_marks.h"
#include "core/interaction/section_edit.h"
#include "core/interaction/view_state.h"
#include "core/model/hint.h"
#include "core/model/naming.h"
#include "core/model/step.h"

#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace fff {

enum class Cursor {
    Arrow,
    Pencil,
    PencilWithSlit,
    PencilWithClock,
    TurningArrows,
    Hand,
    MoveCross,
    Pen,
    PenCloses, // the path
    ArrowWithPlus
};

/// What interaction asks of whoever holds the model (the session).
struct PulledTemplates;

class InteractionHost
{
public:
    virtual ~InteractionHost() = default;
    virtual const Model &model() const = 0; // the committed one
    /// What magnets make of templates, of the newest model that this is known of; may be null.
    virtual std::shared_ptr<const PulledTemplates> pulled() const { return nullptr; }
    virtual void preview(Document document) = 0;
    virtual void cancelPreview() = 0;
    virtual void commit(const Step &step, Document document) = 0;
    /// The mark of this number was clicked, of several places of its row that one.
    virtual void chooseProblem(int /*number*/, int /*place*/) {}
    /// The handle of this parameter was clicked.
    virtual void chooseParameter(OperationId /*operation*/, const std::string & /*key*/) {}
};

struct InteractionSettings
{
    NavigationPreset navigation = NavigationPreset::FlatFitFab;
    double turnTime = 800.0; // ms; 0 jumps
    /// Between the view and the slit's section at the end of a turn, radians: at a right angle the
    /// canvas is seen straight, with less its section stays readable.
    double turnAngle = std::numbers::pi / 2.0;
    bool mirrors = true;       // local symmetry: a stroke on one side of its slit is mirrored
    bool mirrorsFirst = false; // also the first section's, across the vertical through its start
    bool cutsAtGround = true;  // contours end at Y = 0
    bool snaps = true;         // points that the pen sets or moves, and sections that are moved
    double guideReach = 12.7;  // mm from which points are caught by guides (snapping.h)
    bool takesChildren = true; // what was drawn on a section goes along with it
    std::string figure = "rectangle"; // kind of the next one that is drawn
    bool scores = false;              // marks are scored, not engraved
    bool movesInSpace = false;        // along the world's axes rather than in the section's plane
    double deadZoneFraction = 0.025;  // of the viewport's width
    double dragThreshold = 4.0;       // px
    double nameDelay = 400.0;         // ms that the cursor rests before a name is shown
    double fitTolerance = 2.0;        // px that the fitted contour may be off the samples
    Naming naming;                    // of what is drawn
};

class Tool;
struct CanvasChoice;
struct ToolNumber;

class Interaction
{
public:
    explicit Interaction(InteractionHost &host);
    ~Interaction();

    void setViewport(const Vec2 &size); // px
    const Vec2 &viewport() const;
    InteractionSettings &settings();
    const InteractionSettings &settings() const;

    const Camera &camera() const;
    /// Where the running animation ends; the camera itself when none runs.
    const Camera &targetCamera() const;
    /// At once. Like turnTo, ends a gesture: what is drawn belongs to the view it began in.
    void setCamera(const Camera &camera);
    /// Looks as `from` does at all that is seen, so that it fills what nothing covers of the view.
    /// As long as neither camera nor document is another one, it does so whatever room there is.
    void fitAll(const Camera &from, double time, double duration);
    /// The same of these world points; it does not follow the room.
    void fit(std::span<const Vec3> points, double time, double duration);
    /// Boxes of what stands over the view, px: marks keep out of them, and what is fitted does.
    /// passing: what comes and goes with the tool in the hand; nothing is fitted anew for it, or
    /// the model would leap from under the cursor.
    void setCovered(std::vector<Box2> covered, const std::vector<Box2> &passing = {});
    /// Both.
    const std::vector<Box2> &covered() const;
    /// What is seen besides the sections, such as a glass that stands on them: world points round
    /// it.
    void setSeenBesides(std::vector<Vec3> points);
    /// Animated from `time` on, in `duration` ms (0: at once). A press finishes it at once.
    void turnTo(const Camera &camera, double time, double duration);
    /// Keeps what the model's middle, or that of the selection, looks like; no step of the history.
    void setProjection(Projection projection);
    /// To the view before this one, animated as turnTo.
    void goBack(double time, double duration);
    bool canGoBack() const;
    /// Another document: the views of the one before, and what was selected there and deleted, are
    /// of no use in this one.
    void forgetViews();

    const ViewState &view() const;
    void setView(ViewState view);

    /// Whoever only looks turns, pushes and zooms the view; nothing of the model is marked,
    /// selected or edited, and no tool is held. What was is laid down.
    void setLooksOnly(bool looksOnly);
    bool looksOnly() const;

    /// Marks of problems: to be hovered and clicked, in the way of nothing else.
    const std::vector<ProblemMark> &marks() const;
    void setMarks(std::vector<ProblemMark> marks);
    /// A tool, or what a drag changes, is in the hand: only its own marks are seen and hit then.
    bool isHandBusy() const;
    /// The joints of what is selected are listed somewhere: so their marks are all there, not only
    /// those under the cursor.
    void setListsJoints(bool lists);

    void handle(const PointerEvent &event);
    /// Esc: one step back (gesture, tool, selection, cut, isolated sections). True when there was
    /// something to go back from.
    bool escape(double time);
    /// Moves animations on to `time`; true while one runs, so that the caller asks again.
    bool advance(double time);
    bool isAnimating() const;
    bool hasGesture() const;
    /// When something will change that no event brings (a name appears, a note goes): advance()
    /// wants to be called then. ms; none while nothing is waited for.
    std::optional<double> wakeTime() const;

    /// Holds a tool, in place of the one held before; the same one again is laid down.
    void pickUp(std::unique_ptr<Tool> tool, double time);
    /// As Esc does, to the end.
    void layDown(double time);
    /// Null: none is held.
    const Tool *tool() const;
    bool wants(ToolKey key) const;
    /// True when the tool had a use for it.
    bool key(ToolKey key, double time);
    /// A canvas was picked: true when the tool in hand draws there.
    bool useCanvas(const CanvasChoice &canvas, double time);
    /// Steps of the tool in hand, which Undo and Redo go through first. Each: false when there is
    /// none.
    bool canUndoInTool() const;
    bool canRedoInTool() const;
    bool undoInTool(double time);
    bool redoInTool(double time);
    /// What can be typed for the tool in hand; none while there is no use for numbers.
    std::vector<ToolNumber> numbers() const;
    /// Shown until Enter (key) does it, or they are dropped.
    void setNumbers(const std::vector<ToolNumber> &numbers, double time);
    void dropNumbers(double time);

    const std::vector<SectionRef> &selection() const;
    void select(std::vector<SectionRef> selection);
    /// None unless a joint is selected, in place of sections.
    const std::optional<JointRef> &selectedJoint() const;
    void selectJoint(const JointRef &joint);
    /// Not valid unless an operation is selected, in place of sections.
    OperationId selectedOperation() const;
    void selectOperation(OperationId id);
    /// Not valid unless a weight is selected, in place of all else.
    LoadId selectedLoad() const;
    void selectLoad(LoadId id);
    /// It, or the one that made all that is selected.
    OperationId operationInFocus() const;
    /// The sections that are selected and there; of an operation those that it made or changed.
    std::vector<SectionRef> sectionsInFocus() const;
    /// The selected control points of the selected section.
    const PointSelection &points() const;
    void selectPoints(std::vector<PointAddress> points);
    /// The drawn section, as committed, whose points can be edited: the one that is selected, or
    /// whose image is. Null when there is none.
    SectionPointer sectionOfPoints() const;
    /// The committed document, with that section as it is shown: what edits of its points begin
    /// with.
    Document documentOfPoints() const;
    /// The place of its contour that is under the cursor.
    std::optional<PointTarget> hoveredPoint() const;
    /// Commits an edit of points and selects those that it names, or says why it was refused.
    void carryOut(PointEdit edit, double time);
    /// Says it for a while, in place of what the next gesture does.
    void say(const Hint &hint, double time);
    /// Commits an edit of sections, or says why it was refused.
    void carryOut(SectionEdit edit, double time);
    /// An arrow key: where the slits of the selected joint meet goes along its axis if that runs so
    /// on the screen; the selected weight, the selected points, else the selected sections, go
    /// along the axis that is nearest to the arrow. arrow: unit, right and up; distance: mm. False
    /// when the arrow is not for what is selected.
    bool nudge(const Vec2 &arrow, double distance, double time);
    /// What was just drawn is offered as what it was meant to be (shape_offer.h), until the next
    /// press, edit or Esc; or what is being drawn is (Gesture::hasOffer).
    bool hasOffer() const;
    /// Commits it, or goes on with it; does nothing where there is none.
    void takeOffer(double time);
    /// What is being drawn could go all round a guide (Gesture::hasGuide).
    bool hasGuide() const;
    /// It does, and is over; does nothing where there is none.
    void takeGuide(double time);
    /// What edits of points go by.
    PointRules pointRules() const;

    /// The model changed (commit, undo, another document): what is no longer there is not selected,
    /// until it comes back.
    void modelChanged();

    const Overlay &overlay() const;
    const Hovered &hovered() const;
    const Hint &hint() const;
    Cursor cursor() const;

private:
    class Private;
    std::unique_ptr<Private> d;
};

} // namespace fff
