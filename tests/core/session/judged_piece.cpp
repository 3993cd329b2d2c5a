#include "tests/core/session/judged_piece.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fff::test {

namespace {

constexpr double kWallStep = 0.25; // mm along an outline: two points on a wall of 0.5
constexpr double kLayerStep = 0.5; // mm across the thickness
constexpr double kFaceStep = 0.5;  // mm on faces, which see what edges do not
constexpr double kBend = 0.1;      // sine of a turn from which on a vertex is a corner
constexpr double kParallel = 1e-3; // sine of the angle of two planes

bool isBend(const Vec2 &before, const Vec2 &at, const Vec2 &after)
{
    const Vec2 in = at - before, out = after - at;
    return std::abs(cross(in, out)) > kBend * in.norm() * out.norm() || in.dot(out) < 0.0;
}

/// The stretch of 0 … 1 where a value that runs evenly from `from` to `to` is within ±limit.
std::pair<double, double> within(double from, double to, double limit)
{
    if (from == to)
        return std::abs(from) <= limit ? std::pair(0.0, 1.0) : std::pair(1.0, 0.0);
    const double low = (-limit - from) / (to - from), high = (limit - from) / (to - from);
    return {std::max(0.0, std::min(low, high)), std::min(1.0, std::max(low, high))};
}

} // namespace

JudgedPiece::JudgedPiece(Prism prism)
    : m_prism(std::move(prism)), m_normal(m_prism.frame.normal()),
      m_edges(m_prism.outer, m_prism.holes),
      m_middle(frame().toWorld(0.5 * (m_edges.min() + m_edges.max()))),
      m_radius(std::hypot(0.5 * (m_edges.max() - m_edges.min()).norm(), half()))
{
}

double JudgedPiece::depth(const Vec3 &p) const
{
    const double below = half() - std::abs(m_normal.dot(p - frame().origin));
    if (below <= 0.0)
        return 0.0;
    const Vec2 local = frame().toLocal(p);
    return m_edges.isInside(local) ? m_edges.distance(local, below) : 0.0;
}

bool JudgedPiece::isWithin(const Vec3 &p, double depth) const
{
    if (half() - std::abs(m_normal.dot(p - frame().origin)) < depth)
        return false;
    const Vec2 local = frame().toLocal(p);
    return m_edges.isInside(local) && m_edges.distance(local, depth) >= depth;
}

double JudgedPiece::distance(const Vec3 &p, double limit) const
{
    const double above = std::max(0.0, std::abs(m_normal.dot(p - frame().origin)) - half());
    if (above >= limit)
        return limit;
    const Vec2 local = frame().toLocal(p);
    const double beside = m_edges.isInside(local) ? 0.0 : m_edges.distance(local, limit);
    return std::min(limit, std::hypot(above, beside));
}

std::vector<SurfacePoint> JudgedPiece::pointsNear(const JudgedPiece &other, double reach,
                                                  double faceReach) const
{
    std::vector<SurfacePoint> points;
    if (isFarFrom(other, reach))
        return points;
    addWalls(m_prism.outer, other, reach, points);
    for (const PlainRing &hole : m_prism.holes)
        addWalls(hole, other, reach, points);
    addFaces(other, faceReach, points);
    return points;
}

/// Heights from face to face.
std::vector<double> JudgedPiece::layers() const
{
    const int steps = std::max(2, static_cast<int>(std::ceil(m_prism.thickness / kLayerStep)));
    std::vector<double> heights;
    for (int i = 0; i <= steps; ++i)
        heights.push_back(half() * (2.0 * i / steps - 1.0));
    return heights;
}

