#include "core/fabrication/shared_cuts.h"

#include "core/base/tolerances.h"
#include "core/fabrication/line_stations.h"
#include "core/geometry/box_runs.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// Shorter ones are not worth to lift the tool, mm.
constexpr double kLeastShared = 0.1;

struct StraightEdge
{
    std::size_t line = 0;
    double station = 0.0; // of its start
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();

    Box2 box() const
    {
        Box2 box;
        box.extend(from);
        box.extend(to);
        return box;
    }
};

std::vector<StraightEdge> straightEdges(std::span<const ToolLine *const> lines)
{
    std::vector<StraightEdge> edges;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const LineStations stations(*lines[i]);
        for (std::size_t k = 0; k < lines[i]->curves.size(); ++k) {
            const CubicBezier &curve = lines[i]->curves[k];
            if (curve.isStraight(2.0 * kClipGrid) && (curve.p3 - curve.p0).norm() >= kLeastShared)
                edges.push_back({i, stations.startOf(k), curve.p0, curve.p3});
        }
    }
    return edges;
}

/// Where the edge lies on the other one; to <= from: nowhere.
LineSpan overlapOn(const StraightEdge &edge, const StraightEdge &other)
{
    const Vec2 way = edge.to - edge.from;
    const double length = way.norm();
    const Vec2 along = way / length;
    const auto placeOf = [&](const Vec2 &p) {
        return Vec2((p - edge.from).dot(along), cross(along, p - edge.from));
    };
    Vec2 a = placeOf(other.from), b = placeOf(other.to);
    if (a.x() > b.x())
        std::swap(a, b);
    const double from = std::max(0.0, a.x()), to = std::min(length, b.x());
    if (to - from < kLeastShared)
        return {};
    const auto offAt = [&](double x) {
        return a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
    };
    if (std::max(std::abs(offAt(from)), std::abs(offAt(to))) > kTouchingDepth)
        return {};
    return {edge.station + from, edge.station + to};
}

std::vector<LineSpan> joined(std::vector<LineSpan> spans)
{
    std::sort(spans.begin(), spans.end(),
              [](const LineSpan &a, const LineSpan &b) { return a.from < b.from; });
    std::vector<LineSpan> all;
    for (const LineSpan &span : spans)
        if (!all.empty() && span.from <= all.back().to + kTouchingDepth)
            all.back().to = std::max(all.back().to, span.to);
        else
            all.push_back(span);
    return all;
}

} // namespace

std::vector<std::vector<LineSpan>> sharedSpans(std::span<const ToolLine *const> lines)
{
    const std::vector<StraightEdge> edges = straightEdges(lines);
    BoxRuns runs;
    runs.fill(edges.size(), [&edges](std::size_t i) { return edges[i].box(); });
    std::vector<std::vector<LineSpan>> spans(lines.size());
    for (const StraightEdge &edge : edges) {
        Box2 near = edge.box();
        near.min -= Vec2::Constant(kTouchingDepth);
        near.max += Vec2::Constant(kTouchingDepth);
        runs.any([&near](const Box2 &box) { return box.intersects(near); },
                 [&](std::size_t i) {
                     if (edges[i].line >= edge.line)
                         return true; // lines follow each other: none before it is left
                     if (const LineSpan on = overlapOn(edge, edges[i]); on.to > on.from)
                         spans[edge.line].push_back(on);
                     return false;
                 });
    }
    for (std::vector<LineSpan> &some : spans)
        some = joined(std::move(some));
    return spans;
}

} // namespace fff
