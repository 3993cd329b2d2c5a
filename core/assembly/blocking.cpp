#include "core/assembly/blocking.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace fff {

namespace {

/// Directions that differ by less are one (no unit): over a metre, by less than a part may be in
/// another one.
constexpr double kSameWay = 1e-6;

constexpr double kEndless = std::numeric_limits<double>::infinity();
/// What is out of its slits is moved on by so much before it turns, where there is room. mm
constexpr double kRoom = 1.0;

bool has(const Group &group, int part)
{
    return std::binary_search(group.begin(), group.end(), part);
}

} // namespace

Group without(const Group &group, const Group &parts)
{
    Group rest;
    std::set_difference(group.begin(), group.end(), parts.begin(), parts.end(),
                        std::back_inserter(rest));
    return rest;
}

Blocking::Blocking(Collisions &collisions, const std::vector<Slide> &slides,
                   const PlanOptions &options)
    : m_collisions(collisions), m_slides(slides), m_options(options), m_mates(collisions.size())
{
    for (const Vec3 &free : {Vec3(Vec3::UnitY()), Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitX()),
                             Vec3(Vec3::UnitZ()), Vec3(-Vec3::UnitZ()), Vec3(-Vec3::UnitY())})
        m_ways.push_back({free, m_collisions.way(free), {}, {}, {}});
    m_freeWays = static_cast<int>(m_ways.size());
    for (const Slide &slide : slides) {
        const int there = indexOf(slide.direction), back = indexOf(-slide.direction);
        Mate ofA{slide.b, slide.length, {back}}, ofB{slide.a, slide.length, {there}};
        if (slide.goesBothWays) {
            ofA.directions.push_back(there);
            ofB.directions.push_back(back);
        }
        m_mates[static_cast<std::size_t>(slide.a)].push_back(std::move(ofA));
        m_mates[static_cast<std::size_t>(slide.b)].push_back(std::move(ofB));
    }
}

int Blocking::indexOf(const Vec3 &direction)
{
    const auto same = std::find_if(m_ways.begin(), m_ways.end(), [&](const Way &way) {
        return (way.along - direction).norm() < kSameWay;
    });
    if (same != m_ways.end())
        return static_cast<int>(same - m_ways.begin());
    m_ways.push_back({direction, m_collisions.way(direction), {}, {}, {}});
    return static_cast<int>(m_ways.size()) - 1;
}

Blocking::Way &Blocking::opened(int direction)
{
    Way &way = m_ways[static_cast<std::size_t>(direction)];
    if (!way.shadows.empty())
        return way;
    const Vec3 u = way.along.unitOrthogonal(), v = way.along.cross(u);
    for (std::size_t i = 0; i < partCount(); ++i) {
        const Solid &solid = m_collisions.solid(static_cast<int>(i));
        const Extent across = solid.along(u), up = solid.along(v), on = solid.along(way.along);
        way.shadows.push_back({across.min, across.max, up.min, up.max, on.min, on.max});
    }
    way.held.resize(partCount());
    way.obstacles.resize(partCount());
    for (const Slide &slide : m_slides) {
        const bool isHeld = slide.play < 0.5 * std::numbers::pi &&
                            way.along.cross(slide.direction).norm() > std::sin(slide.play);
        if (!isHeld || isIgnored(slide.a, slide.b))
            continue;
        way.held[static_cast<std::size_t>(slide.a)].push_back(slide.b);
        way.held[static_cast<std::size_t>(slide.b)].push_back(slide.a);
    }
    return way;
}

std::vector<int> Blocking::waysOff(int part, const Group &others) const
{
    std::vector<int> ways;
    bool isHeld = false;
    for (const Mate &mate : m_mates[static_cast<std::size_t>(part)]) {
        if (!has(others, mate.part))
            continue;
        if (!std::exchange(isHeld, true)) {
            ways = mate.directions;
            continue;
        }
        std::erase_if(ways, [&](int way) {
            return std::find(mate.directions.begin(), mate.directions.end(), way) ==
                   mate.directions.end();
        });
        if (ways.empty())
            return ways;
    }
    for (int i = 0; !isHeld && i < m_freeWays; ++i)
        ways.push_back(i);
    return ways;
}

