#include "core/physics/section_outline.h"

#include "core/base/tolerances.h"
#include "core/geometry/directions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace fff {

namespace {

/// An inside angle of more is a corner that weakens (200°): its sine and cosine beyond 180°.
constexpr double kReentrantSine = 0.3420201433256687;

/// Of two places on the boundary that are as near, up to this, mm, the first one is the nearest:
/// between the walls of a slit rounding would choose.
constexpr double kTie = 1e-7;

Polygon withoutRepeats(const Polygon &ring)
{
    Polygon kept;
    kept.reserve(ring.size());
    for (const Vec2 &p : ring)
        if (p.allFinite() && (kept.empty() || (p - kept.back()).norm() > kClipGrid))
            kept.push_back(p);
    while (kept.size() > 1 && (kept.front() - kept.back()).norm() <= kClipGrid)
        kept.pop_back();
    return kept;
}

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

/// How far to the left of a line a vertex lies, mm; 0 for one on it. The same answer for all edges
/// that meet there, and so far from rounding that it needs no exact predicate.
double sideOf(const CutLine &line, const Vec2 &vertex)
{
    const double left = line.across(vertex);
    return std::abs(left) <= kOnCut ? 0.0 : left;
}

} // namespace

SectionOutline::SectionOutline(const Region &region)
{
    m_bounds = fff::bounds(region.outer);
    if (m_bounds.isEmpty())
        return;
    m_base = m_bounds.center();
    addRing(region.outer, false);
    if (m_rings.empty())
        return;
    for (const Polygon &hole : region.holes)
        addRing(hole, true);
    for (const std::vector<AreaMoment> &sums : m_sums)
        m_total += sums.back();
    buildBridges();
}

void SectionOutline::addRing(const Polygon &given, bool isHole)
{
    Polygon ring = withoutRepeats(given);
    if (ring.size() < 3)
        return;
    if ((signedArea(ring) < 0.0) != isHole)
        std::reverse(ring.begin(), ring.end());
    const std::size_t n = ring.size();
    std::vector<Vec2> outward(n);
    std::vector<double> lengths(n), turns(n);
    std::vector<char> reentrant(n);
    std::vector<AreaMoment> sums(n + 1);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 &a = ring[i], &b = ring[(i + 1) % n];
        lengths[i] = (b - a).norm();
        outward[i] = -perpendicular(b - a) / lengths[i];
        sums[i + 1] = sums[i];
        sums[i + 1] += ofStep(a - m_base, b - m_base);
    }
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 &before = outward[(i + n - 1) % n], &after = outward[i];
        const double sine = cross(before, after);
        turns[i] = signedTurn(before, after);
        // A spike into the material turns by nearly 180°, with a sine of nothing.
        reentrant[i] = sine < -kReentrantSine || (sine < 0.0 && before.dot(after) < 0.0) ? 1 : 0;
    }
    BoxRuns edges;
    edges.fill(n, [&ring, n](std::size_t i) {
        Box2 box;
        box.extend(ring[i]);
        box.extend(ring[(i + 1) % n]);
        return box;
    });
    m_rings.push_back(std::move(ring));
    m_outward.push_back(std::move(outward));
    m_lengths.push_back(std::move(lengths));
    m_turns.push_back(std::move(turns));
    m_reentrant.push_back(std::move(reentrant));
    m_sums.push_back(std::move(sums));
    m_edges.push_back(std::move(edges));
}

void SectionOutline::buildBridges()
{
    // From the leftmost vertex of a hole to the left, to the first ring there: that reaches farther
    // to the left, so the bridges make no circle.
    std::vector<double> reach;
    LineCrossings found;
    for (std::size_t ring = 1; ring < m_rings.size(); ++ring) {
        const Polygon &hole = m_rings[ring];
        const Vec2 from = *std::min_element(
            hole.begin(), hole.end(), [](const Vec2 &a, const Vec2 &b) { return a.x() < b.x(); });
        crossings({from, -Vec2::UnitX()}, {}, found);
        Bridge bridge{from, {0, 0, 0.0, m_rings.front().front()}};
        double nearest = std::numeric_limits<double>::infinity();
        for (const OutlineCrossing &c : found.touchedLeft) {
            if (c.point.ring != static_cast<int>(ring) && c.along >= 0.0 && c.along < nearest) {
                nearest = c.along;
                bridge.to = c.point;
            }
        }
        m_bridges.push_back(bridge);
        reach.push_back(from.x());
    }
    m_holeOrder.resize(m_bridges.size());
    std::iota(m_holeOrder.begin(), m_holeOrder.end(), 1);
    std::sort(m_holeOrder.begin(), m_holeOrder.end(),
              [&reach](int a, int b) { return reach[at(a - 1)] < reach[at(b - 1)]; });
}

LineSpan SectionOutline::spanOn(const CutLine &line) const
{
    constexpr double kSpare = 1.0;
    const double middle = line.along(m_bounds.center());
    const double reach = 0.5 * line.direction.cwiseAbs().dot(m_bounds.size()) + kSpare;
    return {middle - reach, middle + reach};
}

