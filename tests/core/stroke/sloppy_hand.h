// Outlines with a known truth, and hands that draw them hastily: they go too far, stop short, hook
// back, tremble, or leave no more than a few samples. In pixels, tolerance 2; the same at every
// run.
#pragma once

#include "core/geometry/contour.h"
#include "tests/core/geometry/polyline_distance.h"
#include "tests/core/geometry/samples.h"
#include "tests/core/geometry/turns.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace fff::test {

/// What is meant: a closed line, close together, its first point not repeated.
struct Outline
{
    std::string name;
    Samples line;
    Samples corners;

    double length() const { return along().back(); }
    /// So far along it, mm; any number of times round.
    Vec2 at(double place) const
    {
        const double whole = length();
        place = std::fmod(std::fmod(place, whole) + whole, whole);
        const auto after = std::upper_bound(along().begin(), along().end() - 1, place);
        const auto i = static_cast<std::size_t>(after - along().begin()) - 1;
        const double edge = along()[i + 1] - along()[i];
        const Vec2 &from = line[i], &to = line[(i + 1) % line.size()];
        return from + (edge > 0.0 ? (place - m_along[i]) / edge : 0.0) * (to - from);
    }
    /// The same from another place on.
    Outline from(double along) const
    {
        Outline result{name, {}, corners, {}};
        const int count = static_cast<int>(length() / 0.5);
        for (int i = 0; i < count; ++i)
            result.line.push_back(at(along + i * 0.5));
        return result;
    }

    mutable std::vector<double> m_along; // of each point, and once round

private:
    const std::vector<double> &along() const
    {
        if (m_along.empty()) {
            m_along = {0.0};
            for (std::size_t i = 0; i < line.size(); ++i)
                m_along.push_back(m_along.back() + (line[(i + 1) % line.size()] - line[i]).norm());
        }
        return m_along;
    }
};

inline Outline roundOutline(double rx, double ry)
{
    Samples line = curve(
        [=](double t) {
            const double a = 2.0 * std::numbers::pi * t;
            return Vec2(rx * std::cos(a), ry * std::sin(a));
        },
        720);
    line.pop_back();
    return {"round", line, {}, {}};
}

/// With three bays.
inline Outline concaveOutline(double size)
{
    Samples line = curve(
        [=](double t) {
            const double a = 2.0 * std::numbers::pi * t;
            const double r = size * (1.0 + 0.35 * std::cos(3.0 * a));
            return Vec2(r * std::cos(a), r * std::sin(a));
        },
        1440);
    line.pop_back();
    return {"concave", line, {}, {}};
}

inline Outline polygonOutline(const std::string &name, const Samples &corners)
{
    Samples closed = corners;
    closed.push_back(corners.front());
    Samples line = lines(closed, 1.0);
    line.pop_back();
    return {name, line, corners, {}};
}

inline Outline spikyOutline(double outer, double inner, int tips)
{
    Samples corners;
    for (int i = 0; i < 2 * tips; ++i) {
        const double a = std::numbers::pi * i / tips;
        corners.push_back((i % 2 ? inner : outer) * Vec2(std::cos(a), std::sin(a)));
    }
    return polygonOutline("spiky", corners);
}

/// A hand that samples about every `step` px and trembles by `shake`.
class SloppyHand
{
public:
    explicit SloppyHand(double step = 4.0, double shake = 0.3, unsigned seed = 7)
        : m_step(step), m_shake(shake), m_random(seed)
    {
    }

    /// From one place to another along the outline; both may be beyond once round.
    void along(const Outline &outline, double from, double to)
    {
        const int count = std::max(1, static_cast<int>(std::abs(to - from) / m_step));
        for (int i = m_samples.empty() ? 0 : 1; i <= count; ++i)
            add(outline.at(from + (to - from) * i / count));
    }
    void to(const Vec2 &p)
    {
        const Vec2 from = m_end;
        const int count = std::max(1, static_cast<int>((p - from).norm() / m_step));
        for (int i = 1; i <= count; ++i)
            add(from + (p - from) * (double(i) / count));
    }
    void by(double length, double angle) { to(m_end + length * way(angle)); }
    void start(const Vec2 &p) { add(p); }
    static Vec2 way(double angle) { return {std::cos(angle), std::sin(angle)}; }

    const Samples &samples() const { return m_samples; }

    double any(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(m_random() >> 5) / 134217728.0);
    }
    double normal()
    {
        double sum = 0.0;
        for (int i = 0; i < 12; ++i)
            sum += any(0.0, 1.0);
        return sum - 6.0;
    }

private:
    void add(const Vec2 &p)
    {
        m_end = p;
        const double x = normal(), y = normal();
        m_samples.push_back(p + m_shake * Vec2(x, y));
    }

    double m_step, m_shake;
    std::mt19937 m_random;
    Samples m_samples;
    Vec2 m_end = Vec2::Zero();
};

/// How far a contour is from what was meant.
struct Misfit
{
    double distance = 0.0;    // the furthest that one of them is from the other
    int falseCorners = 0;     // that turn by more than 20° where nothing of the truth does
    int lostCorners = 0;      // of the truth, with no corner near
    double sharpestFalse = 0; // degrees
    int segments = 0;
};

inline Misfit misfit(const Contour &contour, const Outline &truth, double nearby = 14.0)
{
    Misfit result;
    Samples line = contour.polygon(0.05), meant = truth.line;
    Samples closed = line, closedMeant = meant;
    closed.push_back(closed.front());
    closedMeant.push_back(closedMeant.front());
    const PolylineDistance toContour(closed), toTruth(closedMeant);
    for (const Vec2 &p : meant)
        result.distance = std::max(result.distance, toContour(p));
    for (const Vec2 &p : line)
        result.distance = std::max(result.distance, toTruth(p));
    result.segments = contour.segmentCount();
    const std::vector<double> turns = turnsOf(contour);
    std::vector<bool> isFound(truth.corners.size(), false);
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const double turn = turns[static_cast<std::size_t>(i)] * 180.0 / std::numbers::pi;
        if (turn < 20.0)
            continue;
        bool isTrue = false;
        for (std::size_t k = 0; k < truth.corners.size(); ++k) {
            if ((truth.corners[k] - contour.segment(i).p0).norm() <= nearby)
                isTrue = isFound[k] = true;
        }
        result.falseCorners += isTrue ? 0 : 1;
        if (!isTrue)
            result.sharpestFalse = std::max(result.sharpestFalse, turn);
    }
    result.lostCorners = static_cast<int>(std::count(isFound.begin(), isFound.end(), false));
    return result;
}

} // namespace fff::test
