#include "core/geometry/notch.h"

#include "core/base/tolerances.h"
#include "core/geometry/curve_crossing.h"
#include "core/geometry/curve_recovery.h"
#include "core/geometry/grid_predicates.h"

#include <algorithm>

namespace fff {

namespace {

/// Nearer than this to a corner a crossing is left to the general way, which joins them.
constexpr double kNearCorner = 10.0 * kClipSlack; // mm
/// Edges that are looked at together.
constexpr std::size_t kRun = 16;

bool meet(const Box2 &a, const Box2 &b)
{
    return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

/// A polygon that takes a bite.
struct Bite
{
    const Polygon *corners = nullptr;
    GridRing snapped;
    Box2 box; // and what snapping moves

    std::size_t after(std::size_t corner) const
    {
        return corner + 1 < snapped.size() ? corner + 1 : 0;
    }
    std::size_t before(std::size_t corner) const
    {
        return corner > 0 ? corner - 1 : snapped.size() - 1;
    }
};

/// Where the boundary goes into a bite or comes out of it.
struct Passage
{
    std::size_t bite = 0, side = 0; // the side starts at the corner of that number
    std::size_t edge = 0;           // of the ring
    bool entersBite = false;
    double along = 0.0;           // share of the edge
    int segment = 0;              // of the contour
    double t = 0.0;               // on the segment
    Vec2 onChord = Vec2::Zero();  // of the edge
    Vec2 position = Vec2::Zero(); // on the curve
};

class NotchCutter
{
public:
    NotchCutter(const Contour &contour, const Polyline &chords, const std::vector<Polygon> &cuts);

    /// False where the general way is needed.
    bool findPassages();
    bool meetsAny(const Polygon &hole) const;
    CurvedRegion region() const;

private:
    /// Edges that follow each other, looked at together.
    struct Run
    {
        std::size_t first = 0, end = 0;
        Box2 box;
    };

    std::size_t count() const { return m_chords.points.size(); }
    std::size_t after(std::size_t vertex) const { return vertex + 1 < count() ? vertex + 1 : 0; }
    const Vec2 &vertex(std::size_t i) const { return m_chords.points[i]; }
    void findRuns();
    bool findPassages(std::size_t bite);
    bool findPassages(std::size_t bite, std::size_t edge, std::size_t firstPassage);
    bool place(Passage &passage) const;
    bool areBitesApart() const;
    bool isInOrder() const;
    void addRun(const Passage *from, const Passage *to, std::vector<Vec2> &points,
                Polygon &chords) const;
    void addBite(const Passage &in, const Passage &out, std::vector<Vec2> &points,
                 Polygon &chords) const;
    void addLine(const Vec2 &from, const Vec2 &to, std::vector<Vec2> &points) const;

    const Contour &m_contour;
    const Polyline &m_chords;
    ClipGrid m_grid;
    std::vector<Run> m_runs;
    std::vector<Bite> m_bites;
    std::vector<Passage> m_passages; // in the order of the boundary
};

NotchCutter::NotchCutter(const Contour &contour, const Polyline &chords,
                         const std::vector<Polygon> &cuts)
    : m_contour(contour), m_chords(chords), m_grid(contour.bounds())
{
    findRuns();
    m_bites.reserve(cuts.size());
    for (const Polygon &cut : cuts) {
        Bite bite;
        bite.corners = &cut;
        bite.snapped.reserve(cut.size());
        for (const Vec2 &corner : cut)
            bite.snapped.push_back(m_grid.snap(corner));
        for (const Vec2 &corner : cut)
            bite.box.extend(corner);
        bite.box.min -= Vec2::Constant(kClipSlack);
        bite.box.max += Vec2::Constant(kClipSlack);
        m_bites.push_back(std::move(bite));
    }
}

void NotchCutter::findRuns()
{
    m_runs.reserve(count() / kRun + 1);
    for (std::size_t first = 0; first < count(); first += kRun) {
        Run run{first, std::min(first + kRun, count()), {}};
        for (std::size_t i = first; i < run.end; ++i)
            run.box.extend(vertex(i));
        run.box.extend(vertex(after(run.end - 1)));
        m_runs.push_back(run);
    }
}

/// Where the curve itself crosses the bite's side, given that its chord does.
bool NotchCutter::place(Passage &passage) const
{
    const Bite &bite = m_bites[passage.bite];
    const std::size_t next = after(passage.edge);
    const Vec2 a = vertex(passage.edge), b = vertex(next);
    const Vec2 from = (*bite.corners)[passage.side];
    const Vec2 to = (*bite.corners)[bite.after(passage.side)];
    const double whole = cross(to - from, b - a);
    if (std::abs(whole) <= kParallelSine * (to - from).norm() * (b - a).norm())
        return false;
    passage.along = cross(to - from, from - a) / whole;
    passage.onChord = a + passage.along * (b - a);
    const EdgeSpan span =
        spanBetween(m_contour, m_chords.origins[passage.edge], m_chords.origins[next]);
    passage.segment = span.segment;
    const CubicBezier curve = m_contour.segment(span.segment);
    const Vec2 normal = perpendicular((to - from).normalized());
    const auto t = crossLine({curve, span.from, span.to}, from, normal, kClipSlack);
    if (!t)
        return false;
    passage.t = *t;
    passage.position = curve.at(*t);
    // Neither the chord's crossing nor the curve's may come to the end of an edge or a side.
    for (const Vec2 &p : {passage.onChord, passage.position}) {
        if ((p - a).dot(b - a) <= kNearCorner * (b - a).norm() ||
            (b - p).dot(b - a) <= kNearCorner * (b - a).norm() ||
            (p - from).dot(to - from) <= kNearCorner * (to - from).norm() ||
            (to - p).dot(to - from) <= kNearCorner * (to - from).norm())
            return false;
    }
    return true;
}

/// Where the edge goes through the sides of the bite.
bool NotchCutter::findPassages(std::size_t index, std::size_t edge, std::size_t first)
{
    const Bite &bite = m_bites[index];
    const Vec2 &start = vertex(edge), &end = vertex(after(edge));
    if (!meet({start.cwiseMin(end), start.cwiseMax(end)}, bite.box))
        return true;
    const GridPoint a = m_grid.snap(start), b = m_grid.snap(end);
    for (std::size_t s = 0; s < bite.snapped.size(); ++s) {
        const GridPoint &from = bite.snapped[s], &to = bite.snapped[bite.after(s)];
        const int sideOfA = sideOf(from, to, a), sideOfB = sideOf(from, to, b);
        if (sideOfA * sideOfB > 0)
            continue;
        const int sidesOfEnds = sideOf(a, b, from) * sideOf(a, b, to);
        if (sidesOfEnds > 0)
            continue;
        if (sideOfA * sideOfB == 0 || sidesOfEnds == 0 || m_passages.size() == first + 2)
            return false; // they touch, or there are too many
        Passage passage;
        passage.bite = index;
        passage.side = s;
        passage.edge = edge;
        passage.entersBite = sideOfB > 0;
        if (!place(passage))
            return false;
        m_passages.push_back(passage);
    }
    return true;
}

bool NotchCutter::findPassages(std::size_t index)
{
    const std::size_t first = m_passages.size();
    for (const Run &run : m_runs) {
        if (!meet(run.box, m_bites[index].box))
            continue;
        for (std::size_t edge = run.first; edge < run.end; ++edge) {
            if (!findPassages(index, edge, first))
                return false;
        }
    }
    if (m_passages.size() != first + 2)
        return false;
    const Passage &one = m_passages[first], &two = m_passages[first + 1];
    return one.side != two.side && one.entersBite != two.entersBite;
}

/// No two of them have a point in common, with a margin beyond the grid's rounding.
bool NotchCutter::areBitesApart() const
{
    const auto isBeside = [](const Polygon &a, const Polygon &b) {
        for (std::size_t i = 0; i < a.size(); ++i) {
            const Vec2 &from = a[i], &to = a[i + 1 < a.size() ? i + 1 : 0];
            const double margin = kNearCorner * (to - from).norm();
            if (std::all_of(b.begin(), b.end(),
                            [&](const Vec2 &p) { return cross(to - from, p - from) < -margin; }))
                return true;
        }
        return false;
    };
    std::vector<const Bite *> order;
    order.reserve(m_bites.size());
    for (const Bite &bite : m_bites)
        order.push_back(&bite);
    std::sort(order.begin(), order.end(),
              [](const Bite *a, const Bite *b) { return a->box.min.x() < b->box.min.x(); });
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t j = i + 1;
             j < order.size() && order[j]->box.min.x() <= order[i]->box.max.x(); ++j) {
            const Polygon &a = *order[i]->corners, &b = *order[j]->corners;
            if (meet(order[i]->box, order[j]->box) && !isBeside(a, b) && !isBeside(b, a))
                return false;
        }
    }
    return true;
}

/// Every way into a bite is followed by the way out of it.
bool NotchCutter::isInOrder() const
{
    const std::size_t count = m_passages.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Passage &here = m_passages[i], &next = m_passages[i + 1 < count ? i + 1 : 0];
        if (here.entersBite == next.entersBite || (here.entersBite && here.bite != next.bite) ||
            (here.edge == next.edge && i + 1 < count &&
             (next.along - here.along) * (vertex(after(here.edge)) - vertex(here.edge)).norm() <=
                 kNearCorner))
            return false;
        // On one segment the curve's crossings are in the order of its chords'.
        if (i + 1 < count && here.segment == next.segment && here.t >= next.t)
            return false;
    }
    return true;
}

