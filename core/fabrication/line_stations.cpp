#include "core/fabrication/line_stations.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

constexpr int kChordsOfCurve = 32;
/// Where a line turns by more than this, in radians, is a corner.
constexpr double kCornerTurn = 0.2;
/// In which handles lie on their ends: mm.
constexpr double kNoWay = kClipGrid;

Vec2 wayAt(const CubicBezier &curve, double t)
{
    const Vec2 tangent = curve.derivative(t);
    if (tangent.norm() > kNoWay)
        return tangent.normalized();
    const Vec2 chord = curve.p3 - curve.p0;
    const Vec2 towards = t < 0.5 ? curve.p2 - curve.p0 : curve.p3 - curve.p1;
    return (towards.norm() > kNoWay ? towards : chord).normalized();
}

} // namespace

LineStations::LineStations(const ToolLine &line) : m_line(line)
{
    double station = 0.0;
    for (std::size_t i = 0; i < line.curves.size(); ++i) {
        const CubicBezier &curve = line.curves[i];
        m_starts.push_back(station);
        m_knots.push_back({station, i, 0.0});
        const int count = curve.isStraight(2.0 * kClipGrid) ? 1 : kChordsOfCurve;
        Vec2 before = curve.p0;
        for (int k = 1; k <= count; ++k) {
            const double t = static_cast<double>(k) / count;
            const Vec2 next = k == count ? curve.p3 : curve.at(t);
            station += (next - before).norm();
            if (k < count)
                m_knots.push_back({station, i, t});
            before = next;
        }
    }
    m_starts.push_back(station);
    m_knots.push_back({station, line.curves.size() - 1, 1.0});
}

LineStations::Knot LineStations::knotAt(double station) const
{
    const double all = length();
    if (station < 0.0 || station > all)
        station -= all * std::floor(station / all);
    const auto next =
        std::upper_bound(m_knots.begin(), m_knots.end(), station,
                         [](double value, const Knot &knot) { return value < knot.station; });
    if (next == m_knots.end())
        return m_knots.back();
    const Knot &before = *std::prev(next);
    const double end = next->curve == before.curve ? next->t : 1.0;
    const double span = next->station - before.station;
    const double share = span > 0.0 ? (station - before.station) / span : 0.0;
    return {station, before.curve, before.t + share * (end - before.t)};
}

Vec2 LineStations::at(double station) const
{
    const Knot knot = knotAt(station);
    return m_line.curves[knot.curve].at(knot.t);
}

Vec2 LineStations::along(double station) const
{
    const Knot knot = knotAt(station);
    return wayAt(m_line.curves[knot.curve], knot.t);
}

std::vector<double> LineStations::corners() const
{
    std::vector<double> corners;
    const std::size_t count = m_line.curves.size();
    for (std::size_t i = m_line.isClosed ? 0 : 1; i < count; ++i) {
        const Vec2 in = wayAt(m_line.curves[(i + count - 1) % count], 1.0),
                   out = wayAt(m_line.curves[i], 0.0);
        if (std::abs(std::atan2(cross(in, out), in.dot(out))) > kCornerTurn)
            corners.push_back(m_starts[i]);
    }
    return corners;
}

std::vector<CubicBezier> LineStations::between(double from, double to) const
{
    std::vector<CubicBezier> curves;
    const double all = length();
    const double round = all * std::floor(from / all);
    from -= round;
    to -= round;
    Knot at = knotAt(from);
    double turns = 0.0; // stations of rounds that are done
    while (turns + m_starts[at.curve] < to) {
        const double end = turns + m_starts[at.curve + 1];
        const double until = end <= to ? 1.0 : knotAt(to - turns).t;
        const CubicBezier &curve = m_line.curves[at.curve];
        if (until > at.t) {
            const bool isWhole = at.t == 0.0 && until == 1.0;
            curves.push_back(isWhole ? curve : curve.piece(at.t, until));
            if (curves.size() > 1)
                curves.back().p0 = curves[curves.size() - 2].p3;
        }
        at = {end, at.curve + 1, 0.0};
        if (at.curve == m_line.curves.size()) {
            at.curve = 0;
            turns += all;
        }
    }
    std::erase_if(curves, [](const CubicBezier &curve) {
        return curve.isStraight(2.0 * kClipGrid) &&
               (curve.p3 - curve.p0).cwiseAbs().maxCoeff() <= kClipGrid;
    });
    for (std::size_t i = 1; i < curves.size(); ++i)
        curves[i].p0 = curves[i - 1].p3;
    return curves;
}

} // namespace fff
