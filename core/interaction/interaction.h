// The one modeless way of working: turns events into camera moves, previews and commits. Pure of
// window, widgets and clocks: the window and `replay` feed it the same events, time comes with each
// of them.
#pragma once

#include "core/interaction/camera.h"
#include "core/interaction/pick.h"
#include "core/interaction/problem_marks.h"
#include "core/interaction/view_cube.h"
#include "core/interaction/view_state.h"
#include "core/model/naming.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fff {

enum class Button { None, Left, Middle, Right };

struct Modifiers
{
    bool shift = false, control = false, space = false;
};

struct PointerEvent
{
    enum class Type { Press, Move, Release, Wheel, Zoom, Scroll, DoubleClick, Leave };
    Type type = Type::Move;
    Vec2 position = Vec2::Zero(); // px
    Button button = Button::None; // that was pressed or released
    Modifiers modifiers;
    double wheelSteps = 0.0;    // notches, positive away from the person
    double zoomFactor = 1.0;    // Zoom: two fingers apart; above 1 is nearer
    Vec2 scroll = Vec2::Zero(); // Scroll: px that two fingers push the picture
    double time = 0.0;          // ms, the only clock
    /// More moves are at hand and follow at once: this one is taken in, nothing is shown for it.
    bool isFollowed = false;
};

/// What a commit did; ui makes the words ("Draw Section 3") of it.
struct Step
{
    enum class Kind {
        DrawSection,
        DeleteSections,
        RenameSection,
        MoveSection,
        SetStock,
        EditStock
    };
    Kind kind = Kind::DrawSection;
    std::vector<std::string> names; // of the sections or stocks it was done to
};

/// What the next click or drag does, or why one came to nothing; ui makes the sentence (ui/UI.md,
/// 8).
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
        Orbiting,
        Panning,
        LookFrom,      // section: nameOfPart() of the cube's part
        MoveCut,       // over the handle
        MovingCut,     // dragging it
        ChooseProblem, // section: the number of its mark
        NeverLeft,
        TooShort,
        CrossesItself,
        Failed
    };
    Kind kind = Kind::TurnView;
    std::string section;    // the name that the sentence speaks of
    bool isRefusal = false; // amber, stays for 6 s or until the next press
    bool operator==(const Hint &) const = default;
};

enum class Cursor {
    Arrow,
    Pencil,
    PencilWithSlit,
    PencilWithClock,
    TurningArrows,
    Hand,
    MoveCross
};

/// What is drawn over the model during a gesture. World points are mm, screen points px.
struct Overlay
{
    struct SlitLine
    {
        Vec3 from, to;        // pressed point, cursor or leaving point
        bool hasLeft = false; // `to` is where the stroke left the section
    };
    struct DeadZone
    {
        Vec3 from, to;       // the slit
        double radius = 0.0; // px
    };
    struct Stroke
    {
        Frame canvas;
        std::vector<Vec2> samples;          // frame coordinates of canvas
        std::vector<CubicBezier> fitted;    // open chain as drawn so far
        std::optional<CubicBezier> closing; // the piece that a release would add
    };
    std::optional<SlitLine> slit;
    std::optional<DeadZone> deadZone;
    std::optional<Stroke> stroke;
    std::optional<Vec3> slitStart; // hovering: where a slit would begin
    int hovered = -1;              // index of the section under the cursor
    /// The cursor has rested on a section: its name may be shown there (px).
    std::optional<Vec2> namePlace;
    std::optional<CubePart> cubePart; // of the view cube, under the cursor
    bool isHandleHovered = false;     // of the cut
    int mark = 0;                     // number of the problem's mark under the cursor; 0: none
};

/// What interaction asks of whoever holds the model (the session).
class InteractionHost
{
public:
    virtual ~InteractionHost() = default;
    virtual const Model &model() const = 0; // the committed one
    virtual void preview(Document document) = 0;
    virtual void cancelPreview() = 0;
    virtual void commit(const Step &step, Document document) = 0;
    /// The mark of this number was clicked.
    virtual void chooseProblem(int /*number*/) {}
};

struct InteractionSettings
{
    double turnTime = 800.0;         // ms; 0 jumps
    double deadZoneFraction = 0.025; // of the viewport's width
    double dragThreshold = 4.0;      // px
    double nameDelay = 400.0;        // ms that the cursor rests before a name is shown
    double fitTolerance = 2.0;       // px that the fitted contour may be off the samples
    Naming naming;                   // of what is drawn
};

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

    /// Numbers beside problems: to be hovered and clicked, in the way of nothing else.
    const std::vector<ProblemMark> &marks() const;
    void setMarks(std::vector<ProblemMark> marks);

    void handle(const PointerEvent &event);
    /// Esc: one step back (gesture, selection, cut, isolated sections). True when there was
    /// something to go back from.
    bool escape(double time);
    /// Moves animations on to `time`; true while one runs, so that the caller asks again.
    bool advance(double time);
    bool isAnimating() const;
    bool hasGesture() const;
    /// When something will change that no event brings (a name appears, a note goes): advance()
    /// wants to be called then. ms; none while nothing is waited for.
    std::optional<double> wakeTime() const;

    const std::vector<SectionRef> &selection() const;
    void select(std::vector<SectionRef> selection);
    /// The model changed (commit, undo, another document): what is no longer there is not selected,
    /// until it comes back.
    void modelChanged();

    const Overlay &overlay() const;
    const Hint &hint() const;
    Cursor cursor() const;

private:
    class Private;
    std::unique_ptr<Private> d;
};

} // namespace fff
