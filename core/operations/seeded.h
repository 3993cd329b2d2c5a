// Random numbers that are the same on every machine and for every library.
#pragma once

#include <cstdint>
#include <random>
#include <string_view>

namespace fff {

/// Numbers of one instance: from the seed and the instance's key, whatever else is made. The
/// generator's sequence is laid down by the standard; what its distributions make of it is not.
class Seeded
{
public:
    Seeded(std::uint64_t seed, std::string_view key) : m_engine(mixed(seed, key)) {}

    /// −1 … 1: the upper 53 bits of the next number.
    double symmetric() { return 2.0 * static_cast<double>(m_engine() >> 11) * 0x1.0p-53 - 1.0; }

private:
    /// FNV-1a over the seed's bytes and the key's.
    static std::uint64_t mixed(std::uint64_t seed, std::string_view key)
    {
        std::uint64_t hash = 0xcbf29ce484222325ull;
        const auto add = [&hash](unsigned char byte) { hash = (hash ^ byte) * 0x100000001b3ull; };
        for (int shift = 0; shift < 64; shift += 8)
            add(static_cast<unsigned char>(seed >> shift));
        for (const char letter : key)
            add(static_cast<unsigned char>(letter));
        return hash;
    }

    std::mt19937_64 m_engine;
};

} // namespace fff
