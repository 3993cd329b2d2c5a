// Text that is made of little else than numbers, as drawings are. Internal to io.
#pragma once

#include "core/geometry/vector.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace fff::io {

/// What numbers are whole multiples of: one over a power of ten.
enum class Decimals : std::uint32_t {
    Six = 1'000'000, // in mm a nanometre: what is cut is what was computed
    Three = 1'000    // a micrometre, for engravings: nobody measures a digit, and there are many
};

/// Grows at its end, in chunks.
class DrawingText
{
public:
    /// length   about that of the whole text, rather more than less
    explicit DrawingText(std::size_t length) { m_text.reserve(length); }

    DrawingText &operator<<(std::string_view text);
    /// With six decimals at most.
    DrawingText &operator<<(double value);
    /// x, a space and y; before them what stands in front of a point, three characters at most.
    template <Decimals decimals>
    void addPoint(std::string_view before, const Vec2 &p);
    std::string take();

private:
    static constexpr std::size_t kChunk = 8192;
    static constexpr std::size_t kPlace = 96; // more than a point needs

    /// Where so many characters can be written.
    char *place()
    {
        if (m_chunk.size() - m_used < kPlace)
            flush();
        return m_chunk.data() + m_used;
    }
    void flush();

    std::string m_text;
    std::size_t m_used = 0;
    std::array<char, kChunk> m_chunk;
};

extern template void DrawingText::addPoint<Decimals::Six>(std::string_view, const Vec2 &);
extern template void DrawingText::addPoint<Decimals::Three>(std::string_view, const Vec2 &);

} // namespace fff::io
