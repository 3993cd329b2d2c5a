// Which things belong together, when pairs of them do.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace fff {

/// Things 0 … count − 1, each at first a group of its own. Our own in place of Boost's
/// disjoint_sets: that header costs each file that has it 3 s, and leaders of its groups are
/// whichever, where an order that people see needs the first ones.
/// Source  R. Tarjan, J. van Leeuwen 1984, Worst-case analysis of set union algorithms (halving).
class Groups
{
public:
    explicit Groups(std::size_t count) : m_towards(count)
    {
        std::iota(m_towards.begin(), m_towards.end(), std::size_t(0));
    }

    void join(std::size_t a, std::size_t b)
    {
        const std::size_t x = firstOf(a), y = firstOf(b);
        m_towards[std::max(x, y)] = std::min(x, y);
    }
    /// The first one of its group.
    std::size_t firstOf(std::size_t i)
    {
        while (m_towards[i] != i)
            i = m_towards[i] = m_towards[m_towards[i]];
        return i;
    }
    /// All groups by their first ones, what is in each in its order.
    std::vector<std::vector<std::size_t>> all()
    {
        std::vector<std::vector<std::size_t>> members(m_towards.size());
        for (std::size_t i = 0; i < members.size(); ++i)
            members[firstOf(i)].push_back(i);
        std::erase_if(members, [](const auto &group) { return group.empty(); });
        return members;
    }

private:
    std::vector<std::size_t>
        m_towards; // of each one another of its group that is before it, or itself
};

} // namespace fff
