// Where something comes to rest, by another way than settling.h: its energy goes down by small
// steps of the ground's slope until no step lowers it, and is then lifted over the lowest barrier.
#pragma once

#include "core/geometry/vector.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
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

} // namespace fff::test
