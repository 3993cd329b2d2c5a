// The single stroke: one press, one way, one release make a section (paper, "Single stroke planar
// section creation"). Pure: knows points and times, no camera, no document.
#pragma once

#include "core/stroke/leaving.h"
#include "core/stroke/steady_hand.h"
#include "core/stroke/stroke_contour.h"
#include "core/stroke/thinned_line.h"

namespace fff {

/// States and what takes one to the next:
///
///     Idle      beginOnCanvas              -> Contour    the first section has no slit
///     Idle      beginInSection             -> Slit
///     Slit      move that leaves the shape -> Turn       holes are outside
///     Slit      release                    -> Cancelled  NeverLeft
///     Turn      advance past its end       -> DeadZone   positions are not looked at
///     Turn      endTurn                    -> DeadZone   the hand does not wait
///     DeadZone  move that leaves the zone  -> Contour    begins on the zone's border
///     Turn, DeadZone  release              -> Cancelled  TooShort
///     Contour   release                    -> Done       or Cancelled, TooShort, without an area
///     any but Done    cancel               -> Cancelled
///
/// While in Slit, points are in the frame of the section; after it in that of the canvas: the plane
/// that is drawn on, its origin at the slit's start and its x axis along the slit, so that the slit
/// is the segment from (0, 0) to (slitLength(), 0) there. A slit shorter than kMinOverlap has no
/// direction to speak of and cancels with TooShort.
class Stroke
{
public:
    enum class State { Idle, Slit, Turn, DeadZone, Contour, Done, Cancelled };
    enum class Refusal { None, NeverLeft, TooShort };

    struct Sample
    {
        double time = 0.0; // ms
        Vec2 point = Vec2::Zero();
    };
    struct Options
    {
        double turnTime = 800.0;     // ms
        double deadZoneRadius = 0.0; // mm
        StrokeContourOptions contour;
    };

    /// Of the tolerance, what a sample has to add to be kept: a third of a pixel where that is two.
    static constexpr double kThinning = 0.15;

    explicit Stroke(const Options &options)
        : m_options(options), m_hand(options.contour.tolerance),
          m_line(kThinning * options.contour.tolerance), m_meant(fitOptions(options.contour))
    {
    }

    void beginOnCanvas(const Sample &sample);
    /// The sample's point lies inside the shape.
    void beginInSection(ShapePointer shape, const Sample &sample);
    /// Call advance(sample.time) before it: after a turn the point is one on the canvas.
    void move(const Sample &sample);
    /// The slit ends there, not at the cursor or where the way left: a guide leads it. None: it is
    /// as it was drawn. Only in Slit, and in Turn before anything has looked at the slit.
    void leadSlit(const std::optional<Vec2> &to);
    /// The view has moved while the cursor rested in the dead zone, and is over this point now.
    void viewMoved(const Vec2 &point);
    /// Whether what is one-sided is mirrored; may change while it is drawn.
    void setSymmetryOn(bool on);
    /// Curves on the canvas that the contour follows where it comes near them; null: none.
    void setGuides(std::shared_ptr<const Guides> guides);
    /// The slit is to hold what is drawn, in a section of this thickness, mm. Once it has ended.
    void reachSlit(double thickness);
    /// Whether what is drawn from now on goes free of them, and what is drawn beside the slit stays
    /// there.
    void setFree(bool isFree);
    /// Where the last move was.
    void release();
    void cancel();
    void advance(double time);
    /// Positions count from now on: those that come next are on the canvas.
    void endTurn();

    State state() const { return m_state; }
    Refusal refusal() const { return m_refusal; }

    /// Of the section that the slit is in; only once it has begun there.
    const Interior &interior() const { return *m_interior; }
    /// The slit in the section's frame; until it has left, it ends at the cursor.
    const Vec2 &slitFrom() const { return m_slitFrom; }
    const Vec2 &slitTo() const { return m_slitTo; }
    /// The last that was drawn in the section: in haste that is a good way before it left, on which
    /// the hand may have turned already.
    const Vec2 &lastInside() const { return m_lastInside; }
    double slitLength() const { return (m_slitTo - m_slitFrom).norm(); }
    double tolerance() const { return m_options.contour.tolerance; }
    double deadZoneRadius() const { return m_options.deadZoneRadius; }
    /// ms
    double turnEnd() const { return m_turnStart + m_options.turnTime; }
    /// How far the turn has come at a time, eased, 0 … 1.
    double turnProgress(double time) const;

    /// Those that say something new (thinned_line.h). Canvas coordinates, finite, no two equal in a
    /// row.
    const std::vector<Vec2> &samples() const { return m_line.points(); }
    /// Changes with them.
    std::uint64_t revision() const { return m_line.revision(); }
    /// What is to hold the contour; none while it is free.
    std::optional<SlitToReach> slit() const { return m_isFree ? std::nullopt : m_slit; }
    /// What is fitted, and what of that stays as it is, whatever is drawn next.
    const MeantLine &meant() const;
    /// What a release would make now. Kept until the next sample that adds something.
    const StrokeContour &contour() const;

private:
    void moveInSection(const Sample &sample);
    void moveInDeadZone(const Vec2 &point);
    void addSample(const Vec2 &point);
    void noteFree();
    void refuse(Refusal refusal);
    double distanceToSlit(const Vec2 &point) const;

    Options m_options;
    State m_state = State::Idle;
    Refusal m_refusal = Refusal::None;
    std::optional<Interior> m_interior;
    Vec2 m_slitFrom = Vec2::Zero(), m_slitTo = Vec2::Zero();
    Vec2 m_slitDrawn = Vec2::Zero(); // its end, led by nothing
    Vec2 m_lastInside = Vec2::Zero();
    double m_turnStart = 0.0; // ms
    Vec2 m_last = Vec2::Zero();
    SteadyHand m_hand;
    ThinnedLine m_line;
    bool m_isFree = false;
    std::optional<SlitToReach> m_slit;
    mutable MeantLine m_meant; // follows when it is looked at, and every so often
    mutable std::optional<StrokeContour> m_contour;
};

} // namespace fff
