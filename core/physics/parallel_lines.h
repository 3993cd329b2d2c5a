// Where lines of one direction cross the boundary of a piece, all of them at once.
#pragma once

#include "core/physics/section_outline.h"

#include <span>
#include <vector>

namespace fff {

/// For those who cut a piece in many directions: its room is used again. The outline outlives it.
class ParallelLines
{
public:
    explicit ParallelLines(const SectionOutline &outline) : m_outline(outline) {}

    /// Lines along the unit vector, `spacing` mm apart over all of the outer ring, of which the
    /// first lies `shift` mm within it.
    void find(const Vec2 &direction, double shift, double spacing);

    std::size_t size() const { return m_lines.size(); }
    const CutLine &line(std::size_t i) const { return m_lines[i]; }
    /// In their order along the line; as SectionOutline::crossings, vertices on it count as to its
    /// left.
    std::span<const OutlineCrossing> crossings(std::size_t i);

private:
    void placeLines(const Vec2 &direction, double shift, double spacing);
    void crossRing(int ring, double spacing);
    int rowOf(double position, double slack);

    /// An edge that crosses a line.
    struct Event
    {
        std::size_t line = 0;
        int ring = 0, edge = 0;
        bool isToLeft = false;
    };

    const SectionOutline &m_outline;
    std::vector<CutLine> m_lines;
    std::vector<char> m_isUnsure; // a vertex may lie on the line
    std::vector<int> m_rows;      // of a ring's vertices: the last line that is not beyond it
    std::vector<Event> m_events;
    std::vector<std::size_t> m_begins; // of each line in m_sorted; one more
    std::vector<Event> m_sorted;
    std::vector<OutlineCrossing> m_row;
    LineCrossings m_exact;
    Vec2 m_step = Vec2::UnitY();
    double m_first = 0.0;
};

} // namespace fff
