#include "core/stroke/pen_path.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"

#include <utility>

namespace fff {

namespace {

/// Handles that follow each other are of one length and opposite to this, mm.
constexpr double kSymmetric = 1e-9;

bool isBroken(const PathPoint &point)
{
    return point.in.has_value() != point.out.has_value() ||
           (point.in && (*point.in + *point.out).norm() > kSymmetric);
}

} // namespace

CubicBezier pathPiece(const PathPoint &from, const PathPoint &to)
{
    if (!from.out && !to.in)
        return CubicBezier::line(from.at, to.at);
    const Vec2 leaving = from.out ? Vec2(from.at + *from.out) : from.at;
    const Vec2 arriving = to.in ? Vec2(to.at + *to.in) : to.at;
    const Vec2 p1 = from.out ? leaving : Vec2(from.at + (arriving - from.at) / 3.0);
    const Vec2 p2 = to.in ? arriving : Vec2(to.at + (leaving - to.at) / 3.0);
    return {from.at, p1, p2, to.at};
}

std::vector<CubicBezier> PenPath::pieces() const
{
    std::vector<CubicBezier> pieces;
    for (std::size_t i = 0; i + 1 < m_points.size(); ++i)
        pieces.push_back(pathPiece(m_points[i], m_points[i + 1]));
    return pieces;
}

void PenPath::keep()
{
    if (m_before.empty() || !(m_before.back() == m_points))
        m_before.push_back(m_points);
}

void PenPath::add(const Vec2 &at)
{
    m_after.clear();
    m_points.push_back({at, {}, {}});
}

void PenPath::move(std::size_t index, const Vec2 &at)
{
    m_after.clear();
    m_points[index].at = at;
}

void PenPath::bend(std::size_t index, End end, const Vec2 &tip, bool isBrokenOff)
{
    m_after.clear();
    PathPoint &point = m_points[index];
    const bool follows = !isBrokenOff && (point.isCorner() || !isBroken(point));
    std::optional<Vec2> &handle = end == End::Out ? point.out : point.in;
    std::optional<Vec2> &other = end == End::Out ? point.in : point.out;
    const Vec2 way = tip - point.at;
    handle.reset();
    if (way.norm() > kClipGrid)
        handle = way;
    if (!follows)
        return;
    other.reset();
    if (handle)
        other = -way;
}

void PenPath::removeLast()
{
    m_after.clear();
    m_points.pop_back();
}

bool PenPath::canUndo() const
{
    // The last step may have changed nothing so far; none before it did so.
    return m_before.size() > 1 || (m_before.size() == 1 && !(m_before.back() == m_points));
}

void PenPath::undo()
{
    if (m_before.back() == m_points)
        m_before.pop_back();
    m_after.push_back(std::exchange(m_points, std::move(m_before.back())));
    m_before.pop_back();
}

void PenPath::redo()
{
    keep();
    m_points = std::move(m_after.back());
    m_after.pop_back();
}

PathContour closedPath(const std::vector<PathPoint> &points)
{
    PathContour path;
    if (points.size() < 2)
        return path;
    std::vector<CubicBezier> chain;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        chain.push_back(pathPiece(points[i], points[i + 1]));
    if ((points.back().at - points.front().at).norm() <= kClipGrid)
        chain.back().p3 = points.front().at;
    else
        chain.push_back(*(path.closing = pathPiece(points.back(), points.front())));
    // A contour has two segments at least: a loop of a single one is cut in its middle.
    if (chain.size() == 1)
        chain = {chain.front().piece(0.0, 0.5), chain.front().piece(0.5, 1.0)};

    const Result<Contour> closed = Contour::fromSegments(chain);
    if (!closed)
        return path;
    Result<ResolvedContour> resolved = resolveCrossings(*closed);
    if (!resolved)
        return path;
    path.contour = std::move(resolved->contour);
    path.wasCrossing = resolved->wasCrossing;
    return path;
}

} // namespace fff
