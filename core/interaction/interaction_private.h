// What Interaction keeps between events, for the files that implement it: interaction.cpp (what
// others ask), interaction_pointer.cpp (events), interaction_replies.cpp (what gestures and tools
// answer), interaction_tool.cpp (the tool in the hand), interaction_points.cpp (control points),
// interaction_joints.cpp (marks of joints), interaction_fit.cpp (what fills the view),
// interaction_loads.cpp (loads), interaction_sections.cpp (edits of whole sections),
// interaction_offer.cpp (what a stroke was meant to be), interaction_looking.cpp (whoever only
// looks).
#pragma once

#include "core/interaction/click_selection.h"
#include "core/interaction/hover_words.h"
#include "core/interaction/hovering.h"
#include "core/interaction/interaction.h"
#include "core/interaction/routing.h"
#include "core/interaction/tool.h"
#include "core/interaction/view_gestures.h"
#include "core/interaction/view_motion.h"
#include "core/model/origin.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <tuple>
#include <utility>

namespace fff {

/// Nearer by this factor for each notch of the wheel.
inline constexpr double kZoomPerNotch = 1.2;
/// How long the view takes to return when a gesture comes to nothing, ms; never longer than a turn.
inline constexpr double kReturnTime = 400.0;
/// How long a note or a refusal is said, ms, unless a press comes first.
inline constexpr double kNoteTime = 6000.0;
/// A click on the view cube turns in this time, ms; never longer than a turn.
inline constexpr double kCubeTime = 400.0;
/// Between the two presses of a double click, ms.
inline constexpr double kDoubleClickTime = 400.0;

/// Says, as long as it lives, that what changes is a tool's own doing.
class QuietTool
{
public:
    explicit QuietTool(bool &isCommitting) : m_isCommitting(isCommitting), m_was(isCommitting)
    {
        m_isCommitting = true;
    }
    ~QuietTool() { m_isCommitting = m_was; }
    QuietTool(const QuietTool &) = delete;
    QuietTool &operator=(const QuietTool &) = delete;

private:
    bool &m_isCommitting;
    const bool m_was;
};

struct Note
{
    Hint hint;
    double until = 0.0; // ms
};

class Interaction::Private
{
public:
    explicit Private(InteractionHost &h) : host(h), document(h.model().document) { fitFirst(); }

    GestureContext context()
    {
        return {host.model(), host.pulled(), settings, motion.viewport, motion.camera,
                overlay,      hovered,       view,     selection,       points};
    }
    Sight sight() const
    {
        const std::span<const ProblemMark> seen =
            isHandBusy() ? std::span<const ProblemMark>() : marks;
        return {host.model(), motion.camera, motion.viewport, view, seen, covered};
    }
    void fitFirst();
    void keepFit();
    Camera fittedToAll(const Camera &from, std::span<const Box2> beside) const;
    void followRoom();
    bool isHandBusy() const;

    void moveOn(double time);
    void showLate();
    void showNow();

    void press(const PointerEvent &event);
    void move(const PointerEvent &event);
    void release(const PointerEvent &event);
    void roll(const PointerEvent &event, const std::function<Camera(const Camera &)> &moved);
    void zoom(const PointerEvent &event, double factor);
    void scroll(const PointerEvent &event);
    void twist(const PointerEvent &event);
    void leave();

    void beginWithSecondButton(std::unique_ptr<Gesture> next);
    bool toolTakes(const PointerEvent &event);
    bool toolHasUse(const PointerEvent &press);
    void feedTool(const PointerEvent &event);
    void click(const PointerEvent &press);
    void feed(const PointerEvent &event);
    void take(GestureReply reply);
    void takeFromTool(GestureReply reply);
    void carryOut(GestureReply &reply);
    void layToolDown();
    void showPreview(std::optional<Document> shown);
    bool cancelGesture();
    bool cancelTool();

    bool isSecondClick(const PointerEvent &press);
    bool addPointAt(const PointerEvent &press);
    bool clickPoint(const PointerEvent &press);
    void selectPoints(std::vector<PointAddress> addresses, const Document &of);
    Document documentOfPoints() const;
    PointRules rulesOfPoints() const;
    bool isEdited(const EditedPoints &edit) const;
    /// Says why it was refused, or what became of it; false: it was refused.
    template <class Edit>
    bool isTaken(const Edit &edit)
    {
        cancelGesture();
        note.reset();
        offer({});
        if (!edit)
            note = Note{edit.error(), now + kNoteTime};
        else if (edit->note)
            note = Note{*edit->note, now + kNoteTime};
        return edit.has_value();
    }
    void carryOut(PointEdit edit);
    void carryOut(SectionEdit edit);

    void hover();
    void hoverViewOnly();
    void hoverMarks();
    void hoverJoint();
    void hoverMagnet();
    void markMagnet();
    Hint magnetHint() const;
    void hoverPoint();
    void markPoints();
    void markJoints();
    bool marksSelection() const;
    const JointMark *jointMarkAt(const Vec2 &position);
    void hoverOperation();
    void markOperation();
    std::optional<OperationHandle> operationHandleAt(const Vec2 &position);
    void hoverLoad();
    LoadId loadAt(const Vec2 &position);
    bool nudgeMeetingPoints(const JointRef &joint, const Vec2 &arrow, double distance);
    void clearOverlay();
    void update();
    void offer(std::optional<ShapeOffer> shape);
    void turn(const Camera &to, double start, double duration);
    void stopMotion();
    void feedClick(const PointerEvent &press);

    InteractionHost &host;
    InteractionSettings settings;
    ViewMotion motion;
    ViewState view;
    std::vector<ProblemMark> marks;
    std::vector<Box2> covered;     // of the view, px
    std::vector<Box2> lasting;     // of these, what does not come and go with tools
    std::vector<Vec3> seenBesides; // world
    Document fittedDocument;       // that the view was fitted to
    double now = 0.0;              // ms, of the last event

    Document document; // committed, as known here
    Selection selection;
    PointSelection points;
    std::optional<PointTarget> hoveredPoint;
    JointMarks jointMarks;
    std::optional<JointMark> hoveredJoint;
    bool listsJoints = false;
    bool looksOnly = false;
    int sectionUnderCursor = -1;                  // also where a mark lies before it
    std::optional<OperationHandle> hoveredHandle; // of the selected operation
    bool isOverMagnet = false;                    // the handle of one
    Pointer pointer = Pointer::Mouse;             // of the last event
    ClickSelection clicks;
    std::optional<PointerEvent> lastClick; // the first of two, maybe

    std::vector<PointerEvent> pending; // a press and its moves, not yet a click or a drag
    std::unique_ptr<Gesture> gesture;
    bool hasSecondButton = false; // turns the view as long as it is pressed
    std::unique_ptr<Tool> tool;
    bool isToolPressed = false;    // the left button, for the tool
    PointerEvent toolPress;        // of it
    bool isToolCommitting = false; // what changes then is its own doing
    bool hasPreview = false;       // of the gesture
    Camera cameraBefore;           // the gesture
    Button pressed = Button::None;
    Hovering hovering;
    Modifiers modifiers;

    std::optional<ShapeOffer> offered;
    Overlay overlay;
    Hovered hovered;
    std::optional<Note> note;
    Hint hint = Hint::ofView(hints::kTurnView);
    Cursor cursor = Cursor::Arrow;
};

} // namespace fff
