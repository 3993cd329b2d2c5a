#include "ui/view/cut_caps.h"

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

std::array<float, 3> toFloats(const Vec3 &p)
{
    return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

class Cutter
{
public:
    Cutter(CutCaps &caps, const Frame &frame, double thickness, const ClipPlane &plane)
        : m_caps(caps), m_frame(frame), m_plane(plane), m_up(0.5 * thickness * frame.normal())
    {
        const auto part = [](double v) { return static_cast<std::int8_t>(std::lround(127.0 * v)); };
        m_normal = {part(plane.normal.x()), part(plane.normal.y()), part(plane.normal.z()), 127};
        m_across = plane.normal.unitOrthogonal();
        m_along = plane.normal.cross(m_across);
    }

    void cutPrism(const Vec2 &a, const Vec2 &b, const Vec2 &c)
    {
        const Vec3 corners[] = {m_frame.toWorld(a), m_frame.toWorld(b), m_frame.toWorld(c)};
        std::vector<Vec3> points;
        for (int side = -1; side <= 1; side += 2) {
            std::vector<Vec3> onFace;
            for (int i = 0; i < 3; ++i)
                addCrossing(corners[i] + side * m_up, corners[(i + 1) % 3] + side * m_up, onFace);
            if (onFace.size() == 2)
                addEdge(onFace[0], onFace[1]);
            points.insert(points.end(), onFace.begin(), onFace.end());
        }
        for (const Vec3 &corner : corners)
            addCrossing(corner - m_up, corner + m_up, points);
        addFan(points);
    }

    void cutWall(const Vec2 &a, const Vec2 &b)
    {
        const Vec3 from = m_frame.toWorld(a), to = m_frame.toWorld(b);
        std::vector<Vec3> points;
        addCrossing(from - m_up, to - m_up, points);
        addCrossing(from + m_up, to + m_up, points);
        addCrossing(from - m_up, from + m_up, points);
        addCrossing(to - m_up, to + m_up, points);
        if (points.size() == 2)
            addEdge(points[0], points[1]);
    }

private:
    /// Points on the plane count as above it, so that each crossing is found once.
    void addCrossing(const Vec3 &a, const Vec3 &b, std::vector<Vec3> &points) const
    {
        const double heightA = m_plane.height(a), heightB = m_plane.height(b);
        if ((heightA >= 0.0) != (heightB >= 0.0))
            points.push_back(a + heightA / (heightA - heightB) * (b - a));
    }

    void addEdge(const Vec3 &a, const Vec3 &b)
    {
        m_caps.edges.push_back({toFloats(a), toFloats(b), m_normal, m_normal});
    }

    /// The convex polygon with these corners, counter-clockwise seen from where the normal points.
    void addFan(std::vector<Vec3> &points)
    {
        if (points.size() < 3)
            return;
        Vec3 middle = Vec3::Zero();
        for (const Vec3 &p : points)
            middle += p / static_cast<double>(points.size());
        const auto angle = [&](const Vec3 &p) {
            return std::atan2(m_along.dot(p - middle), m_across.dot(p - middle));
        };
        std::sort(points.begin(), points.end(),
                  [&](const Vec3 &p, const Vec3 &q) { return angle(p) < angle(q); });
        for (std::size_t i = 1; i + 1 < points.size(); ++i) {
            for (const Vec3 &p : {points[0], points[i], points[i + 1]})
                m_caps.triangles.push_back(toFloats(p));
        }
    }

    CutCaps &m_caps;
    const Frame &m_frame;
    const ClipPlane &m_plane;
    Vec3 m_up; // half the thickness
    Vec3 m_across, m_along;
    PackedNormal m_normal;
};

} // namespace

void addCap(CutCaps &caps, std::span<const Region> regions,
            std::span<const Triangulation> triangulations, const Frame &frame, double thickness,
            const ClipPlane &plane)
{
    Cutter cutter(caps, frame, thickness, plane);
    for (const Triangulation &triangulation : triangulations) {
        const auto at = [&](int i) { return triangulation.points[static_cast<std::size_t>(i)]; };
        for (const auto &t : triangulation.triangles)
            cutter.cutPrism(at(t[0]), at(t[1]), at(t[2]));
    }
    const auto cutRing = [&](const Polygon &ring) {
        for (std::size_t i = 0; i < ring.size(); ++i)
            cutter.cutWall(ring[i], ring[(i + 1) % ring.size()]);
    };
    for (const Region &region : regions) {
        cutRing(region.outer);
        for (const Polygon &hole : region.holes)
            cutRing(hole);
    }
}

} // namespace fff::ui
