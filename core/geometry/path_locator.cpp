#include "core/geometry/path_locator.h"

#include "core/base/tolerances.h"
#include "core/geometry/segment_distance.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

double distanceToFlatBox(const Box3 &box, const Vec2 &p)
{
    const double dx = std::max({box.min.x() - p.x(), 0.0, p.x() - box.max.x()});
    const double dy = std::max({box.min.y() - p.y(), 0.0, p.y() - box.max.y()});
    return std::hypot(dx, dy);
}

} // namespace

PathLocator::PathLocator(CurvePath path) : m_path(std::move(path))
{
    if (m_path.segmentCount() == 0)
        return;
    m_points.push_back(m_path.points().front());
    m_origins.push_back({0, 0.0});
    m_lengths.push_back(0.0);
    std::vector<Box3> boxes;
    for (int i = 0; i < m_path.segmentCount(); ++i) {
        const CubicBezier segment = m_path.segment(i);
        const int count = segment.chordCount(kChord);
        for (int k = 1; k <= count; ++k) {
            const double t = static_cast<double>(k) / count;
            const Vec2 next = k == count ? segment.p3 : segment.at(t);
            Box3 box;
            for (const Vec2 &end : {m_points.back(), next})
                box.extend({end.x(), end.y(), 0.0});
            boxes.push_back(box);
            m_lengths.push_back(m_lengths.back() + (next - m_points.back()).norm());
            m_points.push_back(next);
            m_origins.push_back({i, t});
        }
    }
    m_tree = BoxTree(boxes);
}

/// The chord that contains so much of the line.
std::size_t PathLocator::chordAt(double along) const
{
    const auto above = std::upper_bound(m_lengths.begin(), m_lengths.end(), along);
    const auto index = static_cast<std::size_t>(
        std::max<std::ptrdiff_t>(std::distance(m_lengths.begin(), above) - 1, 0));
    return std::min(index, m_lengths.size() - 2);
}

PathLocator::Vertex PathLocator::vertexAt(double along) const
{
    const std::size_t chord = chordAt(along);
    const double length = m_lengths[chord + 1] - m_lengths[chord];
    const double share =
        length > 0.0 ? std::clamp((along - m_lengths[chord]) / length, 0.0, 1.0) : 0.0;
    const Vertex &end = m_origins[chord + 1];
    const double from = m_origins[chord].segment == end.segment ? m_origins[chord].t : 0.0;
    return {end.segment, from + share * (end.t - from)};
}

double PathLocator::wrapped(double along) const
{
    if (!isClosed())
        return std::clamp(along, 0.0, length());
    const double rest = std::fmod(along, length());
    return rest < 0.0 ? rest + length() : rest;
}

/// The chord is where the search begins: the place is where the curve comes nearest, beside it.
void PathLocator::look(std::size_t chord, const Vec2 &p, double &reach,
                       std::optional<Place> &best) const
{
    const Vec2 &a = m_points[chord], &b = m_points[chord + 1];
    const Vec2 foot = nearestOfSegment(p, a, b);
    const double distance = (foot - p).norm();
    if (distance > reach)
        return;
    reach = distance;
    best = Place{m_lengths[chord] + (foot - a).norm(), foot, distance};
}

/// From the nearest chord to the nearest place of the curve beside it.
void PathLocator::polish(const Vec2 &p, std::optional<Place> &place) const
{
    constexpr int kSteps = 3; // of Newton's method, each of which doubles the digits
    if (!place)
        return;
    const std::size_t chord = chordAt(place->along);
    const CubicBezier segment = m_path.segment(m_origins[chord + 1].segment);
    const double to = m_origins[chord + 1].t;
    const double from =
        m_origins[chord].segment == m_origins[chord + 1].segment ? m_origins[chord].t : 0.0;
    double t = vertexAt(place->along).t;
    for (int i = 0; i < kSteps; ++i) {
        const Vec2 off = segment.at(t) - p, way = segment.derivative(t);
        const double bend = way.squaredNorm() + off.dot(segment.secondDerivative(t));
        if (!(bend > 0.0))
            break;
        t = std::clamp(t - off.dot(way) / bend, from, to);
    }
    const double share = to > from ? (t - from) / (to - from) : 0.0;
    place->along = m_lengths[chord] + share * (m_lengths[chord + 1] - m_lengths[chord]);
    place->at = segment.at(t);
    place->distance = (place->at - p).norm();
}

