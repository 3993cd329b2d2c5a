#include "core/geometry/curve_recovery.h"

#include "core/base/fault_point.h"
#include "core/base/tolerances.h"
#include "core/geometry/curve_crossing.h"
#include "core/geometry/source_edges.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fff {

namespace {

double squaredSteps(const GridPoint &a, const GridPoint &b)
{
    const auto x = static_cast<double>(a.x - b.x), y = static_cast<double>(a.y - b.y);
    return x * x + y * y;
}

/// One ring of the result on its way back to curves. Vertex i starts edge i.
class RingRecovery
{
public:
    RingRecovery(const std::vector<SourceRing> &sources, const SourceIndex &index,
                 const ClipGrid &grid, const GridRing &ring, const std::vector<SourceEdge> &edges)
        : m_sources(sources), m_index(index), m_grid(grid), m_ring(ring), m_edges(edges),
          m_vertices(ring.size())
    {
    }

    Result<Contour> contour();

private:
    /// Where a vertex really is, and its parameter on the curves before and after it.
    struct Vertex
    {
        Vec2 position = Vec2::Zero();
        double before = 0.0, after = 0.0;
        bool isInRun = false; // the curve just goes on
    };

    struct Piece
    {
        CubicBezier curve;
        bool isJoinable = false;    // a straight line that no contour owns
        std::array<int, 3> order{}; // ring, segment, vertex: where the contour may start
    };

    std::size_t count() const { return m_ring.size(); }
    std::size_t previous(std::size_t i) const { return (i + count() - 1) % count(); }
    const SourceRing &source(const SourceEdge &e) const
    {
        return m_sources[static_cast<std::size_t>(e.ring)];
    }
    const EdgeSpan &span(const SourceEdge &e) const
    {
        return source(e).spans[static_cast<std::size_t>(e.edge)];
    }
    CurveRange range(const SourceEdge &e) const
    {
        const EdgeSpan &s = span(e);
        return {source(e).contour.segment(s.segment), s.from, s.to};
    }
    bool isStraight(const SourceEdge &e) const
    {
        return !e.isKnown() || range(e).curve.isStraight(kClipGrid);
    }
    /// The source's vertex where the edge starts or ends, in its direction.
    int startCorner(const SourceEdge &e) const { return corner(e, e.direction < 0); }
    int endCorner(const SourceEdge &e) const { return corner(e, e.direction > 0); }
    int corner(const SourceEdge &e, bool isFar) const
    {
        return isFar ? (e.edge + 1) % static_cast<int>(source(e).points.size()) : e.edge;
    }
    bool isAt(const SourceEdge &e, int corner, std::size_t vertex) const
    {
        return source(e).snapped[static_cast<std::size_t>(corner)] == m_ring[vertex];
    }

    void place(std::size_t vertex);
    void placeOffCurve(std::size_t vertex);
    bool placeOnCorner(std::size_t vertex);
    double parameterNear(const SourceEdge &e, const Vec2 &point) const;
    void undoOvershoots();
    Piece piece(std::size_t from, std::size_t to) const;
    static void joinLines(std::vector<Piece> &pieces);

