// How far points are from a polyline, for tests that ask it a million times, also without
// optimisation: boxes round runs of edges tell most of them apart.
#pragma once

#include "core/geometry/vector.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fff::test {

class PolylineDistance
{
public:
    explicit PolylineDistance(const std::vector<Vec2> &line)
    {
        for (const Vec2 &p : line) {
            m_x.push_back(p.x());
            m_y.push_back(p.y());
        }
        const std::size_t edges = line.size() > 1 ? line.size() - 1 : 1;
        for (std::size_t first = 0; first < edges; first += kRun) {
            Run run{first,     std::min(first + kRun, edges), m_x[first], m_x[first], m_y[first],
                    m_y[first]};
            for (std::size_t i = first; i <= run.end && i < m_x.size(); ++i) {
                run.x0 = std::min(run.x0, m_x[i]);
                run.x1 = std::max(run.x1, m_x[i]);
                run.y0 = std::min(run.y0, m_y[i]);
                run.y1 = std::max(run.y1, m_y[i]);
            }
            m_runs.push_back(run);
        }
    }

    double operator()(const Vec2 &point) const
    {
        const double px = point.x(), py = point.y();
        double best = squared(px, py, m_last);
        for (const Run &run : m_runs) {
            const double bx = std::max({run.x0 - px, 0.0, px - run.x1});
            const double by = std::max({run.y0 - py, 0.0, py - run.y1});
            if (bx * bx + by * by >= best)
                continue;
            for (std::size_t i = run.first; i < run.end; ++i) {
                const double here = squared(px, py, i);
                if (here < best) {
                    best = here;
                    m_last = i;
                }
            }
        }
        return std::sqrt(best);
    }

private:
    static constexpr std::size_t kRun = 24;
    struct Run
    {
        std::size_t first, end;
        double x0, x1, y0, y1;
    };

    double squared(double px, double py, std::size_t i) const
    {
        const std::size_t j = std::min(i + 1, m_x.size() - 1);
        const double wx = m_x[j] - m_x[i], wy = m_y[j] - m_y[i];
        const double x = px - m_x[i], y = py - m_y[i], length = wx * wx + wy * wy;
        const double u = length > 0.0 ? std::clamp((wx * x + wy * y) / length, 0.0, 1.0) : 0.0;
        return (u * wx - x) * (u * wx - x) + (u * wy - y) * (u * wy - y);
    }

    std::vector<double> m_x, m_y;
    std::vector<Run> m_runs;
    mutable std::size_t m_last = 0; // the edge that was nearest: mostly the next one is near it
};

} // namespace fff::test