namespace {

/// Takes edges of a ring in turn, and adds where the line crosses them.
class EdgeCrosser
{
public:
    EdgeCrosser(const Polygon &points, int ring, const CutLine &line, const LineSpan &span,
                LineCrossings &found)
        : m_points(points), m_ring(ring), m_line(line), m_span(span), m_found(found),
          m_known(points.size())
    {
    }

    void take(std::size_t i)
    {
        const std::size_t j = i + 1 == m_points.size() ? 0 : i + 1;
        // Edges of a run follow each other: of each, the side of its end is that of the next one's
        // beginning.
        const double here = m_known == i ? m_side : sideOf(m_line, m_points[i]);
        const double there = sideOf(m_line, m_points[j]);
        m_known = j;
        m_side = there;
        if ((here == 0.0 || there == 0.0) && !m_found.isTouched) {
            m_found.isTouched = true;
            m_found.touchedRight = m_found.touchedLeft;
        }
        const bool crosses = (here >= 0.0) != (there >= 0.0);
        const bool crossesOther = m_found.isTouched && (here > 0.0) != (there > 0.0);
        if (!crosses && !crossesOther)
            return;
        const OutlineCrossing crossing =
            crossingOf(m_points, m_ring, static_cast<int>(i), m_line, there >= 0.0);
        if (crossing.along < m_span.from || crossing.along > m_span.to)
            return;
        if (crosses)
            m_found.touchedLeft.push_back(crossing);
        if (crossesOther) {
            m_found.touchedRight.push_back(crossing);
            m_found.touchedRight.back().isToLeft = there > 0.0;
        }
    }

private:
    const Polygon &m_points;
    int m_ring;
    const CutLine &m_line;
    const LineSpan &m_span;
    LineCrossings &m_found;
    std::size_t m_known;
    double m_side = 0.0;
};

/// Boxes that come near to a stretch of a line.
class NearLine
{
public:
    NearLine(const CutLine &line, const LineSpan &span)
        : m_line(line), m_span(span), m_slope(line.direction.cwiseAbs())
    {
    }

    bool operator()(const Box2 &box) const
    {
        const Vec2 half = 0.5 * box.size();
        const Vec2 middle = box.min + half - m_line.point;
        const double reach = m_slope.y() * half.x() + m_slope.x() * half.y() + kSpare;
        if (std::abs(cross(m_line.direction, middle)) > reach)
            return false;
        const double along = m_line.direction.dot(middle);
        const double length = m_slope.dot(half) + kSpare;
        return along + length >= m_span.from && along - length <= m_span.to;
    }

private:
    static constexpr double kSpare = 2.0 * kOnCut; // mm: vertices on the line are at hand with both
                                                   // of their edges
    const CutLine &m_line;
    const LineSpan &m_span;
    Vec2 m_slope;
};

/// Of two at one place, as where a line touches a corner, rounding would say which is first: into
/// the material and out of it take turns.
void sortAlong(std::vector<OutlineCrossing> &crossings)
{
    std::sort(crossings.begin(), crossings.end(),
              [](const OutlineCrossing &a, const OutlineCrossing &b) { return a.along < b.along; });
    for (std::size_t i = 1; i + 1 < crossings.size(); ++i) {
        OutlineCrossing &here = crossings[i], &next = crossings[i + 1];
        if (here.isToLeft == crossings[i - 1].isToLeft && next.isToLeft != here.isToLeft &&
            next.along - here.along <= kOnCut)
            std::swap(here, next);
    }
}

} // namespace

OutlineCrossing crossingOf(const Polygon &ring, int index, int edge, const CutLine &line,
                           bool isToLeft)
{
    const Vec2 &a = ring[at(edge)], &b = ring[at(edge) + 1 == ring.size() ? 0 : at(edge) + 1];
    const double before = std::abs(line.across(a)), after = std::abs(line.across(b));
    const double share = before + after > 0.0 ? before / (before + after) : 0.0;
    const Vec2 p = a + share * (b - a);
    return {line.along(p), {index, edge, share, p}, isToLeft};
}

void SectionOutline::crossings(const CutLine &line, const LineSpan &span,
                               LineCrossings &found) const
{
    found.clear();
    const NearLine isNear(line, span);
    for (std::size_t ring = 0; ring < m_rings.size(); ++ring) {
        EdgeCrosser crosser(m_rings[ring], static_cast<int>(ring), line, span, found);
        m_edges[ring].any(isNear, [&crosser](std::size_t edge) {
            crosser.take(edge);
            return false;
        });
    }
    sortAlong(found.touchedLeft);
    sortAlong(found.touchedRight);
}

