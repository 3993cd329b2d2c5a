// A list of rows that copies of the list share until one of them replaces a row.
#pragma once

#include "core/assembly/shared_list.h"

namespace fff {

/// A copy costs little, whatever is in the rows. Rows are never changed in place; equal addresses
/// of two lists' rows mean equal rows.
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

    std::size_t size() const { return m_rows.size(); }
    bool empty() const { return m_rows.empty(); }
    const Row &operator[](std::size_t index) const { return *pointer(index); }
    const RowPointer &pointer(std::size_t index) const { return m_rows[index]; }
    const SharedList<RowPointer> &pointers() const { return m_rows; }

    void resize(std::size_t size) { m_rows.resize(size, emptyRow()); }

    /// Replaces rows of a list, best in the order of their indices; they are there when it ends.
    class Editor
    {
    public:
        explicit Editor(SharedRows &rows) : m_editor(rows.m_rows) {}
        void set(std::size_t index, Row row) { m_editor.set(index, pointerTo(std::move(row))); }

    private:
        typename SharedList<RowPointer>::Editor m_editor;
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
        explicit Iterator(typename SharedList<RowPointer>::Iterator at) : m_at(at) {}
        reference operator*() const { return **m_at; }
        pointer operator->() const { return m_at->get(); }
        Iterator &operator++()
        {
            ++m_at;
            return *this;
        }
        Iterator operator++(int) { return Iterator(m_at++); }
        bool operator==(const Iterator &) const = default;

    private:
        typename SharedList<RowPointer>::Iterator m_at;
    };
    Iterator begin() const { return Iterator(m_rows.begin()); }
    Iterator end() const { return Iterator(m_rows.end()); }

    /// Same values.
    bool operator==(const SharedRows &other) const
    {
        if (size() != other.size())
            return false;
        for (std::size_t i = 0; i < size(); ++i) {
            if (pointer(i) != other.pointer(i) && !((*this)[i] == other[i]))
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

    SharedList<RowPointer> m_rows;
};

} // namespace fff
