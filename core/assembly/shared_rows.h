// A list of rows that copies of the list share until one of them replaces a row.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace fff {

/// A copy costs a pointer for each kInBlock rows, whatever is in them. Rows are never changed in
/// place; equal addresses of two lists' rows mean equal rows.
template <class T>
class SharedRows
{
public:
    using Row = std::vector<T>;
    using RowPointer = std::shared_ptr<const Row>;

    SharedRows() = default;
    SharedRows(std::initializer_list<Row> rows)
    {
        resize(rows.size());
        Editor editor(*this);
        std::size_t index = 0;
        for (const Row &row : rows)
            editor.set(index++, row);
    }

    std::size_t size() const { return m_size; }
    bool empty() const { return m_size == 0; }
    const Row &operator[](std::size_t index) const { return *pointer(index); }
    const RowPointer &pointer(std::size_t index) const
    {
        return (*m_blocks[index / kInBlock])[index % kInBlock];
    }

    void resize(std::size_t size)
    {
        if (size == m_size)
            return;
        const std::size_t full = std::min(size, m_size) / kInBlock; // these blocks stay
        const std::size_t count = (size + kInBlock - 1) / kInBlock;
        BlockPointer cut = full < m_blocks.size() ? m_blocks[full] : nullptr;
        m_blocks.resize(full);
        for (std::size_t first = full * kInBlock; m_blocks.size() < count; first += kInBlock) {
            Block block = cut ? *std::exchange(cut, nullptr) : Block();
            block.resize(std::min(kInBlock, size - first), emptyRow());
            m_blocks.push_back(std::make_shared<const Block>(std::move(block)));
        }
        m_size = size;
    }

    /// Replaces rows of a list, best in the order of their indices; they are there when it ends.
    class Editor
    {
    public:
        explicit Editor(SharedRows &rows) : m_rows(rows) {}
        Editor(const Editor &) = delete;
        Editor &operator=(const Editor &) = delete;
        ~Editor() { finish(); }

        void set(std::size_t index, Row row)
        {
            if (m_changed.empty() || index / kInBlock != m_index) {
                finish();
                m_index = index / kInBlock;
                m_changed = *m_rows.m_blocks[m_index];
            }
            m_changed[index % kInBlock] = pointerTo(std::move(row));
        }

    private:
        void finish()
        {
            if (!m_changed.empty())
                m_rows.m_blocks[m_index] = std::make_shared<const Block>(std::move(m_changed));
            m_changed.clear();
        }

        SharedRows &m_rows;
        std::size_t m_index = 0; // of the block
        std::vector<RowPointer> m_changed;
    };

    class Iterator
    {
    public:
        using value_type = Row;
        using difference_type = std::ptrdiff_t;
        using iterator_category = std::forward_iterator_tag;
        using pointer = const Row *;
        using reference = const Row &;

        Iterator() = default;
        Iterator(const SharedRows *rows, std::size_t index) : m_rows(rows), m_index(index) {}
        reference operator*() const { return (*m_rows)[m_index]; }
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
        const SharedRows *m_rows = nullptr;
        std::size_t m_index = 0;
    };
    Iterator begin() const { return {this, 0}; }
    Iterator end() const { return {this, m_size}; }

    /// Same values.
    bool operator==(const SharedRows &other) const
    {
        if (m_size != other.m_size)
            return false;
        for (std::size_t i = 0; i < m_size; ++i) {
            if (pointer(i) != other.pointer(i) && !((*this)[i] == other[i]))
                return false;
        }
        return true;
    }

private:
    static constexpr std::size_t kInBlock = 16;
    using Block = std::vector<RowPointer>;
    using BlockPointer = std::shared_ptr<const Block>;

    static const RowPointer &emptyRow()
    {
        static const RowPointer row = std::make_shared<const Row>();
        return row;
    }
    static RowPointer pointerTo(Row row)
    {
        return row.empty() ? emptyRow() : std::make_shared<const Row>(std::move(row));
    }

    std::vector<BlockPointer> m_blocks; // all but the last one full
    std::size_t m_size = 0;
};

} // namespace fff
