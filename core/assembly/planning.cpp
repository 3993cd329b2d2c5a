#include "core/assembly/planning.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>

namespace fff {

namespace {

using Group = std::vector<int>; // ascending

/// So near they still touch; beyond, the way is over. mm
constexpr double kTouching = 0.02;
/// Directions that differ by less are one (no unit): over a metre, by less than a part may be in
/// another one.
constexpr double kSameWay = 1e-6;

Group without(const Group &group, const Group &parts)
{
    Group rest;
    std::set_difference(group.begin(), group.end(), parts.begin(), parts.end(),
                        std::back_inserter(rest));
    return rest;
}

/// Which part is in whose way, in each direction that something may move in. Every pair is looked
/// at once.
class Blocking
{
public:
    Blocking(const std::vector<Solid> &solids, const std::vector<Slide> &slides,
             const PlanOptions &options);

    /// Indices of the directions in which a part could come off all its mates among `others`.
    std::vector<int> waysOff(int part, const Group &others) const;
    /// In which groups of these parts could come off the rest.
    std::vector<int> waysApart(const Group &parts) const;
    const Vec3 &direction(int index) const { return m_directions[static_cast<std::size_t>(index)]; }

    /// Once the time is over everything is in everything's way.
    bool isBlocked(int part, int by, int direction);
    bool isOutOfTime() const { return m_isOutOfTime; }
    /// The part and all that is in its way, and in the way of these, among `others`.
    Group movedWith(int part, const Group &others, int direction);

private:
    int indexOf(const Vec3 &direction);

    struct Mate
    {
        int part;
        std::vector<int> directions; // in which one comes off it
    };