void JudgedPiece::addWalls(const PlainRing &ring, const JudgedPiece &other, double reach,
                           std::vector<SurfacePoint> &points) const
{
    const std::vector<double> heights = layers();
    // What of the mid-plane has a point within reach of the other's slab, above or below it.
    const double limit = other.half() + reach + half() * std::abs(m_normal.dot(other.m_normal));
    const auto add = [&](const Vec2 &p) { addWithin(other, p, heights, reach, points); };
    double since = kWallStep; // mm from the last point
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 &before = ring[(i + ring.size() - 1) % ring.size()];
        const Vec2 &from = ring[i], &to = ring[(i + 1) % ring.size()];
        const double length = (to - from).norm();
        const auto [low, high] =
            within(other.m_normal.dot(world(from, 0.0) - other.frame().origin),
                   other.m_normal.dot(world(to, 0.0) - other.frame().origin), limit);
        if (low > high) {
            since = kWallStep;
            continue;
        }
        if (low == 0.0 && (since >= kWallStep || isBend(before, from, to))) {
            add(from);
            since = 0.0;
        }
        const int steps = static_cast<int>(std::ceil(length / kWallStep));
        const int first = std::max(1, static_cast<int>(std::floor(low * steps)));
        const int last = std::min(steps - 1, static_cast<int>(std::ceil(high * steps)));
        for (int k = first; k <= last; ++k)
            add(from + (static_cast<double>(k) / steps) * (to - from));
        since = steps > 1 ? length / steps : since + length;
    }
}

void JudgedPiece::addFaces(const JudgedPiece &other, double reach,
                           std::vector<SurfacePoint> &points) const
{
    const double cosine = m_normal.dot(other.m_normal);
    const double limit = other.half() + reach + half() * std::abs(cosine);
    // In this plane: along the line that both have, and across it.
    const Vec2 slope = frame().directionToLocal(other.m_normal);
    const double sine = slope.norm();
    const Vec2 across = sine < kParallel ? Vec2(Vec2::UnitY()) : Vec2(slope / sine);
    const Vec2 along(across.y(), -across.x());
    const Box2 own = boundsOf(*this, along), others = boundsOf(other, along);
    Vec2 low = own.min.cwiseMax(others.min) - Vec2::Constant(reach),
         high = own.max.cwiseMin(others.max) + Vec2::Constant(reach);
    const double height = other.m_normal.dot(frame().origin - other.frame().origin);
    if (sine >= kParallel) {
        low.y() = std::max(low.y(), (-limit - height) / sine);
        high.y() = std::min(high.y(), (limit - height) / sine);
    } else if (std::abs(height) > limit) {
        return;
    }
    for (double s = low.x() + 0.5 * kFaceStep; s < high.x(); s += kFaceStep)
        for (double v = low.y() + 0.25 * kFaceStep; v < high.y(); v += kFaceStep)
            if (const Vec2 p = s * along + v * across; m_edges.isInside(p))
                addWithin(other, p, {-half(), 0.0, half()}, reach, points);
}

void JudgedPiece::addWithin(const JudgedPiece &other, const Vec2 &p,
                            const std::vector<double> &heights, double reach,
                            std::vector<SurfacePoint> &points) const
{
    for (const double height : heights) {
        const Vec3 at = world(p, height);
        if (const double distance = other.distance(at, reach); distance < reach)
            points.push_back({at, distance});
    }
}

/// Seen in this plane, along a direction and to the left of it.
Box2 JudgedPiece::boundsOf(const JudgedPiece &other, const Vec2 &along) const
{
    Box2 box;
    for (const double x : {other.m_edges.min().x(), other.m_edges.max().x()}) {
        for (const double y : {other.m_edges.min().y(), other.m_edges.max().y()}) {
            for (const double z : {-other.half(), other.half()}) {
                const Vec2 p = frame().toLocal(other.world({x, y}, z));
                box.extend({along.dot(p), perpendicular(along).dot(p)});
            }
        }
    }
    return box;
}

bool JudgedPiece::isFarFrom(const JudgedPiece &other, double reach) const
{
    return (m_middle - other.m_middle).norm() > m_radius + other.m_radius + reach;
}

Vec3 JudgedPiece::world(const Vec2 &p, double height) const
{
    return frame().toWorld(p) + height * m_normal;
}

} // namespace fff::test
