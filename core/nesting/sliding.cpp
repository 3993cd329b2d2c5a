#include "core/nesting/sliding.h"

#include "core/nesting/collision.h"
#include "core/nesting/grown_outline.h"

#include <algorithm>
#include <cmath>

namespace fff::nest {

namespace {

Axis namedAxis(int axis)
{
    return axis == 0 ? Axis::X : Axis::Y;
}

Vec2 alongAxis(int axis, double way)
{
    return axis == 0 ? Vec2(way, 0.0) : Vec2(0.0, way);
}

} // namespace

Sliding::Sliding(const Region &outline, std::span<const Region> others, double apart)
{
    // The grown outline may be larger by twice its slack.
    pose(grownOutline(outline, apart, kSlidingSlack / 4.0), {}, Vec2::UnitX(), m_outline);
    for (const Region &other : others)
        pose(other, {}, Vec2::UnitX(), m_others.emplace_back());
}

bool Sliding::isFree(const Vec2 &by) const
{
    Steps steps = 0;
    for (const Posed &other : m_others)
        if (collide(m_outline, other, by, steps))
            return false;
    return true;
}

/// Out of one it may come into the next.
std::optional<double> Sliding::wayOut(const Vec2 &by, int axis, bool isForward, double most) const
{
    Steps steps = 0;
    double way = 0.0;
    for (bool isFound = true; isFound;) {
        isFound = false;
        for (const Posed &other : m_others) {
            const Vec2 at = by + alongAxis(axis, isForward ? way : -way);
            // Backwards it is the other one that goes forwards.
            const double more = isForward
                                    ? nest::wayOut(m_outline, other, at, namedAxis(axis), steps)
                                    : nest::wayOut(other, m_outline, -at, namedAxis(axis), steps);
            isFound = isFound || more > 0.0;
            way += more;
            if (!(way <= most))
                return std::nullopt;
        }
    }
    return isForward ? way : -way;
}

std::optional<Vec2> Sliding::wayOut(const Vec2 &by, double most) const
{
    std::optional<Vec2> best;
    for (const int axis : {0, 1})
        for (const bool isForward : {true, false})
            if (const auto way = wayOut(by, axis, isForward, most);
                way && (!best || std::abs(*way) < best->norm()))
                best = alongAxis(axis, *way);
    return best;
}

std::optional<double> Sliding::wayTo(const Vec2 &by, int axis, double most) const
{
    Steps steps = 0;
    double back = most, forth = most;
    for (const Posed &other : m_others) {
        back = std::min(back, wayDown(m_outline, other, by, namedAxis(axis), most, steps));
        forth = std::min(forth, wayDown(other, m_outline, -by, namedAxis(axis), most, steps));
    }
    if (!(std::min(back, forth) < most))
        return std::nullopt;
    return forth < back ? forth : -back;
}

} // namespace fff::nest
