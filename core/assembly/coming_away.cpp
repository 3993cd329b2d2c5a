#include "core/assembly/coming_away.h"

#include "core/assembly/grips.h"
#include "core/assembly/locking.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// What is nearer may be touched within a step, mm.
constexpr double kTouchReach = 0.3;
/// mm, of the number of a motion that changes most.
constexpr double kWayStep = 0.1;
/// Of what may be grazed, what a step is planned with: the rest is for what it bends.
constexpr double kPlannedGraze = 0.7;
/// A step that comes to less of what was wanted, as a share, leads nowhere.
constexpr double kLeastProgress = 0.1;
/// mm: what contacts make longer than that is a jump.
constexpr double kLongestStep = 2.0 * kWayStep;
constexpr int kMostHalvings = 3;
/// mm: so near to the edge of a wall or a face a point grazes past it. Half of what may be grazed:
/// the next point may be the one that does not.
constexpr double kGrazedRim = 0.5 * kGraze;

/// Two bodies that may touch, each by the thing that it is of and its place in that.
struct NearPair
{
    int thing = 0, other = RigidContact::kAtRest;
    std::size_t body = 0, otherBody = 0;
    double inEachOther = 0.0; // mm, from the start
};

/// Where the things are.
class Scene
{
public:
    explicit Scene(const RigidThings &things) : m_things(&things), m_now(things.things)
    {
        const auto add = [&](int thing, int other, const std::vector<BodyPointer> &others) {
            for (std::size_t i = 0; i < m_now[static_cast<std::size_t>(thing)].size(); ++i)
                for (std::size_t k = 0; k < others.size(); ++k)
                    m_pairs.push_back({thing, other, i, k});
        };
        for (int thing = 0; thing < count(); ++thing) {
            add(thing, RigidContact::kAtRest, things.atRest);
            for (int other = thing + 1; other < count(); ++other)
                add(thing, other, m_now[static_cast<std::size_t>(other)]);
        }
        for (NearPair &pair : m_pairs) {
            const std::size_t first = m_contacts.size();
            addContacts(pair);
            for (std::size_t i = first; i < m_contacts.size(); ++i)
                pair.inEachOther = std::max(pair.inEachOther, -m_contacts[i].contact.gap);
            for (std::size_t i = first; i < m_contacts.size(); ++i)
                m_contacts[i].give += pair.inEachOther;
        }
        m_pivots = pivotsOf(m_contacts, count());
        m_way = Motion::Zero(6 * static_cast<Eigen::Index>(m_pivots.size()));
        m_turns.assign(m_pivots.size(), Eigen::Quaterniond::Identity());
    }

    int count() const { return static_cast<int>(m_now.size()); }
    const std::vector<Pivot> &pivots() const { return m_pivots; }
    /// From the start.
    const Motion &way() const { return m_way; }
    /// The largest number of a thing's, mm.
    double wayOf(std::size_t thing) const
    {
        return m_way.segment<6>(6 * static_cast<Eigen::Index>(thing)).cwiseAbs().maxCoeff();
    }

    /// What touches now, or nearly.
    const std::vector<RigidContact> &contacts() const { return m_contacts; }
    bool isTooDeep() const
    {
        return std::any_of(m_contacts.begin(), m_contacts.end(), [](const RigidContact &touch) {
            return -touch.contact.gap >= touch.give + (1.0 - kPlannedGraze) * kGraze;
        });
    }

    void move(const Motion &by)
    {
        m_way += by;
        for (std::size_t i = 0; i < m_now.size(); ++i) {
            const auto at = 6 * static_cast<Eigen::Index>(i);
            const Vec3 shift = by.segment<3>(at), turn = by.segment<3>(at + 3) / m_pivots[i].radius;
            if (turn.norm() > 0.0)
                m_turns[i] =
                    (Eigen::AngleAxisd(turn.norm(), turn.normalized()) * m_turns[i]).normalized();
            const Vec3 from = m_pivots[i].at - m_way.segment<3>(at) + shift;
            m_pivots[i].at += shift;
            for (std::size_t k = 0; k < m_now[i].size(); ++k)
                m_now[i][k] = moved(*m_things->things[i][k], from, m_pivots[i].at, m_turns[i]);
        }
        m_contacts.clear();
        for (const NearPair &pair : m_pairs)
            addContacts(pair);
    }

private:
    static BodyPointer moved(const Body &body, const Vec3 &from, const Vec3 &to,
                             const Eigen::Quaterniond &turn)
    {
        const Frame &frame = body.frame();
        const Frame there{to + turn * (frame.origin - from), turn * frame.x, turn * frame.y};
        return std::make_shared<const Body>(body.key(), body.cut(), body.piece(), there,
                                            body.thickness(), 0.0);
    }