    const std::vector<SourceRing> &m_sources;
    const SourceIndex &m_index;
    const ClipGrid &m_grid;
    const GridRing &m_ring;
    const std::vector<SourceEdge> &m_edges;
    std::vector<Vertex> m_vertices;
};

/// The vertex is a corner of the one source that both its edges belong to, or lies inside an edge.
bool RingRecovery::placeOnCorner(std::size_t vertex)
{
    const SourceEdge &in = m_edges[previous(vertex)];
    const SourceEdge &out = m_edges[vertex];
    if (!in.isKnown() || in.ring != out.ring)
        return false;
    Vertex &v = m_vertices[vertex];
    if (in.edge == out.edge && in.direction == out.direction) {
        v.isInRun = true;
        return true;
    }
    const int end = endCorner(in);
    if (!isAt(in, end, vertex) || startCorner(out) != end)
        return false;
    v.position = source(in).points[static_cast<std::size_t>(end)];
    const EdgeSpan &spanIn = span(in);
    const EdgeSpan &spanOut = span(out);
    v.before = in.direction > 0 ? spanIn.to : spanIn.from;
    v.after = out.direction > 0 ? spanOut.from : spanOut.to;
    v.isInRun =
        in.direction == out.direction && spanIn.segment == spanOut.segment && v.before == v.after;
    return true;
}

double RingRecovery::parameterNear(const SourceEdge &e, const Vec2 &point) const
{
    const CurveRange r = range(e);
    const Vec2 chord = r.curve.at(r.to) - r.curve.at(r.from);
    if (const auto t = crossLine(r, point, chord, kClipSlack))
        return *t;
    return chord.dot(point - r.curve.at(r.from)) < 0.5 * chord.squaredNorm() ? r.from : r.to;
}

/// Where the sources' corner is, or else where the boolean put the vertex; the curves are bent by
/// as much as that is off them, which is less than the chords are.
void RingRecovery::placeOffCurve(std::size_t vertex)
{
    const SourceEdge &in = m_edges[previous(vertex)];
    const SourceEdge &out = m_edges[vertex];
    Vertex &v = m_vertices[vertex];
    v.position = m_grid.position(m_ring[vertex]);
    m_index.anyCornerAt(m_ring[vertex], [&](const SourceIndex::Corner &c) {
        if (c.ring != in.ring && c.ring != out.ring)
            return false;
        v.position =
            m_sources[static_cast<std::size_t>(c.ring)].points[static_cast<std::size_t>(c.index)];
        return true;
    });
    if (in.isKnown())
        v.before = parameterNear(in, v.position);
    if (out.isKnown())
        v.after = parameterNear(out, v.position);
}

void RingRecovery::place(std::size_t vertex)
{
    if (placeOnCorner(vertex))
        return;
    const SourceEdge &in = m_edges[previous(vertex)];
    const SourceEdge &out = m_edges[vertex];
    if (in.isKnown() && out.isKnown()) {
        const Vec2 near = m_grid.position(m_ring[vertex]);
        if (const auto crossing = crossNear(range(in), range(out), near)) {
            m_vertices[vertex].position = crossing->point;
            m_vertices[vertex].before = crossing->a;
            m_vertices[vertex].after = crossing->b;
            return;
        }
    }
    placeOffCurve(vertex);
}

/// A crossing that moved from the chord to the curve may have passed the other end of its straight
/// edge, where that is shorter than the curve's bulge. Such ends stay on the chords.
void RingRecovery::undoOvershoots()
{
    for (std::size_t i = 0; i < count(); ++i) {
        const std::size_t next = (i + 1) % count();
        if (!isStraight(m_edges[i]) || m_vertices[i].isInRun || m_vertices[next].isInRun)
            continue;
        const Vec2 wanted = m_grid.position(m_ring[next]) - m_grid.position(m_ring[i]);
        if ((m_vertices[next].position - m_vertices[i].position).dot(wanted) > 0.0)
            continue;
        for (std::size_t vertex : {i, next}) {
            if (!placeOnCorner(vertex))
                placeOffCurve(vertex);
        }
    }
}

/// The piece between two vertices that are ends of runs.
RingRecovery::Piece RingRecovery::piece(std::size_t from, std::size_t to) const
{
    const Vec2 start = m_vertices[from].position, end = m_vertices[to].position;
    const SourceEdge &edge = m_edges[from];
    const int vertex = static_cast<int>(from);
    if (!edge.isKnown())
        return {
            CubicBezier::line(start, end), true, {static_cast<int>(m_sources.size()), 0, vertex}};
    const std::array<int, 3> order{edge.ring, span(edge).segment, vertex};
    if (source(edge).isCut)
        return {CubicBezier::line(start, end), true, order};
    const double t0 = m_vertices[from].after, t1 = m_vertices[to].before;
    if (!(edge.direction > 0 ? t0 < t1 : t1 < t0))
        return {CubicBezier::line(start, end), false, order};
    CubicBezier curve = range(edge).curve.piece(t0, t1);
    // Ends off the curve take their handles along, so that the tangents stay.
    curve.p1 += start - curve.p0;
    curve.p2 += end - curve.p3;
    curve.p0 = start;
    curve.p3 = end;
    return {curve, false, order};
}

/// Consecutive cut edges in one line become one, also across the end of the list.
void RingRecovery::joinLines(std::vector<Piece> &pieces)
{
    const auto join = [](Piece &a, const Piece &b) {
        const Vec2 first = a.curve.p3 - a.curve.p0, second = b.curve.p3 - b.curve.p0;
        const Vec2 whole = b.curve.p3 - a.curve.p0;
        if (!a.isJoinable || !b.isJoinable || first.dot(second) <= 0.0 ||
            std::abs(cross(whole, first)) > kClipSlack * whole.norm())
            return false;
        a.curve = CubicBezier::line(a.curve.p0, b.curve.p3);
        return true;
    };
    std::vector<Piece> joined;
    for (const Piece &p : pieces) {
        if (joined.empty() || !join(joined.back(), p))
            joined.push_back(p);
    }
    if (joined.size() > 2 && join(joined.back(), joined.front()))
        joined.erase(joined.begin());
    pieces = std::move(joined);
}

Result<Contour> RingRecovery::contour()
{
    for (std::size_t i = 0; i < count(); ++i)
        place(i);
    undoOvershoots();
    std::vector<std::size_t> ends; // of runs
    for (std::size_t i = 0; i < count(); ++i) {
        if (!m_vertices[i].isInRun)
            ends.push_back(i);
    }
    std::vector<Piece> pieces;
    for (std::size_t k = 0; k < ends.size(); ++k) {
        Piece next = piece(ends[k], ends[(k + 1) % ends.size()]);
        // Ends that were steps of the grid apart are one where their curves meet.
        if ((next.curve.p3 - next.curve.p0).norm() > 0.5 * kClipGrid ||
            !next.curve.isStraight(kClipGrid))
            pieces.push_back(std::move(next));
    }
    joinLines(pieces);
    // The same start for the same boundary, wherever the boolean began: a stable file.
    const auto first =
        std::min_element(pieces.begin(), pieces.end(),
                         [](const Piece &a, const Piece &b) { return a.order < b.order; });
    std::rotate(pieces.begin(), first, pieces.end());
    std::vector<CubicBezier> segments;
    segments.reserve(pieces.size());
    for (const Piece &p : pieces)
        segments.push_back(p.curve);
    if (segments.size() == 1) // a contour has two at least
        segments = {segments.front().piece(0.0, 0.5), segments.front().piece(0.5, 1.0)};
    if (segments.empty())
        return Contour::fromPolygon(m_grid.positions(m_ring));
    return Contour::fromSegments(segments);
}

/// Crossings that all but meet a corner leave splinters of the grid's size beside it; the corner
/// is what stays of them.
GridRing withoutSplinters(const GridRing &ring, const SourceIndex &index)
{
    const double limit = std::pow(kClipSlack / kClipGrid, 2.0);
    GridRing result;
    result.reserve(ring.size());
    const auto isCorner = [&](const GridPoint &p) { return index.hasCornerAt(p); };
    for (const GridPoint &p : ring) {
        if (result.empty() || squaredSteps(result.back(), p) > limit)
            result.push_back(p);
        else if (!isCorner(result.back()))
            result.back() = p;
        else if (isCorner(p))
            result.push_back(p);
    }
    while (result.size() > 1 && squaredSteps(result.front(), result.back()) <= limit) {
        if (!isCorner(result.back()))
            result.pop_back();
        else if (!isCorner(result.front()))
            result.erase(result.begin());
        else
            break;
    }
    return result;
}

} // namespace

