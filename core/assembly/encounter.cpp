#include "core/assembly/encounter.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace fff {

namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
/// Squared sine below which two edges are parallel: their common normal is rounding.
constexpr double kParallel = 1e-18;
/// A way so short that nothing moves, mm.
constexpr double kStill = 1e-9;
/// Prisms of a part that come near another one's slit.
constexpr std::size_t kMostlyFewer = 16;
/// Boxes around many triangles may be wrong by less, mm.
constexpr double kBoxRounding = 1e-6;

Extent extentOf(const std::array<Vec3, 3> &triangle, const Vec3 &axis)
{
    const double a = axis.dot(triangle[0]), b = axis.dot(triangle[1]), c = axis.dot(triangle[2]);
    return {std::min({a, b, c}), std::max({a, b, c})};
}

/// Leaves of `way` where the extent of a, moved on by `speed` each mm, and that of b share more
/// than `depth`. False when nothing is left.
bool keepShared(const Extent &a, const Extent &b, double speed, double depth, Travel &way)
{
    // a.max + t speed > b.min + depth  and  a.min + t speed < b.max − depth
    const double low = b.min + depth - a.max, high = b.max - depth - a.min;
    if (speed == 0.0)
        return low < 0.0 && high > 0.0;
    const double first = low / speed, second = high / speed;
    way.from = std::max(way.from, std::min(first, second));
    way.to = std::min(way.to, std::max(first, second));
    // A product of negative depths can turn the two around; then there is nothing.
    return low < high && way.from < way.to;
}

/// One of the prisms of a solid, as its axes need it.
struct Prism
{
    const std::array<Vec3, 3> &corners;
    const Vec3 &normal;
    double half;

    Extent along(const Vec3 &axis) const
    {
        const double more = half * std::abs(axis.dot(normal));
        const Extent flat = extentOf(corners, axis);
        return {flat.min - more, flat.max + more};
    }
    Vec3 edge(std::size_t i) const { return corners[(i + 1) % 3] - corners[i]; }
};

/// Calls `look` with each axis that can separate two prisms (unit) until it answers false.
template <typename Look>
bool forEachAxis(const Prism &a, const Prism &b, const Look &look)
{
    if (!look(a.normal) || !look(b.normal))
        return false;
    const auto lookAcross = [&](const Vec3 &u, const Vec3 &v) {
        const Vec3 axis = u.cross(v);
        const double length = axis.squaredNorm();
        return !(length > kParallel * u.squaredNorm() * v.squaredNorm()) ||
               look(Vec3(axis / std::sqrt(length)));
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 edge = a.edge(i);
        if (!lookAcross(edge, a.normal) || !lookAcross(b.edge(i), b.normal) ||
            !lookAcross(edge, b.normal) || !lookAcross(a.normal, b.edge(i)))
            return false;
        for (std::size_t k = 0; k < 3; ++k)
            if (!lookAcross(edge, b.edge(k)))
                return false;
    }
    return lookAcross(a.normal, b.normal);
}

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

Extent wider(const Extent &extent, double by)
{
    return {extent.min - by, extent.max + by};
}

