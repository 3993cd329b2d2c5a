// The boundary of a piece as cuts across it ask for it: where a line crosses it, and how much area
// lies along a stretch of it. All lengths in mm, coordinates of the section's frame.
#pragma once

#include "core/base/tolerances.h"
#include "core/geometry/box_runs.h"
#include "core/geometry/polygon.h"

#include <limits>
#include <optional>
#include <vector>

namespace fff {

/// A directed line; `direction` is a unit vector.
struct CutLine
{
    Vec2 point = Vec2::Zero();
    Vec2 direction = Vec2::UnitX();

    double along(const Vec2 &p) const { return direction.dot(p - point); }
    double across(const Vec2 &p) const { return cross(direction, p - point); } // positive: left
    Vec2 at(double s) const { return point + s * direction; }
};

/// 0 inside, mm.
inline double distanceToBox(const Box2 &box, const Vec2 &p)
{
    return (box.min - p).cwiseMax(p - box.max).cwiseMax(0.0).norm();
}

/// Area and ∫ position dA of it (mm², mm³).
struct AreaMoment
{
    double area = 0.0;
    Vec2 first = Vec2::Zero();

    AreaMoment &operator+=(const AreaMoment &other)
    {
        area += other.area;
        first += other.first;
        return *this;
    }
    AreaMoment &operator-=(const AreaMoment &other)
    {
        area -= other.area;
        first -= other.first;
        return *this;
    }
};

/// A point of the boundary, on the edge that begins at vertex `edge` of a ring (0: the outer one).
struct OutlinePoint
{
    int ring = 0;
    int edge = 0;
    double share = 0.0; // of the edge, 0 … 1
    Vec2 at = Vec2::Zero();

    /// Comes before it on the same ring.
    bool isBefore(const OutlinePoint &other) const
    {
        return edge != other.edge ? edge < other.edge : share < other.share;
    }
};

/// Where a line crosses the boundary.
struct OutlineCrossing
{
    double along = 0.0; // on the line
    OutlinePoint point;
    bool isToLeft = false; // the ring goes over to the line's left side there
};

/// From one place of a line to another, mm along it.
struct LineSpan
{
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();
};

/// A boundary point this near to a cut lies on it, mm: rays pass corners that the booleans rounded,
/// in symmetrical models many of them, and on which side is chance.
inline constexpr double kOnCut = kClipSlack;

/// The crossings of a line, in their order along it. Vertices on it count as to its left in the one
/// list and as to its right in the other, which is filled only where there are such.
struct LineCrossings
{
    std::vector<OutlineCrossing> touchedLeft, touchedRight;
    bool isTouched = false;

    void clear()
    {
        touchedLeft.clear();
        touchedRight.clear();
        isTouched = false;
    }
};

/// Edges of a ring that follow each other, and a box around them.
struct EdgeRun
{
    int ring = 0;
    std::size_t begin = 0, end = 0;
    Box2 box;
};

/// Where the line crosses an edge of a ring, of which it is known that it does.
OutlineCrossing crossingOf(const Polygon &ring, int index, int edge, const CutLine &line,
                           bool isToLeft);

/// A piece of material: one outer ring, holes inside and apart from it. Rings may be given in
/// either orientation; points repeated at once are dropped, rings of fewer than three points too.
///
/// Integrals along a ring are prefix sums (Green's theorem), so that any stretch of it costs one
/// subtraction. They are taken about base(), a point of the piece, to keep their digits.
class SectionOutline
{
public:
    explicit SectionOutline(const Region &region);

    /// The outer ring counter-clockwise, then the holes, clockwise: material is to their left.
    const std::vector<Polygon> &rings() const { return m_rings; }
    bool isEmpty() const { return m_rings.empty(); }
    const Box2 &bounds() const { return m_bounds; }
    const Vec2 &base() const { return m_base; }
    /// Of all the material, about base().
    const AreaMoment &total() const { return m_total; }

    // Indices are counted around, at most once more in either direction.
    const Vec2 &vertex(int ring, int index) const { return around(m_rings, ring, index); }
    /// Unit, out of the material, of the edge that begins at the vertex.
    const Vec2 &outward(int ring, int edge) const { return around(m_outward, ring, edge); }
    double length(int ring, int edge) const { return around(m_lengths, ring, edge); } // mm
    /// From the edge before a vertex to the one behind, radians: positive where it is convex.
    double turn(int ring, int index) const { return around(m_turns, ring, index); }
    /// Inside angle of more than 200° there.
    bool isReentrant(int ring, int index) const { return around(m_reentrant, ring, index) != 0; }

