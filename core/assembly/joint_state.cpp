#include "core/assembly/joint_state.h"

#include "core/assembly/crossing.h"
#include "core/assembly/intervals.h"
#include "core/assembly/joint_wish.h"
#include "core/assembly/tabs.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

const Frame &frameOf(const Model &model, int section)
{
    return model.section(static_cast<std::size_t>(section))->frame;
}

/// Towards which end of the axis these slits open, ±1; 0 without an open one.
int signOf(const std::vector<Slit> &slits, const Axis &axis, const Frame &frame)
{
    const auto open =
        std::find_if(slits.begin(), slits.end(), [](const Slit &slit) { return slit.isOpen; });
    if (open == slits.end())
        return 0;
    return lineInFrame(axis, frame).direction.dot(open->mouth - open->inner) > 0.0 ? 1 : -1;
}

Crossing crossingOf(const Model &model, int a, int b)
{
    const Section &sectionA = *model.section(static_cast<std::size_t>(a));
    const Section &sectionB = *model.section(static_cast<std::size_t>(b));
    return findCrossing(*sectionA.shape, sectionA.frame, *sectionB.shape, sectionB.frame);
}

JointObstacle obstacleOf(NoTabs why)
{
    switch (why) {
    case NoTabs::TooOblique:
        return JointObstacle::TooOblique;
    case NoTabs::NoWidth:
        return JointObstacle::NoWidth;
    case NoTabs::EndsNowhere:
        return JointObstacle::EndsNowhere;
    case NoTabs::NoRoom:
        break;
    }
    return JointObstacle::NoRoom;
}

JointObstacle obstacleOf(NoSlit why)
{
    switch (why) {
    case NoSlit::NoWidth:
        return JointObstacle::NoWidth;
    case NoSlit::OppositeWays:
        return JointObstacle::OppositeWays;
    case NoSlit::NothingHolds:
        return JointObstacle::NothingHolds;
    case NoSlit::Wanted:
    case NoSlit::Enclosed:
        break;
    }
    return JointObstacle::EndsOnHole;
}

/// The two sections in the model's order, and what each wish would make of them.
class Trial
{
public:
    Trial(const Model &model, const JointState &state)
        : m_model(model), m_a(std::min(state.a, state.b)), m_b(std::max(state.a, state.b)),
          m_isTurned(state.b < state.a), m_crossing(state.crossing)
    {
        if (state.kind == JointKind::Tabs) // of which those are the overlaps
            m_crossing = crossingOf(model, m_a, m_b);
    }

    /// sign: of the state's a.
    JointSlits slits(std::optional<JointKind> kind, int sign = 0) const
    {
        Crossing crossing = m_crossing; // it is told where they meet
        return slitsOf(m_model, m_a, m_b, crossing, {kind, m_isTurned ? -sign : sign, {}});
    }
    /// That of the state's a.
    int sign(const JointSlits &slits) const
    {
        const int ofA = signOf(slits.a, m_crossing.axis, frameOf(m_model, m_a));
        const int sign = ofA != 0 ? ofA : -signOf(slits.b, m_crossing.axis, frameOf(m_model, m_b));
        return m_isTurned ? -sign : sign;
    }
    /// The kind of cross lap when a opens to that side; none when it cannot.
    std::optional<JointKind> lap(int side) const
    {
        const JointSlits made = slits(JointKind::CrossLap, side);
        return sign(made) == side ? std::optional(made.kind) : std::nullopt;
    }
    bool doCross() const { return !m_crossing.overlaps.empty(); }
    bool isInOnePlace() const { return m_crossing.overlaps.size() == 1; }
    JointObstacle tabsObstacle() const
    {
        const auto tabs = tabsOf(m_model, m_a, m_b);
        return tabs ? JointObstacle::None : obstacleOf(tabs.error());
    }
    /// Of two that have no cross lap.
    JointObstacle slitObstacle() const
    {
        return obstacleOf(whyNoSlit(m_crossing, sideOf(m_model, m_a), sideOf(m_model, m_b), {}));
    }

private:
    const Model &m_model;
    int m_a, m_b;
    bool m_isTurned;
    Crossing m_crossing;
};

