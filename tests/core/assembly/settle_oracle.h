// Where something comes to rest, by another way than settling.h: its energy goes down by small
// steps of the ground's slope until no step lowers it, and is then lifted over the lowest barrier.
#pragma once

#include "core/geometry/vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace fff::test {

class SettleOracle
{
public:
    SettleOracle(std::vector<Vec3> points, const Vec3 &centre)
        : m_points(std::move(points)), m_centre(centre)
    {
        const double far = std::tan(1.0); // it lies on its side
        for (double step = 0.01; step > 1e-6 && std::hypot(m_x, m_z) < far;)
            if (!goDown(step))
                step *= 0.5;
    }

    double lean() const { return std::atan(std::hypot(m_x, m_z)); } // radians
    /// Tilted by less it comes back, in steps of a quarter of a degree; radians.
    double tipAngle() const
    {
        double least = std::numbers::pi / 2;
        constexpr int kWays = 96;
        const double step = std::numbers::pi / 720;
        for (int way = 0; way < kWays; ++way) {
            const double angle = 2.0 * std::numbers::pi * way / kWays;
            double height = heightAt(m_x, m_z), tilt = 0.0;
            for (int k = 1; k < 300; ++k, tilt += step) {
                const double slope = std::tan(k * step);
                const double next =
                    heightAt(m_x + slope * std::cos(angle), m_z + slope * std::sin(angle));
                if (next < height)
                    break;
                height = next;
            }
            least = std::min(least, tilt);
        }
        return least;
    }

    double height() const { return heightAt(m_x, m_z); }
    /// Of the centre of mass above the lowest point, the ground's slopes being these.
    double heightAt(double x, double z) const
    {
        const Vec3 up = Vec3(x, 1.0, z).normalized();
        double lowest = std::numeric_limits<double>::infinity();
        for (const Vec3 &p : m_points)
            lowest = std::min(lowest, up.dot(p));
        return up.dot(m_centre) - lowest;
    }

private:
    bool goDown(double step)
    {
        constexpr int kWays = 180; // along a ridge few of them go down
        const double here = heightAt(m_x, m_z);
        double least = here - 1e-12 - 1e-7 * step, x = m_x, z = m_z;
        for (int way = 0; way < kWays; ++way) {
            const double angle = 2.0 * std::numbers::pi * way / kWays;
            const double toX = m_x + step * std::cos(angle), toZ = m_z + step * std::sin(angle);
            if (const double height = heightAt(toX, toZ); height < least) {
                least = height;
                x = toX;
                z = toZ;
            }
        }
        const bool goes = x != m_x || z != m_z;
        m_x = x;
        m_z = z;
        return goes;
    }

    std::vector<Vec3> m_points;
    Vec3 m_centre;
    double m_x = 0.0, m_z = 0.0; // slopes of the ground
};

/// How it tips, by the lower faces of its hull: planes through three points with none below. It
/// falls from the face over which its centre of mass is by the way over edges to a face that is too
/// steep of which the worst edge takes least tilting.
class HullOracle
{
public:
    HullOracle(const std::vector<Vec3> &points, const Vec3 &centre, double farthest)
        : m_points(points), m_centre(centre), m_farthest(farthest)
    {
        const int n = static_cast<int>(points.size());
        for (int i = 0; i < n; ++i)
            for (int j = i + 1; j < n; ++j)
                for (int k = j + 1; k < n; ++k)
                    addFace({i, j, k});
    }

