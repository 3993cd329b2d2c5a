// Parts that come off along two lines.
#include "core/assembly/blocking.h"
#include "core/assembly/swept_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff {

namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
/// What is out of its slits is moved on by so much before it turns, where there is room. mm
constexpr double kRoom = 1.0;

} // namespace

std::vector<Vec3> Blocking::turnsOf(int part) const
{
    const Vec3 &across = m_collisions.solid(part).normal;
    std::vector<Vec3> turns{across, -across};
    for (int i = 0; i < m_freeWays; ++i)
        turns.push_back(m_ways[static_cast<std::size_t>(i)].along);
    return turns;
}

std::optional<int> Blocking::stopBeyond(int part, const Vec3 &by, const Vec3 &direction)
{
    const int way = m_collisions.way(direction), lift = m_collisions.lift(by);
    const Box3 &box = m_collisions.solid(part).box;
    const SweptBox swept({box.min + by, box.max + by}, direction, kTouchingDepth);
    std::optional<int> stop;
    m_boxes.any(swept, [&](int other) {
        if (other == part || !has(other) || m_collisions.comesFree(part, other, way, lift))
            return false;
        stop = other;
        return true;
    });
    return stop;
}

std::optional<Blocking::Removal> Blocking::bentOff(int part)
{
    // As long as all of these are there, all that was found out is as it was.
    Group &stops = m_stops[static_cast<std::size_t>(part)];
    if (!stops.empty() && std::all_of(stops.begin(), stops.end(), [&](int i) { return has(i); }))
        return {};
    stops.clear();
    double held = 0.0;
    for (const Mate &mate : m_mates[static_cast<std::size_t>(part)]) {
        if (!has(mate.part))
            continue;
        held = std::max(held, mate.length);
        stops.push_back(mate.part);
    }
    if (held == 0.0 || std::isinf(held))
        return {}; // nothing to come out of
    for (const int direction : waysOff(part))
        if (std::optional<Removal> found = bentOff(part, direction, held, stops))
            return found;
    std::sort(stops.begin(), stops.end());
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    return {};
}

std::optional<Blocking::Removal> Blocking::bentOff(int part, int direction, double held,
                                                   Group &stops)
{
    const Vec3 &along = way(direction).along;
    double until = kEndless;
    int first = kNone;
    for (Obstacle &obstacle : obstaclesOf(part, direction).all) {
        if (!has(obstacle.part) || !isInTheWay(obstacle, part, direction))
            continue;
        if (isOutOfTime())
            return {};
        const double met = m_collisions.wayUntil(part, obstacle.part, way(direction).number);
        if (met < until) {
            until = met;
            first = obstacle.part;
        }
        if (until < kRoom)
            break;
    }
    if (first != kNone)
        stops.push_back(first);
    if (until < kRoom)
        return {};
    // A little out of the slits, as far as it goes, or half of that: some come free of a slit long
    // before its end.
    std::vector<double> places{until - kRoom, 0.5 * until};
    if (held + kRoom < until)
        places.insert(places.begin(), held + kRoom);
    for (const double place : places) {
        const Move move{along, place};
        for (const Vec3 &turn : turnsOf(part)) {
            const std::optional<int> stop = stopBeyond(part, place * along, turn);
            if (!stop)
                return Removal{{part}, {move, {turn, 0.0}}};
            stops.push_back(*stop);
        }
    }
    return {};
}

} // namespace fff