std::optional<Blocking::Removal> Blocking::partOff(int part, const Group &others, Path path)
{
    for (const int direction : waysOff(part, others)) {
        if (path == Path::Bent) {
            if (std::optional<Removal> found = bent(part, others, direction))
                return found;
            continue;
        }
        Way &way = opened(direction);
        std::vector<Obstacle> &obstacles = obstaclesOf(part, way);
        if (std::none_of(obstacles.begin(), obstacles.end(), [&](Obstacle &obstacle) {
                return has(others, obstacle.part) && isInTheWay(obstacle, part, way);
            }))
            return Removal{{part}, {{way.along, 0.0}}};
    }
    return {};
}

/// In which directions groups of these parts could come off the rest.
std::vector<int> Blocking::waysApart(const Group &parts) const
{
    std::vector<char> isUsed(m_ways.size(), char(false));
    std::fill_n(isUsed.begin(), m_freeWays, char(true));
    for (const int part : parts) {
        for (const Mate &mate : m_mates[static_cast<std::size_t>(part)]) {
            if (!has(parts, mate.part))
                continue;
            for (const int direction : mate.directions)
                isUsed[static_cast<std::size_t>(direction)] = true;
        }
    }
    std::vector<int> ways;
    for (std::size_t i = 0; i < isUsed.size(); ++i) {
        if (isUsed[i])
            ways.push_back(static_cast<int>(i));
    }
    return ways;
}

bool Blocking::isIgnored(int a, int b) const
{
    return std::binary_search(m_options.ignored.begin(), m_options.ignored.end(),
                              std::pair(std::min(a, b), std::max(a, b)));
}

std::vector<Blocking::Obstacle> &Blocking::obstaclesOf(int part, Way &way)
{
    std::optional<std::vector<Obstacle>> &known = way.obstacles[static_cast<std::size_t>(part)];
    if (known)
        return *known;
    known.emplace();
    const Shadow &own = way.shadows[static_cast<std::size_t>(part)];
    for (int other = 0; other < static_cast<int>(partCount()); ++other) {
        if (other != part &&
            own.meetsOnItsWay(way.shadows[static_cast<std::size_t>(other)],
                              m_collisions.depth(part, other)) &&
            !isIgnored(part, other))
            known->push_back({other, {}});
    }
    return *known;
}

bool Blocking::isInTheWay(Obstacle &obstacle, int part, const Way &way)
{
    if (!obstacle.isInTheWay) {
        if (isOutOfTime())
            return true;
        obstacle.isInTheWay = !m_collisions.comesFree(part, obstacle.part, way.number);
    }
    return *obstacle.isInTheWay;
}

bool Blocking::isOutOfTime()
{
    m_isOutOfTime = m_isOutOfTime || (m_options.isOutOfTime && m_options.isOutOfTime());
    return m_isOutOfTime;
}

std::pair<std::vector<int>, int> Blocking::heaps(const Group &parts, int direction)
{
    const Way &way = opened(direction);
    constexpr int kAway = -2, kNone = -1;
    std::vector<int> heapOf(partCount(), kAway);
    for (const int part : parts)
        heapOf[static_cast<std::size_t>(part)] = kNone;
    int count = 0;
    std::vector<int> open;
    for (const int part : parts) {
        if (heapOf[static_cast<std::size_t>(part)] != kNone)
            continue;
        open.assign(1, part);
        heapOf[static_cast<std::size_t>(part)] = count;
        while (!open.empty()) {
            const int next = open.back();
            open.pop_back();
            for (const int mate : way.held[static_cast<std::size_t>(next)]) {
                int &heap = heapOf[static_cast<std::size_t>(mate)];
                if (heap == kNone) {
                    heap = count;
                    open.push_back(mate);
                }
            }
        }
        ++count;
    }
    std::vector<int> found;
    found.reserve(parts.size());
    for (const int part : parts)
        found.push_back(heapOf[static_cast<std::size_t>(part)]);
    return {std::move(found), count};
}