    /// Radians, of what rests on the face that this is up for; none where faces are too alike to
    /// tell them from touching ones.
    std::optional<double> tipAngle(const Vec3 &up) const
    {
        int start = -1;
        double nearest = 0.01;
        for (std::size_t f = 0; f < m_faces.size(); ++f) {
            if (m_faces[f].isClose)
                return std::nullopt;
            if (const double off = (m_faces[f].up - up).norm(); off < nearest) {
                start = static_cast<int>(f);
                nearest = off;
            }
        }
        if (start < 0)
            return std::nullopt;
        // Widest way, by trying tilts: few faces, so all are relaxed until nothing changes.
        constexpr double kNever = std::numeric_limits<double>::infinity();
        std::vector<double> reached(m_faces.size(), kNever);
        reached[static_cast<std::size_t>(start)] = -kNever;
        double falls = kNever;
        for (bool changes = true; changes;) {
            changes = false;
            for (std::size_t f = 0; f < m_faces.size(); ++f) {
                if (reached[f] == kNever)
                    continue;
                for (int e = 0; e < 3; ++e) {
                    const double worst = std::max(reached[f], tilt(m_faces[f], e));
                    const int beyond = neighbour(f, e);
                    const bool fell =
                        beyond < 0 || angle(m_faces[static_cast<std::size_t>(beyond)],
                                            m_faces[static_cast<std::size_t>(start)]) > m_farthest;
                    double &known = fell ? falls : reached[static_cast<std::size_t>(beyond)];
                    if (worst < known) {
                        known = worst;
                        changes = true;
                    }
                }
            }
        }
        return falls;
    }

private:
    struct Face
    {
        std::array<int, 3> corners;
        Vec3 up;              // unit, out of the ground that it lies on
        bool isClose = false; // a fourth point nearly touches
    };

    void addFace(std::array<int, 3> corners)
    {
        const Vec3 &a = at(corners[0]);
        Vec3 up = (at(corners[1]) - a).cross(at(corners[2]) - a);
        if (up.norm() < 1e-6)
            return;
        up.normalize();
        if (up.y() < 0.0) {
            up = -up;
            std::swap(corners[1], corners[2]);
        }
        Face face{corners, up};
        for (std::size_t i = 0; i < m_points.size(); ++i) {
            if (std::find(corners.begin(), corners.end(), static_cast<int>(i)) != corners.end())
                continue;
            const double above = up.dot(m_points[i] - a);
            if (above < 0.0)
                return;
            face.isClose = face.isClose || above < 0.2;
        }
        if (lean(face) < 4.0 * m_farthest)
            m_faces.push_back(face);
    }
    const Vec3 &at(int i) const { return m_points[static_cast<std::size_t>(i)]; }
    static double lean(const Face &face) { return std::acos(std::min(1.0, face.up.y())); }
    static double angle(const Face &a, const Face &b)
    {
        return std::acos(std::min(1.0, a.up.dot(b.up)));
    }
    /// Until the centre of mass is over edge e, seen from above counter-clockwise or not.
    double tilt(const Face &face, int e) const
    {
        const Vec3 &a = at(face.corners[static_cast<std::size_t>(e)]);
        const Vec3 &b = at(face.corners[static_cast<std::size_t>((e + 1) % 3)]);
        const Vec3 &c = at(face.corners[static_cast<std::size_t>((e + 2) % 3)]);
        const Vec3 inward = face.up.cross(b - a).normalized();
        const double side = inward.dot(c - a) > 0.0 ? 1.0 : -1.0;
        return std::atan2(side * inward.dot(m_centre - a), face.up.dot(m_centre - a));
    }
    int neighbour(std::size_t f, int e) const
    {
        const auto has = [](const Face &face, int corner) {
            return std::find(face.corners.begin(), face.corners.end(), corner) !=
                   face.corners.end();
        };
        const int a = m_faces[f].corners[static_cast<std::size_t>(e)];
        const int b = m_faces[f].corners[static_cast<std::size_t>((e + 1) % 3)];
        for (std::size_t g = 0; g < m_faces.size(); ++g)
            if (g != f && has(m_faces[g], a) && has(m_faces[g], b))
                return static_cast<int>(g);
        return -1;
    }

    const std::vector<Vec3> &m_points;
    Vec3 m_centre;
    double m_farthest;
    std::vector<Face> m_faces;
};

} // namespace fff::test
