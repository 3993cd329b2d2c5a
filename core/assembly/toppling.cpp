#include "core/assembly/toppling.h"

#include "core/base/tolerances.h"
#include "core/geometry/hull_faces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <queue>

namespace fff {

namespace {

/// The lower half of a hull: faces that have something else than sky above them.
HullFaces lowerFaces(std::vector<Vec3> points)
{
    // Three points so far up that what is seen from them is no way to lie (1 : 10, steeper than
    // anything that kFarthestLean reaches), and that the hull of a single point has a face.
    Box3 box;
    for (const Vec3 &p : points)
        box.extend(p);
    const double size = std::max(1.0, box.size().maxCoeff());
    const double sky = box.max.y() + 10.0 * size;
    const Vec3 middle = 0.5 * (box.min + box.max);
    for (const Vec2 &off : {Vec2(1.0, 0.0), Vec2(-1.0, 1.0), Vec2(-1.0, -1.0)})
        points.emplace_back(middle.x() + 0.1 * size * off.x(), sky,
                            middle.z() + 0.1 * size * off.y());
    HullFaces hull = hullFaces(points);
    const auto isUp = [&](int face) {
        const auto &corners = hull.faces[static_cast<std::size_t>(face)].corners;
        return std::any_of(corners.begin(), corners.end(), [&](int corner) {
            return hull.points[static_cast<std::size_t>(corner)].y() >= sky;
        });
    };
    std::vector<int> kept(hull.faces.size(), -1);
    std::vector<HullFaces::Face> lower;
    for (std::size_t f = 0; f < hull.faces.size(); ++f)
        if (!isUp(static_cast<int>(f))) {
            kept[f] = static_cast<int>(lower.size());
            lower.push_back(hull.faces[f]);
        }
    for (HullFaces::Face &face : lower)
        for (int &across : face.across)
            across = kept[static_cast<std::size_t>(across)]; // −1: the sky
    hull.faces = std::move(lower);
    return hull;
}

double angleBetween(const Vec3 &a, const Vec3 &b)
{
    return std::acos(std::clamp(a.dot(b), -1.0, 1.0));
}

/// An edge that keeps it from falling.
struct Hold
{
    double tilt = -std::numeric_limits<double>::infinity(); // radians, less than which it keeps
    double margin = 0.0;                                    // mm
    Vec3 at = Vec3::Zero();
};

class Topple
{
public:
    Topple(const std::vector<Vec3> &points, const Vec3 &centre, const Ground &ground)
        : m_hull(lowerFaces(points)), m_centre(centre), m_ground(ground),
          m_isReached(m_hull.faces.size(), false), m_isFoot(m_hull.points.size(), false)
    {
        for (const int first : firstFaces()) {
            const std::optional<int> still = stillFrom(first);
            if (!still)
                m_last = fallFrom(first);
            else if (m_rest < 0)
                m_rest = *still;
        }
        const Vec3 up = m_rest < 0 ? ground.up : upOf(m_rest).value_or(ground.up);
        if (m_rest >= 0 && !isOnGround(m_rest))
            m_ground = {up, up.dot(cornerOf(m_rest, 0))};
        for (std::size_t i = 0; i < m_hull.points.size(); ++i)
            m_isFoot[i] = touches(static_cast<int>(i));
        if (m_last || m_rest < 0)
            return;
        lieOn({m_rest, up, Hold()});
        // In the order of the tilting that it takes: each is reached with the least.
        while (!m_last && !m_next.empty()) {
            const Push push = m_next.top();
            m_next.pop();
            if (!lieOn(push))
                m_last = push.held;
        }
    }

    Toppling toppling() const
    {
        const Vec3 below = m_centre - m_ground.above(m_centre) * m_ground.up;
        // Without faces it stands on a point.
        const Hold last = m_last.value_or(Hold{0.0, 0.0, below});
        Toppling found{m_ground, last.tilt, last.margin, last.at, m_rocking, {}};
        for (std::size_t i = 0; i < m_hull.points.size(); ++i)
            if (m_isFoot[i])
                found.contacts.push_back(m_hull.points[i]);
        return found;
    }

private:
    /// Onto a face.
    struct Push
    {
        int onto;  // −1: the sky
        Vec3 up;   // of that which it comes from
        Hold held; // of the edges on the way that which takes most tilting

        bool operator>(const Push &other) const { return held.tilt > other.held.tilt; }
    };

    const Vec3 &cornerOf(int face, int corner) const
    {
        return m_hull.points[static_cast<std::size_t>(indexOf(face, corner))];
    }
    int indexOf(int face, int corner) const
    {
        return m_hull.faces[static_cast<std::size_t>(face)]
            .corners[static_cast<std::size_t>(corner % 3)];
    }
    bool touches(int point) const
    {
        return m_ground.above(m_hull.points[static_cast<std::size_t>(point)]) <= kGroundContact;
    }
    int feetOf(int face) const
    {
        return touches(indexOf(face, 0)) + touches(indexOf(face, 1)) + touches(indexOf(face, 2));
    }