std::optional<Group> Blocking::movedWith(int part, const Group &parts, int direction,
                                         std::size_t fewerThan)
{
    Way &way = opened(direction);
    std::vector<char> isResting(partCount(), char(false));
    for (const int other : parts)
        isResting[static_cast<std::size_t>(other)] = true;
    Group moved;
    const auto move = [&](int next) {
        isResting[static_cast<std::size_t>(next)] = false;
        moved.push_back(next);
    };
    move(part);
    std::size_t held = 0; // so many of the moved ones have taken along what they hold
    for (std::size_t next = 0; next < moved.size() && moved.size() < fewerThan; ++next) {
        for (; held < moved.size(); ++held) // costs nothing: before any look
            for (const int mate : way.held[static_cast<std::size_t>(moved[held])])
                if (isResting[static_cast<std::size_t>(mate)])
                    move(mate);
        const int mover = moved[next];
        for (Obstacle &obstacle : obstaclesOf(mover, way)) {
            if (moved.size() >= fewerThan)
                break;
            if (isResting[static_cast<std::size_t>(obstacle.part)] &&
                isInTheWay(obstacle, mover, way))
                move(obstacle.part);
        }
    }
    if (moved.size() >= fewerThan)
        return {};
    std::sort(moved.begin(), moved.end());
    return moved;
}

std::optional<Blocking::Removal> Blocking::smallestOff(const Group &parts)
{
    std::optional<Group> smallest;
    int along = 0;
    for (const int direction : waysApart(parts)) {
        const auto [heapOf, count] = heaps(parts, direction);
        if (count < 2)
            continue;
        std::vector<char> isTried(static_cast<std::size_t>(count), char(false));
        for (std::size_t i = parts.size(); i-- > 0;) {
            if (std::exchange(isTried[static_cast<std::size_t>(heapOf[i])], char(true)))
                continue;
            std::optional<Group> moved =
                movedWith(parts[i], parts, direction, smallest ? smallest->size() : parts.size());
            if (moved) {
                smallest = std::move(moved);
                along = direction;
            }
        }
    }
    if (!smallest)
        return {};
    return Removal{*std::move(smallest), {{m_ways[static_cast<std::size_t>(along)].along, 0.0}}};
}

std::vector<Move> Blocking::measured(const Removal &removal, const Group &rest)
{
    std::vector<Move> moves = removal.moves;
    Move &last = moves.back();
    Vec3 by = Vec3::Zero();
    for (std::size_t i = 0; i + 1 < moves.size(); ++i)
        by += moves[i].distance * moves[i].direction;
    const int way = m_collisions.way(last.direction);
    const int lift = moves.size() > 1 ? m_collisions.lift(by) : Collisions::kNotLifted;
    last.distance = 0.0;
    for (const int part : removal.parts) {
        const double first = m_collisions.solid(part).along(last.direction).min +
                             by.dot(last.direction) - Collisions::kNearParts;
        for (const int other : rest) {
            // It does not take longer than others.
            if (m_collisions.solid(other).along(last.direction).max > first + last.distance)
                last.distance =
                    std::max(last.distance, m_collisions.wayToClear(part, other, way, lift));
        }
    }
    return moves;
}

std::vector<Vec3> Blocking::turnsOf(int part) const
{
    const Vec3 &across = m_collisions.solid(part).normal;
    std::vector<Vec3> turns{across, -across};
    for (int i = 0; i < m_freeWays; ++i)
        turns.push_back(m_ways[static_cast<std::size_t>(i)].along);
    return turns;
}

std::optional<Blocking::Removal> Blocking::bent(int part, const Group &others, int direction)
{
    double held = 0.0, until = kEndless;
    for (const Mate &mate : m_mates[static_cast<std::size_t>(part)])
        if (has(others, mate.part))
            held = std::max(held, mate.length);
    if (held == 0.0 || std::isinf(held))
        return {}; // nothing to come out of
    Way &way = opened(direction);
    for (Obstacle &obstacle : obstaclesOf(part, way)) {
        if (!has(others, obstacle.part) || !isInTheWay(obstacle, part, way))
            continue;
        if (isOutOfTime())
            return {};
        until = std::min(until, m_collisions.wayUntil(part, obstacle.part, way.number));
        if (until < kRoom)
            return {};
    }
    // A little out of the slits, as far as it goes, or half of that: some come free of a slit long
    // before its end.
    std::vector<double> places{until - kRoom, 0.5 * until};
    if (held + kRoom < until)
        places.insert(places.begin(), held + kRoom);
    for (const double place : places) {
        const Move first{way.along, place};
        const int lift = m_collisions.lift(place * way.along);
        for (const Vec3 &turn : turnsOf(part)) {
            const int next = m_collisions.way(turn);
            if (std::all_of(others.begin(), others.end(), [&](int other) {
                    return other == part || isIgnored(part, other) ||
                           m_collisions.comesFree(part, other, next, lift);
                }))
                return Removal{{part}, {first, {turn, 0.0}}};
        }
    }
    return {};
}

} // namespace fff