bool NotchCutter::findPassages()
{
    if (count() < 3 || m_contour.signedArea() <= 0.0)
        return false;
    m_passages.reserve(2 * m_bites.size());
    for (std::size_t i = 0; i < m_bites.size(); ++i) {
        if (m_bites[i].snapped.size() < 3 || signedArea(m_bites[i].snapped) <= 0.0 ||
            !findPassages(i))
            return false;
    }
    std::sort(m_passages.begin(), m_passages.end(), [](const Passage &a, const Passage &b) {
        return a.edge != b.edge ? a.edge < b.edge : a.along < b.along;
    });
    return isInOrder() && areBitesApart();
}

bool NotchCutter::meetsAny(const Polygon &hole) const
{
    const Box2 box = bounds(hole);
    return std::any_of(m_bites.begin(), m_bites.end(),
                       [&](const Bite &bite) { return meet(bite.box, box); });
}

void NotchCutter::addLine(const Vec2 &from, const Vec2 &to, std::vector<Vec2> &points) const
{
    const CubicBezier line = CubicBezier::line(from, to);
    points.insert(points.end(), {line.p0, line.p1, line.p2});
}

/// The boundary between two passages; null is where the contour starts and ends.
void NotchCutter::addRun(const Passage *from, const Passage *to, std::vector<Vec2> &points,
                         Polygon &chords) const
{
    const int first = from ? from->segment : 0;
    const int last = to ? to->segment : m_contour.segmentCount() - 1;
    for (int s = first; s <= last; ++s) {
        const double t0 = from && s == first ? from->t : 0.0;
        const double t1 = to && s == last ? to->t : 1.0;
        const CubicBezier curve = m_contour.segment(s);
        const CubicBezier piece = t0 > 0.0 || t1 < 1.0 ? curve.piece(t0, t1) : curve;
        if (piece.p0 != piece.p3 || !piece.isStraight(kClipGrid))
            points.insert(points.end(), {piece.p0, piece.p1, piece.p2});
    }
    if (from)
        chords.push_back(from->onChord);
    const auto at = [this](std::size_t vertex) {
        return m_chords.points.begin() + static_cast<std::ptrdiff_t>(vertex);
    };
    chords.insert(chords.end(), at(from ? from->edge + 1 : 0), at(to ? to->edge + 1 : count()));
    if (to)
        chords.push_back(to->onChord);
}

