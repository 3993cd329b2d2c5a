#include "core/nesting/poles.h"

#include "core/geometry/segment_distance.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

namespace fff::nest {

namespace {

/// Of the area; what is left is corners.
constexpr double kCovered = 0.9;
/// A disc less than this part of the first one adds nothing.
constexpr double kLeastShare = 0.02;
/// As a part of its radius, how much larger a disc elsewhere may be.
constexpr double kPrecision = 0.03;
constexpr int kMostSquares = 600;

struct Square
{
    Vec2 center = Vec2::Zero();
    double half = 0.0;
    double radius = 0.0; // of the disc there; less than 0: outside or in another one

    double promise() const { return radius + half * std::numbers::sqrt2; }
    bool operator<(const Square &other) const { return promise() < other.promise(); }
};

class PoleFinder
{
public:
    explicit PoleFinder(const Region &shape) : m_box(bounds(shape.outer))
    {
        addRing(shape.outer);
        for (const Polygon &hole : shape.holes)
            addRing(hole);
    }

    Pole next() const
    {
        std::priority_queue<Square> squares;
        Square best;
        int looked = 0;
        const auto look = [&](const Vec2 &center, double half) {
            const Square square{center, half, radiusAt(center)};
            ++looked;
            if (square.radius > best.radius)
                best = square;
            if (square.promise() > best.radius * (1.0 + kPrecision))
                squares.push(square);
        };
        const Vec2 size = m_box.size();
        const double side = std::max(size.minCoeff(), size.maxCoeff() / 8.0);
        if (!(side > 0.0))
            return {};
        for (double x = 0.5 * side; x < size.x() + 0.5 * side; x += side)
            for (double y = 0.5 * side; y < size.y() + 0.5 * side; y += side)
                look(m_box.min + Vec2(x, y), 0.5 * side);
        while (!squares.empty() && looked < kMostSquares) {
            const Square top = squares.top();
            squares.pop();
            if (top.promise() <= best.radius * (1.0 + kPrecision))
                break;
            const double half = 0.5 * top.half;
            for (const Vec2 &corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(-1, 1), Vec2(1, 1)})
                look(top.center + half * corner, half);
        }
        return {best.center, best.radius};
    }
    void take(const Pole &pole) { m_taken.push_back(pole); }

private:
    void addRing(const Polygon &ring)
    {
        for (std::size_t i = 0; i < ring.size(); ++i)
            m_edges.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
    }

    double radiusAt(const Vec2 &point) const
    {
        double square = std::numeric_limits<double>::infinity();
        bool inside = false;
        for (const auto &[from, to] : m_edges) {
            square = std::min(square, (nearestOfSegment(point, from, to) - point).squaredNorm());
            if ((from.y() > point.y()) != (to.y() > point.y()))
                inside ^= (cross(to - from, point - from) > 0.0) == (to.y() > from.y());
        }
        double radius = inside ? std::sqrt(square) : -std::sqrt(square);
        for (const Pole &pole : m_taken)
            radius = std::min(radius, (point - pole.center).norm() - pole.radius);
        return radius;
    }

    Box2 m_box;
    std::vector<std::pair<Vec2, Vec2>> m_edges;
    std::vector<Pole> m_taken;
};

} // namespace

std::vector<Pole> polesOf(const Region &shape)
{
    PoleFinder finder(shape);
    std::vector<Pole> poles;
    double covered = 0.0;
    const double whole = area(shape);
    while (poles.size() < Poles::kMost && covered < kCovered * whole) {
        const Pole pole = finder.next();
        if (!(pole.radius > 0.0) ||
            (!poles.empty() && pole.radius < kLeastShare * poles.front().radius))
            break;
        covered += std::numbers::pi * pole.radius * pole.radius;
        finder.take(pole);
        poles.push_back(pole);
    }
    return poles;
}

} // namespace fff::nest
