// A list that shares with its copies what none of them has replaced.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace fff {

/// A copy costs a pointer for each kInBlock items. Items are never changed in place.
template <class T>
class SharedList
{
public:
    static constexpr std::size_t kInBlock = 16;

    SharedList() = default;
    SharedList(std::initializer_list<T> items) : SharedList(std::vector<T>(items)) {}
    SharedList(const std::vector<T> &items)
    {
        for (std::size_t first = 0; first < items.size(); first += kInBlock) {
            const auto from = items.begin() + static_cast<std::ptrdiff_t>(first);
            const std::size_t count = std::min(kInBlock, items.size() - first);
            m_blocks.push_back(
                std::make_shared<const Block>(from, from + static_cast<std::ptrdiff_t>(count)));
        }
        m_size = items.size();
    }

    std::size_t size() const { return m_size; }
    bool empty() const { return m_size == 0; }
    const T &operator[](std::size_t index) const
    {
        return (*m_blocks[index / kInBlock])[index % kInBlock];
    }

    /// Blocks are so many items that follow each other; the last one may have fewer.
    std::size_t blockCount() const { return m_blocks.size(); }
    std::size_t endOf(std::size_t block) const { return std::min((block + 1) * kInBlock, m_size); }
    /// Whether all items of the block are known to be those of the other list, without a look at
    /// them.
    bool shares(const SharedList &other, std::size_t block) const
    {
        return block < m_blocks.size() && block < other.m_blocks.size() &&
               m_blocks[block] == other.m_blocks[block];
    }

    void resize(std::size_t size, const T &added = {})
    {
        if (size == m_size)
            return;
        const std::size_t full = std::min(size, m_size) / kInBlock; // these blocks stay
        const std::size_t count = (size + kInBlock - 1) / kInBlock;
        BlockPointer cut = full < m_blocks.size() ? m_blocks[full] : nullptr;
        m_blocks.resize(full);
        for (std::size_t first = full * kInBlock; m_blocks.size() < count; first += kInBlock) {
            Block block = cut ? *std::exchange(cut, nullptr) : Block();
            block.resize(std::min(kInBlock, size - first), added);
            m_blocks.push_back(std::make_shared<const Block>(std::move(block)));
        }
        m_size = size;
    }

    /// Replaces items of a list, best in the order of their indices; they are there when it ends.
    class Editor
    {
    public:
        explicit Editor(SharedList &list) : m_list(list) {}
        Editor(const Editor &) = delete;
        Editor &operator=(const Editor &) = delete;
        ~Editor() { finish(); }

        void set(std::size_t index, T item)
        {
            if (m_changed.empty() || index / kInBlock != m_index) {
                finish();
                m_index = index / kInBlock;
                m_changed = *m_list.m_blocks[m_index];
            }
            m_changed[index % kInBlock] = std::move(item);
        }

    private:
        void finish()
        {
            if (!m_changed.empty())
                m_list.m_blocks[m_index] = std::make_shared<const Block>(std::move(m_changed));
            m_changed.clear();
        }

        SharedList &m_list;
        std::size_t m_index = 0; // of the block
        std::vector<T> m_changed;
    };

    class Iterator
    {
    public:
        using value_type = T;
        using difference_type = std::ptrdiff_t;
        using iterator_category = std::forward_iterator_tag;
        using pointer = const T *;
        using reference = const T &;

        Iterator() = default;
        Iterator(const SharedList *list, std::size_t index) : m_list(list), m_index(index) {}
        reference operator*() const { return (*m_list)[m_index]; }
        pointer operator->() const { return &**this; }
        Iterator &operator++()
        {
            ++m_index;
            return *this;
        }
        Iterator operator++(int)
        {
            Iterator before = *this;
            ++m_index;
            return before;
        }
        bool operator==(const Iterator &) const = default;

    private:
        const SharedList *m_list = nullptr;
        std::size_t m_index = 0;
    };
    Iterator begin() const { return {this, 0}; }
    Iterator end() const { return {this, m_size}; }

private:
    using Block = std::vector<T>;
    using BlockPointer = std::shared_ptr<const Block>;

    std::vector<BlockPointer> m_blocks; // all but the last one full
    std::size_t m_size = 0;
};

} // namespace fff
