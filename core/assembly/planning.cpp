#include "core/assembly/planning.h"

#include "core/assembly/blocking.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace fff {

namespace {

/// Parts that may come off, the last one first.
class Open
{
public:
    explicit Open(const Group &parts) : m_parts(parts.begin(), parts.end()) {}

    void add(const std::vector<int> &parts) { m_parts.insert(parts.begin(), parts.end()); }
    std::optional<int> next()
    {
        if (m_parts.empty())
            return {};
        const auto last = std::prev(m_parts.end());
        const int part = *last;
        m_parts.erase(last);
        return part;
    }

private:
    std::set<int> m_parts;
};

class Planner
{
public:
    Planner(Collisions &collisions, const std::vector<Slide> &slides, const PlanOptions &options)
        : m_blocking(collisions, slides, options)
    {
    }

    /// Appends the steps that put the parts together. False when some of them are locked.
    bool putTogether(const Group &parts, std::vector<AssemblyStep> &steps);
    /// Of the parts that were found to be locked last, as few as stay locked.
    Group fewestLocked();
    bool isOutOfTime() { return m_blocking.isOutOfTime(); }

private:
    using Removal = Blocking::Removal;

    std::optional<Removal> nextOff(Open &open);
    /// Removals, the first one first; nothing when parts are locked, which it keeps.
    struct Apart
    {
        std::vector<Removal> removals;
        Group last;
    };
    std::optional<Apart> takeApart(const Group &parts);
    bool isLocked(const Group &parts);

    Blocking m_blocking;
    Group m_locked;
};

/// A single part before any group, and straight before bent.
std::optional<Blocking::Removal> Planner::nextOff(Open &open)
{
    while (const std::optional<int> part = open.next()) {
        if (!m_blocking.has(*part))
            continue;
        if (std::optional<Removal> removal = m_blocking.straightOff(*part))
            return removal;
    }
    if (std::optional<Removal> removal = m_blocking.smallestOff())
        return removal;
    const Group parts = m_blocking.there();
    for (auto part = parts.rbegin(); part != parts.rend(); ++part)
        if (std::optional<Removal> removal = m_blocking.bentOff(*part))
            return removal;
    return {};
}

std::optional<Planner::Apart> Planner::takeApart(const Group &parts)
{
    Apart apart;
    m_blocking.begin(parts);
    Open open(parts);
    std::vector<int> woken;
    while (m_blocking.count() > 1) {
        std::optional<Removal> removal = nextOff(open);
        if (!removal) {
            m_locked = m_blocking.there();
            return {};
        }
        woken.clear();
        m_blocking.remove(removal->parts, woken);
        open.add(woken);
        apart.removals.push_back(*std::move(removal));
    }
    apart.last = m_blocking.there();
    return apart;
}

bool Planner::isLocked(const Group &parts)
{
    const std::optional<Apart> apart = takeApart(parts);
    return !apart || std::any_of(apart->removals.begin(), apart->removals.end(),
                                 [&](const Removal &removal) { return isLocked(removal.parts); });
}

bool Planner::putTogether(const Group &parts, std::vector<AssemblyStep> &steps)
{
    const std::optional<Apart> apart = takeApart(parts);
    if (!apart)
        return false;
    JoinedParts::List list;
    list.add(apart->last);
    for (auto removal = apart->removals.rbegin(); removal != apart->removals.rend(); ++removal)
        list.add(removal->parts);
    const std::vector<JoinedParts> there = std::move(list).perStep();
    steps.push_back({apart->last, {}, {}});
    std::size_t step = 1;
    for (auto removal = apart->removals.rbegin(); removal != apart->removals.rend(); ++removal) {
        if (removal->parts.size() > 1 && !putTogether(removal->parts, steps))
            return false;
        const JoinedParts &rest = there[step++];
        std::vector<Move> moves =
            m_blocking.measured(*removal, [&](int part) { return rest.contains(part); });
        std::reverse(moves.begin(), moves.end());
        for (Move &move : moves)
            move.direction = -move.direction;
        steps.push_back({removal->parts, rest, std::move(moves)});
    }
    return true;
}

/// Of the first group what is not in the second one.
Group without(const Group &group, const Group &parts)
{
    Group rest;
    std::set_difference(group.begin(), group.end(), parts.begin(), parts.end(),
                        std::back_inserter(rest));
    return rest;
}

/// Leaves out runs of parts as long as the rest stays locked, long runs first.
Group Planner::fewestLocked()
{
    Group locked = m_locked;
    for (std::size_t run = std::max<std::size_t>(locked.size() / 2, 1); run > 0; run /= 2) {
        for (std::size_t end = locked.size(); end > 0;) {
            const std::size_t first = end > run ? end - run : 0;
            const Group left(locked.begin() + static_cast<std::ptrdiff_t>(first),
                             locked.begin() + static_cast<std::ptrdiff_t>(end));
            end = first;
            if (isLocked(without(locked, left))) {
                locked = m_locked; // fewer still, perhaps
                end = std::min(end, locked.size());
            }
        }
    }
    return locked;
}

} // namespace

AssemblyPlan planAssembly(Collisions &collisions, const std::vector<Slide> &slides,
                          const PlanOptions &options)
{
    Group all(collisions.size());
    std::iota(all.begin(), all.end(), 0);
    AssemblyPlan plan;
    plan.verdict = AssemblyPlan::Verdict::Possible;
    if (all.empty())
        return plan;
    Planner planner(collisions, slides, options);
    if (planner.putTogether(all, plan.steps))
        return plan;
    plan.steps.clear();
    if (!planner.isOutOfTime())
        plan.locked = planner.fewestLocked();
    plan.verdict = AssemblyPlan::Verdict::Impossible;
    if (planner.isOutOfTime()) {
        plan.locked.clear();
        plan.verdict = AssemblyPlan::Verdict::NotFound;
    }
    return plan;
}

} // namespace fff
