#include "core/assembly/lobes.h"

#include "core/assembly/rings_near.h"
#include "core/base/groups.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

namespace fff {

namespace {

/// Where a ring crosses an edge of the strip, and the arc inside that begins or ends there.
struct Gate
{
    double at = 0.0;
    int arc = 0;
};

/// How far points are from a line, with two products each: nearly all vertices are beside the
/// strip, and all are looked at.
class Across
{
public:
    explicit Across(const PlaneLine &line)
        : m_normal(-line.direction.y(), line.direction.x()), m_offset(m_normal.dot(line.point))
    {
    }
    double operator()(const Vec2 &p) const
    {
        return m_normal.x() * p.x() + m_normal.y() * p.y() - m_offset;
    }

private:
    Vec2 m_normal;
    double m_offset;
};

/// Of a point across a strip: above (1), below (−1) or in it.
int sideOf(double across, double halfWidth)
{
    return across > halfWidth ? 1 : across < -halfWidth ? -1 : 0;
}

/// A run of a ring in the strip.
class Arcs
{
public:
    explicit Arcs(double halfWidth) : m_halfWidth(halfWidth) {}

    void addRing(const PlaneLine &line, const Polygon &ring, bool isOuter);
    /// Of the pieces.
    std::vector<Stretch> joined();

private:
    static constexpr double kEndless = std::numeric_limits<double>::infinity();

    int sideOf(double across) const { return fff::sideOf(across, m_halfWidth); }
    int begin()
    {
        m_arcs.push_back({kEndless, -kEndless});
        return static_cast<int>(m_arcs.size()) - 1;
    }
    void reach(int arc, double along)
    {
        Stretch &stretch = m_arcs[static_cast<std::size_t>(arc)];
        stretch.from = std::min(stretch.from, along);
        stretch.to = std::max(stretch.to, along);
    }
    /// An arc ends at the upper (1) or lower (−1) edge of the strip.
    void pass(int arc, int side, double along)
    {
        reach(arc, along);
        m_gates[side > 0].push_back({along, arc});
    }

    double m_halfWidth;
    std::vector<Stretch> m_arcs;
    std::array<std::vector<Gate>, 2> m_gates; // of the lower and the upper edge
};

void Arcs::addRing(const PlaneLine &line, const Polygon &ring, bool isOuter)
{
    const Across acrossOf(line);
    const auto start = std::find_if(ring.begin(), ring.end(),
                                    [&](const Vec2 &p) { return sideOf(acrossOf(p)) != 0; });
    if (start == ring.end()) { // all of it inside: a hole there parts nothing
        if (!isOuter || ring.empty())
            return;
        const int arc = begin();
        for (const Vec2 &p : ring)
            reach(arc, line.along(p));
        return;
    }
    const Vec2 *last = &*start;
    double before = acrossOf(*last);
    int side = sideOf(before), arc = -1;
    const auto walk = [&](auto from, auto to) {
        for (auto p = from; p != to; last = &*p++) {
            const double here = acrossOf(*p);
            const double ahead = side * here;
            if (ahead > m_halfWidth) {
                before = here;
                continue;
            }
            const int next = sideOf(here);
            const auto alongAt = [&](int edge) {
                const double share =
                    std::clamp((edge * m_halfWidth - before) / (here - before), 0.0, 1.0);
                return (1.0 - share) * line.along(*last) + share * line.along(*p);
            };
            if (next != side && side != 0) { // into the strip
                arc = begin();
                pass(arc, side, alongAt(side));
            }
            if (next != side && next != 0) // and out of it
                pass(arc, next, alongAt(next));
            if (next == 0)
                reach(arc, line.along(*p));
            before = here;
            side = next;
        }
    };
    walk(start + 1, ring.end());
    walk(ring.begin(), start + 1);
}

std::vector<Stretch> Arcs::joined()
{
    Groups groups(m_arcs.size());
    for (std::vector<Gate> &gates : m_gates) {
        std::sort(gates.begin(), gates.end(),
                  [](const Gate &a, const Gate &b) { return a.at < b.at; });
        for (std::size_t i = 0; i + 1 < gates.size(); i += 2)
            groups.join(static_cast<std::size_t>(gates[i].arc),
                        static_cast<std::size_t>(gates[i + 1].arc));
    }
    std::vector<Stretch> pieces;
    for (std::size_t i = 0; i < m_arcs.size(); ++i) {
        const int first = static_cast<int>(groups.firstOf(i));
        reach(first, m_arcs[i].from);
        reach(first, m_arcs[i].to);
    }
    for (std::size_t i = 0; i < m_arcs.size(); ++i)
        if (groups.firstOf(i) == i)
            pieces.push_back(m_arcs[i]);
    std::sort(pieces.begin(), pieces.end(),
              [](const Stretch &a, const Stretch &b) { return a.from < b.from; });
    return pieces;
}

} // namespace

std::vector<Stretch> lobesIn(const PlaneLine &line, const Region &region, double halfWidth)
{
    Arcs arcs(halfWidth);
    arcs.addRing(line, region.outer, true);
    for (const Polygon &hole : region.holes)
        arcs.addRing(line, hole, false);
    return arcs.joined();
}

std::vector<Stretch> lobesIn(const PlaneLine &line, const Shape &shape, double halfWidth)
{
    return lobesIn(line, RingsNear(line, shape, halfWidth).region(), halfWidth);
}

bool isOneLobe(const PlaneLine &line, const Shape &shape, double halfWidth)
{
    return isOneLobe(line, RingsNear(line, shape, halfWidth).region(), halfWidth);
}

bool isOneLobe(const PlaneLine &line, const Region &region, double halfWidth)
{
    const Across acrossOf(line);
    int crossings = 0;
    const auto isThrough = [&](const Polygon &ring) {
        // Where it was last beside the strip; nowhere at first.
        int outside = 0, first = 0;
        bool wasInside = false, beganInside = false;
        for (const Vec2 &p : ring) {
            const double across = acrossOf(p);
            if (outside * across > halfWidth && !wasInside)
                continue;
            const int side = sideOf(across, halfWidth);
            if (side == 0) {
                wasInside = true;
                continue;
            }
            if (outside == 0) {
                first = side;
                beganInside = wasInside;
            } else if (side != outside) {
                ++crossings;
            } else if (wasInside) {
                return false; // in and out at the same edge
            }
            outside = side;
            wasInside = false;
        }
        if (outside == 0)
            return false;
        crossings += outside != first ? 1 : 0;
        return outside != first || !(wasInside || beganInside);
    };
    if (!isThrough(region.outer) || crossings != 2)
        return false;
    return std::all_of(region.holes.begin(), region.holes.end(),
                       [&](const Polygon &hole) { return isThrough(hole) && crossings == 2; });
}

std::vector<Stretch> leftOf(const std::vector<Stretch> &lobes, std::vector<Stretch> cuts)
{
    std::sort(cuts.begin(), cuts.end(),
              [](const Stretch &a, const Stretch &b) { return a.from < b.from; });
    std::vector<Stretch> left;
    for (Stretch lobe : lobes) {
        for (const Stretch &cut : cuts) {
            if (cut.from > lobe.from && cut.from < lobe.to)
                left.push_back({lobe.from, cut.from});
            if (cut.from < lobe.to)
                lobe.from = std::max(lobe.from, cut.to);
        }
        if (lobe.from < lobe.to)
            left.push_back(lobe);
    }
    return left;
}

} // namespace fff
