#include "core/geometry/notch.h"

#include "core/base/tolerances.h"
#include "core/geometry/curve_crossing.h"
#include "core/geometry/curve_recovery.h"
#include "core/geometry/grid_predicates.h"

#include <algorithm>
#include <span>

namespace fff {

namespace {

/// Nearer than this to a corner a crossing is left to the general way, which joins them.
constexpr double kNearCorner = 10.0 * kClipSlack; // mm
/// Edges that are looked at together.
constexpr std::size_t kRun = 16;

struct GridBox
{
    std::int64_t left, right, bottom, top;

    void extend(const GridPoint &p)
    {
        left = std::min(left, p.x);
        right = std::max(right, p.x);
        bottom = std::min(bottom, p.y);
        top = std::max(top, p.y);
    }
    bool meets(const GridBox &other) const
    {
        return left <= other.right && other.left <= right && bottom <= other.top &&
               other.bottom <= top;
    }
};

GridBox boxOf(std::span<const GridPoint> points)
{
    GridBox box{points[0].x, points[0].x, points[0].y, points[0].y};
    for (const GridPoint &p : points)
        box.extend(p);
    return box;
}

/// A polygon that takes a bite.
struct Bite
{
    const Polygon *corners = nullptr;
    GridRing snapped;
    GridBox box{};

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
    bool meetsAny(const GridRing &hole) const;
    CurvedRegion region() const;
    const ClipGrid &grid() const { return m_grid; }

private:
    /// Edges that follow each other, looked at together.
    struct Run
    {
        std::size_t first = 0, end = 0;
        GridBox box{};
    };

    std::size_t count() const { return m_snapped.size(); }
    std::size_t after(std::size_t vertex) const { return vertex + 1 < count() ? vertex + 1 : 0; }
    const Vec2 &vertex(std::size_t i) const { return m_chords.points[i]; }
    void snapChords();
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
    GridRing m_snapped; // the chords' vertices; neighbours may be the same
    std::vector<Run> m_runs;
    std::vector<Bite> m_bites;
    std::vector<Passage> m_passages; // in the order of the boundary
};

NotchCutter::NotchCutter(const Contour &contour, const Polyline &chords,
                         const std::vector<Polygon> &cuts)
    : m_contour(contour), m_chords(chords), m_grid(contour.bounds())
{
    snapChords();
    m_bites.reserve(cuts.size());
    for (const Polygon &cut : cuts) {
        Bite bite;
        bite.corners = &cut;
        bite.snapped.reserve(cut.size());
        for (const Vec2 &corner : cut)
            bite.snapped.push_back(m_grid.snap(corner));
        bite.box = boxOf(bite.snapped);
        m_bites.push_back(std::move(bite));
    }
}

void NotchCutter::snapChords()
{
    const std::size_t size = m_chords.points.size();
    m_snapped.resize(size);
    for (std::size_t i = 0; i < size; ++i)
        m_snapped[i] = m_grid.snap(vertex(i));
    m_runs.reserve(size / kRun + 1);
    for (std::size_t first = 0; first < size; first += kRun) {
        Run run{first, std::min(first + kRun, size), boxOf({&m_snapped[first], 1})};
        for (std::size_t i = first + 1; i < run.end; ++i)
            run.box.extend(m_snapped[i]);
        run.box.extend(m_snapped[after(run.end - 1)]);
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
    const GridPoint &a = m_snapped[edge], &b = m_snapped[after(edge)];
    if (std::max(a.x, b.x) < bite.box.left || std::min(a.x, b.x) > bite.box.right ||
        std::max(a.y, b.y) < bite.box.bottom || std::min(a.y, b.y) > bite.box.top)
        return true;
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
        if (!run.box.meets(m_bites[index].box))
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
              [](const Bite *a, const Bite *b) { return a->box.left < b->box.left; });
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t j = i + 1; j < order.size() && order[j]->box.left <= order[i]->box.right;
             ++j) {
            const Polygon &a = *order[i]->corners, &b = *order[j]->corners;
            if (order[i]->box.meets(order[j]->box) && !isBeside(a, b) && !isBeside(b, a))
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

bool NotchCutter::meetsAny(const GridRing &hole) const
{
    const GridBox box = boxOf(hole);
    return std::any_of(m_bites.begin(), m_bites.end(),
                       [&](const Bite &bite) { return bite.box.meets(box); });
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
        chords.push_back(m_grid.position(m_grid.snap(from->onChord)));
    const std::size_t begin = from ? from->edge + 1 : 0;
    const std::size_t end = to ? to->edge + 1 : count();
    for (std::size_t v = begin; v < end; ++v) {
        if (v == 0 || m_snapped[v] != m_snapped[v - 1])
            chords.push_back(m_grid.position(m_snapped[v]));
    }
    if (to)
        chords.push_back(m_grid.position(m_grid.snap(to->onChord)));
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
        chords.push_back(m_grid.position(bite.snapped[corner]));
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
        const SourceRing ring = makeSourceRing(hole, chord, cutter.grid(), false);
        if (ring.snapped.size() < 3 || cutter.meetsAny(ring.snapped))
            return std::nullopt;
        Polygon chords = cutter.grid().positions(ring.snapped);
        if (std::abs(signedArea(chords)) < kMinArea)
            continue;
        region.holes.push_back(hole);
        region.region.holes.push_back(std::move(chords));
    }
    double left = region.outer.signedArea();
    for (const Contour &hole : region.holes)
        left += hole.signedArea();
    if (!(left >= kMinArea))
        return std::nullopt;
    return region;
}

} // namespace fff
