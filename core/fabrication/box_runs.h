// Boxes of things that follow each other, for finding those near a place. Internal to fabrication.
#pragma once

#include "core/geometry/vector.h"

#include <algorithm>
#include <vector>

namespace fff {

/// What follows each other lies near each other: one box for every run of things, and one for every
/// run of such boxes. Cheaper to fill than a grid, for a boundary of which a few places matter.
class BoxRuns
{
public:
    /// Of so many things at once.
    template <class BoxOf>
    void fill(std::size_t count, BoxOf boxOf)
    {
        m_count = count;
        m_runs.resize((count + kRun - 1) / kRun);
        m_groups.resize((m_runs.size() + kRun - 1) / kRun);
        for (std::size_t run = 0; run < m_runs.size(); ++run) {
            Box2 box;
            for (std::size_t i = run * kRun; i < std::min((run + 1) * kRun, count); ++i)
                box.extend(boxOf(i));
            m_runs[run] = box;
            m_groups[run / kRun].extend(box);
        }
    }
    /// Of the next thing.
    void add(const Box2 &box)
    {
        if (m_count % kRun == 0)
            m_runs.emplace_back();
        if (m_count % (kRun * kRun) == 0)
            m_groups.emplace_back();
        m_runs.back().extend(box);
        m_groups.back().extend(box);
        ++m_count;
    }

    /// Of everything.
    Box2 bounds() const
    {
        Box2 all;
        for (const Box2 &group : m_groups)
            all.extend(group);
        return all;
    }
    /// Calls `visit` with the index of everything in the boxes of which `isNear` says true, until
    /// it says true itself. Whether it did.
    template <class IsNear, class Visit>
    bool any(IsNear isNear, Visit visit) const
    {
        for (std::size_t group = 0; group < m_groups.size(); ++group) {
            if (!isNear(m_groups[group]))
                continue;
            const std::size_t lastRun = std::min((group + 1) * kRun, m_runs.size());
            for (std::size_t run = group * kRun; run < lastRun; ++run) {
                if (!isNear(m_runs[run]))
                    continue;
                const std::size_t last = std::min((run + 1) * kRun, m_count);
                for (std::size_t i = run * kRun; i < last; ++i)
                    if (visit(i))
                        return true;
            }
        }
        return false;
    }

private:
    static constexpr std::size_t kRun = 8;

    std::size_t m_count = 0;
    std::vector<Box2> m_runs, m_groups;
};

} // namespace fff
