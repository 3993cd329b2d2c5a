#include "core/geometry/swept_disc.h"

#include "core/base/tolerances.h"
#include "core/geometry/box_runs.h"
#include "core/geometry/raw_offset.h"
#include "core/geometry/simple_ring.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

// Faults beyond these are of no use to who mends them.
constexpr std::size_t kMaxFaults = 256;
// A disc that goes into the part by less, in mm, is stopped by rounding only.
constexpr double kStopped = 1e-7;
constexpr int kMaxFanHalvings = 10;

struct Edge
{
    Vec2 from, to;
    std::size_t next = 0; // index of the edge that begins where this one ends
};

Vec2 normalOf(const Edge &e)
{
    const Vec2 way = e.to - e.from;
    return -perpendicular(way) / way.norm();
}

double squaredDistance(const Vec2 &p, const Vec2 &from, const Vec2 &way)
{
    const double squared = way.squaredNorm();
    const double share = squared > 0.0 ? std::clamp(way.dot(p - from) / squared, 0.0, 1.0) : 0.0;
    return (from + share * way - p).squaredNorm();
}

bool doCross(const Edge &a, const Edge &b)
{
    const Vec2 u = a.to - a.from, v = b.to - b.from;
    const double a0 = cross(v, a.from - b.from), a1 = cross(v, a.to - b.from);
    const double b0 = cross(u, b.from - a.from), b1 = cross(u, b.to - a.from);
    return (a0 < 0.0) != (a1 < 0.0) && (b0 < 0.0) != (b1 < 0.0);
}

double squaredDistance(const Edge &a, const Edge &b)
{
    if (doCross(a, b))
        return 0.0;
    const Vec2 u = a.to - a.from, v = b.to - b.from;
    return std::min(std::min(squaredDistance(a.from, b.from, v), squaredDistance(a.to, b.from, v)),
                    std::min(squaredDistance(b.from, a.from, u), squaredDistance(b.to, a.from, u)));
}

/// A stretch of an edge, in shares of it.
struct Stretch
{
    double from = 0.0, to = -1.0; // empty

    bool isEmpty() const { return from > to; }
    void extend(double low, double high)
    {
        low = std::max(low, 0.0);
        high = std::min(high, 1.0);
        if (low > high)
            return;
        *this = isEmpty() ? Stretch{low, high} : Stretch{std::min(from, low), std::max(to, high)};
    }
};

/// Where the line from `start` along `way` (0 … 1) is within the radius of the edge: one stretch,
/// as the distance from a straight edge is convex.
Stretch withinReach(const Vec2 &start, const Vec2 &way, const Edge &edge, double radius)
{
    Stretch result;
    const double squared = way.squaredNorm();
    const auto addDisc = [&](const Vec2 &middle) {
        const Vec2 to = start - middle;
        const double half = way.dot(to) / squared;
        const double rest = half * half - (to.squaredNorm() - radius * radius) / squared;
        if (rest >= 0.0)
            result.extend(-half - std::sqrt(rest), -half + std::sqrt(rest));
    };
    addDisc(edge.from);
    addDisc(edge.to);
    // The strip beside the edge, between its ends.
    const Vec2 along = edge.to - edge.from;
    const double length = along.norm();
    if (length == 0.0)
        return result;
    double low = 0.0, high = 1.0;
    const auto cut = [&](double at, double slope, double least, double most) {
        if (slope == 0.0) {
            if (at < least || at > most)
                high = -1.0;
            return;
        }
        const double a = (least - at) / slope, b = (most - at) / slope;
        low = std::max(low, std::min(a, b));
        high = std::min(high, std::max(a, b));
    };
    const Vec2 unit = along / length;
    cut(unit.dot(start - edge.from), unit.dot(way), 0.0, length);
    cut(cross(unit, start - edge.from), cross(unit, way), -radius, radius);
    if (low <= high)
        result.extend(low, high);
    return result;
}