    void addContacts(const NearPair &pair)
    {
        const Body &a = *m_now[static_cast<std::size_t>(pair.thing)][pair.body];
        const Body &b = pair.other == RigidContact::kAtRest
                            ? *m_things->atRest[pair.otherBody]
                            : *m_now[static_cast<std::size_t>(pair.other)][pair.otherBody];
        if (distanceBetween(a.box(), b.box()) > kTouchReach)
            return;
        const double give = pair.inEachOther + kPlannedGraze * kGraze;
        for (const Contact &contact : contactsOf(a, b, kTouchReach, kGrazedRim))
            m_contacts.push_back({pair.thing, pair.other, contact, give});
        for (Contact contact : contactsOf(b, a, kTouchReach, kGrazedRim)) {
            contact.normal = -contact.normal; // as a feels it
            m_contacts.push_back({pair.thing, pair.other, contact, give});
        }
    }

    const RigidThings *m_things;
    std::vector<std::vector<BodyPointer>> m_now;
    std::vector<NearPair> m_pairs;
    std::vector<Pivot> m_pivots;
    std::vector<Eigen::Quaterniond> m_turns;
    Motion m_way;
    std::vector<RigidContact> m_contacts;
};

/// Leads the things along until one of them has moved by kHeldMove.
class Lead
{
public:
    /// wanted  by how much the numbers of the motion are to change in a step
    Lead(const Scene &start, std::size_t thing, const Motion &wanted)
        : m_scene(start), m_thing(thing), m_wanted(wanted)
    {
    }

    bool arrives()
    {
        while (goesOn())
            if (m_scene.wayOf(m_thing) > kHeldMove)
                return true;
        return false;
    }

private:
    /// As far of a step as contacts let it go, or of a shorter one where that bends too much.
    bool goesOn()
    {
        const Scene before = m_scene;
        for (int halved = 0; halved <= kMostHalvings; ++halved) {
            const Motion wanted = std::ldexp(1.0, -halved) * m_wanted;
            const std::optional<Motion> by =
                Locking(m_scene.contacts(), m_scene.pivots()).nearestMotion(wanted);
            if (!by || by->dot(wanted) < kLeastProgress * wanted.squaredNorm())
                return false;
            if (by->cwiseAbs().maxCoeff() > kLongestStep)
                continue;
            m_scene.move(*by);
            if (!m_scene.isTooDeep())
                return true;
            m_scene = before;
        }
        return false;
    }

    Scene m_scene;
    std::size_t m_thing;
    Motion m_wanted;
};

/// Of each, all others moving as they like.
std::vector<char> whatMoves(const RigidThings &things)
{
    const Scene start(things);
    const Locking locking(start.contacts(), start.pivots());
    std::vector<char> moves(things.things.size(), 0);
    for (Eigen::Index number = 0; number < start.way().size(); ++number) {
        const auto thing = static_cast<std::size_t>(number / 6);
        for (const double way : {1.0, -1.0}) {
            if (moves[thing])
                continue;
            std::optional<Motion> told = locking.motionAlong(number, way, {kGripLoss, kHeldMove});
            if (!told)
                continue;
            *told *= kWayStep / told->cwiseAbs().maxCoeff();
            const Motion plain = way * kWayStep * Motion::Unit(told->size(), number);
            moves[thing] =
                Lead(start, thing, *told).arrives() || Lead(start, thing, plain).arrives();
        }
    }
    return moves;
}

} // namespace

std::vector<char> whatComesAway(const RigidThings &things)
{
    std::vector<char> comesAway(things.things.size(), 1);
    for (;;) {
        RigidThings left{{}, things.atRest};
        std::vector<std::size_t> which;
        for (std::size_t i = 0; i < comesAway.size(); ++i) {
            const std::vector<BodyPointer> &thing = things.things[i];
            if (!comesAway[i]) {
                left.atRest.insert(left.atRest.end(), thing.begin(), thing.end());
                continue;
            }
            left.things.push_back(thing);
            which.push_back(i);
        }
        const std::vector<char> moves = whatMoves(left);
        if (std::find(moves.begin(), moves.end(), 0) == moves.end())
            return comesAway;
        for (std::size_t k = 0; k < which.size(); ++k)
            comesAway[which[k]] = moves[k];
    }
}

} // namespace fff
