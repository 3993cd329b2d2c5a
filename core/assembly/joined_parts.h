// Parts that are together at some step of a plan.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace fff {

/// A list of parts, ascending, that copies share: what is together grows from step to step, and n
/// steps are of one list in which each sees what came before it.
class JoinedParts
{
    struct Entry
    {
        int part = 0;
        int came = 0; // the how manieth step of the list it came with
    };

public:
    /// In the order in which they come, of each step some.
    class List
    {
    public:
        void add(const std::vector<int> &parts)
        {
            for (const int part : parts)
                m_entries.push_back({part, m_steps});
            m_sizes.push_back(m_entries.size());
            ++m_steps;
        }
        /// What is there before each step, and after the last one.
        std::vector<JoinedParts> perStep() &&
        {
            std::sort(m_entries.begin(), m_entries.end(),
                      [](const Entry &a, const Entry &b) { return a.part < b.part; });
            const auto all = std::make_shared<const std::vector<Entry>>(std::move(m_entries));
            std::vector<JoinedParts> steps;
            for (int i = 0; i <= m_steps; ++i)
                steps.push_back({all, i, i > 0 ? m_sizes[static_cast<std::size_t>(i) - 1] : 0});
            return steps;
        }

    private:
        std::vector<Entry> m_entries;
        std::vector<std::size_t> m_sizes;
        int m_steps = 0;
    };

    class Iterator
    {
    public:
        using value_type = int;
        using difference_type = std::ptrdiff_t;
        using iterator_category = std::forward_iterator_tag;
        using pointer = const int *;
        using reference = const int &;

        Iterator() = default;
        reference operator*() const { return m_at->part; }
        Iterator &operator++()
        {
            ++m_at;
            skipLater();
            return *this;
        }
        Iterator operator++(int)
        {
            Iterator before = *this;
            ++*this;
            return before;
        }
        bool operator==(const Iterator &other) const { return m_at == other.m_at; }

    private:
        friend class JoinedParts;
        Iterator(const Entry *at, const Entry *end, int steps)
            : m_at(at), m_end(end), m_steps(steps)
        {
            skipLater();
        }
        void skipLater()
        {
            while (m_at != m_end && m_at->came >= m_steps)
                ++m_at;
        }

        const Entry *m_at = nullptr, *m_end = nullptr;
        int m_steps = 0;
    };

    JoinedParts() = default;
    JoinedParts(std::initializer_list<int> parts) : JoinedParts(std::vector<int>(parts)) {}
    /// ascending
    explicit JoinedParts(const std::vector<int> &parts)
    {
        List list;
        list.add(parts);
        *this = std::move(list).perStep().back();
    }

    std::size_t size() const { return m_size; }
    bool empty() const { return m_size == 0; }
    Iterator begin() const
    {
        return m_all ? Iterator(m_all->data(), m_all->data() + m_all->size(), m_steps) : Iterator();
    }
    Iterator end() const
    {
        const Entry *end = m_all ? m_all->data() + m_all->size() : nullptr;
        return m_all ? Iterator(end, end, m_steps) : Iterator();
    }
    /// O(log n).
    bool contains(int part) const
    {
        if (!m_all)
            return false;
        const auto found =
            std::lower_bound(m_all->begin(), m_all->end(), part,
                             [](const Entry &entry, int value) { return entry.part < value; });
        return found != m_all->end() && found->part == part && found->came < m_steps;
    }
    bool operator==(const JoinedParts &other) const
    {
        return m_size == other.m_size && std::equal(begin(), end(), other.begin(), other.end());
    }

private:
    JoinedParts(std::shared_ptr<const std::vector<Entry>> all, int steps, std::size_t size)
        : m_all(std::move(all)), m_steps(steps), m_size(size)
    {
    }

    std::shared_ptr<const std::vector<Entry>> m_all;
    int m_steps = 0; // of the list, that are over
    std::size_t m_size = 0;
};

} // namespace fff
