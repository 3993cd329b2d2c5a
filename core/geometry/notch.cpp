#include "core/geometry/notch.h"

#include "core/base/tolerances.h"
#include "core/geometry/box_runs.h"
#include "core/geometry/convex_hull.h"
#include "core/geometry/curve_crossing.h"
#include "core/geometry/curve_recovery.h"
#include "core/geometry/grid_predicates.h"
#include "core/geometry/segment_distance.h"

#include <algorithm>

namespace fff {

namespace {

/// Nearer than this to a corner a crossing is left to the general way, which joins them.
constexpr double kNearCorner = 10.0 * kClipSlack; // mm

/// Where the boundary goes into a bite or comes out of it.
struct Passage
{
    std::size_t side = 0; // of the bite; it starts at the corner of that number
    std::size_t edge = 0; // of the ring
    bool entersBite = false;
    double along = 0.0;           // share of the edge
    int segment = 0;              // of the contour
    double t = 0.0;               // on the segment
    Vec2 onChord = Vec2::Zero();  // of the edge
    Vec2 position = Vec2::Zero(); // on the curve
};

std::size_t next(std::size_t index, std::size_t count)
{
    return index + 1 < count ? index + 1 : 0;
}

std::size_t previous(std::size_t index, std::size_t count)
{
    return index > 0 ? index - 1 : count - 1;
}

} // namespace

struct Notch
{
    Polygon corners;
    Box2 box; // and what snapping moves
    Passage in, out;
    // Of a cut with curves: the segments, of each side the one that it is a chord of, and what
    // stands for the corners where they have to be convex.
    std::vector<CubicBezier> segments;
    std::vector<int> segmentOf;
    Polygon hull;

    const Polygon &convex() const { return hull.empty() ? corners : hull; }
};

struct NotchFinder::Data
{
    const Contour &contour;
    const Polyline &chords;
    ClipGrid grid;
    BoxRuns edges;

