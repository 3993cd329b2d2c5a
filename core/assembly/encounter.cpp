#include "core/assembly/encounter.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace fff {

namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
/// A way so short that nothing moves, mm.
constexpr double kStill = 1e-9;
/// Prisms of a part that come near another one's slit.
constexpr std::size_t kMostlyFewer = 64;
/// Boxes around many triangles may be wrong by less, mm.
constexpr double kBoxRounding = 1e-6;

/// Two unit vectors square to a direction and to each other.
std::array<Vec3, 2> across(const Vec3 &direction)
{
    const Vec3 u = direction.unitOrthogonal();
    return {u, direction.cross(u)};
}

/// What of a solid lies along an axis, of boxes in its frame.
class Seen
{
public:
    Seen(const Solid &solid, const Vec3 &by, const Vec3 &axis)
        : m_base(axis.dot(solid.frame.origin + by)), m_x(axis.dot(solid.frame.x)),
          m_y(axis.dot(solid.frame.y)), m_more(solid.half * std::abs(axis.dot(solid.normal)))
    {
    }
    Extent of(const Box2 &box) const
    {
        const double x1 = m_x * box.min.x(), x2 = m_x * box.max.x();
        const double y1 = m_y * box.min.y(), y2 = m_y * box.max.y();
        return {m_base + std::min(x1, x2) + std::min(y1, y2) - m_more,
                m_base + std::max(x1, x2) + std::max(y1, y2) + m_more};
    }
    double more() const { return m_more; }

private:
    double m_base, m_x, m_y, m_more;
};

bool share(const Extent &a, const Extent &b, double depth)
{
    return a.max > b.min + depth && b.max > a.min + depth;
}

void extend(Extent &extent, const Extent &by)
{
    extent.min = std::min(extent.min, by.min);
    extent.max = std::max(extent.max, by.max);
}

/// Whether the boxes come as near as that on the way.
bool keepBoxes(const Box3 &a, const Box3 &b, const Vec3 &direction, double depth, Travel &way)
{
    for (int i = 0; i < 3; ++i) {
        if (!keepShared({a.min[i], a.max[i]}, {b.min[i], b.max[i]}, direction[i], depth, way))
            return false;
    }
    return true;
}

} // namespace

Encounter::Encounter(const Solid &a, const Solid &b, const Vec3 &direction, double depth,
                     const Vec3 &by)
    : m_a(a), m_b(b), m_by(by), m_depth(depth), m_way{0.0, kEndless},
      m_pairs({a.normal, a.half}, {b.normal, b.half}, direction)
{
    const auto [u, v] = across(direction);
    m_axes = {direction, u, v};
    findMovers();
}

Encounter::Encounter(const Solid &a, const Solid &b, double depth)
    : m_a(a), m_b(b), m_by(Vec3::Zero()), m_depth(depth), m_way{-kStill, kStill},
      m_pairs({a.normal, a.half}, {b.normal, b.half}, a.normal)
{
    const auto [u, v] = across(a.normal);
    m_axes = {a.normal, u, v};
    findMovers();
}

void Encounter::findMovers()
{
    Travel way = m_way;
    const Box3 from{m_a.box.min + m_by, m_a.box.max + m_by};
    if (!keepBoxes(from, m_b.box, m_axes.along, m_depth - kBoxRounding, way))
        return;
    const Box2 all = m_b.runs.bounds();
    const auto seen = [&](const Vec3 &axis) { return Seen(m_b, Vec3::Zero(), axis).of(all); };
    m_window = {seen(m_axes.u), seen(m_axes.v), seen(m_axes.along)};
    m_way = forEachCandidate(m_a, m_by, m_b, Vec3::Zero(), 1.0, [&](const Candidate &candidate) {
        if (m_movers.empty())
            m_movers.reserve(kMostlyFewer);
        m_movers.push_back(candidate);
        return false;
    });
    m_window = {};
    for (const Candidate &candidate : m_movers) {
        extend(m_window.u, candidate.u);
        extend(m_window.v, candidate.v);
        extend(m_window.along, candidate.along);
    }
    m_isComplete = m_movers.empty();
}

/// Until `visit` says true, which it is asked with each that is found.
template <typename Visit>
void Encounter::findOthers(const Visit &visit)
{
    if (m_isComplete)
        return;
    m_others.clear();
    bool hasEnded = false;
    const Travel way =
        forEachCandidate(m_b, Vec3::Zero(), m_a, m_by, -1.0, [&](const Candidate &candidate) {
            if (m_others.empty())
                m_others.reserve(kMostlyFewer);
            m_others.push_back(candidate);
            return hasEnded = visit(m_others.back());
        });
    if (hasEnded)
        return;
    m_isComplete = true;
    m_way = way;
    std::sort(m_others.begin(), m_others.end(),
              [](const Candidate &x, const Candidate &y) { return x.u.min < y.u.min; });
}

