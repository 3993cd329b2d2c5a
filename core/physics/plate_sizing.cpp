#include "core/physics/plate_sizing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

constexpr double kSharpTurn = 20.0 * std::numbers::pi / 180.0; // beyond straight
constexpr double kGrading = 0.35;       // edges grow by so much of the distance
constexpr double kSharpShare = 0.3;     // of the plain edge, at sharp corners
constexpr double kBendShare = 0.25;     // of the radius, where the boundary bends inwards
constexpr double kShortestShare = 0.02; // of the plain edge: what is narrower gets no finer mesh

struct RingEdge
{
    Vec2 from, to;
};

std::vector<RingEdge> ringEdges(const Region &region)
{
    std::vector<RingEdge> edges;
    const auto add = [&](const Polygon &ring) {
        for (std::size_t i = 0; i < ring.size(); ++i)
            edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
    };
    add(region.outer);
    for (const Polygon &hole : region.holes)
        add(hole);
    return edges;
}

/// From `point` along `way` (unit) to the first edge that faces it; infinite where none does.
double distanceAcross(const Vec2 &point, const Vec2 &way, const std::vector<RingEdge> &edges,
                      double least)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const RingEdge &edge : edges) {
        const Vec2 along = edge.to - edge.from;
        const double turn = cross(way, along);
        if (!(std::abs(turn) > 0.0))
            continue;
        const double there = cross(edge.from - point, along) / turn;
        const double onEdge = cross(edge.from - point, way) / turn;
        if (there > least && onEdge >= 0.0 && onEdge <= 1.0)
            nearest = std::min(nearest, there);
    }
    return nearest;
}

/// A corner at which the boundary turns into the material.
struct InwardCorner
{
    Vec2 point;
    double turn = 0.0;   // radians, positive
    double radius = 0.0; // mm, of the bend that the corner stands for
};

std::vector<InwardCorner> inwardCorners(const Region &region)
{
    std::vector<InwardCorner> found;
    const auto add = [&](const Polygon &ring) {
        const std::size_t n = ring.size();
        for (std::size_t i = 0; i < n; ++i) {
            const Vec2 in = ring[i] - ring[(i + n - 1) % n], out = ring[(i + 1) % n] - ring[i];
            // The material lies on the left of every ring.
            const double turn = -std::atan2(cross(in, out), in.dot(out));
            if (turn > 0.0)
                found.push_back({ring[i], turn, 0.5 * (in.norm() + out.norm()) / turn});
        }
    };
    add(region.outer);
    for (const Polygon &hole : region.holes)
        add(hole);
    return found;
}

} // namespace

std::vector<Vec2> sharpCorners(const Region &region)
{
    std::vector<Vec2> found;
    for (const InwardCorner &corner : inwardCorners(region)) {
        if (corner.turn > kSharpTurn)
            found.push_back(corner.point);
    }
    return found;
}

PlateSizing::PlateSizing(const Region &region, double edge, double linesAcross) : m_edge(edge)
{
    for (const InwardCorner &corner : inwardCorners(region)) {
        const double wanted =
            corner.turn > kSharpTurn ? kSharpShare * edge : kBendShare * corner.radius;
        if (wanted < edge)
            m_fine.push_back({corner.point, wanted});
    }
    addNarrowPlaces(region, linesAcross);
}

void PlateSizing::addNarrowPlaces(const Region &region, double linesAcross)
{
    const std::vector<RingEdge> edges = ringEdges(region);
    for (const RingEdge &edge : edges) {
        const Vec2 along = edge.to - edge.from;
        const double length = along.norm();
        if (!(length > 0.0))
            continue;
        const Vec2 inward = perpendicular(along) / length;
        const int count = std::clamp(static_cast<int>(length / m_edge), 1, 50);
        for (int k = 0; k < count; ++k) {
            const Vec2 point = edge.from + along * ((k + 0.5) / count);
            const double width = distanceAcross(point, inward, edges, kShortestShare * m_edge);
            if (width < linesAcross * m_edge)
                m_fine.push_back({point + 0.5 * width * inward, width / linesAcross});
        }
    }
}

double PlateSizing::edgeAt(const Vec2 &point) const
{
    double edge = m_edge;
    for (const FinePlace &place : m_fine) {
        if (place.edge < edge)
            edge = std::min(edge, place.edge + kGrading * (point - place.point).norm());
    }
    return std::max(edge, kShortestShare * m_edge);
}

} // namespace fff