/// The rings of an outline as chords, and their edges by place.
class FlatOutline
{
public:
    FlatOutline(const CurvedRegion &outline, double chord)
    {
        m_rings.push_back(outline.outer.polygon(chord));
        for (const Contour &hole : outline.holes)
            m_rings.push_back(hole.polygon(chord));
        for (const Polygon &ring : m_rings) {
            const std::size_t first = m_edges.size();
            for (std::size_t i = 0; i < ring.size(); ++i)
                m_edges.push_back({ring[i], ring[i + 1 < ring.size() ? i + 1 : 0],
                                   i + 1 < ring.size() ? first + i + 1 : first});
        }
        m_boxes.fill(m_edges.size(), [&](std::size_t i) { return boxOf(m_edges[i], 0.0); });
    }

    const std::vector<Polygon> &rings() const { return m_rings; }
    const std::vector<Edge> &edges() const { return m_edges; }

    /// Calls visit(edge) for those in the box, and some near it, until it says true. Whether it
    /// did.
    template <class Visit>
    bool anyNear(const Box2 &box, Visit visit) const
    {
        return m_boxes.any([&](const Box2 &run) { return run.intersects(box); },
                           [&](std::size_t i) {
                               const Edge &e = m_edges[i];
                               const bool isBeside = std::max(e.from.x(), e.to.x()) < box.min.x() ||
                                                     std::min(e.from.x(), e.to.x()) > box.max.x() ||
                                                     std::max(e.from.y(), e.to.y()) < box.min.y() ||
                                                     std::min(e.from.y(), e.to.y()) > box.max.y();
                               return !isBeside && visit(e);
                           });
    }

    static Box2 boxOf(const Edge &e, double margin) { return boxOf(e.from, e.to, margin); }
    static Box2 boxOf(const Vec2 &a, const Vec2 &b, double margin)
    {
        Box2 box{a.cwiseMin(b), a.cwiseMax(b)};
        box.min.array() -= margin;
        box.max.array() += margin;
        return box;
    }

private:
    std::vector<Polygon> m_rings;
    std::vector<Edge> m_edges;
    BoxRuns m_boxes;
};

class SweepJudge
{
public:
    SweepJudge(const CurvedRegion &part, const CurvedRegion &path, double radius)
        : m_curves(path), m_radius(radius), m_error(std::min(kSweepError, 0.5 * radius)),
          m_slack(m_error / 5.0), m_part(part, chord()), m_path(path, chord())
    {
    }

    std::vector<SweepFault> placesLeft()
    {
        m_slack = 0.0;
        m_stopped = m_error / 5.0;
        judgeReach();
        return std::move(m_faults);
    }

    std::vector<SweepFault> faults()
    {
        judgeCrossings();
        if (std::any_of(m_path.rings().begin(), m_path.rings().end(),
                        [](const Polygon &ring) { return ring.size() < 3; }))
            return std::move(m_faults); // a crossing, too
        judgeDistance();
        judgeReach();
        judgeNesting();
        return std::move(m_faults);
    }

private:
    double chord() const { return m_error / 8.0; }
    /// What is left of the error for what is compared on chords of both.
    double error() const { return m_error - 2.0 * chord(); }

    void add(SweepFault::Kind kind, const Vec2 &at)
    {
        if (m_faults.size() < kMaxFaults)
            m_faults.push_back({kind, at});
    }

    void judgeCrossings();
    void judgeDistance();
    void judgeReach();
    void judgeReachOf(const Edge &edge);
    void judgeGap(const Edge &edge, const Stretch &gap);
    void judgeFan(const Edge &before, const Edge &after);
    void judgeFan(const Vec2 &corner, double from, double to, int halvings);
    void judgeNesting();
    bool isInPart(const Vec2 &p) const;