    Data(const Contour &c, const Polyline &p) : contour(c), chords(p), grid(c.bounds())
    {
        edges.fill(count(), [&](std::size_t i) {
            Box2 box;
            box.extend(vertex(i));
            box.extend(vertex(next(i, count())));
            return box;
        });
    }
    std::size_t count() const { return chords.points.size(); }
    const Vec2 &vertex(std::size_t i) const { return chords.points[i]; }
    bool place(const Polygon &corners, Passage &passage) const;
    bool find(const Notch &notch, const GridRing &snapped, std::size_t edge,
              std::vector<Passage> &passages) const;
    bool complete(Notch &notch) const;
};

/// Where the curve itself crosses the bite's side, given that its chord does.
bool NotchFinder::Data::place(const Polygon &corners, Passage &passage) const
{
    const std::size_t end = next(passage.edge, count());
    const Vec2 a = vertex(passage.edge), b = vertex(end);
    const Vec2 from = corners[passage.side], to = corners[next(passage.side, corners.size())];
    const double whole = cross(to - from, b - a);
    if (std::abs(whole) <= kParallelSine * (to - from).norm() * (b - a).norm())
        return false;
    passage.along = cross(to - from, from - a) / whole;
    passage.onChord = a + passage.along * (b - a);
    const EdgeSpan span = spanBetween(contour, chords.origins[passage.edge], chords.origins[end]);
    passage.segment = span.segment;
    const CubicBezier curve = contour.segment(span.segment);
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
bool NotchFinder::Data::find(const Notch &notch, const GridRing &snapped, std::size_t edge,
                             std::vector<Passage> &passages) const
{
    const Vec2 &start = vertex(edge), &end = vertex(next(edge, count()));
    if (!notch.box.intersects({start.cwiseMin(end), start.cwiseMax(end)}))
        return true;
    const GridPoint a = grid.snap(start), b = grid.snap(end);
    for (std::size_t s = 0; s < snapped.size(); ++s) {
        const GridPoint &from = snapped[s], &to = snapped[next(s, snapped.size())];
        const int sideOfA = sideOf(from, to, a), sideOfB = sideOf(from, to, b);
        // A corner on a side leaves a point to hang by, or nothing: rounding would tell.
        const Vec2 &corner = notch.corners[s], &other = notch.corners[next(s, snapped.size())];
        if (isNearSegment(start, corner, other, kClipSlack) ||
            isNearSegment(corner, start, end, kClipSlack))
            return false;
        if (sideOfA * sideOfB > 0)
            continue;
        const int sidesOfEnds = sideOf(a, b, from) * sideOf(a, b, to);
        if (sidesOfEnds > 0)
            continue;
        if (sideOfA * sideOfB == 0 || sidesOfEnds == 0 || passages.size() == 2)
            return false; // they touch, or there are too many
        Passage passage;
        passage.side = s;
        passage.edge = edge;
        passage.entersBite = sideOfB > 0;
        if (!place(notch.corners, passage))
            return false;
        passages.push_back(passage);
    }
    return true;
}

NotchFinder::NotchFinder(const Contour &contour, const Polyline &chords)
    : m_data(std::make_unique<Data>(contour, chords))
{
}

NotchFinder::~NotchFinder() = default;

/// Given its corners, finds the rest. False where it is not that plain.
bool NotchFinder::Data::complete(Notch &notch) const
{
    if (notch.corners.size() < 3)
        return false;
    GridRing snapped;
    snapped.reserve(notch.corners.size());
    for (const Vec2 &corner : notch.corners) {
        if (!corner.allFinite())
            return false;
        snapped.push_back(grid.snap(corner));
        notch.box.extend(corner);
    }
    notch.box.min -= Vec2::Constant(kClipSlack);
    notch.box.max += Vec2::Constant(kClipSlack);
    if (signedArea(snapped) <= 0.0)
        return false;
    std::vector<Passage> passages;
    passages.reserve(2);
    const bool isOdd =
        edges.any([&](const Box2 &box) { return box.intersects(notch.box); },
                  [&](std::size_t edge) { return !find(notch, snapped, edge, passages); });
    if (isOdd || passages.size() != 2 || passages[0].side == passages[1].side ||
        passages[0].entersBite == passages[1].entersBite)
        return false;
    notch.in = passages[passages[0].entersBite ? 0 : 1];
    notch.out = passages[passages[0].entersBite ? 1 : 0];
    return true;
}

NotchPointer NotchFinder::find(Polygon cut) const
{
    auto notch = std::make_shared<Notch>();
    notch->corners = std::move(cut);
    return m_data->complete(*notch) ? notch : nullptr;
}

NotchPointer NotchFinder::find(const Contour &cut, double chord) const
{
    auto notch = std::make_shared<Notch>();
    Polyline chords = cut.flatten(chord);
    notch->corners = std::move(chords.points);
    if (!m_data->complete(*notch))
        return nullptr;
    for (const CurvePoint &origin : chords.origins)
        notch->segmentOf.push_back(origin.segment);
    for (int i = 0; i < cut.segmentCount(); ++i)
        notch->segments.push_back(cut.segment(i));
    for (const Passage *passage : {&notch->in, &notch->out}) {
        const int segment = notch->segmentOf[passage->side];
        if (!notch->segments[static_cast<std::size_t>(segment)].isStraight(kClipGrid))
            return nullptr;
    }
    notch->hull = convexHull(notch->corners);
    return notch;
}

namespace {

/// Takes the bites out of the boundary.
class NotchCutter
{
public:
    NotchCutter(const Contour &contour, const Polyline &chords,
                const std::vector<NotchPointer> &notches);

    /// False where the general way is needed.
    bool arePlain() const;
    bool meetsAny(const Polygon &hole) const;
    CurvedRegion region() const;

private:
    std::size_t count() const { return m_chords.points.size(); }
    bool areApart() const;
    bool areInOrder() const;
    bool isBefore(const Passage &here, const Passage &there) const;
    /// The contour starts inside the last of them.
    bool wraps() const
    {
        const Passage &in = m_notches.back()->in, &out = m_notches.back()->out;
        return out.edge != in.edge ? out.edge < in.edge : out.along < in.along;
    }
    void addRun(const Passage *from, const Passage *to, std::vector<Vec2> &points,
                Polygon &chords) const;
    void addBite(const Notch &notch, std::vector<Vec2> &points, Polygon &chords) const;
    Vec2 addCurves(const Notch &notch, std::vector<Vec2> &points) const;
    void addLine(const Vec2 &from, const Vec2 &to, std::vector<Vec2> &points) const;

    const Contour &m_contour;
    const Polyline &m_chords;
    std::vector<const Notch *> m_notches; // in the order in which the boundary goes into them
};

NotchCutter::NotchCutter(const Contour &contour, const Polyline &chords,
                         const std::vector<NotchPointer> &notches)
    : m_contour(contour), m_chords(chords)
{
    m_notches.reserve(notches.size());
    for (const NotchPointer &notch : notches)
        m_notches.push_back(notch.get());
    std::sort(m_notches.begin(), m_notches.end(), [](const Notch *a, const Notch *b) {
        return a->in.edge != b->in.edge ? a->in.edge < b->in.edge : a->in.along < b->in.along;
    });
}

/// No two of them have a point in common, with a margin beyond the grid's rounding.
bool NotchCutter::areApart() const
{
    const auto isBeside = [](const Polygon &a, const Polygon &b) {
        for (std::size_t i = 0; i < a.size(); ++i) {
            const Vec2 &from = a[i], &to = a[next(i, a.size())];
            const double margin = kNearCorner * (to - from).norm();
            if (std::all_of(b.begin(), b.end(),
                            [&](const Vec2 &p) { return cross(to - from, p - from) < -margin; }))
                return true;
        }
        return false;
    };
    std::vector<const Notch *> order = m_notches;
    std::sort(order.begin(), order.end(),
              [](const Notch *a, const Notch *b) { return a->box.min.x() < b->box.min.x(); });
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t j = i + 1;
             j < order.size() && order[j]->box.min.x() <= order[i]->box.max.x(); ++j) {
            const Polygon &a = order[i]->convex(), &b = order[j]->convex();
            if (order[i]->box.intersects(order[j]->box) && !isBeside(a, b) && !isBeside(b, a))
                return false;
        }
    }
    return true;
}

/// Along the boundary, on the chords and on the curve.
bool NotchCutter::isBefore(const Passage &here, const Passage &there) const
{
    if (here.segment == there.segment && here.t >= there.t)
        return false;
    if (here.edge != there.edge)
        return here.edge < there.edge;
    const Vec2 edge = m_chords.points[next(here.edge, count())] - m_chords.points[here.edge];
    return (there.along - here.along) * edge.norm() > kNearCorner;
}

/// Every way into a bite is followed by the way out of it.
bool NotchCutter::areInOrder() const
{
    const bool startsInside = !m_notches.empty() && wraps();
    const Passage *here = startsInside ? &m_notches.back()->out : nullptr;
    for (const Notch *notch : m_notches) {
        if (here && !isBefore(*here, notch->in))
            return false;
        if (startsInside && notch == m_notches.back())
            return true;
        if (!isBefore(notch->in, notch->out))
            return false;
        here = &notch->out;
    }
    return true;
}

bool NotchCutter::arePlain() const
{
    return count() >= 3 && m_contour.signedArea() > 0.0 && areInOrder() && areApart();
}

bool NotchCutter::meetsAny(const Polygon &hole) const
{
    const Box2 box = bounds(hole);
    return std::any_of(m_notches.begin(), m_notches.end(),
                       [&](const Notch *notch) { return notch->box.intersects(box); });
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
void NotchCutter::addBite(const Notch &notch, std::vector<Vec2> &points, Polygon &chords) const
{
    const std::size_t last = next(notch.out.side, notch.corners.size());
    Vec2 from = notch.in.position;
    for (std::size_t corner = notch.in.side;; corner = previous(corner, notch.corners.size())) {
        const Vec2 &to = notch.corners[corner];
        if (notch.segments.empty())
            addLine(from, to, points);
        chords.push_back(to);
        from = to;
        if (corner == last)
            break;
    }
    if (!notch.segments.empty())
        from = addCurves(notch, points);
    addLine(from, notch.out.position, points);
}

/// The same on the cut's own curves, up to the segment by which the boundary goes on: its end.
Vec2 NotchCutter::addCurves(const Notch &notch, std::vector<Vec2> &points) const
{
    const auto at = [&notch](int segment) -> const CubicBezier & {
        return notch.segments[static_cast<std::size_t>(segment)];
    };
    const int count = static_cast<int>(notch.segments.size());
    const int first = notch.segmentOf[notch.in.side], last = notch.segmentOf[notch.out.side];
    addLine(notch.in.position, at(first).p0, points);
    for (int segment = (first + count - 1) % count; segment != last;
         segment = (segment + count - 1) % count) {
        const CubicBezier &curve = at(segment);
        points.insert(points.end(), {curve.p3, curve.p2, curve.p1});
    }
    return at(last).p3;
}

CurvedRegion NotchCutter::region() const
{
    std::vector<Vec2> points;
    points.reserve(m_contour.points().size() + 15 * m_notches.size());
    CurvedRegion result;
    Polygon &chords = result.region.outer;
    chords.reserve(count() + 4 * m_notches.size());
    const bool startsInside = !m_notches.empty() && wraps();
    const Passage *here = startsInside ? &m_notches.back()->out : nullptr;
    for (const Notch *notch : m_notches) {
        addRun(here, &notch->in, points, chords);
        addBite(*notch, points, chords);
        here = &notch->out;
    }
    if (!startsInside)
        addRun(here, nullptr, points, chords);
    if (points.size() >= 6)
        result.outer = Contour::ofPoints(std::move(points));
    return result;
}

} // namespace

std::optional<CurvedRegion> cutNotches(const Contour &contour, const std::vector<Contour> &holes,
                                       const std::vector<Polygon> &cuts, double chord)
{
    const Polyline chords = contour.flatten(chord);
    const NotchFinder finder(contour, chords);
    std::vector<NotchPointer> notches;
    for (const Polygon &cut : cuts) {
        notches.push_back(finder.find(cut));
        if (!notches.back())
            return std::nullopt;
    }
    return cutNotches(contour, chords, holes, notches, chord);
}

std::optional<CurvedRegion> cutNotches(const Contour &contour, const Polyline &polyline,
                                       const std::vector<Contour> &holes,
                                       const std::vector<NotchPointer> &notches, double chord)
{
    const NotchCutter cutter(contour, polyline, notches);
    if (!cutter.arePlain())
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
