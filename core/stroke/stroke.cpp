#include "core/stroke/stroke.h"

#include "core/base/easing.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cassert>

namespace fff {

namespace {

/// Halvings of the way across the dead zone's border: down to the last bit.
constexpr int kBisections = 60;
/// Samples after which what is meant by them is followed, so that none of them costs much.
constexpr std::size_t kFollowed = 32;
/// So many radii of the dead zone, on whose border it begins, a contour may be away from its slit.
constexpr double kReach = 2.0;

} // namespace

void Stroke::beginOnCanvas(const Sample &sample)
{
    assert(m_state == State::Idle && "a stroke begins once");
    m_state = State::Contour;
    if (sample.point.allFinite())
        addSample(sample.point);
}

void Stroke::beginInSection(ShapePointer shape, const Sample &sample)
{
    assert(m_state == State::Idle && "a stroke begins once");
    m_interior.emplace(std::move(shape));
    m_slitFrom = m_slitTo = m_slitDrawn = m_last = sample.point;
    m_state = State::Slit;
}

void Stroke::move(const Sample &sample)
{
    if (!sample.point.allFinite())
        return;
    switch (m_state) {
    case State::Slit:
        moveInSection(sample);
        break;
    case State::DeadZone:
        moveInDeadZone(sample.point);
        break;
    case State::Contour:
        addSample(sample.point);
        break;
    case State::Idle:
    case State::Turn:
    case State::Done:
    case State::Cancelled:
        break;
    }
}

void Stroke::leadSlit(const std::optional<Vec2> &to)
{
    if (m_state == State::Slit || m_state == State::Turn)
        m_slitTo = to.value_or(m_slitDrawn);
}

void Stroke::viewMoved(const Vec2 &point)
{
    if (m_state == State::DeadZone && point.allFinite())
        m_last = point;
}

void Stroke::setSymmetryOn(bool on)
{
    if (on == m_options.contour.isSymmetryOn)
        return;
    m_options.contour.isSymmetryOn = on;
    m_contour.reset();
}

void Stroke::setGuides(std::shared_ptr<const Guides> guides)
{
    m_options.contour.guides = std::move(guides);
    m_contour.reset();
}

void Stroke::reachSlit(double thickness)
{
    const Vec2 back = 2.0 * m_slitFrom - m_slitTo;
    const double behind =
        (m_interior->leavingPoint(m_slitFrom, back).value_or(back) - m_slitFrom).norm();
    m_slit = {slitLength(), thickness, kReach * m_options.deadZoneRadius, behind};
    m_options.contour.slit = slit();
    m_contour.reset();
}

void Stroke::setFree(bool isFree)
{
    if (m_slit && isFree != m_isFree)
        m_contour.reset();
    m_isFree = isFree;
    m_options.contour.slit = slit();
}

/// The samples that are drawn while no guide counts: those of the line from the last one on.
void Stroke::noteFree()
{
    const std::size_t end = m_line.points().size();
    std::vector<FreeSamples> &free = m_options.contour.free;
    if (!m_isFree || end == 0)
        return;
    if (free.empty() || free.back().to + 1 < end)
        free.push_back({end - 1, end});
    free.back().to = end;
}

void Stroke::release()
{
    switch (m_state) {
    case State::Slit:
        refuse(Refusal::NeverLeft);
        break;
    case State::Turn:
    case State::DeadZone:
        refuse(Refusal::TooShort);
        break;
    case State::Contour:
        if (contour().contour)
            m_state = State::Done;
        else
            refuse(Refusal::TooShort);
        break;
    case State::Idle:
    case State::Done:
    case State::Cancelled:
        break;
    }
}

void Stroke::cancel()
{
    if (m_state != State::Done)
        m_state = State::Cancelled;
}

void Stroke::advance(double time)
{
    if (m_state == State::Turn && time >= turnEnd())
        endTurn();
}

void Stroke::endTurn()
{
    assert(m_state == State::Turn && "it has left the section, and nothing is drawn yet");
    m_state = State::DeadZone;
    // The turn kept the slit's end under the cursor.
    m_last = {slitLength(), 0.0};
}

double Stroke::turnProgress(double time) const
{
    if (m_state == State::Idle || m_state == State::Slit)
        return 0.0;
    if (m_state != State::Turn || m_options.turnTime <= 0.0)
        return 1.0;
    return easeInOutCubic((time - m_turnStart) / m_options.turnTime);
}

const MeantLine &Stroke::meant() const
{
    m_meant.follow(m_line.points());
    return m_meant;
}

const StrokeContour &Stroke::contour() const
{
    if (!m_contour)
        m_contour = strokeContour(m_line.points(), meant(), m_options.contour);
    return *m_contour;
}

void Stroke::moveInSection(const Sample &sample)
{
    const std::optional<Vec2> leaving = m_interior->leavingPoint(m_last, sample.point);
    m_lastInside = leaving ? m_last : sample.point;
    m_last = sample.point;
    m_slitTo = m_slitDrawn = leaving.value_or(sample.point);
    if (!leaving)
        return;
    if (slitLength() < kMinOverlap) {
        refuse(Refusal::TooShort);
        return;
    }
    m_state = State::Turn;
    m_turnStart = sample.time;
}

void Stroke::moveInDeadZone(const Vec2 &point)
{
    if (distanceToSlit(point) <= m_options.deadZoneRadius) {
        m_last = point;
        return;
    }
    // The zone is convex and the last point inside: the way crosses its border once.
    double inside = 0.0, outside = 1.0;
    for (int i = 0; i < kBisections; ++i) {
        const double middle = 0.5 * (inside + outside);
        const bool isInside =
            distanceToSlit(m_last + middle * (point - m_last)) <= m_options.deadZoneRadius;
        (isInside ? inside : outside) = middle;
    }
    m_state = State::Contour;
    addSample(m_last + outside * (point - m_last));
    addSample(point);
}

void Stroke::addSample(const Vec2 &point)
{
    const Vec2 meant = m_hand.follow(point);
    if (m_hand.beginsAnew()) {
        m_line.clear();
        m_meant.clear();
        m_options.contour.free.clear();
    }
    if (!m_line.add(meant))
        return;
    noteFree();
    if (m_line.points().size() % kFollowed == 0)
        m_meant.follow(m_line.points());
    m_contour.reset();
}

void Stroke::refuse(Refusal refusal)
{
    m_refusal = refusal;
    m_state = State::Cancelled;
}

double Stroke::distanceToSlit(const Vec2 &point) const
{
    const Vec2 foot(std::clamp(point.x(), 0.0, slitLength()), 0.0);
    return (point - foot).norm();
}

} // namespace fff
