#include "core/assembly/blocking.h"

#include "core/assembly/swept_box.h"

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

/// Directions are looked up by how far they reach along this one, which is square to none that
/// people draw by.
double reach(const Vec3 &direction)
{
    static const Vec3 kOdd = Vec3(0.5377, 0.6123, 0.5796).normalized();
    return kOdd.dot(direction);
}

} // namespace

Blocking::Blocking(Collisions &collisions, const std::vector<Slide> &slides,
                   const PlanOptions &options)
    : m_collisions(collisions), m_options(options), m_mates(collisions.size()),
      m_obstacles(collisions.size()), m_isThere(collisions.size(), char(false)),
      m_holding(collisions.size()), m_waiting(collisions.size()), m_stops(collisions.size()),
      m_placeOf(collisions.size(), kNone)
{
    for (const Vec3 &free : {Vec3(Vec3::UnitY()), Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitX()),
                             Vec3(Vec3::UnitZ()), Vec3(-Vec3::UnitZ()), Vec3(-Vec3::UnitY())})
        indexOf(free);
    m_freeWays = static_cast<int>(m_ways.size());
    for (const Slide &slide : slides) {
        const int there = indexOf(slide.direction), back = indexOf(-slide.direction);
        const bool isHeld =
            slide.play < 0.5 * std::numbers::pi && !areInEachOther(slide.a, slide.b);
        const double sine = std::sin(slide.play);
        const int hold = isHeld ? static_cast<int>(m_holds.size()) : kNone;
        if (isHeld)
            m_holds.push_back({slide.direction, sine * sine});
        const std::array<int, 2> ofA{back, slide.goesBothWays ? there : -1};
        const std::array<int, 2> ofB{there, slide.goesBothWays ? back : -1};
        m_mates[static_cast<std::size_t>(slide.a)].push_back(
            {slide.b, ofA, ofB, hold, slide.length});
        m_mates[static_cast<std::size_t>(slide.b)].push_back(
            {slide.a, ofB, ofA, hold, slide.length});
    }
    m_isLoose.assign(m_holds.size(), char(false));
    std::vector<Box3> boxes;
    for (std::size_t i = 0; i < partCount(); ++i)
        boxes.push_back(m_collisions.solid(static_cast<int>(i)).box);
    m_boxes = BoxTree(boxes);
}

/// The first one that is the same.
int Blocking::indexOf(const Vec3 &direction)
{
    const double at = reach(direction);
    int same = static_cast<int>(m_ways.size());
    const auto end = m_waysAlong.upper_bound(at + kSameWay);
    for (auto known = m_waysAlong.lower_bound(at - kSameWay); known != end; ++known)
        if (known->second < same && (way(known->second).along - direction).norm() < kSameWay)
            same = known->second;
    if (same == static_cast<int>(m_ways.size())) {
        m_ways.push_back({direction, m_collisions.way(direction), m_collisions.way(-direction)});
        m_waysAlong.emplace(at, same);
    }
    return same;
}

void Blocking::begin(const Group &parts)
{
    for (const int part : m_group) {
        m_isThere[static_cast<std::size_t>(part)] = false;
        m_waiting[static_cast<std::size_t>(part)].clear();
        m_stops[static_cast<std::size_t>(part)].clear();
    }
    m_group = parts;
    m_count = parts.size();
    ++m_run;
    for (const int part : parts)
        m_isThere[static_cast<std::size_t>(part)] = true;
    std::vector<int> directions;
    for (const int part : parts) {
        Holding &holding = m_holding[static_cast<std::size_t>(part)];
        holding = {};
        directions.clear();
        for (const Mate &mate : m_mates[static_cast<std::size_t>(part)]) {
            if (!has(mate.part))
                continue;
            ++holding.count;
            for (const int direction : mate.directions)
                if (direction >= 0)
                    directions.push_back(direction);
        }
        std::sort(directions.begin(), directions.end());
        for (const int direction : directions) {
            if (holding.ways.empty() || holding.ways.back().first != direction)
                holding.ways.emplace_back(direction, 0);
            ++holding.ways.back().second;
        }
    }
}

void Blocking::remove(const Group &parts, std::vector<int> &woken)
{
    for (const int part : parts)
        m_isThere[static_cast<std::size_t>(part)] = false;
    m_count -= parts.size();
    for (const int part : parts) {
        std::vector<int> &waiting = m_waiting[static_cast<std::size_t>(part)];
        std::copy_if(waiting.begin(), waiting.end(), std::back_inserter(woken),
                     [&](int other) { return has(other); });
        waiting.clear();
        for (const Mate &mate : m_mates[static_cast<std::size_t>(part)]) {
            if (!has(mate.part))
                continue;
            // It had to come off this one as well.
            Holding &holding = m_holding[static_cast<std::size_t>(mate.part)];
            --holding.count;
            bool hasMore = holding.count == 0;
            for (auto &[direction, count] : holding.ways) {
                if (direction == mate.itsOwn[0] || direction == mate.itsOwn[1])
                    --count;
                else
                    hasMore = hasMore || count == holding.count;
            }
            if (hasMore)
                woken.push_back(mate.part);
        }
    }
}