    const CurvedRegion &m_curves;
    double m_radius, m_error;
    double m_slack;              // by how much larger a disc has to fit, mm
    double m_stopped = kStopped; // it may enter the part by, mm
    FlatOutline m_part, m_path;
    std::vector<Stretch> m_stretches; // kept between edges, for their memory
    std::vector<SweepFault> m_faults;
};

void SweepJudge::judgeCrossings()
{
    const ClipGrid grid(m_curves.outer.bounds());
    const auto judge = [&](const std::vector<Polygon> &polygons) {
        std::vector<GridRing> rings;
        for (const Polygon &polygon : polygons) {
            GridRing &ring = rings.emplace_back();
            ring.reserve(polygon.size());
            for (const Vec2 &p : polygon)
                if (const GridPoint point = grid.snap(p); ring.empty() || ring.back() != point)
                    ring.push_back(point);
            while (ring.size() > 1 && ring.back() == ring.front())
                ring.pop_back();
        }
        if (const auto meeting = firstMeeting(rings))
            add(SweepFault::Kind::Crossing, grid.position(*meeting));
        return m_faults.empty();
    };
    if (!judge(m_path.rings()))
        return;
    // As other readers may flatten them.
    std::vector<Polygon> coarse{m_curves.outer.polygon(m_error)};
    for (const Contour &hole : m_curves.holes)
        coarse.push_back(hole.polygon(m_error));
    judge(coarse);
}

void SweepJudge::judgeDistance()
{
    const double least = m_radius - error(), most = kMitreLimit * m_radius + error();
    for (const Edge &edge : m_path.edges()) {
        if (m_part.anyNear(FlatOutline::boxOf(edge, least), [&](const Edge &other) {
                return squaredDistance(edge, other) < least * least;
            }))
            add(SweepFault::Kind::TooNear, 0.5 * (edge.from + edge.to));
        if (!m_part.anyNear(FlatOutline::boxOf(edge.from, edge.from, most), [&](const Edge &other) {
                return squaredDistance(edge.from, other.from, other.to - other.from) <= most * most;
            }))
            add(SweepFault::Kind::TooFar, edge.from);
    }
}

void SweepJudge::judgeReach()
{
    for (const Edge &edge : m_part.edges())
        judgeReachOf(edge);
}

/// Stretches of the edge that some edge of the path comes near to; between them, discs must be
/// stopped by another edge.
void SweepJudge::judgeReachOf(const Edge &edge)
{
    const double reach = m_radius + error();
    const Vec2 way = edge.to - edge.from;
    m_stretches.clear();
    if (m_path.anyNear(FlatOutline::boxOf(edge, reach), [&](const Edge &other) {
            const Stretch stretch = withinReach(edge.from, way, other, reach);
            if (!stretch.isEmpty())
                m_stretches.push_back(stretch);
            return stretch.from <= 0.0 && stretch.to >= 1.0;
        }))
        return;
    std::sort(m_stretches.begin(), m_stretches.end(),
              [](const Stretch &a, const Stretch &b) { return a.from < b.from; });
    std::vector<Stretch> gaps;
    double covered = 0.0;
    bool isEndCovered = false;
    for (const Stretch &stretch : m_stretches) {
        if (stretch.from > covered)
            gaps.push_back({covered, stretch.from});
        covered = std::max(covered, stretch.to);
        isEndCovered = isEndCovered || stretch.to >= 1.0;
    }
    if (!isEndCovered)
        gaps.push_back({covered, 1.0});
    for (const Stretch &gap : gaps)
        judgeGap(edge, gap);
    if (!isEndCovered)
        judgeFan(edge, m_part.edges()[edge.next]);
}