void Encounter::complete()
{
    findOthers([](Candidate &) { return false; });
}

/// Of `solid`, what comes as deep as the depth into the slab of the other's plane on the way, and
/// is seen in the window: calls visit(candidate) until it says true.
/// sense   1: the solid moves, −1: the other one does
/// Result  what there is of the way in those slabs
template <typename Visit>
Travel Encounter::forEachCandidate(const Solid &solid, const Vec3 &by, const Solid &other,
                                   const Vec3 &otherBy, double sense, const Visit &visit) const
{
    const double middle = other.normal.dot(other.frame.origin + otherBy);
    const Extent slab{middle - other.half, middle + other.half};
    const double speed = sense * other.normal.dot(m_axes.along);
    const Seen inSlab(solid, by, other.normal), inU(solid, by, m_axes.u), inV(solid, by, m_axes.v),
        inAlong(solid, by, m_axes.along);
    const double depth = m_depth - kBoxRounding;
    Travel all{kEndless, -kEndless};
    // Both move past each other by a mm each mm.
    const auto isOnTheWay = [&](const Extent &extent) {
        const double low = m_window.along.min + depth - extent.max;
        const double high = m_window.along.max - depth - extent.min;
        return low < high && std::max(m_way.from, std::min(sense * low, sense * high)) <
                                 std::min(m_way.to, std::max(sense * low, sense * high));
    };
    const auto isBoxNear = [&](const Box2 &box) {
        Travel way = m_way;
        return share(inU.of(box), m_window.u, depth) && share(inV.of(box), m_window.v, depth) &&
               isOnTheWay(inAlong.of(box)) && keepShared(inSlab.of(box), slab, speed, depth, way);
    };
    solid.runs.any(isBoxNear, [&](std::size_t i) {
        Candidate candidate{{solid.triangles[i]}, i, {}, {}, {}};
        std::array<Vec3, 3> &corners = candidate.prism.corners;
        for (Vec3 &corner : corners)
            corner += by;
        candidate.u = wider(extentOf(corners, m_axes.u), inU.more());
        if (!share(candidate.u, m_window.u, depth))
            return false;
        candidate.v = wider(extentOf(corners, m_axes.v), inV.more());
        if (!share(candidate.v, m_window.v, depth))
            return false;
        candidate.along = wider(extentOf(corners, m_axes.along), inAlong.more());
        if (!isOnTheWay(candidate.along))
            return false;
        Travel own = m_way;
        const Extent extent = wider(extentOf(corners, other.normal), inSlab.more());
        if (!keepShared(extent, slab, speed, m_depth, own))
            return false;
        all.from = std::min(all.from, own.from);
        all.to = std::max(all.to, own.to);
        return visit(candidate);
    });
    return all;
}

/// Calls `meet` with two prisms and the stretch in which they share more than the depth, for each
/// pair that has one on the way and may matter, until it answers false; movers of a low rank first.
/// `meet` may narrow what of the way is still wanted.
template <typename Rank, typename MayMatter, typename Meet>
void Encounter::forEachMeeting(const Rank &rank, const MayMatter &mayMatter, const Meet &meet)
{
    complete();
    std::vector<std::pair<double, Candidate *>> movers;
    movers.reserve(m_movers.size());
    for (Candidate &mover : m_movers)
        movers.emplace_back(rank(mover), &mover);
    std::sort(movers.begin(), movers.end());
    double widest = 0.0;
    for (const Candidate &other : m_others)
        widest = std::max(widest, other.u.max - other.u.min);
    Travel wanted = m_way;
    for (const auto &ranked : movers) {
        Candidate &mover = *ranked.second;
        auto other = std::lower_bound(
            m_others.begin(), m_others.end(), mover.u.min + m_depth - widest,
            [](const Candidate &candidate, double value) { return candidate.u.min < value; });
        for (; other != m_others.end() && other->u.min + m_depth < mover.u.max; ++other) {
            if (!(other->u.max > mover.u.min + m_depth && share(other->v, mover.v, m_depth)) ||
                !mayMatter(mover, *other))
                continue;
            ++m_pairCount;
            Travel shared = wanted;
            if (!m_pairs.keepMeeting(mover.prism, other->prism, m_depth, shared))
                continue;
            if (wanted.from != m_way.from || wanted.to != m_way.to) {
                shared = m_way; // all of the stretch
                m_pairs.keepMeeting(mover.prism, other->prism, m_depth, shared);
            }
            if (!meet(mover, *other, shared, wanted))
                return;
        }
    }
}