    const std::vector<Solid> &m_solids;
    const PlanOptions &m_options;
    std::vector<Vec3> m_directions;
    int m_freeDirections = 0; // so many of them, the first ones, are those of the world
    std::vector<std::vector<Mate>> m_mates; // of each part
    std::unordered_map<long long, bool> m_known;
    bool m_isOutOfTime = false;
};

Blocking::Blocking(const std::vector<Solid> &solids, const std::vector<Slide> &slides,
                   const PlanOptions &options)
    : m_solids(solids), m_options(options), m_mates(solids.size())
{
    for (const Vec3 &free : {Vec3(Vec3::UnitY()), Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitX()),
                             Vec3(Vec3::UnitZ()), Vec3(-Vec3::UnitZ()), Vec3(-Vec3::UnitY())})
        m_directions.push_back(free);
    m_freeDirections = static_cast<int>(m_directions.size());
    for (const Slide &slide : slides) {
        const int there = indexOf(slide.direction), back = indexOf(-slide.direction);
        Mate ofA{slide.b, {back}}, ofB{slide.a, {there}};
        if (slide.goesBothWays) {
            ofA.directions.push_back(there);
            ofB.directions.push_back(back);
        }
        m_mates[static_cast<std::size_t>(slide.a)].push_back(ofA);
        m_mates[static_cast<std::size_t>(slide.b)].push_back(ofB);
    }
}

int Blocking::indexOf(const Vec3 &direction)
{
    for (std::size_t i = 0; i < m_directions.size(); ++i) {
        if ((m_directions[i] - direction).norm() < kSameWay)
            return static_cast<int>(i);
    }
    m_directions.push_back(direction);
    return static_cast<int>(m_directions.size()) - 1;
}

std::vector<int> Blocking::waysOff(int part, const Group &others) const
{
    std::vector<int> ways;
    bool isHeld = false;
    for (const Mate &mate : m_mates[static_cast<std::size_t>(part)]) {
        if (!std::binary_search(others.begin(), others.end(), mate.part))
            continue;
        if (!std::exchange(isHeld, true)) {
            ways = mate.directions;
            continue;
        }
        std::erase_if(ways, [&](int way) {
            return std::find(mate.directions.begin(), mate.directions.end(), way) ==
                   mate.directions.end();
        });
    }
    for (int i = 0; !isHeld && i < m_freeDirections; ++i)
        ways.push_back(i);
    return ways;
}

std::vector<int> Blocking::waysApart(const Group &parts) const
{
    std::vector<char> isUsed(m_directions.size(), char(false));
    std::fill_n(isUsed.begin(), m_freeDirections, char(true));
    for (const int part : parts) {
        for (const Mate &mate : m_mates[static_cast<std::size_t>(part)]) {
            if (!std::binary_search(parts.begin(), parts.end(), mate.part))
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

bool Blocking::isBlocked(int part, int by, int direction)
{
    const auto count = static_cast<long long>(m_solids.size());
    const long long key = (direction * count + part) * count + by;
    if (const auto known = m_known.find(key); known != m_known.end())
        return known->second;
    m_isOutOfTime = m_isOutOfTime || (m_options.isOutOfTime && m_options.isOutOfTime());
    if (m_isOutOfTime)
        return true;
    const bool isIgnored = std::binary_search(m_options.ignored.begin(), m_options.ignored.end(),
                                              std::pair(std::min(part, by), std::max(part, by)));
    return m_known[key] = !isIgnored && collisionAlong(m_solids[static_cast<std::size_t>(part)],
                                                       m_solids[static_cast<std::size_t>(by)],
                                                       this->direction(direction), m_options.depth)
                                            .has_value();
}

Group Blocking::movedWith(int part, const Group &others, int direction)
{
    Group moved{part}, rest = others;
    for (std::size_t next = 0; next < moved.size() && !rest.empty(); ++next) {
        std::erase_if(rest, [&](int other) {
            if (!isBlocked(moved[next], other, direction))
                return false;
            moved.push_back(other);
            return true;
        });
    }
    std::sort(moved.begin(), moved.end());
    return moved;
}

class Planner
{
public:
    Planner(const std::vector<Solid> &solids, const std::vector<Slide> &slides,
            const PlanOptions &options)
        : m_solids(solids), m_blocking(solids, slides, options)
    {
    }

    /// Appends the steps that put the parts together. False when some of them are locked.
    bool putTogether(Group parts, std::vector<AssemblyStep> &steps);
    /// Of the parts that were found to be locked last, as few as stay locked.
    Group fewestLocked();
    bool isOutOfTime() const { return m_blocking.isOutOfTime(); }

private:
    struct Removal
    {
        Group parts;
        int direction;
    };
    std::optional<Removal> singleOff(const Group &parts);
    std::optional<Removal> groupOff(const Group &parts);
    double wayOff(const Removal &removal, const Group &rest) const;

    const std::vector<Solid> &m_solids;
    Blocking m_blocking;
    Group m_locked;
};

std::optional<Planner::Removal> Planner::singleOff(const Group &parts)
{
    for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
        for (const int direction : m_blocking.waysOff(*part, parts)) {
            if (std::none_of(parts.begin(), parts.end(), [&](int other) {
                    return other != *part && m_blocking.isBlocked(*part, other, direction);
                }))
                return Removal{{*part}, direction};
        }
    }
    return {};
}

std::optional<Planner::Removal> Planner::groupOff(const Group &parts)
{
    std::optional<Removal> smallest;
    for (const int direction : m_blocking.waysApart(parts)) {
        for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
            Group moved = m_blocking.movedWith(*part, without(parts, {*part}), direction);
            if (moved.size() < parts.size() && (!smallest || moved.size() < smallest->parts.size()))
                smallest = Removal{std::move(moved), direction};
        }
    }
    return smallest;
}

/// How far it moves until it touches nothing any more.
double Planner::wayOff(const Removal &removal, const Group &rest) const
{
    double way = 0.0;
    for (const int part : removal.parts) {
        for (const int other : rest)
            way = std::max(way, wayToClear(m_solids[static_cast<std::size_t>(part)],
                                           m_solids[static_cast<std::size_t>(other)],
                                           m_blocking.direction(removal.direction), kTouching));
    }
    return way;
}

bool Planner::putTogether(Group parts, std::vector<AssemblyStep> &steps)
{
    std::vector<Removal> removals;
    std::vector<Group> rests;
    while (parts.size() > 1) {
        std::optional<Removal> removal = singleOff(parts);
        if (!removal)
            removal = groupOff(parts);
        if (!removal) {
            m_locked = parts;
            return false;
        }
        parts = without(parts, removal->parts);
        removals.push_back(*std::move(removal));
        rests.push_back(parts);
    }
    steps.push_back({parts, {}, -Vec3::UnitY(), 0.0});
    for (std::size_t i = removals.size(); i-- > 0;) {
        const Removal &removal = removals[i];
        if (removal.parts.size() > 1 && !putTogether(removal.parts, steps))
            return false;
        steps.push_back({removal.parts, rests[i], -m_blocking.direction(removal.direction),
                         wayOff(removal, rests[i])});
    }
    return true;
}

Group Planner::fewestLocked()
{
    for (std::size_t i = m_locked.size(); i-- > 0;) {
        if (i >= m_locked.size())
            continue; // fewer are left by now
        const Group locked = m_locked;
        std::vector<AssemblyStep> ignored;
        if (putTogether(without(locked, {locked[i]}), ignored))
            m_locked = locked; // it takes this one
    }
    return m_locked;
}

} // namespace

AssemblyPlan planAssembly(const std::vector<Solid> &solids, const std::vector<Slide> &slides,
                          const PlanOptions &options)
{
    Group all(solids.size());
    std::iota(all.begin(), all.end(), 0);
    AssemblyPlan plan;
    plan.verdict = AssemblyPlan::Verdict::Possible;
    if (all.empty())
        return plan;
    Planner planner(solids, slides, options);
    if (planner.putTogether(all, plan.steps))
        return plan;
    plan.steps.clear();
    plan.locked = planner.fewestLocked();
    plan.verdict = AssemblyPlan::Verdict::Impossible;
    if (planner.isOutOfTime()) {
        plan.locked.clear();
        plan.verdict = AssemblyPlan::Verdict::NotFound;
    }
    return plan;
}

} // namespace fff