void SectionOutline::crossings(const CutLine &line, const LineSpan &span,
                               const std::vector<EdgeRun> &among, LineCrossings &found) const
{
    found.clear();
    const NearLine isNear(line, span);
    for (const EdgeRun &run : among) {
        if (!isNear(run.box))
            continue;
        EdgeCrosser crosser(m_rings[at(run.ring)], run.ring, line, span, found);
        for (std::size_t edge = run.begin; edge < run.end; ++edge)
            crosser.take(edge);
    }
    sortAlong(found.touchedLeft);
    sortAlong(found.touchedRight);
}

bool SectionOutline::leadsInside(const Vec2 &direction, int ring, int vertex) const
{
    const auto isInside = [&](int edge) {
        return direction.dot(outward(ring, edge)) < -kSameDirection;
    };
    const bool isBefore = isInside(vertex - 1), isAfter = isInside(vertex);
    return turn(ring, vertex) > 0.0 ? isBefore && isAfter : isBefore || isAfter;
}

std::optional<OutlineCrossing> SectionOutline::firstAhead(const CutLine &line, int ring, int vertex,
                                                          const std::vector<EdgeRun> &among) const
{
    if (!leadsInside(line.direction, ring, vertex))
        return std::nullopt;
    LineSpan span{0.0, std::numeric_limits<double>::infinity()};
    OutlineCrossing first{span.to, {}, true};
    const NearLine isNear(line, span);
    for (const EdgeRun &run : among) {
        if (!isNear(run.box))
            continue;
        const Polygon &points = m_rings[at(run.ring)];
        const int n = static_cast<int>(points.size());
        double here = 0.0;
        for (std::size_t i = run.begin; i <= run.end; ++i) {
            const Vec2 &p = points[i == points.size() ? 0 : i];
            const double there = sideOf(line, p);
            if (there == 0.0 && p != line.point && line.along(p) > 0.0 && line.along(p) <= span.to)
                return std::nullopt;
            const int edge = static_cast<int>(i) - 1;
            const bool isOwn = run.ring == ring && (edge == vertex || (edge + 1) % n == vertex);
            if (i > run.begin && !isOwn && (here > 0.0) != (there > 0.0)) {
                const OutlineCrossing found = crossingOf(points, run.ring, edge, line, there > 0.0);
                if (found.along > 0.0 && found.along < span.to) {
                    first = found;
                    span.to = found.along;
                }
            }
            here = there;
        }
    }
    return first.isToLeft ? std::optional(first) : std::nullopt;
}

OutlinePoint SectionOutline::entryAt(const CutLine &line, int ring, int vertex) const
{
    const Vec2 &p = m_rings[at(ring)][at(vertex)];
    if (line.across(SectionOutline::vertex(ring, vertex + 1)) < 0.0)
        return {ring, vertex, 0.0, p};
    const int before = vertex == 0 ? static_cast<int>(m_rings[at(ring)].size()) - 1 : vertex - 1;
    return {ring, before, 1.0, p};
}

void SectionOutline::runsNear(const Vec2 &point, double reach, std::vector<EdgeRun> &found) const
{
    found.clear();
    for (std::size_t ring = 0; ring < m_rings.size(); ++ring)
        m_edges[ring].eachRun([&](const Box2 &box) { return distanceToBox(box, point) <= reach; },
                              [&](const Box2 &box, std::size_t begin, std::size_t end) {
                                  found.push_back({static_cast<int>(ring), begin, end, box});
                              });
}

OutlinePoint SectionOutline::nearest(const Vec2 &point) const
{
    return nearestWithin(point, std::numeric_limits<double>::infinity());
}

OutlinePoint SectionOutline::nearest(const Vec2 &point, const Vec2 &known) const
{
    return nearestWithin(point, (known - point).norm() + 2.0 * kTie);
}

/// Of what is nearer than `least` mm; something is.
OutlinePoint SectionOutline::nearestWithin(const Vec2 &point, double least) const
{
    OutlinePoint best;
    for (std::size_t ring = 0; ring < m_rings.size(); ++ring) {
        const Polygon &points = m_rings[ring];
        m_edges[ring].any([&](const Box2 &box) { return distanceToBox(box, point) < least; },
                          [&](std::size_t i) {
                              const Vec2 &a = points[i];
                              const Vec2 way = points[i + 1 == points.size() ? 0 : i + 1] - a;
                              const double share =
                                  std::clamp(way.dot(point - a) / way.squaredNorm(), 0.0, 1.0);
                              const Vec2 here = a + share * way;
                              if (const double d = (here - point).norm(); d < least - kTie) {
                                  least = d;
                                  best = {static_cast<int>(ring), static_cast<int>(i), share, here};
                              }
                              return false;
                          });
    }
    return best;
}

bool SectionOutline::isClear(const Vec2 &a, const Vec2 &b, double slack) const
{
    const double length = (b - a).norm();
    if (length <= 2.0 * slack)
        return true;
    LineCrossings found;
    crossings({a, (b - a) / length}, {slack, length - slack}, found);
    return std::none_of(
        found.touchedLeft.begin(), found.touchedLeft.end(),
        [&](const OutlineCrossing &c) { return c.along > slack && c.along < length - slack; });
}

} // namespace fff