    /// What the ring sweeps over about base() from its first vertex to the point; of all of it.
    AreaMoment upTo(const OutlinePoint &point) const
    {
        const auto ring = static_cast<std::size_t>(point.ring);
        const auto edge = static_cast<std::size_t>(point.edge);
        AreaMoment sum = m_sums[ring][edge];
        sum += ofStep(m_rings[ring][edge] - m_base, point.at - m_base);
        return sum;
    }
    const AreaMoment &ofRing(int ring) const
    {
        return m_sums[static_cast<std::size_t>(ring)].back();
    }
    static AreaMoment ofStep(const Vec2 &a, const Vec2 &b) // both about one base
    {
        const double twice = cross(a, b);
        return {0.5 * twice, (twice / 6.0) * (a + b)};
    }

    /// All crossings within the span. O(edges near it).
    void crossings(const CutLine &line, const LineSpan &span, LineCrossings &found) const;
    /// The same for those who cut one place many times: among the edges that are near to it.
    void crossings(const CutLine &line, const LineSpan &span, const std::vector<EdgeRun> &among,
                   LineCrossings &found) const;
    /// From a vertex on into the material, where the line begins and which way it goes: the first
    /// crossing, among these edges; endlessly far where none is ahead. Nothing if it does not go
    /// there, if vertices lie on the line up to it, or rings touch.
    std::optional<OutlineCrossing> firstAhead(const CutLine &line, int ring, int vertex,
                                              const std::vector<EdgeRun> &among) const;
    /// Where a ring goes over to the right of such a line, at the vertex that this begins at.
    OutlinePoint entryAt(const CutLine &line, int ring, int vertex) const;
    /// Of the edges nearer to the point than `reach` mm all, and some more.
    void runsNear(const Vec2 &point, double reach, std::vector<EdgeRun> &found) const;
    /// What of the line can be in the material, with some to spare.
    LineSpan spanOn(const CutLine &line) const;

    /// Calls visit(ring, edge) for all edges that are nearer to the point than `reach` mm, which
    /// the call may lower, and for some more, in their order.
    template <class Visit>
    void visitNear(const Vec2 &point, const double &reach, Visit visit) const
    {
        for (std::size_t ring = 0; ring < m_rings.size(); ++ring)
            m_edges[ring].any([&](const Box2 &box) { return distanceToBox(box, point) < reach; },
                              [&](std::size_t edge) {
                                  visit(static_cast<int>(ring), static_cast<int>(edge));
                                  return false;
                              });
    }
    OutlinePoint nearest(const Vec2 &point) const;
    /// The same, faster the nearer a known point of the boundary is.
    OutlinePoint nearest(const Vec2 &point, const Vec2 &known) const;
    /// The straight way between two points of the material meets no edge; touching is meeting,
    /// except within `slack` mm of its ends.
    bool isClear(const Vec2 &a, const Vec2 &b, double slack) const;

    /// From a hole straight to a ring nearer to the outer one, or that itself, inside the material.
    struct Bridge
    {
        Vec2 from = Vec2::Zero();
        OutlinePoint to;
    };
    /// One for each hole, index ring − 1.
    const std::vector<Bridge> &bridges() const { return m_bridges; }
    /// Rings 1 … so that each comes after the one its bridge leads to.
    const std::vector<int> &holeOrder() const { return m_holeOrder; }

private:
    template <class Value>
    static const Value &around(const std::vector<std::vector<Value>> &rings, int ring, int index)
    {
        const std::vector<Value> &all = rings[static_cast<std::size_t>(ring)];
        const int n = static_cast<int>(all.size());
        return all[static_cast<std::size_t>(index < 0    ? index + n
                                            : index >= n ? index - n
                                                         : index)];
    }
    OutlinePoint nearestWithin(const Vec2 &point, double least) const;
    void addRing(const Polygon &ring, bool isHole);
    void buildBridges();
    bool leadsInside(const Vec2 &direction, int ring, int vertex) const;

    std::vector<Polygon> m_rings;
    std::vector<std::vector<Vec2>> m_outward;
    std::vector<std::vector<double>> m_lengths;
    std::vector<std::vector<double>> m_turns;
    std::vector<std::vector<char>> m_reentrant;
    std::vector<std::vector<AreaMoment>> m_sums; // one more than vertices
    std::vector<BoxRuns> m_edges;
    std::vector<Bridge> m_bridges;
    std::vector<int> m_holeOrder;
    Box2 m_bounds;
    Vec2 m_base = Vec2::Zero();
    AreaMoment m_total;
};

} // namespace fff
