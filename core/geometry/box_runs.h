// Boxes of things that follow each other, for finding those near a place.
#pragma once

#include "core/geometry/vector.h"

#include <algorithm>
#include <vector>

namespace fff {

/// What follows each other lies near each other: one box for every run of things, one for every run
/// of such boxes, and so on up to a single one. Cheaper to fill than a grid, for a boundary of
/// which a few places matter.
class BoxRuns
{
public:
    /// Of so many things at once.
    template <class BoxOf>
    void fill(std::size_t count, BoxOf boxOf)
    {
        m_count = count;
        m_levels.clear();
        if (count == 0)
            return;
        m_levels.emplace_back(runs(count));
        for (std::size_t i = 0; i < count; ++i)
            m_levels.front()[i / kRun].extend(boxOf(i));
        close();
    }
    /// Of the next thing.
    void add(const Box2 &box)
    {
        if (m_levels.empty())
            m_levels.emplace_back();
        std::size_t index = m_count++;
        for (std::vector<Box2> &level : m_levels) {
            index /= kRun;
            if (index == level.size())
                level.emplace_back();
            level[index].extend(box);
        }
        close();
    }

    /// Of everything.
    Box2 bounds() const { return m_levels.empty() ? Box2() : m_levels.back().front(); }

    /// Calls `visit` with the index of everything in the boxes of which `isNear` says true, until
    /// it says true itself. Whether it did.
    template <class IsNear, class Visit>
    bool any(IsNear isNear, Visit visit) const
    {
        return walk([&](const Box2 &box, std::size_t, std::size_t) { return isNear(box); }, visit);
    }
    /// The same for those who ask of what a box holds: isWanted(box, first, end), indices of
    /// things.
    template <class IsWanted, class Visit>
    bool walk(IsWanted isWanted, Visit visit) const
    {
        if (m_levels.empty())
            return false;
        std::size_t span = kRun; // things in a box of the level
        for (std::size_t level = 1; level < m_levels.size(); ++level)
            span *= kRun;
        return walkFrom(m_levels.size() - 1, 0, span, isWanted, visit);
    }
    /// Calls visit(box, begin, end) for every run of things in a box that is near.
    template <class IsNear, class Visit>
    void eachRun(IsNear isNear, Visit visit) const
    {
        walk(
            [&](const Box2 &box, std::size_t first, std::size_t end) {
                if (!isNear(box))
                    return false;
                if (end - first > kRun)
                    return true;
                visit(box, first, end);
                return false;
            },
            [](std::size_t) { return false; });
    }

private:
    static constexpr std::size_t kRun = 8;

    static std::size_t runs(std::size_t count) { return (count + kRun - 1) / kRun; }

    /// Levels above, until one box is left.
    void close()
    {
        while (m_levels.back().size() > 1) {
            const std::vector<Box2> &below = m_levels.back();
            std::vector<Box2> level(runs(below.size()));
            for (std::size_t i = 0; i < below.size(); ++i)
                level[i / kRun].extend(below[i]);
            m_levels.push_back(std::move(level));
        }
    }

    template <class IsWanted, class Visit>
    bool walkFrom(std::size_t level, std::size_t index, std::size_t span, IsWanted &isWanted,
                  Visit &visit) const
    {
        const std::size_t first = index * span, end = std::min(first + span, m_count);
        if (!isWanted(m_levels[level][index], first, end))
            return false;
        if (level == 0) {
            for (std::size_t i = first; i < end; ++i)
                if (visit(i))
                    return true;
            return false;
        }
        const std::size_t last = std::min((index + 1) * kRun, m_levels[level - 1].size());
        for (std::size_t below = index * kRun; below < last; ++below)
            if (walkFrom(level - 1, below, span / kRun, isWanted, visit))
                return true;
        return false;
    }

    std::size_t m_count = 0;
    std::vector<std::vector<Box2>> m_levels; // over things, over these boxes, …, one box
};

} // namespace fff
