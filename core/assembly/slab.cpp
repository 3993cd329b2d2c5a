#include "core/assembly/slab.h"

#include <algorithm>
#include <vector>

namespace fff {

namespace {

/// A wall of a slab: the rectangle corner + s along + u across, s and u from 0 to 1.
struct Wall
{
    Vec3 corner, along, across;
    Box3 box;

    Vec3 at(double s, double u) const { return corner + s * along + u * across; }
};

double share(const Vec3 &direction, const Vec3 &p)
{
    const double lengthSquared = direction.squaredNorm();
    return lengthSquared > 0.0 ? std::clamp(direction.dot(p) / lengthSquared, 0.0, 1.0) : 0.0;
}

std::vector<Wall> wallsOf(const Slab &slab)
{
    const Vec3 across = slab.thickness * slab.frame.normal();
    std::vector<Wall> walls;
    const auto add = [&](const Polygon &ring) {
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            Wall wall;
            wall.corner = slab.frame.toWorld(ring[j]) - 0.5 * across;
            wall.along = slab.frame.directionToWorld(ring[i] - ring[j]);
            wall.across = across;
            for (const double s : {0.0, 1.0})
                for (const double u : {0.0, 1.0})
                    wall.box.extend(wall.at(s, u));
            walls.push_back(wall);
        }
    };
    add(slab.region.outer);
    for (const Polygon &hole : slab.region.holes)
        add(hole);
    return walls;
}

void keep(const Vec3 &onA, const Vec3 &onB, Nearest &best)
{
    const double d = (onA - onB).norm();
    if (d < best.distance)
        best = {d, onA, onB};
}

Nearest swapped(const Nearest &n)
{
    return {n.distance, n.onB, n.onA};
}

/// Nearest points of p0 + s d, q0 + t e, s and t from 0 to 1.
void keepSegments(const Vec3 &p0, const Vec3 &d, const Vec3 &q0, const Vec3 &e, Nearest &best)
{
    const Vec3 r = p0 - q0;
    const double dd = d.squaredNorm(), ee = e.squaredNorm(), de = d.dot(e);
    const double denominator = dd * ee - de * de;
    double s = 0.0; // any will do for parallel ones
    if (denominator > 0.0)
        s = std::clamp((de * e.dot(r) - ee * d.dot(r)) / denominator, 0.0, 1.0);
    const double t = share(e, r + s * d);
    s = share(d, q0 + t * e - p0);
    keep(p0 + s * d, q0 + t * e, best);
}

void keepPoint(const Vec3 &point, const Wall &wall, Nearest &best)
{
    const Vec3 r = point - wall.corner;
    keep(point, wall.at(share(wall.along, r), share(wall.across, r)), best);
}

/// Where a segment goes through a wall.
void keepThrough(const Vec3 &from, const Vec3 &way, const Wall &wall, Nearest &best)
{
    const Vec3 normal = wall.along.cross(wall.across);
    const double a = normal.dot(from - wall.corner), b = a + normal.dot(way);
    if ((a < 0.0) == (b < 0.0))
        return;
    const Vec3 point = from + a / (a - b) * way, r = point - wall.corner;
    const double s = wall.along.dot(r) / wall.along.squaredNorm();
    const double u = wall.across.dot(r) / wall.across.squaredNorm();
    if (std::min(s, u) >= 0.0 && std::max(s, u) <= 1.0)
        keep(point, point, best);
}

void keepEdgesThrough(const Wall &edges, const Wall &wall, Nearest &best)
{
    for (const double i : {0.0, 1.0}) {
        keepThrough(edges.at(0, i), edges.along, wall, best);
        keepThrough(edges.at(i, 0), edges.across, wall, best);
    }
}

void keepWalls(const Wall &a, const Wall &b, Nearest &best)
{
    keepEdgesThrough(a, b, best);
    keepEdgesThrough(b, a, best);
    Nearest reverse = swapped(best);
    for (const double s : {0.0, 1.0})
        for (const double u : {0.0, 1.0}) {
            keepPoint(a.at(s, u), b, best);
            keepPoint(b.at(s, u), a, reverse);
        }
    if (reverse.distance < best.distance)
        best = swapped(reverse);
    for (const double i : {0.0, 1.0})
        for (const double j : {0.0, 1.0}) {
            keepSegments(a.at(0, i), a.along, b.at(0, j), b.along, best);
            keepSegments(a.at(0, i), a.along, b.at(j, 0), b.across, best);
            keepSegments(a.at(i, 0), a.across, b.at(0, j), b.along, best);
            keepSegments(a.at(i, 0), a.across, b.at(j, 0), b.across, best);
        }
}

/// A point over (or under) the inside of a slab's region, against its faces.
void keepOverFaces(const Vec3 &point, const Slab &slab, Nearest &best)
{
    const double height = slab.frame.height(point);
    const double beyond = std::abs(height) - 0.5 * slab.thickness;
    if (beyond >= best.distance)
        return;
    const Vec2 foot = slab.frame.toLocal(point);
    if (locate(foot, slab.region) == Side::Outside)
        return;
    const Vec3 onSlab =
        beyond <= 0.0 ? point
                      : Vec3(point - beyond * (height > 0.0 ? 1.0 : -1.0) * slab.frame.normal());
    keep(point, onSlab, best);
}

/// Corners of the walls over the other slab's faces, and edges that run through both of its faces.
void keepThroughFaces(const std::vector<Wall> &walls, const Slab &slab, Nearest &best)
{
    for (const Wall &wall : walls) {
        for (const double u : {0.0, 1.0}) {
            const Vec3 from = wall.at(0, u), to = wall.at(1, u);
            keepOverFaces(from, slab, best);
            const double a = slab.frame.height(from), b = slab.frame.height(to);
            if ((a < 0.0) != (b < 0.0))
                keepOverFaces(from + a / (a - b) * (to - from), slab, best);
        }
        const Vec3 from = wall.corner, to = wall.corner + wall.across;
        const double a = slab.frame.height(from), b = slab.frame.height(to);
        if ((a < 0.0) != (b < 0.0))
            keepOverFaces(from + a / (a - b) * (to - from), slab, best);
    }
}

} // namespace

Box3 boundsOf(const Slab &slab)
{
    Box3 box;
    for (const Vec2 &p : slab.region.outer)
        box.extend(slab.frame.toWorld(p));
    const Vec3 reach = 0.5 * slab.thickness * slab.frame.normal().cwiseAbs();
    box.min -= reach;
    box.max += reach;
    return box;
}

double distanceBetween(const Box3 &a, const Box3 &b)
{
    return (a.min - b.max).cwiseMax(b.min - a.max).cwiseMax(0.0).norm();
}

Nearest nearestPoints(const Slab &a, const Slab &b, double limit)
{
    const std::vector<Wall> wallsA = wallsOf(a), wallsB = wallsOf(b);
    Nearest best;
    best.distance = limit;
    keepThroughFaces(wallsA, b, best);
    Nearest reverse = swapped(best);
    keepThroughFaces(wallsB, a, reverse);
    best = swapped(reverse);
    const Box3 boxB = boundsOf(b);
    for (const Wall &wallA : wallsA) {
        if (distanceBetween(wallA.box, boxB) >= best.distance)
            continue;
        for (const Wall &wallB : wallsB)
            if (distanceBetween(wallA.box, wallB.box) < best.distance)
                keepWalls(wallA, wallB, best);
    }
    if (best.distance >= limit)
        best.distance = std::numeric_limits<double>::infinity();
    return best;
}

} // namespace fff
