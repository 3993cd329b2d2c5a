// The single stroke in the view: feeds the stroke's state machine with points on planes, turns the
// camera and shows what a release would make.
#pragma once

#include "core/interaction/canvas_turn.h"
#include "core/interaction/contour_target.h"
#include "core/interaction/gesture.h"
#include "core/interaction/hand_in_turn.h"
#include "core/interaction/slit_guides.h"
#include "core/interaction/template_guides.h"
#include "core/stroke/stroke.h"

namespace fff {

/// The plane of the first section, through (0, kFirstPlaneHeight, 0): upright and across the view,
/// or level where that looks down or up steeply. Nearly along the world's axes it is so. What is
/// drawn is seen where it was drawn, and the model does not begin with a part that leans.
Frame firstCanvas(const Camera &camera);

/// A hand that does not wait for the turn (HandInTurn) loses nothing of its way: it is taken as a
/// way on the screen that the turn ends with, from the slit's end on. That is what the hand means:
/// a stroke of less than a second is over before what it sees could guide it, and on its way the
/// canvas is seen on edge, where a pixel is a metre. So haste and patience draw the same. The rest
/// of the turn is quick then.
///
/// The contour is shown with every move as long as the moves pay for it: each adds kCreditOfMove
/// to what there is from the beginning, which is enough for all of a usual stroke. Of a long one,
/// moves show the line of the cursor alone until it is paid for; a frame (Interaction::advance) or
/// the release shows all of it in any case. What takes too long even for a frame, as a scribble of
/// thousands of samples does, waits until the hand rests or releases.
class StrokeGesture : public Gesture
{
public:
    /// In samples that are looked at (StrokeContour::work).
    static constexpr std::size_t kFirstCredit = 3'000'000, kCreditOfMove = 400;
    static constexpr std::size_t kMostOfFrame = 80'000;
    static constexpr double kRest = 120.0; // ms
    /// Of a turn's time, what the rest of it takes for a hand that does not wait.
    static constexpr double kQuickTurn = 0.3;

    // The camera's target lies at the depth of what was pressed, so that pixels count there.
    // Shift, while it is held, switches local symmetry over.
    /// On a canvas that the view looks at: the contour begins where it was pressed.
    StrokeGesture(const PointerEvent &press, ContourTarget target, const GestureContext &context);
    /// On a section, from the point that was hit: the slit comes first.
    StrokeGesture(const PointerEvent &press, const Hit &hit, const GestureContext &context);

    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    void advance(double time, GestureContext &context) override;
    bool isAnimating() const override;
    GestureReply cancel(GestureContext &context) override;
    /// The slit has material on one side only: moved in from the edge it has it on both. Taken
    /// again it goes back.
    bool hasOffer() const override;
    void takeOffer() override { m_isMovedIn = m_movedIn && !m_isMovedIn; }
    bool hasGuide() const override;
    GestureReply takeGuide(GestureContext &context) override;
    Hint hint() const override;
    Cursor cursor() const override;

private:
    struct Ground // the section that the stroke began on
    {
        SectionRef ref;
        SectionPointer section;
    };

    const Frame &plane() const; // that the cursor is on
    /// What is made: on that plane, or on one beside it.
    const ContourTarget &target() const { return m_isMovedIn ? *m_movedIn : m_target; }
    /// None where that plane is seen on edge.
    std::optional<Vec2> pointAt(const Vec2 &screen, const GestureContext &context) const;
    Hint releaseHint(const std::string &section) const;
    /// That what is drawn is meant in.
    Camera view(const GestureContext &context) const;
    void leadSlit(const PointerEvent &event, const GestureContext &context);
    void lookAtWalls(const GestureContext &context);
    void lookAtTemplates(const GestureContext &context);
    void followTemplates(const GestureContext &context);
    void addTemplates(const GestureContext &context, Signs &signs) const;
    void moveTo(const PointerEvent &event, GestureContext &context);
    void beginTurn(const PointerEvent &event, GestureContext &context);
    void followHand(const PointerEvent &event, GestureContext &context);
    void goOn(double time, GestureContext &context);
    void turnView(double time, GestureContext &context);
    void makeRoom(double time, GestureContext &context);
    bool isToShow(const PointerEvent &event);
    bool canShow();
    bool isDear() const { return m_price > kMostOfFrame; }
    Frame rulers(const GestureContext &context) const;
    void addWalls(Signs &signs) const;
    void updateOverlay(GestureContext &context) const;
    void followSamples(GestureContext &context) const;
    void updateDrawn(const GestureContext &context);
    DrawingRules rulesOf(const GestureContext &context) const;
    void updateOffer(const GestureContext &context);
    void offerMovedIn(const GestureContext &context);
    void keepMovedIn(const GestureContext &context);
    GestureReply reply(GestureContext &context);
    GestureReply running() const;
    GestureReply over() const;
    GestureReply done(const GestureContext &context);

    Stroke m_stroke;
    bool m_mirrors = true; // as it is set
    bool m_isAxisSlit = true;
    std::optional<Ground> m_ground;
    std::optional<SlitGuides> m_guides; // of the slit
    std::optional<SlitGuide> m_guide;   // that it goes along
    TemplateGuides m_templates;         // what its plane cuts of them
    std::string m_followed;             // the name of the one that it may follow; empty: none
    bool m_canFollow = false;           // what it draws is caught by guides
    ContourTarget m_target;
    std::optional<Vec3> m_missing;          // world, unit: where the slit has no wall
    std::optional<ContourTarget> m_movedIn; // where it has
    bool m_isMovedIn = false;
    bool m_wasPutBack = false; // moved in it would have done harm
    std::optional<CanvasTurn> m_turn;
    std::optional<HandInTurn> m_hand;
    std::optional<QuickTurn> m_quick; // until it is over
    std::optional<RoomPan> m_room;
    Camera m_before;    // of the stroke: where Esc returns to
    Vec2 m_cursor;      // px
    double m_now = 0.0; // ms
    bool m_isMovingToRoom = false;
    std::uint64_t m_drawnRevision = 0;                       // of the samples of m_drawn
    bool m_drawnMirrored = false;                            // whether it was mirrored,
    bool m_drawnMovedIn = false;                             // moved in,
    bool m_drawnBeside = false;                              // or given a neck
    std::optional<tl::expected<DrawnContour, Hint>> m_drawn; // none: nothing is enclosed yet
    std::optional<ShapeOffer> m_offer;                       // of what is committed
    // What showing the contour may cost, and cost the last time, in samples looked at.
    std::size_t m_credit, m_price = 0;
    bool m_isBehind = false; // samples are not in what is shown yet
    double m_sampled = 0.0;  // ms, when the last of them came
};

} // namespace fff