Group Blocking::there() const
{
    Group there;
    std::copy_if(m_group.begin(), m_group.end(), std::back_inserter(there),
                 [&](int part) { return has(part); });
    return there;
}

/// Those in which all mates let it go, in the order of the first one's.
std::vector<int> Blocking::waysOff(int part)
{
    std::vector<int> ways;
    Holding &holding = m_holding[static_cast<std::size_t>(part)];
    if (holding.count == 0) {
        for (int i = 0; i < m_freeWays; ++i)
            ways.push_back(i);
        return ways;
    }
    const std::vector<Mate> &mates = m_mates[static_cast<std::size_t>(part)];
    while (!has(mates[holding.first].part))
        ++holding.first;
    for (const int direction : mates[holding.first].directions) {
        const auto known =
            std::lower_bound(holding.ways.begin(), holding.ways.end(), std::pair(direction, 0));
        if (direction >= 0 && known->second == holding.count)
            ways.push_back(direction);
    }
    return ways;
}

std::optional<Blocking::Removal> Blocking::straightOff(int part)
{
    for (const int direction : waysOff(part)) {
        const std::optional<int> obstacle = firstObstacle(part, direction);
        if (!obstacle)
            return Removal{{part}, {{way(direction).along, 0.0}}};
        m_waiting[static_cast<std::size_t>(*obstacle)].push_back(part);
    }
    return {};
}

bool Blocking::areInEachOther(int a, int b) const
{
    return std::binary_search(m_options.inEachOther.begin(), m_options.inEachOther.end(),
                              std::pair(std::min(a, b), std::max(a, b)));
}

Blocking::Obstacles &Blocking::obstaclesOf(int part, int direction)
{
    const auto [known, isNew] = m_obstacles[static_cast<std::size_t>(part)].try_emplace(direction);
    Obstacles &obstacles = known->second;
    if (!isNew)
        return obstacles;
    const SweptBox swept(m_collisions.solid(part).box, way(direction).along, kTouchingDepth);
    m_boxes.any(swept, [&](int other) {
        if (other != part)
            obstacles.all.push_back({other, {}});
        return false;
    });
    std::sort(obstacles.all.begin(), obstacles.all.end(),
              [](const Obstacle &a, const Obstacle &b) { return a.part < b.part; });
    return obstacles;
}

bool Blocking::isInTheWay(Obstacle &obstacle, int part, int direction)
{
    if (!obstacle.isInTheWay) {
        if (isOutOfTime())
            return true;
        // One question, whichever of the two moves.
        const Way &asked = way(direction);
        obstacle.isInTheWay = part < obstacle.part
                                  ? !m_collisions.comesFree(part, obstacle.part, asked.number)
                                  : !m_collisions.comesFree(obstacle.part, part, asked.opposite);
    }
    return *obstacle.isInTheWay;
}

std::optional<int> Blocking::firstObstacle(int part, int direction)
{
    Obstacles &obstacles = obstaclesOf(part, direction);
    if (std::exchange(obstacles.run, m_run) != m_run)
        obstacles.passed = 0;
    for (; obstacles.passed < obstacles.all.size(); ++obstacles.passed) {
        Obstacle &obstacle = obstacles.all[obstacles.passed];
        if (has(obstacle.part) && isInTheWay(obstacle, part, direction))
            return obstacle.part;
    }
    return {};
}

bool Blocking::isOutOfTime()
{
    m_isOutOfTime = m_isOutOfTime || (m_options.isOutOfTime && m_options.isOutOfTime());
    return m_isOutOfTime;
}

std::vector<Move> Blocking::measured(const Removal &removal, const std::function<bool(int)> &isRest)
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
        const Solid &solid = m_collisions.solid(part);
        const double first =
            solid.along(last.direction).min + by.dot(last.direction) - Collisions::kNearParts;
        const SweptBox swept({solid.box.min + by, solid.box.max + by}, last.direction,
                             -Collisions::kNearParts);
        m_boxes.any(swept, [&](int other) {
            // It does not take longer than others.
            if (other != part && isRest(other) &&
                m_collisions.solid(other).along(last.direction).max > first + last.distance)
                last.distance =
                    std::max(last.distance, m_collisions.wayToClear(part, other, way, lift));
            return false;
        });
    }
    return moves;
}

} // namespace fff
