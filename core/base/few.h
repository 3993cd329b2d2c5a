// A list that is nearly always short: so many of its entries need no memory of their own.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace fff {

template <class T, std::size_t kInline>
class Few
{
public:
    std::size_t size() const { return m_size; }
    bool empty() const { return m_size == 0; }
    const T *data() const { return m_size <= kInline ? m_few.data() : m_many.data(); }

    const T *begin() const { return data(); }
    const T *end() const { return data() + m_size; }
    const T &operator[](std::size_t i) const { return data()[i]; }
    const T &front() const { return data()[0]; }
    const T &back() const { return data()[m_size - 1]; }

    void push_back(T value)
    {
        if (m_size < kInline) {
            m_few[m_size++] = std::move(value);
            return;
        }
        if (m_size == kInline)
            m_many.assign(m_few.begin(), m_few.end());
        m_many.push_back(std::move(value));
        ++m_size;
    }

private:
    std::size_t m_size = 0;
    std::array<T, kInline> m_few{};
    std::vector<T> m_many; // all of them, once they are more
};

} // namespace fff