std::uint64_t Encounter::signature()
{
    complete();
    if (isEmpty())
        return 0;
    // Odd numbers whose products mix the bits well (D. Lemire, M. Thorup: multiply-shift). One sum
    // for each coordinate, which do not wait for each other.
    std::array<std::uint64_t, 3> mixed{m_movers.size(), m_others.size(), 0};
    const auto add = [](std::uint64_t &sum, double value) {
        sum = (std::rotl(sum, 23) ^ std::bit_cast<std::uint64_t>(value)) * 0xC2B2AE3D27D4EB4Full;
        sum ^= sum >> 29;
    };
    const auto addVector = [&](const Vec3 &vector) {
        for (std::size_t i = 0; i < 3; ++i)
            add(mixed[i], vector[static_cast<int>(i)]);
    };
    for (const Plate *plate : {&m_pairs.mover(), &m_pairs.other()}) {
        addVector(plate->normal);
        add(mixed[0], plate->half);
    }
    for (const std::vector<Candidate> *side : {&m_movers, &m_others})
        for (const Candidate &candidate : *side)
            for (const Vec3 &corner : candidate.prism.corners)
                addVector(corner);
    for (std::size_t i = 1; i < 3; ++i)
        mixed[0] = (std::rotl(mixed[0], 23) ^ mixed[i]) * 0x9E3779B97F4A7C15ull;
    return mixed[0];
}

std::optional<Travel> Encounter::first()
{
    // Those that are ahead, which leaves little to look at of the rest.
    const auto rank = [](const Candidate &mover) { return -mover.along.max; };
    std::optional<Travel> found;
    const auto mayBeEarlier = [&](const Candidate &mover, const Candidate &other) {
        return other.along.max - m_depth > mover.along.min &&
               (!found || other.along.min + m_depth - mover.along.max < found->from);
    };
    forEachMeeting(rank, mayBeEarlier, [&](auto &, auto &, const Travel &meeting, Travel &wanted) {
        if (!found || meeting.from < found->from)
            found = meeting;
        wanted.to = found->from;
        return meeting.from > 0.0; // nothing is earlier than that
    });
    return found;
}

std::optional<PrismIndices> Encounter::meeting()
{
    // Each that is found is looked at before the next one is.
    std::vector<std::pair<double, Candidate *>> movers; // by where they begin
    movers.reserve(m_movers.size());
    double widest = 0.0;
    for (Candidate &mover : m_movers) {
        movers.emplace_back(mover.u.min, &mover);
        widest = std::max(widest, mover.u.max - mover.u.min);
    }
    std::sort(movers.begin(), movers.end());
    std::optional<PrismIndices> found;
    const auto meets = [&](Candidate &other) {
        auto next =
            std::lower_bound(movers.begin(), movers.end(), other.u.min + m_depth - widest,
                             [](const auto &mover, double value) { return mover.first < value; });
        for (; next != movers.end() && next->first + m_depth < other.u.max; ++next) {
            Candidate &mover = *next->second;
            if (!(mover.u.max > other.u.min + m_depth && share(other.v, mover.v, m_depth) &&
                  other.along.max - m_depth > mover.along.min))
                continue;
            ++m_pairCount;
            Travel shared = m_way;
            if (!m_pairs.keepMeeting(mover.prism, other.prism, m_depth, shared))
                continue;
            found = PrismIndices{mover.triangle, other.triangle};
            return true;
        }
        return false;
    };
    if (m_isComplete)
        static_cast<void>(std::any_of(m_others.begin(), m_others.end(), meets));
    else
        findOthers(meets);
    return found;
}

double Encounter::wayToClear()
{
    double last = 0.0;
    const auto rank = [](const Candidate &mover) { return mover.along.min; };
    const auto mayBeLater = [&](const Candidate &mover, const Candidate &other) {
        return other.along.max - m_depth - mover.along.min > last;
    };
    forEachMeeting(rank, mayBeLater, [&](auto &, auto &, const Travel &meeting, Travel &wanted) {
        last = std::max(last, meeting.to);
        wanted.from = std::max(wanted.from, last);
        return true;
    });
    return last;
}

std::vector<Encounter::Meeting> Encounter::meetings()
{
    std::vector<Meeting> found;
    const auto rank = [](const Candidate &) { return 0.0; };
    const auto all = [](const Candidate &, const Candidate &) { return true; };
    forEachMeeting(rank, all, [&](Candidate &p, Candidate &q, const Travel &, Travel &) {
        const double depth = m_pairs.depthOf(p.prism, q.prism);
        if (depth > m_depth)
            found.push_back({{p.triangle, q.triangle}, depth});
        return true;
    });
    return found;
}

bool prismsMeet(const Solid &a, const Solid &b, const PrismIndices &prisms, const Vec3 &direction,
                double depth, const Vec3 &by)
{
    PrismPairs pairs({a.normal, a.half}, {b.normal, b.half}, direction);
    PairedPrism mover{a.triangles[prisms.mover]}, other{b.triangles[prisms.other]};
    for (Vec3 &corner : mover.corners)
        corner += by;
    Travel way{0.0, kEndless};
    return pairs.keepMeeting(mover, other, depth, way);
}

} // namespace fff
