#include "core/assembly/planning.h"

#include "core/assembly/blocking.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace fff {

namespace {

class Planner
{
public:
    Planner(Collisions &collisions, const std::vector<Slide> &slides, const PlanOptions &options)
        : m_blocking(collisions, slides, options)
    {
    }

    /// Appends the steps that put the parts together. False when some of them are locked.
    bool putTogether(Group parts, std::vector<AssemblyStep> &steps);
    /// Of the parts that were found to be locked last, as few as stay locked.
    Group fewestLocked();
    bool isOutOfTime() { return m_blocking.isOutOfTime(); }

private:
    using Removal = Blocking::Removal;

    std::optional<Removal> nextOff(const Group &parts);
    /// Removals, the first one first; nothing when parts are locked, which it keeps.
    struct Apart
    {
        std::vector<Removal> removals;
        Group last;
    };
    std::optional<Apart> takeApart(Group parts);
    bool isLocked(const Group &parts);

    Blocking m_blocking;
    Group m_locked;
};

/// A single part before any group, and straight before bent.
std::optional<Blocking::Removal> Planner::nextOff(const Group &parts)
{
    const auto partOff = [&](Blocking::Path path) -> std::optional<Removal> {
        for (auto part = parts.rbegin(); part != parts.rend(); ++part)
            if (std::optional<Removal> removal = m_blocking.partOff(*part, parts, path))
                return removal;
        return {};
    };
    std::optional<Removal> removal = partOff(Blocking::Path::Straight);
    if (!removal)
        removal = m_blocking.smallestOff(parts);
    if (!removal)
        removal = partOff(Blocking::Path::Bent);
    return removal;
}

std::optional<Planner::Apart> Planner::takeApart(Group parts)
{
    Apart apart;
    while (parts.size() > 1) {
        std::optional<Removal> removal = nextOff(parts);
        if (!removal) {
            m_locked = std::move(parts);
            return {};
        }
        parts = without(parts, removal->parts);
        apart.removals.push_back(*std::move(removal));
    }
    apart.last = std::move(parts);
    return apart;
}

bool Planner::isLocked(const Group &parts)
{
    const std::optional<Apart> apart = takeApart(parts);
    return !apart || std::any_of(apart->removals.begin(), apart->removals.end(),
                                 [&](const Removal &removal) { return isLocked(removal.parts); });
}

bool Planner::putTogether(Group parts, std::vector<AssemblyStep> &steps)
{
    const std::optional<Apart> apart = takeApart(std::move(parts));
    if (!apart)
        return false;
    Group there = apart->last;
    steps.push_back({there, {}, {}});
    for (auto removal = apart->removals.rbegin(); removal != apart->removals.rend(); ++removal) {
        if (removal->parts.size() > 1 && !putTogether(removal->parts, steps))
            return false;
        std::vector<Move> moves = m_blocking.measured(*removal, there);
        std::reverse(moves.begin(), moves.end());
        for (Move &move : moves)
            move.direction = -move.direction;
        steps.push_back({removal->parts, there, std::move(moves)});
        const auto middle = static_cast<std::ptrdiff_t>(there.size());
        there.insert(there.end(), removal->parts.begin(), removal->parts.end());
        std::inplace_merge(there.begin(), there.begin() + middle, there.end());
    }
    return true;
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
    plan.locked = planner.fewestLocked();
    plan.verdict = AssemblyPlan::Verdict::Impossible;
    if (planner.isOutOfTime()) {
        plan.locked.clear();
        plan.verdict = AssemblyPlan::Verdict::NotFound;
    }
    return plan;
}

} // namespace fff