/// A gap is none where discs beside the edge would enter the part elsewhere.
void SweepJudge::judgeGap(const Edge &edge, const Stretch &gap)
{
    const double radius = m_radius + m_slack, stopped = radius - m_stopped;
    const Vec2 way = edge.to - edge.from, middle = radius * normalOf(edge);
    const Vec2 start = edge.from + gap.from * way + middle, along = (gap.to - gap.from) * way;
    std::vector<Stretch> stops;
    if (along.norm() <= kStopped)
        return;
    m_part.anyNear(FlatOutline::boxOf(start, start + along, radius), [&](const Edge &other) {
        const Stretch stop = withinReach(start, along, other, stopped);
        if (!stop.isEmpty())
            stops.push_back(stop);
        return false;
    });
    std::sort(stops.begin(), stops.end(),
              [](const Stretch &a, const Stretch &b) { return a.from < b.from; });
    const double least = kStopped / along.norm();
    const auto judge = [&](double from, double to) {
        if (const Vec2 free = start + 0.5 * (from + to) * along;
            to - from > least && !isInPart(free))
            add(SweepFault::Kind::NotReached, free);
    };
    double covered = 0.0;
    for (const Stretch &stop : stops) {
        judge(covered, stop.from);
        covered = std::max(covered, stop.to);
    }
    judge(covered, 1.0);
}

/// For what is not near its boundary.
bool SweepJudge::isInPart(const Vec2 &p) const
{
    const std::vector<Polygon> &rings = m_part.rings();
    return locate(p, rings.front()) == Side::Inside &&
           std::none_of(rings.begin() + 1, rings.end(),
                        [&](const Polygon &hole) { return locate(p, hole) == Side::Inside; });
}

/// Discs that touch a corner alone.
void SweepJudge::judgeFan(const Edge &before, const Edge &after)
{
    const Vec2 a = normalOf(before), b = normalOf(after);
    const double turn = std::atan2(cross(a, b), a.dot(b));
    if (turn <= 0.0)
        return;
    const double from = std::atan2(a.y(), a.x());
    judgeFan(before.to, from, from + turn, 0);
}

void SweepJudge::judgeFan(const Vec2 &corner, double from, double to, int halvings)
{
    const double radius = m_radius + m_slack, angle = 0.5 * (from + to);
    const Vec2 middle = corner + radius * Vec2(std::cos(angle), std::sin(angle));
    double nearest = radius * radius;
    m_part.anyNear(FlatOutline::boxOf(middle, middle, radius), [&](const Edge &other) {
        nearest = std::min(nearest, squaredDistance(middle, other.from, other.to - other.from));
        return false;
    });
    const double inside = radius - std::sqrt(nearest), half = 0.5 * radius * (to - from);
    if (inside <= m_stopped) {
        if (!isInPart(middle))
            add(SweepFault::Kind::NotReached, middle);
    } else if (inside <= half && halvings < kMaxFanHalvings) {
        judgeFan(corner, from, angle, halvings + 1);
        judgeFan(corner, angle, to, halvings + 1);
    }
}

void SweepJudge::judgeNesting()
{
    const std::vector<Polygon> &path = m_path.rings(), &part = m_part.rings();
    if (path.front().size() < 3 || signedArea(path.front()) <= 0.0 ||
        locate(part.front().front(), path.front()) != Side::Inside) {
        add(SweepFault::Kind::Nesting, part.front().front());
        return;
    }
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Vec2 &at = path[i].front();
        bool isApart = locate(at, path.front()) == Side::Inside;
        for (std::size_t k = 1; k < path.size() && isApart; ++k)
            isApart = k == i || locate(at, path[k]) == Side::Outside;
        if (isInPart(at) || !isApart || signedArea(path[i]) >= 0.0 ||
            locate(part.front().front(), path[i]) != Side::Outside)
            add(SweepFault::Kind::Nesting, at);
    }
}

} // namespace

std::vector<SweepFault> sweepFaults(const CurvedRegion &part, const CurvedRegion &path,
                                    double radius)
{
    return SweepJudge(part, path, radius).faults();
}

std::vector<SweepFault> placesLeft(const CurvedRegion &part, const CurvedRegion &path,
                                   double radius)
{
    return SweepJudge(part, path, radius).placesLeft();
}

} // namespace fff
