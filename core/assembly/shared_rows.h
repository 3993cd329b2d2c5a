// A list of rows that copies of the list share until one of them replaces a row.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <vector>

namespace fff {

/// A copy costs a pointer a row, whatever is in the rows. Rows are never changed in place; equal
/// addresses of two lists' rows mean equal rows.
template <class T>
class SharedRows
{
public:
    using Row = std::vector<T>;
    using RowPointer = std::shared_ptr<const Row>;

    SharedRows() = default;
    SharedRows(std::initializer_list<Row> rows)
    {
        for (const Row &row : rows)
            push_back(row);
    }

    std::size_t size() const { return m_rows.size(); }
    bool empty() const { return m_rows.empty(); }
    const Row &operator[](std::size_t index) const { return *m_rows[index]; }
    const Row &at(std::size_t index) const { return *m_rows.at(index); }
    const RowPointer &pointer(std::size_t index) const { return m_rows[index]; }

    void resize(std::size_t size) { m_rows.resize(size, emptyRow()); }
    void push_back(Row row) { m_rows.push_back(pointerTo(std::move(row))); }
    void share(std::size_t index, RowPointer row) { m_rows[index] = std::move(row); }
    void set(std::size_t index, Row row) { m_rows[index] = pointerTo(std::move(row)); }

    class Iterator
    {
    public:
        using value_type = Row;
        using difference_type = std::ptrdiff_t;
        using iterator_category = std::forward_iterator_tag;
        using pointer = const Row *;
        using reference = const Row &;

        Iterator() = default;
        explicit Iterator(const RowPointer *at) : m_at(at) {}
        reference operator*() const { return **m_at; }
        pointer operator->() const { return m_at->get(); }
        Iterator &operator++()
        {
            ++m_at;
            return *this;
        }
        Iterator operator++(int)
        {
            Iterator before = *this;
            ++m_at;
            return before;
        }
        bool operator==(const Iterator &) const = default;

    private:
        const RowPointer *m_at = nullptr;
    };
    Iterator begin() const { return Iterator(m_rows.data()); }
    Iterator end() const { return Iterator(m_rows.data() + m_rows.size()); }

    /// Same values.
    bool operator==(const SharedRows &other) const
    {
        if (m_rows.size() != other.m_rows.size())
            return false;
        for (std::size_t i = 0; i < m_rows.size(); ++i) {
            if (m_rows[i] != other.m_rows[i] && !(*m_rows[i] == *other.m_rows[i]))
                return false;
        }
        return true;
    }

private:
    static const RowPointer &emptyRow()
    {
        static const RowPointer row = std::make_shared<const Row>();
        return row;
    }
    static RowPointer pointerTo(Row row)
    {
        return row.empty() ? emptyRow() : std::make_shared<const Row>(std::move(row));
    }

    std::vector<RowPointer> m_rows;
};

} // namespace fff
