#include "core/stroke/line_way.h"

#include "core/base/tolerances.h"
#include "core/geometry/directions.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// Scales by which it is judged at least where an end points.
constexpr double kLeastWay = 3.0;
constexpr std::size_t kRun = 24; // edges that have a box in common

Vec2 turnedBy(const Vec2 &way, double angle)
{
    return std::cos(angle) * way + std::sin(angle) * perpendicular(way);
}

/// Boxes of runs of edges within a stretch of the way.
struct EdgeRun
{
    std::size_t first = 0, end = 0;
    Box2 box;
};

std::vector<EdgeRun> runsWithin(const LineWay &way, double from, double to)
{
    std::vector<EdgeRun> runs;
    for (std::size_t i = way.edgeAt(from), last = way.edgeAt(to); i <= last; i += kRun) {
        EdgeRun run{i, std::min(i + kRun, last + 1), {}};
        for (std::size_t k = run.first; k <= run.end; ++k)
            run.box.extend(way.point(k));
        runs.push_back(run);
    }
    return runs;
}

/// Where the two edges cross, as parts of them. A touch does not count.
std::optional<Vec2> crossing(const Vec2 &a, const Vec2 &b, const Vec2 &c, const Vec2 &d)
{
    const Vec2 one = b - a, two = d - c;
    const double determinant = cross(one, two);
    if (std::abs(determinant) <= kParallelSine * one.norm() * two.norm())
        return {};
    const double u = cross(c - a, two) / determinant, v = cross(c - a, one) / determinant;
    if (u < 0.0 || u > 1.0 || v < 0.0 || v > 1.0)
        return {};
    return Vec2(u, v);
}

} // namespace

EndPointing pointingAt(const LineWay &way, const KeptStretch &kept, bool isEnd, double scale,
                       double corner)
{
    const double sign = isEnd ? -1.0 : 1.0, end = isEnd ? kept.to : kept.from;
    EndPointing result;
    for (double over = std::min(kPointingWay * scale, 0.2 * kept.length());;
         over = std::max(0.5 * over, kLeastWay * scale)) {
        const Vec2 last = way.at(end), middle = way.at(end + sign * 0.5 * over),
                   first = way.at(end + sign * over);
        const Vec2 near = sign * (middle - last), far = sign * (first - middle);
        if (near.norm() <= kClipGrid || far.norm() <= kClipGrid)
            return result;
        const double turn = isEnd ? signedTurn(far, near) : signedTurn(near, far);
        result.way = turnedBy(near.normalized(), (isEnd ? 0.5 : -0.5) * turn);
        result.bend = turn / (0.5 * over);
        // A corner so near to the end says nothing about it.
        if (std::abs(turn) < corner || over <= kLeastWay * scale)
            return result;
    }
}

double nearestAlong(const LineWay &way, double from, double to, const Vec2 &p, double &distance)
{
    double best = from;
    distance = (way.at(from) - p).norm();
    for (std::size_t i = way.edgeAt(from); i <= way.edgeAt(to); ++i) {
        const Vec2 edge = way.point(i + 1) - way.point(i);
        const double squared = edge.squaredNorm();
        const double share =
            squared > 0.0 ? std::clamp(edge.dot(p - way.point(i)) / squared, 0.0, 1.0) : 0.0;
        const double s =
            std::clamp(way.along(i) + share * (way.along(i + 1) - way.along(i)), from, to);
        const double here = (way.at(s) - p).norm();
        if (here < distance) {
            distance = here;
            best = s;
        }
    }
    return best;
}

std::optional<KeptStretch> crossingOfEnds(const LineWay &way, const KeptStretch &kept,
                                          double budget)
{
    std::optional<KeptStretch> best;
    const auto tail = runsWithin(way, kept.to - budget, kept.to);
    for (const EdgeRun &a : runsWithin(way, kept.from, kept.from + budget)) {
        for (const EdgeRun &b : tail) {
            if (!a.box.intersects(b.box))
                continue;
            for (std::size_t i = a.first; i < a.end; ++i) {
                for (std::size_t k = std::max(b.first, i + 2); k < b.end; ++k) {
                    const auto at =
                        crossing(way.point(i), way.point(i + 1), way.point(k), way.point(k + 1));
                    if (!at)
                        continue;
                    const KeptStretch here{
                        way.along(i) + at->x() * (way.along(i + 1) - way.along(i)),
                        way.along(k) + at->y() * (way.along(k + 1) - way.along(k))};
                    if (here.from < kept.from || here.to > kept.to ||
                        kept.length() - here.length() > budget)
                        continue;
                    if (!best || here.length() > best->length())
                        best = here;
                }
            }
        }
    }
    return best;
}

} // namespace fff