JointObstacle lapObstacle(const Trial &trial, JointKind kind)
{
    const std::optional<JointKind> plus = trial.lap(1), minus = trial.lap(-1);
    if (plus == kind || minus == kind)
        return JointObstacle::None;
    if (!plus && !minus)
        return trial.slitObstacle();
    return kind == JointKind::CrossLap ? JointObstacle::ReachesBeyond : JointObstacle::EndsWithin;
}

JointObstacle mortiseObstacle(const Trial &trial)
{
    if (trial.slits(JointKind::Mortise).kind == JointKind::Mortise)
        return JointObstacle::None;
    if (trial.slitObstacle() == JointObstacle::NoWidth)
        return JointObstacle::NoWidth;
    return trial.isInOnePlace() ? JointObstacle::DoesNotFit : JointObstacle::SeveralPlaces;
}

bool hasSlit(const std::vector<Slit> &slits, int overlap)
{
    return std::any_of(slits.begin(), slits.end(), [overlap](const Slit &slit) {
        return slit.isOpen && slit.overlap == overlap;
    });
}

void readShares(JointState &state)
{
    for (std::size_t i = 0; i < state.crossing.overlaps.size(); ++i) {
        const Overlap &o = state.crossing.overlaps[i];
        const int overlap = static_cast<int>(i);
        state.shares.emplace_back();
        if (hasSlit(state.slitsOfA, overlap) && hasSlit(state.slitsOfB, overlap)) {
            const double length = state.sign > 0 ? o.to - o.meet : o.meet - o.from;
            state.shares.back() = meetsInMiddle(o) ? 0.5 : length / (o.to - o.from);
        }
    }
}

/// One half is what the slits share by themselves: 0.5 is not stored.
bool isHalf(double share)
{
    return std::abs(share - 0.5) < kSameShare;
}

/// Of a, towards that end of the axis; none when the slits open there by themselves.
std::optional<Vec2> openingTo(int side, const Model &model, const JointState &state,
                              const Trial &trial)
{
    if (trial.sign(trial.slits(JointKind::CrossLap)) == side)
        return {};
    const Frame &frame = frameOf(model, state.a);
    const Vec3 way = side * state.crossing.axis.direction;
    return Vec2(way.dot(frame.x), way.dot(frame.y));
}

/// That the document says of it, or that nothing is wanted.
JointOverride wantedOf(const Model &model, const JointRef &joint)
{
    if (const JointOverride *wanted = model.document.jointOverride(joint.a, joint.b))
        return *wanted;
    JointOverride wanted;
    wanted.a = joint.a;
    wanted.b = joint.b;
    return wanted;
}

} // namespace

JointObstacle JointState::obstacleTo(JointKind of) const
{
    const auto at = std::find(kKinds.begin(), kKinds.end(), of);
    return obstacles[static_cast<std::size_t>(at - kKinds.begin())];
}

Vec3 JointState::meetingPoint(int overlap) const
{
    const auto index = static_cast<std::size_t>(overlap);
    const Overlap &o = crossing.overlaps[index];
    return crossing.axis.at(shares[index] ? o.meet : 0.5 * (o.from + o.to));
}

bool hasJoint(const Model &model, const JointRef &joint)
{
    const int a = model.indexOf(joint.a), b = model.indexOf(joint.b);
    return a >= 0 && b >= 0 && a != b &&
           findJoint(model, std::min(a, b), std::max(a, b)).has_value();
}

