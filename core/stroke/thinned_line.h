// What of a hand's samples says something new.
#pragma once

#include "core/geometry/vector.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fff {

/// The line of a stroke with fewer samples, which is nowhere further than `error` (mm) from any of
/// those that were given.
///
/// A sample adds nothing where it is that near to
///   - the line's end, or what the hand has just drawn: the line stays as it is;
///   - the straight way on from the sample before the end, by no more than kLongestStep errors: the
///     end moves on to it.
/// So a line of samples further apart than a few errors is kept as it is, a hand that rests or
/// trembles on one spot adds no more than the spot has room for, and a mouse that tells of its
/// place a thousand times a second is no different from a slow one. Depends on nothing but the
/// samples. O(1) each.
class ThinnedLine
{
public:
    explicit ThinnedLine(double error) : m_error(error) {}

    /// True when the line changed.
    bool add(const Vec2 &p);
    /// Leaves nothing of it.
    void clear();

    /// No two equal in a row. All but the last stay where they are.
    const std::vector<Vec2> &points() const { return m_points; }
    /// Counts the changes.
    std::uint64_t revision() const { return m_revision; }

    static constexpr double kLongestStep = 4.0;

private:
    bool isBesideLine(const Vec2 &p) const;
    bool canMoveEnd(const Vec2 &to) const;
    bool keep(const Vec2 &p);

    double m_error; // mm
    std::vector<Vec2> m_points;
    std::vector<Vec2> m_leftOut; // that the line's last edge stands for; empty once it is fixed
    std::uint64_t m_revision = 0;
};

} // namespace fff