    /// To rounding. Of many points on one plane the faces are whatever their order and rounding
    /// make them, narrow ones turned by much among them: what is said is of the plane.
    bool isOnGround(int face) const
    {
        for (int corner = 0; corner < 3; ++corner)
            if (std::abs(m_ground.above(cornerOf(face, corner))) > kClipGrid)
                return false;
        return true;
    }
    /// Out of the ground that lies along it, unit; none of one so narrow that rounding turns it.
    std::optional<Vec3> upOf(int face) const;
    /// What it rests on.
    std::vector<int> firstFaces() const;
    Hold holdOf(int face, int side, const Vec3 &up) const;
    /// The side of a face over which it goes down most; none where it lies still.
    std::optional<int> wayDown(int face, const Vec3 &up) const;
    /// Where it lies still; none where it falls.
    std::optional<int> stillFrom(int face) const;
    /// Over the worst edge of what it cannot lie on.
    Hold fallFrom(int face) const;
    /// False: nothing is there on which it could lie.
    bool lieOn(const Push &push);

    HullFaces m_hull;
    Vec3 m_centre;
    Ground m_ground;
    int m_rest = -1;               // a face
    std::vector<bool> m_isReached; // of the faces
    std::vector<bool> m_isFoot;    // of the points
    double m_rocking = 0.0;        // radians
    std::priority_queue<Push, std::vector<Push>, std::greater<>> m_next;
    std::optional<Hold> m_last; // when that gives way it falls
};

std::optional<Vec3> Topple::upOf(int face) const
{
    if (isOnGround(face))
        return m_ground.up;
    const Vec3 &a = cornerOf(face, 0), &b = cornerOf(face, 1), &c = cornerOf(face, 2);
    const Vec3 down = (b - a).cross(c - a);
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    if (down.norm() <= kClipGrid * longest)
        return std::nullopt;
    return -down.normalized();
}

std::vector<int> Topple::firstFaces() const
{
    std::vector<int> faces;
    int most = 1; // feet
    double nearest = 0.0;
    for (int face = 0; face < static_cast<int>(m_hull.faces.size()); ++face) {
        const std::optional<Vec3> up = upOf(face);
        const int feet = feetOf(face);
        if (!up || feet < most)
            continue;
        const double along = up->dot(m_ground.up);
        // Of those that lie on the ground the one that does so best; of an edge or a point all.
        const bool isBetter = feet > most || (feet == 3 && along > nearest);
        if (isBetter)
            faces.clear();
        if (isBetter || feet < 3) {
            faces.push_back(face);
            nearest = along;
        }
        most = feet;
    }
    return faces;
}

Hold Topple::holdOf(int face, int side, const Vec3 &up) const
{
    const Vec3 &from = cornerOf(face, side);
    const Vec3 along = cornerOf(face, side + 1) - from;
    const double height = up.dot(m_centre - from);
    const Vec3 middle = m_centre - height * up;
    Hold hold{0.0, (middle - from).norm(), from};
    if (along.norm() > kClipGrid) { // else it has no direction
        const Vec3 way = up.cross(along).normalized();
        hold.margin = way.dot(from - middle);
        hold.at = middle + hold.margin * way;
    }
    hold.tilt = std::atan2(hold.margin, std::max(0.0, height));
    return hold;
}

std::optional<int> Topple::wayDown(int face, const Vec3 &up) const
{
    std::optional<int> way;
    double least = -kClipGrid; // mm: on an edge it is over neither side
    for (int side = 0; side < 3; ++side)
        if (const double margin = holdOf(face, side, up).margin; margin < least) {
            least = margin;
            way = side;
        }
    return way;
}

std::optional<int> Topple::stillFrom(int face) const
{
    Vec3 up = m_ground.up;
    std::vector<bool> isPassed(m_hull.faces.size(), false);
    while (!isPassed[static_cast<std::size_t>(face)]) {
        isPassed[static_cast<std::size_t>(face)] = true;
        up = upOf(face).value_or(up);
        if (angleBetween(up, Vec3::UnitY()) > kFarthestLean)
            return std::nullopt;
        const std::optional<int> way = wayDown(face, up);
        if (!way)
            return face;
        const int next =
            m_hull.faces[static_cast<std::size_t>(face)].across[static_cast<std::size_t>(*way)];
        if (next < 0)
            return std::nullopt;
        face = next;
    }
    return face; // to and fro over an edge, to rounding
}

Hold Topple::fallFrom(int face) const
{
    const std::optional<int> way = wayDown(face, m_ground.up);
    Hold hold = holdOf(face, way.value_or(0), m_ground.up);
    hold.tilt = std::min(hold.tilt, 0.0);
    return hold;
}

bool Topple::lieOn(const Push &push)
{
    if (push.onto < 0)
        return false;
    if (m_isReached[static_cast<std::size_t>(push.onto)])
        return true;
    m_isReached[static_cast<std::size_t>(push.onto)] = true;
    const Vec3 up = upOf(push.onto).value_or(push.up);
    const double turned = angleBetween(up, m_ground.up);
    if (turned > kFarthestLean)
        return false;
    if (feetOf(push.onto) < 3 && push.held.tilt < kSteadyTilt)
        m_rocking = std::max(m_rocking, turned);
    const HullFaces::Face &lying = m_hull.faces[static_cast<std::size_t>(push.onto)];
    for (int side = 0; side < 3; ++side) {
        const auto at = static_cast<std::size_t>(side);
        m_isFoot[static_cast<std::size_t>(lying.corners[at])] = true;
        const Hold hold = holdOf(push.onto, side, up);
        m_next.push({lying.across[at], up, hold.tilt > push.held.tilt ? hold : push.held});
    }
    return true;
}

} // namespace

Toppling topplingOf(const std::vector<Vec3> &points, const Vec3 &centreOfMass, const Ground &ground)
{
    return Topple(points, centreOfMass, ground).toppling();
}

} // namespace fff
