// The contract of gestures: what happens between a press that became a drag and its release. One
// file a gesture; Interaction decides which one begins and carries out what it answers.
#pragma once

#include "core/interaction/interaction.h"
#include "core/interaction/selection.h"
#include "core/interaction/shape_offer.h"

namespace fff {

/// What a gesture works with.
struct GestureContext
{
    const Model &model;                            // the committed one
    std::shared_ptr<const PulledTemplates> pulled; // may be null
    const InteractionSettings &settings;
    Vec2 viewport; // px
    Camera &camera;
    Overlay &overlay;
    Hovered &hovered;
    ViewState &view;
    const Selection &selection;
    const PointSelection &points;
};

struct GestureReply
{
    enum class State { Running, Over };
    struct Commit
    {
        Step step;
        Document document;
    };

    State state = State::Running;
    std::optional<Document> preview; // show this; none: show the committed document
    std::optional<Commit> commit;    // of a gesture, only when over
    std::optional<ShapeOffer> offer; // in place of what is committed, until something is done
    std::optional<Hint> note;        // why it came to nothing, or what there is to know
    std::optional<Camera> returnTo;  // turn the view back to where it was
    std::optional<Camera> turnTo;    // turn the view there, as a view of its own
    struct Settling
    {
        Camera camera;
        double time = 0.0; // ms
    };
    std::optional<Settling> settling; // over in the middle of a turn: the view goes on to there
    std::optional<std::vector<SectionRef>> select;
    std::optional<OperationId> selectOperation; // of what is committed
    std::optional<LoadId> selectLoad;           // the same
    /// Of a tool: the press was a click that it has no use for.
    bool isClick = false;
    /// Of a tool that turns the view by itself: where it was before.
    std::optional<Camera> left;
    std::optional<std::vector<PointAddress>>
        selectPoints; // of the preview, or of what is committed
};

class Gesture
{
public:
    virtual ~Gesture() = default;

    /// Moves and the release; the press is given to the constructor.
    virtual GestureReply handle(const PointerEvent &event, GestureContext &context) = 0;
    /// Moves its animation on to `time`.
    virtual void advance(double /*time*/, GestureContext & /*context*/) {}
    virtual bool isAnimating() const { return false; }
    /// Leaves no trace but what the reply says.
    virtual GestureReply cancel(GestureContext &context) = 0;

    /// What it draws could be made better by one key (Interaction::takeOffer).
    virtual bool hasOffer() const { return false; }
    virtual void takeOffer() {}

    /// What it draws could go all round a guide at once (Interaction::takeGuide).
    virtual bool hasGuide() const { return false; }
    virtual GestureReply takeGuide(GestureContext & /*context*/) { return {}; }

    /// It moves the view alone: what lies over the model stays.
    virtual bool isOfView() const { return false; }
    /// It drags control points, which are shown meanwhile.
    virtual bool marksPoints() const { return false; }
    /// It puts the marks of joints among what is selected by itself.
    virtual bool marksJoints() const { return false; }
    /// The same of the handles of an operation.
    virtual bool marksOperation() const { return false; }

    virtual Hint hint() const = 0;
    virtual Cursor cursor() const = 0;
};

} // namespace fff
