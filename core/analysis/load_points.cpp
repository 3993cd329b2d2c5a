#include "core/analysis/load_points.h"

#include "core/geometry/segment_distance.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fff {

namespace {

/// Points of equal areas of a disc: one in the middle, and two rings about it.
constexpr int kInRings[] = {6, 12};
/// Of shares that come to 1, what rounding leaves (no unit).
constexpr double kSharesRounding = 1e-9;
/// Points of an edge.
constexpr int kAlongEdge = 9;

std::vector<LoadPoint> atOnce(const Vec2 &position)
{
    return {{position, 1.0}};
}

/// Shares that change evenly over the points and act at `about`; those that would pull are left
/// out, until none does. False: there are no such.
bool press(std::vector<LoadPoint> &points, const Vec2 &about)
{
    while (!points.empty()) {
        Eigen::Matrix3d sums = Eigen::Matrix3d::Zero();
        for (const LoadPoint &point : points) {
            const Vec3 row(1.0, point.at.x() - about.x(), point.at.y() - about.y());
            sums += row * row.transpose();
        }
        const Eigen::LDLT<Eigen::Matrix3d> solver(sums);
        const Vec3 plane = solver.solve(Vec3::UnitX());
        if (!plane.allFinite() || (sums * plane - Vec3::UnitX()).norm() > kSharesRounding)
            return false; // they lie on one line, beside it
        for (LoadPoint &point : points)
            point.share = plane.dot(Vec3(1.0, point.at.x() - about.x(), point.at.y() - about.y()));
        if (std::erase_if(points, [](const LoadPoint &point) { return point.share < 0.0; }) == 0)
            return true;
    }
    return false;
}

std::vector<LoadPoint> ofPatch(double width, const Vec2 &position, const Region &region)
{
    std::vector<LoadPoint> points;
    const auto add = [&](const Vec2 &at) {
        if (locate(at, region) != Side::Outside)
            points.push_back({at, 0.0});
    };
    add(position);
    double inner = 1.0, all = 1.0;
    for (const int count : kInRings)
        all += count;
    for (const int count : kInRings) {
        // Half of its own area lies within the radius at which they stand.
        const double radius = 0.5 * width * std::sqrt((inner + 0.5 * count) / all);
        inner += count;
        for (int i = 0; i < count; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / count;
            add(position + radius * Vec2(std::cos(angle), std::sin(angle)));
        }
    }
    return press(points, position) ? points : atOnce(position);
}

/// A place on a ring: so far along the edge that ends in the corner, mm.
struct RingPlace
{
    const Polygon *ring = nullptr;
    std::size_t edge = 0; // from its corner to the next one
    double along = 0.0;
};

const Vec2 &corner(const Polygon &ring, std::size_t index)
{
    return ring[index % ring.size()];
}

RingPlace nearestOf(const Region &region, const Vec2 &position)
{
    RingPlace nearest;
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](const Polygon &ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 at = nearestOfSegment(position, ring[i], corner(ring, i + 1));
            if (const double square = (at - position).squaredNorm(); square < least) {
                least = square;
                nearest = {&ring, i, (at - ring[i]).norm()};
            }
        }
    };
    look(region.outer);
    for (const Polygon &hole : region.holes)
        look(hole);
    return nearest;
}

double lengthOf(const Polygon &ring)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
        sum += (corner(ring, i + 1) - ring[i]).norm();
    return sum;
}

/// So far along the ring from there, mm, less than once round; back where it is below 0.
Vec2 walked(const RingPlace &from, double by, double round)
{
    double left = from.along + (by < 0.0 ? by + round : by);
    for (std::size_t i = from.edge, steps = 0; steps <= 2 * from.ring->size(); ++i, ++steps) {
        const Vec2 &a = corner(*from.ring, i), way = corner(*from.ring, i + 1) - a;
        const double length = way.norm();
        if (left <= length && length > 0.0)
            return a + left / length * way;
        left -= length;
    }
    return corner(*from.ring, from.edge); // by rounding alone
}

std::vector<LoadPoint> ofEdge(double width, const Vec2 &position, const Region &region)
{
    const RingPlace middle = nearestOf(region, position);
    if (!middle.ring)
        return atOnce(position);
    const double round = lengthOf(*middle.ring);
    const double length = std::min(width, round);
    std::vector<LoadPoint> points;
    for (int i = 0; i < kAlongEdge; ++i)
        points.push_back(
            {walked(middle, ((i + 0.5) / kAlongEdge - 0.5) * length, round), 1.0 / kAlongEdge});
    return points;
}

} // namespace

std::vector<LoadPoint> loadPoints(const Load &load, const Vec2 &position, const Region &region)
{
    switch (load.spread) {
    case Spread::Patch:
        return ofPatch(load.width, position, region);
    case Spread::Edge:
        return ofEdge(load.width, position, region);
    case Spread::Point:
    case Spread::Hanging:
        break;
    }
    return atOnce(position);
}

} // namespace fff
