#include "core/io/drawing_text.h"

#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

namespace fff::io {

namespace {

/// The texts of 00 … 99, one after the other.
constexpr std::array<char, 200> kPairs = [] {
    std::array<char, 200> pairs{};
    for (std::size_t i = 0; i < 100; ++i) {
        pairs[2 * i] = static_cast<char>('0' + i / 10);
        pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
    }
    return pairs;
}();

char *putPair(char *at, std::uint32_t below100)
{
    std::memcpy(at, kPairs.data() + 2 * below100, 2);
    return at + 2;
}

char *putDigit(char *at, std::uint32_t below10)
{
    *at = static_cast<char>('0' + below10);
    return at + 1;
}

char *putWhole(char *at, std::uint64_t value)
{
    if (value >= 10'000)
        return std::to_chars(at, at + 20, value).ptr;
    const auto small = static_cast<std::uint32_t>(value);
    if (small >= 1'000)
        return putPair(putPair(at, small / 100), small % 100);
    if (small >= 100)
        return putPair(putDigit(at, small / 100), small % 100);
    return small >= 10 ? putPair(at, small) : putDigit(at, small);
}

template <Decimals decimals>
char *putFraction(char *at, std::uint32_t value)
{
    if constexpr (decimals == Decimals::Six) {
        at = putPair(at, value / 10'000);
        at = putPair(at, value / 100 % 100);
        return putPair(at, value % 100);
    } else {
        return putPair(putDigit(at, value / 100), value % 100);
    }
}

/// The shortest text of the number rounded to so many decimals, without an exponent. By whole
/// numbers, which is a fraction of the work of finding the shortest text of a double.
template <Decimals decimals>
char *put(char *at, double value)
{
    constexpr auto kScale = static_cast<std::uint32_t>(decimals);
    const auto size = static_cast<std::uint64_t>(std::abs(value) * kScale + 0.5);
    if (value < 0.0 && size > 0)
        *at++ = '-';
    at = putWhole(at, size / kScale);
    if (const auto fraction = static_cast<std::uint32_t>(size % kScale)) {
        *at++ = '.';
        at = putFraction<decimals>(at, fraction);
        while (at[-1] == '0')
            --at;
    }
    return at;
}

} // namespace

DrawingText &DrawingText::operator<<(std::string_view text)
{
    if (m_chunk.size() - m_used < text.size())
        flush();
    if (text.size() > m_chunk.size()) {
        m_text += text;
        return *this;
    }
    std::memcpy(m_chunk.data() + m_used, text.data(), text.size());
    m_used += text.size();
    return *this;
}

DrawingText &DrawingText::operator<<(double value)
{
    m_used = static_cast<std::size_t>(put<Decimals::Six>(place(), value) - m_chunk.data());
    return *this;
}

template <Decimals decimals>
void DrawingText::addPoint(std::string_view before, const Vec2 &p)
{
    assert(before.size() <= 3 && "place() keeps room for a point and little more");
    char *at = place();
    for (const char c : before)
        *at++ = c;
    at = put<decimals>(at, p.x());
    *at++ = ' ';
    at = put<decimals>(at, p.y());
    m_used = static_cast<std::size_t>(at - m_chunk.data());
}

template void DrawingText::addPoint<Decimals::Six>(std::string_view, const Vec2 &);
template void DrawingText::addPoint<Decimals::Three>(std::string_view, const Vec2 &);

void DrawingText::flush()
{
    m_text.append(m_chunk.data(), m_used);
    m_used = 0;
}

std::string DrawingText::take()
{
    flush();
    return std::move(m_text);
}

} // namespace fff::io
