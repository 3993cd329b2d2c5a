// Numbers in binary formats of meshes. Internal to io.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace fff::io {

class MeshBytes
{
public:
    explicit MeshBytes(std::string_view bytes, bool isBigEndian = false)
        : m_bytes(bytes), m_isSwapped(isBigEndian != (std::endian::native == std::endian::big))
    {
    }

    std::size_t size() const { return m_bytes.size(); }
    bool has(std::uint64_t offset, std::uint64_t count) const
    {
        return offset <= m_bytes.size() && count <= m_bytes.size() - offset;
    }

    /// Where has() says that they are.
    template <class Number>
    Number at(std::size_t offset) const
    {
        char raw[sizeof(Number)];
        std::memcpy(raw, m_bytes.data() + offset, sizeof raw);
        if (m_isSwapped)
            for (std::size_t i = 0; i < sizeof raw / 2; ++i)
                std::swap(raw[i], raw[sizeof raw - 1 - i]);
        Number value;
        std::memcpy(&value, raw, sizeof raw);
        return value;
    }

private:
    std::string_view m_bytes;
    bool m_isSwapped;
};

} // namespace fff::io
