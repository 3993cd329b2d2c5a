// Places along a line by how far along it they are. Internal to fabrication.
#pragma once

#include "core/fabrication/cutting_order.h"

#include <vector>

namespace fff {

/// A station is the way from the line's start, mm; on a closed line any number, which goes round as
/// often as it takes. The line outlives this.
///
/// Exact on straight curves; on others by chords, each of which turns by so little that lengths are
/// off by less than one in ten thousand.
class LineStations
{
public:
    explicit LineStations(const ToolLine &line);

    double length() const { return m_knots.back().station; }
    /// Where a curve starts, and the line's end behind the last one.
    double startOf(std::size_t curve) const { return m_starts[curve]; }
    Vec2 at(double station) const;
    /// Unit, the way the line runs.
    Vec2 along(double station) const;
    /// Stations of corners, ascending, within the first round.
    std::vector<double> corners() const;
    /// from < to; the curves of the line between, with the line's own points where these are ends
    /// of curves.
    std::vector<CubicBezier> between(double from, double to) const;

private:
    struct Knot
    {
        double station = 0.0;
        std::size_t curve = 0;
        double t = 0.0; // of the curve
    };
    Knot knotAt(double station) const;

    const ToolLine &m_line;
    std::vector<Knot> m_knots; // ascending; the last is the end of the last curve
    std::vector<double> m_starts;
};

} // namespace fff
