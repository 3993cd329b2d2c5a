// Numbers as single strokes, for a laser that follows lines.
#pragma once

#include "core/geometry/vector.h"

#include <span>
#include <vector>

namespace fff {

/// Open chains of straight edges, all in one list: an engraved model has thousands.
class Strokes
{
public:
    std::size_t size() const { return m_firsts.size(); }
    bool isEmpty() const { return m_firsts.empty(); }
    std::size_t pointCount() const { return m_points.size(); }
    std::span<const Vec2> operator[](std::size_t index) const
    {
        const std::size_t end = index + 1 < size() ? m_firsts[index + 1] : m_points.size();
        return {m_points.data() + m_firsts[index], m_points.data() + end};
    }

    /// The points that follow are a chain of their own.
    void start() { m_firsts.push_back(m_points.size()); }
    void add(const Vec2 &point) { m_points.push_back(point); }

private:
    std::vector<Vec2> m_points;
    std::vector<std::size_t> m_firsts; // of each chain
};

/// Width and height of the number (0 or more) with digits of height 1. Parts get turned over: a
/// number that reads as another one upside down is underlined, and the size includes that line.
Vec2 strokedSize(int number);

/// Appends the strokes of the number, `scale` times as large. They lie in the box of that size.
/// corner   the box's lower left
void appendNumber(int number, const Vec2 &corner, double scale, Strokes &strokes);

/// The same for the number of a joint, which begins with a short bar: one stroke more for the
/// laser, and like no digit. So it is never taken for a part's number, nor for one more digit of
/// it.
Vec2 strokedJointSize(int number);
void appendJointNumber(int number, const Vec2 &corner, double scale, Strokes &strokes);

} // namespace fff