/// The middle of what the boxes of two prisms share.
Vec3 middleOf(const Prism &a, const Prism &b)
{
    Vec3 middle;
    for (int i = 0; i < 3; ++i) {
        const Extent first = a.along(Vec3::Unit(i)), second = b.along(Vec3::Unit(i));
        middle[i] = 0.5 * (std::max(first.min, second.min) + std::min(first.max, second.max));
    }
    return middle;
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
    : m_depth(depth), m_way{0.0, kEndless}, m_normalA(a.normal), m_normalB(b.normal),
      m_halfA(a.half), m_halfB(b.half)
{
    const auto [u, v] = across(direction);
    m_axes = {direction, u, v};
    findCandidates(a, b, by);
}

Encounter::Encounter(const Solid &a, const Solid &b, double depth)
    : m_depth(depth), m_way{-kStill, kStill}, m_normalA(a.normal), m_normalB(b.normal),
      m_halfA(a.half), m_halfB(b.half)
{
    const auto [u, v] = across(a.normal);
    m_axes = {a.normal, u, v};
    findCandidates(a, b, Vec3::Zero());
}

void Encounter::findCandidates(const Solid &a, const Solid &b, const Vec3 &by)
{
    Travel way = m_way;
    const Box3 from{a.box.min + by, a.box.max + by};
    if (!keepBoxes(from, b.box, m_axes.along, m_depth - kBoxRounding, way))
        return;
    const Box2 all = b.runs.bounds();
    Window window{Seen(b, Vec3::Zero(), m_axes.u).of(all), Seen(b, Vec3::Zero(), m_axes.v).of(all),
                  Seen(b, Vec3::Zero(), m_axes.along).of(all)};
    m_movers = candidates(a, by, b, Vec3::Zero(), 1.0, window);
    if (m_movers.empty())
        return;
    m_others = candidates(b, Vec3::Zero(), a, by, -1.0, window);
    std::sort(m_others.begin(), m_others.end(),
              [](const Candidate &x, const Candidate &y) { return x.u.min < y.u.min; });
}

/// Of `solid`, what comes as deep as the depth into the slab of the other's plane on the way, and
/// is seen in the window; which is that of the result then.
/// sense   1: the solid moves, −1: the other one does
std::vector<Encounter::Candidate> Encounter::candidates(const Solid &solid, const Vec3 &by,
                                                        const Solid &other, const Vec3 &otherBy,
                                                        double sense, Window &window)
{
    const double middle = other.normal.dot(other.frame.origin + otherBy);
    const Extent slab{middle - other.half, middle + other.half};
    const double speed = sense * other.normal.dot(m_axes.along);
    const Seen inSlab(solid, by, other.normal), inU(solid, by, m_axes.u), inV(solid, by, m_axes.v),
        inAlong(solid, by, m_axes.along);
    const double depth = m_depth - kBoxRounding;
    std::vector<Candidate> found;
    Travel all{kEndless, -kEndless};
    const auto isBoxNear = [&](const Box2 &box) {
        Travel way = m_way;
        return share(inU.of(box), window.u, depth) && share(inV.of(box), window.v, depth) &&
               keepShared(inSlab.of(box), slab, speed, depth, way) &&
               keepShared(inAlong.of(box), window.along, sense, depth, way);
    };
    solid.runs.any(isBoxNear, [&](std::size_t i) {
        std::array<Vec3, 3> corners = solid.triangles[i];
        for (Vec3 &corner : corners)
            corner += by;
        const Extent extent = wider(extentOf(corners, other.normal), inSlab.more());
        Travel own = m_way, way = m_way;
        if (!keepShared(extent, slab, speed, m_depth, own))
            return false;
        Candidate candidate;
        candidate.u = wider(extentOf(corners, m_axes.u), inU.more());
        if (!share(candidate.u, window.u, depth))
            return false;
        candidate.v = wider(extentOf(corners, m_axes.v), inV.more());
        if (!share(candidate.v, window.v, depth))
            return false;
        candidate.along = wider(extentOf(corners, m_axes.along), inAlong.more());
        if (!keepShared(candidate.along, window.along, sense, depth, way))
            return false;
        candidate.corners = corners;
        all.from = std::min(all.from, own.from);
        all.to = std::max(all.to, own.to);
        if (found.empty())
            found.reserve(kMostlyFewer);
        found.push_back(candidate);
        return false;
    });
    if (found.empty())
        return found;
    m_way = all;
    window = {};
    for (const Candidate &candidate : found) {
        extend(window.u, candidate.u);
        extend(window.v, candidate.v);
        extend(window.along, candidate.along);
    }
    return found;
}

/// Calls `meet` with two prisms and the stretch in which they share more than the depth, for each
/// pair that has one on the way and may matter, until it answers false.
template <typename MayMatter, typename Meet>
void Encounter::forEachMeeting(const MayMatter &mayMatter, const Meet &meet)
{
    double widest = 0.0;
    for (const Candidate &other : m_others)
        widest = std::max(widest, other.u.max - other.u.min);
    for (const Candidate &mover : m_movers) {
        auto other = std::lower_bound(
            m_others.begin(), m_others.end(), mover.u.min + m_depth - widest,
            [](const Candidate &candidate, double value) { return candidate.u.min < value; });
        for (; other != m_others.end() && other->u.min + m_depth < mover.u.max; ++other) {
            if (!(other->u.max > mover.u.min + m_depth && share(other->v, mover.v, m_depth)) ||
                !mayMatter(mover, *other))
                continue;
            ++m_pairs;
            const Prism p{mover.corners, m_normalA, m_halfA}, q{other->corners, m_normalB, m_halfB};
            Travel shared = m_way;
            const bool meets = forEachAxis(p, q, [&](const Vec3 &axis) {
                return keepShared(p.along(axis), q.along(axis), axis.dot(m_axes.along), m_depth,
                                  shared);
            });
            if (meets && !meet(p, q, shared))
                return;
        }
    }
}

std::uint64_t Encounter::signature() const
{
    // Odd numbers whose products mix the bits well (D. Lemire, M. Thorup: multiply-shift).
    std::uint64_t mixed = m_movers.size() * 0x9E3779B97F4A7C15ull + m_others.size();
    const auto add = [&](double value) {
        mixed =
            (std::rotl(mixed, 23) ^ std::bit_cast<std::uint64_t>(value)) * 0xC2B2AE3D27D4EB4Full;
        mixed ^= mixed >> 29;
    };
    const auto addVector = [&](const Vec3 &vector) {
        for (int i = 0; i < 3; ++i)
            add(vector[i]);
    };
    if (isEmpty())
        return 0;
    for (const auto &[normal, half] : {std::pair(m_normalA, m_halfA), {m_normalB, m_halfB}}) {
        addVector(normal);
        add(half);
    }
    for (const std::vector<Candidate> *side : {&m_movers, &m_others})
        for (const Candidate &candidate : *side)
            for (const Vec3 &corner : candidate.corners)
                addVector(corner);
    return mixed;
}

std::optional<Travel> Encounter::first()
{
    std::optional<Travel> found;
    const auto mayBeEarlier = [&](const Candidate &mover, const Candidate &other) {
        return !found || other.along.min + m_depth - mover.along.max < found->from;
    };
    forEachMeeting(mayBeEarlier, [&](auto &, auto &, const Travel &meeting) {
        if (!found || meeting.from < found->from)
            found = meeting;
        return meeting.from > 0.0; // nothing is earlier than that
    });
    return found;
}

bool Encounter::isFree()
{
    bool isFree = true;
    const auto all = [](const Candidate &, const Candidate &) { return true; };
    forEachMeeting(all, [&](auto &, auto &, const Travel &) { return isFree = false; });
    return isFree;
}

double Encounter::wayToClear()
{
    double last = 0.0;
    const auto mayBeLater = [&](const Candidate &mover, const Candidate &other) {
        return other.along.max - m_depth - mover.along.min > last;
    };
    forEachMeeting(mayBeLater, [&](auto &, auto &, const Travel &meeting) {
        last = std::max(last, meeting.to);
        return true;
    });
    return last;
}

std::optional<Interpenetration> Encounter::deepest()
{
    std::optional<Interpenetration> deepest;
    const auto all = [](const Candidate &, const Candidate &) { return true; };
    forEachMeeting(all, [&](const Prism &p, const Prism &q, const Travel &) {
        double least = kEndless;
        forEachAxis(p, q, [&](const Vec3 &axis) {
            const Extent ofP = p.along(axis), ofQ = q.along(axis);
            least = std::min({least, ofP.max - ofQ.min, ofQ.max - ofP.min});
            return true;
        });
        if (least > m_depth && (!deepest || least > deepest->depth))
            deepest = Interpenetration{least, middleOf(p, q)};
        return true;
    });
    return deepest;
}

} // namespace fff