std::optional<JointState> jointState(const Model &model, const JointRef &joint)
{
    JointState state;
    state.ref = joint;
    state.a = model.indexOf(joint.a);
    state.b = model.indexOf(joint.b);
    if (state.a < 0 || state.b < 0 || state.a == state.b)
        return {};
    std::optional<FoundJoint> found =
        findJoint(model, std::min(state.a, state.b), std::max(state.a, state.b));
    if (!found)
        return {};
    state.kind = found->joint.kind;
    state.crossing = *found->joint.crossing;
    state.slitsOfA = std::move(found->slitsOfA);
    state.slitsOfB = std::move(found->slitsOfB);
    if (state.b < state.a)
        std::swap(state.slitsOfA, state.slitsOfB);

    const int ofA = signOf(state.slitsOfA, state.crossing.axis, frameOf(model, state.a));
    state.sign =
        ofA != 0 ? ofA : -signOf(state.slitsOfB, state.crossing.axis, frameOf(model, state.b));
    readShares(state);

    const Trial trial(model, state);
    state.canFlip = state.sign != 0 && trial.lap(-state.sign).has_value();
    for (std::size_t i = 0; i < JointState::kKinds.size(); ++i) {
        const JointKind kind = JointState::kKinds[i];
        if (kind == JointKind::Tabs)
            state.obstacles[i] = trial.tabsObstacle();
        else if (kind == JointKind::None)
            continue;
        else if (!trial.doCross())
            state.obstacles[i] = JointObstacle::DoNotCross;
        else
            state.obstacles[i] =
                kind == JointKind::Mortise ? mortiseObstacle(trial) : lapObstacle(trial, kind);
    }

    state.wanted = wantedOf(model, joint);
    state.isShareWanted.resize(state.crossing.overlaps.size());
    for (const JointOverride::Share &share : state.wanted.shares) {
        const int overlap = overlapOf(share, frameOf(model, state.a), state.crossing);
        if (overlap >= 0)
            state.isShareWanted[static_cast<std::size_t>(overlap)] = true;
    }
    return state;
}

JointOverride withKind(const Model &model, const JointState &state, JointKind kind)
{
    JointOverride wanted = state.wanted;
    const Trial trial(model, state);
    if (kind == JointKind::Tabs) {
        wanted.kind = kind;
        return wanted;
    }
    if (kind == JointKind::Mortise || kind == JointKind::None) {
        wanted.kind = kind;
        if (trial.slits(std::nullopt).kind == kind)
            wanted.kind.reset();
        return wanted;
    }
    wanted.kind.reset(); // a cross lap is what it is by itself, wherever one can be
    // Which of the two cross laps it is follows from where it opens to.
    int side = trial.sign(trial.slits(JointKind::CrossLap));
    if (wanted.opens) {
        const Vec3 opens = frameOf(model, state.a).directionToWorld(*wanted.opens);
        if (const int wished = signAlong(opens, state.crossing.axis); wished != 0)
            side = wished;
    }
    if (trial.lap(side) != kind)
        wanted.opens = openingTo(-side, model, state, trial);
    return wanted;
}

JointOverride flipped(const Model &model, const JointState &state)
{
    JointOverride wanted = state.wanted;
    wanted.opens = openingTo(-state.sign, model, state, Trial(model, state));
    return wanted;
}

JointOverride withShare(const Model &model, const JointState &state, int overlap, double share)
{
    JointOverride wanted = state.wanted;
    const Frame &frame = frameOf(model, state.a);
    std::erase_if(wanted.shares, [&](const JointOverride::Share &s) {
        return overlapOf(s, frame, state.crossing) == overlap;
    });
    const double ofA = std::clamp(share, kLeastShare, 1.0 - kLeastShare);
    if (!isHalf(ofA)) {
        const Overlap &o = state.crossing.overlaps[static_cast<std::size_t>(overlap)];
        const Vec3 middle = state.crossing.axis.at(0.5 * (o.from + o.to));
        wanted.shares.push_back({frame.toLocal(middle), ofA});
    }
    return wanted;
}

} // namespace fff