std::optional<PathLocator::Place> PathLocator::nearest(const Vec2 &p, double reach) const
{
    std::optional<Place> best;
    m_tree.any([&](const Box3 &box) { return distanceToFlatBox(box, p) <= reach; },
               [&](int chord) {
                   look(static_cast<std::size_t>(chord), p, reach, best);
                   return false;
               });
    polish(p, best);
    return best;
}

std::optional<PathLocator::Place> PathLocator::nearest(const Vec2 &p, double reach, double around,
                                                       double window) const
{
    if (length() <= 0.0)
        return std::nullopt;
    if (isClosed() && 2.0 * window >= length())
        return nearest(p, reach);
    std::optional<Place> best;
    const std::size_t chords = m_points.size() - 1;
    const auto scan = [&](double from, double to) {
        for (std::size_t i = chordAt(from); i < chords && m_lengths[i] <= to; ++i)
            look(i, p, reach, best);
    };
    const double from = around - window, to = around + window;
    scan(std::max(from, 0.0), std::min(to, length()));
    if (isClosed() && from < 0.0)
        scan(from + length(), length());
    if (isClosed() && to > length())
        scan(0.0, to - length());
    polish(p, best);
    return best;
}

Vec2 PathLocator::at(double along) const
{
    const Vertex place = vertexAt(wrapped(along));
    return m_path.segment(place.segment).at(place.t);
}

Vec2 PathLocator::directionAt(double along) const
{
    const Vertex place = vertexAt(wrapped(along));
    const Vec2 way = m_path.segment(place.segment).derivative(place.t);
    if (way.norm() > 0.0)
        return way.normalized();
    const std::size_t chord = chordAt(wrapped(along));
    return (m_points[chord + 1] - m_points[chord]).normalized();
}

/// Forwards, within the line.
void PathLocator::addPiece(double from, double to, std::vector<CubicBezier> &pieces) const
{
    if (!(to > from))
        return;
    const Vertex first = vertexAt(from), last = vertexAt(to);
    for (int i = first.segment; i <= last.segment; ++i) {
        const double t0 = i == first.segment ? first.t : 0.0;
        const double t1 = i == last.segment ? last.t : 1.0;
        if (!(t1 > t0))
            continue;
        const CubicBezier segment = m_path.segment(i);
        CubicBezier piece = t0 == 0.0 && t1 == 1.0 ? segment : segment.piece(t0, t1);
        if ((piece.p3 - piece.p0).norm() <= kClipGrid)
            continue;
        if (!pieces.empty())
            piece.p0 = pieces.back().p3;
        pieces.push_back(piece);
    }
}

std::vector<CubicBezier> PathLocator::piece(double from, double to) const
{
    std::vector<CubicBezier> pieces;
    if (length() <= 0.0)
        return pieces;
    if (to < from) {
        pieces = piece(to, from);
        std::reverse(pieces.begin(), pieces.end());
        for (CubicBezier &one : pieces)
            one = one.reversed();
        return pieces;
    }
    if (!isClosed()) {
        addPiece(std::max(from, 0.0), std::min(to, length()), pieces);
        return pieces;
    }
    const double start = wrapped(from), end = start + std::min(to - from, length());
    addPiece(start, std::min(end, length()), pieces);
    if (end > length())
        addPiece(0.0, end - length(), pieces);
    return pieces;
}

} // namespace fff
