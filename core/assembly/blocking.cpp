#include "core/assembly/blocking.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace fff {

namespace {

/// So near they still touch; beyond, the way is over. mm
constexpr double kNear = 0.02;
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

Blocking::Blocking(const std::vector<Solid> &solids, const std::vector<Slide> &slides,
                   const PlanOptions &options)
    : m_solids(solids), m_slides(slides), m_options(options), m_mates(solids.size()),
      m_lifted(solids.size())
{
    for (const Vec3 &free : {Vec3(Vec3::UnitY()), Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitX()),
                             Vec3(Vec3::UnitZ()), Vec3(-Vec3::UnitZ()), Vec3(-Vec3::UnitY())})
        m_ways.push_back({free, {}, {}});
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
    m_ways.push_back({direction, {}, {}});
    return static_cast<int>(m_ways.size()) - 1;
}

Blocking::Way &Blocking::opened(int direction)
{
    Way &way = m_ways[static_cast<std::size_t>(direction)];
    if (!way.shadows.empty())
        return way;
    const Vec3 u = way.along.unitOrthogonal(), v = way.along.cross(u);
    for (const Solid &solid : m_solids) {
        const Extent across = solid.along(u), up = solid.along(v), on = solid.along(way.along);
        way.shadows.push_back({across.min, across.max, up.min, up.max, on.min, on.max});
    }
    way.held.resize(m_solids.size());
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
        if (std::none_of(others.begin(), others.end(), [&](int other) {
                return other != part && isBlocked(part, other, direction);
            }))
            return Removal{{part}, {{m_ways[static_cast<std::size_t>(direction)].along, 0.0}}};
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

long long Blocking::key(int part, int by, int direction) const
{
    const auto count = static_cast<long long>(m_solids.size());
    return (direction * count + part) * count + by;
}

bool Blocking::isBlocked(int part, int by, int direction)
{
    const Way &way = opened(direction);
    if (!way.shadows[static_cast<std::size_t>(part)].meetsOnItsWay(
            way.shadows[static_cast<std::size_t>(by)], m_options.depth))
        return false;
    const long long question = key(part, by, direction);
    if (const auto known = m_known.find(question); known != m_known.end())
        return known->second;
    if (isOutOfTime())
        return true;
    return m_known[question] = !isIgnored(part, by) &&
                               !comesFree(solid(part), solid(by), way.along, m_options.depth);
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
    std::vector<int> heapOf(m_solids.size(), kAway);
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
    const Way &way = opened(direction);
    std::vector<char> isResting(m_solids.size(), char(false));
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
        for (std::size_t i = 0; i < parts.size() && moved.size() < fewerThan; ++i)
            if (isResting[static_cast<std::size_t>(parts[i])] &&
                isBlocked(moved[next], parts[i], direction))
                move(parts[i]);
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

std::vector<Move> Blocking::measured(const Removal &removal, const Group &rest) const
{
    std::vector<Move> moves = removal.moves;
    Vec3 lift = Vec3::Zero();
    for (std::size_t i = 0; i + 1 < moves.size(); ++i)
        lift += moves[i].distance * moves[i].direction;
    double &length = moves.back().distance;
    length = 0.0;
    const Vec3 &along = moves.back().direction;
    for (const int part : removal.parts) {
        const Solid mover = movedBy(solid(part), lift);
        const double first = mover.along(along).min;
        for (const int other : rest) {
            // It does not take longer than others.
            if (solid(other).along(along).max + kNear > first + length)
                length = std::max(length, wayToClear(mover, solid(other), along, kNear));
        }
    }
    return moves;
}

double Blocking::wayUntil(int part, int by, int direction)
{
    const auto [known, isNew] = m_until.try_emplace(key(part, by, direction), kEndless);
    if (isNew) {
        const Vec3 &along = m_ways[static_cast<std::size_t>(direction)].along;
        if (const auto met = collisionAlong(solid(part), solid(by), along, m_options.depth))
            known->second = met->from;
    }
    return known->second;
}

/// Across the part to both sides, and along the axes of the world.
std::vector<Vec3> Blocking::turnsOf(int part) const
{
    const Vec3 &across = solid(part).normal;
    std::vector<Vec3> turns{across, -across};
    for (int i = 0; i < m_freeWays; ++i)
        turns.push_back(m_ways[static_cast<std::size_t>(i)].along);
    return turns;
}

bool Blocking::isFreeAfter(int part, const Group &others, const Move &lift, std::size_t turn)
{
    const Vec3 by = lift.distance * lift.direction, along = turnsOf(part)[turn];
    std::vector<Lifted> &all = m_lifted[static_cast<std::size_t>(part)];
    auto lifted = std::find_if(all.begin(), all.end(), [&](const Lifted &l) { return l.by == by; });
    if (lifted == all.end())
        lifted = all.insert(all.end(), {by, {}});
    lifted->isFree.resize(std::max(lifted->isFree.size(), turn + 1));
    std::vector<std::optional<bool>> &isFree = lifted->isFree[turn];
    isFree.resize(m_solids.size());
    std::optional<Solid> moved; // made when somebody asks
    return std::all_of(others.begin(), others.end(), [&](int other) {
        if (other == part)
            return true;
        std::optional<bool> &known = isFree[static_cast<std::size_t>(other)];
        if (!known) {
            if (!moved)
                moved = movedBy(solid(part), by);
            known = comesFree(*moved, solid(other), along, m_options.depth);
        }
        return *known;
    });
}

std::optional<Blocking::Removal> Blocking::bent(int part, const Group &others, int direction)
{
    double held = 0.0, until = kEndless;
    for (const Mate &mate : m_mates[static_cast<std::size_t>(part)])
        if (has(others, mate.part))
            held = std::max(held, mate.length);
    if (held == 0.0 || std::isinf(held))
        return {}; // nothing to come out of
    for (const int other : others) {
        if (other == part || !isBlocked(part, other, direction))
            continue;
        if (isOutOfTime())
            return {};
        until = std::min(until, wayUntil(part, other, direction));
        if (until < kRoom)
            return {};
    }
    // A little out of the slits, as far as it goes, or half of that: some come free of a slit long
    // before its end.
    std::vector<double> places{until - kRoom, 0.5 * until};
    if (held + kRoom < until)
        places.insert(places.begin(), held + kRoom);
    const std::vector<Vec3> turns = turnsOf(part);
    for (const double place : places) {
        const Move lift{m_ways[static_cast<std::size_t>(direction)].along, place};
        for (std::size_t turn = 0; turn < turns.size(); ++turn) {
            if (isFreeAfter(part, others, lift, turn))
                return Removal{{part}, {lift, {turns[turn], 0.0}}};
        }
    }
    return {};
}

} // namespace fff
