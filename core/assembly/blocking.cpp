#include "core/assembly/blocking.h"

#include "core/assembly/smallest_sink.h"
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

constexpr double kEndless = std::numeric_limits<double>::infinity();
/// What is out of its slits is moved on by so much before it turns, where there is room. mm
constexpr double kRoom = 1.0;
constexpr int kNone = -1;

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

/// In which directions groups of what is there could come off the rest.
std::vector<int> Blocking::waysApart() const
{
    std::vector<char> isUsed(m_ways.size(), char(false));
    std::fill_n(isUsed.begin(), m_freeWays, char(true));
    for (const int part : m_group)
        if (has(part))
            for (const auto &[direction, count] : m_holding[static_cast<std::size_t>(part)].ways)
                if (count > 0)
                    isUsed[static_cast<std::size_t>(direction)] = true;
    std::vector<int> ways;
    for (std::size_t i = 0; i < isUsed.size(); ++i) {
        if (isUsed[i])
            ways.push_back(static_cast<int>(i));
    }
    return ways;
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

const std::vector<int> &Blocking::looseSlides(int direction)
{
    const auto [known, isNew] = m_loose.try_emplace(direction);
    if (isNew) {
        const Vec3 &along = way(direction).along;
        for (std::size_t i = 0; i < m_holds.size(); ++i)
            if (along.cross(m_holds[i].slide).squaredNorm() <= m_holds[i].from)
                known->second.push_back(static_cast<int>(i));
    }
    return known->second;
}

Blocking::HeldParts Blocking::heldParts()
{
    HeldParts held;
    held.parts = there();
    std::reverse(held.parts.begin(), held.parts.end());
    for (std::size_t i = 0; i < held.parts.size(); ++i)
        m_placeOf[static_cast<std::size_t>(held.parts[i])] = static_cast<int>(i);
    for (const int part : held.parts) {
        held.begins.push_back(held.mates.size());
        for (const Mate &mate : m_mates[static_cast<std::size_t>(part)])
            if (mate.slide != kNone && has(mate.part))
                held.mates.push_back({m_placeOf[static_cast<std::size_t>(mate.part)], mate.slide});
    }
    held.begins.push_back(held.mates.size());
    return held;
}

std::optional<Blocking::Heaps> Blocking::heaps(const HeldParts &held, int direction)
{
    const std::vector<int> &loose = looseSlides(direction);
    for (const int slide : loose)
        m_isLoose[static_cast<std::size_t>(slide)] = true;
    Heaps heaps;
    heaps.heapOf.assign(held.parts.size(), kNone);
    heaps.places.reserve(held.parts.size());
    for (std::size_t i = 0; i < held.parts.size(); ++i) {
        if (heaps.heapOf[i] != kNone)
            continue;
        const int heap = static_cast<int>(heaps.begins.size());
        heaps.begins.push_back(heaps.places.size());
        heaps.places.push_back(static_cast<int>(i));
        heaps.heapOf[i] = heap;
        for (std::size_t next = heaps.begins.back(); next < heaps.places.size(); ++next) {
            const auto place = static_cast<std::size_t>(heaps.places[next]);
            for (std::size_t k = held.begins[place]; k < held.begins[place + 1]; ++k) {
                const HeldParts::Mate &mate = held.mates[k];
                int &ofMate = heaps.heapOf[static_cast<std::size_t>(mate.place)];
                if (ofMate != kNone || m_isLoose[static_cast<std::size_t>(mate.slide)])
                    continue;
                ofMate = heap;
                heaps.places.push_back(mate.place);
            }
        }
    }
    for (const int slide : loose)
        m_isLoose[static_cast<std::size_t>(slide)] = false;
    if (heaps.begins.size() < 2)
        return {};
    heaps.begins.push_back(heaps.places.size());
    return heaps;
}

std::optional<Group> Blocking::smallestOff(const HeldParts &held, const Heaps &heaps, int direction,
                                           std::size_t fewerThan)
{
    std::vector<std::size_t> sizes;
    for (std::size_t i = 0; i < heaps.count(); ++i)
        sizes.push_back(heaps.size(i));
    std::vector<std::vector<Obstacle> *> known(held.parts.size(), nullptr);
    // On to the next heap that is in the way of this one.
    const auto next = [&](int heap, EdgeCursor &cursor) -> std::optional<int> {
        const std::size_t begin = heaps.begins[static_cast<std::size_t>(heap)];
        for (; cursor.first < sizes[static_cast<std::size_t>(heap)];
             ++cursor.first, cursor.second = 0) {
            const auto place = static_cast<std::size_t>(heaps.places[begin + cursor.first]);
            const int part = held.parts[place];
            if (!known[place])
                known[place] = &obstaclesOf(part, direction).all;
            std::vector<Obstacle> &obstacles = *known[place];
            while (cursor.second < obstacles.size()) {
                Obstacle &obstacle = obstacles[cursor.second++];
                if (!has(obstacle.part))
                    continue;
                const int placeOfOther = m_placeOf[static_cast<std::size_t>(obstacle.part)];
                const int other = heaps.heapOf[static_cast<std::size_t>(placeOfOther)];
                if (other != heap && isInTheWay(obstacle, part, direction))
                    return other;
            }
        }
        return {};
    };
    const auto moved = smallestSink(sizes, fewerThan, next);
    if (!moved)
        return {};
    Group together;
    for (const int heap : *moved) {
        const auto i = static_cast<std::size_t>(heap);
        for (std::size_t k = heaps.begins[i]; k < heaps.begins[i + 1]; ++k)
            together.push_back(held.parts[static_cast<std::size_t>(heaps.places[k])]);
    }
    std::sort(together.begin(), together.end());
    return together;
}

std::optional<Blocking::Removal> Blocking::smallestOff()
{
    const HeldParts held = heldParts();
    std::optional<Group> smallest;
    int along = 0;
    std::optional<Heaps> heaps;
    Vec3 before = Vec3::Zero(); // the direction that they are of
    for (const int direction : waysApart()) {
        if (isOutOfTime())
            return {};
        if (before != -way(direction).along) // there and back they are the same
            heaps = this->heaps(held, direction);
        before = way(direction).along;
        if (!heaps)
            continue;
        std::optional<Group> moved =
            smallestOff(held, *heaps, direction, smallest ? smallest->size() : held.parts.size());
        if (moved) {
            smallest = std::move(moved);
            along = direction;
        }
    }
    if (!smallest)
        return {};
    return Removal{*std::move(smallest), {{way(along).along, 0.0}}};
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
