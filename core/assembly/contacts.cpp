#include "core/assembly/contacts.h"

#include "core/base/tolerances.h"
#include "core/geometry/region_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace fff {

namespace {

/// What a point is before: a wall's edge begins at this corner; a face has none.
struct Surface
{
    const Vec2 *edge = nullptr;
    int side = 0; // of a face: +1, −1

    bool operator==(const Surface &) const = default;
};

struct Touch
{
    Surface surface;
    Contact contact;
};

/// The other body, as points of the first one see it.
class Obstacle
{
public:
    Obstacle(const Body &body, double reach, double rim)
        : m_body(body), m_normal(body.frame().normal()), m_half(0.5 * body.thickness()),
          m_reach(reach), m_rim(rim), m_tree(body.outline().region)
    {
    }

    std::optional<Touch> touchAt(const Vec3 &p) const
    {
        const double height = m_body.frame().height(p);
        const double beyond = std::abs(height) - m_half;
        if (beyond > m_reach)
            return {};
        const Vec2 q = m_body.frame().toLocal(p);
        const bool isInside = m_tree.locate(q) == Side::Inside;
        std::optional<Touch> touch;
        if (isInside && beyond >= -m_reach && !isAtRim(q))
            touch = Touch{{nullptr, height < 0.0 ? -1 : 1},
                          {p, height < 0.0 ? Vec3(-m_normal) : m_normal, beyond}};
        // Beside a wall only between the faces: beyond them it is free to pass.
        if (!(beyond < -m_rim))
            return touch;
        const double limit = touch ? std::min(m_reach, -beyond) : m_reach;
        if (std::optional<Touch> wall = wallAt(p, q, isInside, limit))
            return wall;
        return touch;
    }

private:
    /// Of a point inside; a rim that is no more than rounding is not looked for.
    bool isAtRim(const Vec2 &q) const
    {
        if (!(m_rim > kTouchingDepth))
            return false;
        bool isAt = false;
        const Vec2 around(m_rim, m_rim);
        m_tree.visitNear(Box2{q - around, q + around}, [&](const Vec2 &a, const Vec2 &b) {
            const Vec2 edge = b - a;
            const double length = edge.squaredNorm();
            const double share =
                length > 0.0 ? std::clamp(edge.dot(q - a) / length, 0.0, 1.0) : 0.0;
            isAt = isAt || (a + share * edge - q).norm() < m_rim;
        });
        return isAt;
    }

    /// Before the nearest wall, no more than `limit` away.
    std::optional<Touch> wallAt(const Vec3 &p, const Vec2 &q, bool isInside, double limit) const
    {
        std::optional<Touch> touch;
        double nearest = limit;
        const Vec2 around(m_reach, m_reach);
        m_tree.visitNear(Box2{q - around, q + around}, [&](const Vec2 &a, const Vec2 &b) {
            const Vec2 edge = b - a;
            const double length = edge.norm();
            const double along = edge.dot(q - a);
            if (!(length > 0.0) || along < 0.0 || along > length * length)
                return;
            const Vec2 out = Vec2(edge.y(), -edge.x()) / length; // material lies to the left
            const double beside = out.dot(q - a);
            if ((beside < 0.0) != isInside && std::abs(beside) > kTouchingDepth)
                return; // the back of a wall
            if (std::abs(beside) <= nearest) {
                nearest = std::abs(beside);
                touch = Touch{{&a, 0}, {p, m_body.frame().directionToWorld(out), beside}};
            }
        });
        return touch;
    }

    const Body &m_body;
    Vec3 m_normal;
    double m_half, m_reach, m_rim;
    RegionTree m_tree;
};

/// The stretch of a line from a to b that is in a box, as shares of the way.
std::optional<std::pair<double, double>> within(const Box3 &box, const Vec3 &a, const Vec3 &b)
{
    double from = 0.0, to = 1.0;
    for (int i = 0; i < 3; ++i) {
        const double way = b[i] - a[i];
        const double low = box.min[i] - a[i], high = box.max[i] - a[i];
        if (way == 0.0) {
            if (low > 0.0 || high < 0.0)
                return {};
            continue;
        }
        from = std::max(from, std::min(low / way, high / way));
        to = std::min(to, std::max(low / way, high / way));
    }
    if (from > to)
        return {};
    return std::pair(from, to);
}

class Edges
{
public:
    Edges(const Body &body, const Body &other, double reach, double rim)
        : m_body(body), m_obstacle(other, reach, rim), m_box(other.box())
    {
        const Vec3 around = Vec3::Constant(reach);
        m_box = Box3{m_box.min - around, m_box.max + around};
    }

    std::vector<Contact> contacts() &&
    {
        const Region &region = m_body.outline().region;
        addRing(region.outer);
        for (const Polygon &hole : region.holes)
            addRing(hole);
        return std::move(m_contacts);
    }

private:
    void addRing(const Polygon &ring)
    {
        const Frame &frame = m_body.frame();
        const Vec3 up = 0.5 * m_body.thickness() * frame.normal();
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec3 a = frame.toWorld(ring[i]), b = frame.toWorld(ring[(i + 1) % ring.size()]);
            addLine(a + up, b + up);
            addLine(a - up, b - up);
            addLine(a - up, a + up);
        }
    }

    void addLine(const Vec3 &a, const Vec3 &b)
    {
        const auto part = within(m_box, a, b);
        if (!part)
            return;
        const Vec3 first = a + part->first * (b - a), last = a + part->second * (b - a);
        const int steps = std::max(1, static_cast<int>((last - first).norm() / kContactStep));
        std::optional<Touch> run; // the last point of a stretch
        const auto finish = [&] {
            if (run)
                m_contacts.push_back(run->contact);
        };
        bool isFirst = true;
        for (int i = 0; i <= steps; ++i) {
            const Vec3 p = first + (static_cast<double>(i) / steps) * (last - first);
            std::optional<Touch> touch = m_obstacle.touchAt(p);
            if (!touch || !run || !(touch->surface == run->surface)) {
                if (!isFirst)
                    finish();
                if (touch)
                    m_contacts.push_back(touch->contact);
                isFirst = true;
            } else {
                isFirst = false;
            }
            run = std::move(touch);
        }
        if (!isFirst)
            finish();
    }

    const Body &m_body;
    Obstacle m_obstacle;
    Box3 m_box;
    std::vector<Contact> m_contacts;
};

} // namespace

std::vector<Contact> contactsOf(const Body &body, const Body &other, double reach, double rim)
{
    return Edges(body, other, reach, rim).contacts();
}

} // namespace fff