EdgeSpan spanBetween(const Contour &contour, const CurvePoint &from, const CurvePoint &to)
{
    const int count = contour.segmentCount();
    if (from.segment == to.segment && to.t > from.t)
        return {from.segment, from.t, to.t};
    if (from.t > 0.0 && to.t == 0.0)
        return {from.segment, from.t, 1.0};
    if (to.t > 0.0)
        return {to.segment, 0.0, to.t};
    EdgeSpan longest{from.segment, 0.0, 1.0};
    const auto length = [&](int s) {
        const CubicBezier curve = contour.segment(s);
        return (curve.p3 - curve.p0).squaredNorm();
    };
    for (int s = (from.segment + 1) % count; s != to.segment; s = (s + 1) % count) {
        if (length(s) > length(longest.segment))
            longest.segment = s;
    }
    return longest;
}

SourceRing makeSourceRing(const Contour &contour, double chord, const ClipGrid &grid, bool isCut)
{
    return makeSourceRing(contour, contour.flatten(chord), grid, isCut);
}

SourceRing makeSourceRing(const Contour &contour, const Polyline &polyline, const ClipGrid &grid,
                          bool isCut)
{
    SourceRing ring{contour, isCut, {}, {}, {}};
    std::vector<CurvePoint> origins;
    origins.reserve(polyline.points.size());
    ring.points.reserve(polyline.points.size());
    ring.snapped.reserve(polyline.points.size());
    ring.spans.reserve(polyline.points.size());
    for (std::size_t i = 0; i < polyline.points.size(); ++i) {
        const GridPoint snapped = grid.snap(polyline.points[i]);
        if (!ring.snapped.empty() && ring.snapped.back() == snapped) {
            // Of two vertices in one place the start of a segment is the one to keep.
            if (polyline.origins[i].t == 0.0 && origins.back().t != 0.0) {
                origins.back() = polyline.origins[i];
                ring.points.back() = polyline.points[i];
            }
            continue;
        }
        ring.snapped.push_back(snapped);
        ring.points.push_back(polyline.points[i]);
        origins.push_back(polyline.origins[i]);
    }
    while (ring.snapped.size() > 1 && ring.snapped.back() == ring.snapped.front()) {
        ring.snapped.pop_back();
        ring.points.pop_back();
        origins.pop_back();
    }
    if (ring.snapped.size() < 3)
        return {contour, isCut, {}, {}, {}};
    for (std::size_t i = 0; i < origins.size(); ++i)
        ring.spans.push_back(
            spanBetween(contour, origins[i], origins[i + 1 < origins.size() ? i + 1 : 0]));
    return ring;
}

Result<std::vector<RecoveredRing>> recoverCurves(const std::vector<SourceRing> &sources,
                                                 const ClipGrid &grid,
                                                 const std::vector<GridRing> &rings)
{
    if (failsHere(FaultPoint::Curves))
        return failure(ErrorCode::NotWorkedOut);
    const SourceIndex index(sources);
    std::vector<GridRing> clean;
    clean.reserve(rings.size());
    for (const GridRing &ring : rings)
        clean.push_back(withoutSplinters(ring, index));
    const auto edges = findSourceEdges(sources, index, clean);
    std::vector<RecoveredRing> result(rings.size());
    for (std::size_t i = 0; i < clean.size(); ++i) {
        if (clean[i].size() < 3)
            continue;
        result[i].chords = grid.positions(clean[i]);
        Result<Contour> contour = RingRecovery(sources, index, grid, clean[i], edges[i]).contour();
        if (!contour)
            return tl::unexpected(contour.error());
        result[i].contour = *std::move(contour);
    }
    return result;
}

} // namespace fff