/// Round the bite, clockwise: what is left of the boundary has its inside to the left.
void NotchCutter::addBite(const Passage &in, const Passage &out, std::vector<Vec2> &points,
                          Polygon &chords) const
{
    const Bite &bite = m_bites[in.bite];
    Vec2 from = in.position;
    for (std::size_t corner = in.side;; corner = bite.before(corner)) {
        const Vec2 &to = (*bite.corners)[corner];
        addLine(from, to, points);
        chords.push_back(to);
        from = to;
        if (corner == bite.after(out.side))
            break;
    }
    addLine(from, out.position, points);
}

CurvedRegion NotchCutter::region() const
{
    std::vector<Vec2> points;
    points.reserve(m_contour.points().size() + 15 * m_bites.size());
    CurvedRegion result;
    Polygon &chords = result.region.outer;
    chords.reserve(count() + 4 * m_bites.size());
    const std::size_t count = m_passages.size();
    if (count == 0) {
        addRun(nullptr, nullptr, points, chords);
    } else if (m_passages.front().entersBite) {
        addRun(nullptr, &m_passages.front(), points, chords);
        for (std::size_t i = 0; i < count; i += 2) {
            addBite(m_passages[i], m_passages[i + 1], points, chords);
            addRun(&m_passages[i + 1], i + 2 < count ? &m_passages[i + 2] : nullptr, points,
                   chords);
        }
    } else {
        // The contour starts inside a bite.
        for (std::size_t i = 0; i < count; i += 2) {
            addRun(&m_passages[i], &m_passages[i + 1], points, chords);
            addBite(m_passages[i + 1], m_passages[i + 2 < count ? i + 2 : 0], points, chords);
        }
    }
    if (auto outer = Contour::fromPoints(std::move(points)))
        result.outer = *std::move(outer);
    return result;
}

} // namespace

std::optional<CurvedRegion> cutNotches(const Contour &contour, const std::vector<Contour> &holes,
                                       const std::vector<Polygon> &cuts, double chord)
{
    return cutNotches(contour, contour.flatten(chord), holes, cuts, chord);
}

std::optional<CurvedRegion> cutNotches(const Contour &contour, const Polyline &polyline,
                                       const std::vector<Contour> &holes,
                                       const std::vector<Polygon> &cuts, double chord)
{
    if (std::any_of(cuts.begin(), cuts.end(), [](const Polygon &cut) { return cut.size() < 3; }))
        return std::nullopt;
    NotchCutter cutter(contour, polyline, cuts);
    if (!cutter.findPassages())
        return std::nullopt;
    CurvedRegion region = cutter.region();
    for (const Contour &hole : holes) {
        Polygon ring = hole.flatten(chord).points;
        if (ring.size() < 3 || cutter.meetsAny(ring))
            return std::nullopt;
        if (std::abs(signedArea(ring)) < kMinArea)
            continue;
        region.holes.push_back(hole);
        region.region.holes.push_back(std::move(ring));
    }
    double left = region.outer.signedArea();
    for (const Contour &hole : region.holes)
        left += hole.signedArea();
    if (!(left >= kMinArea))
        return std::nullopt;
    return region;
}

} // namespace fff
