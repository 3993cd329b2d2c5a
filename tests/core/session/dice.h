// Random numbers for models that are made anew with every run.
#pragma once

#include <cstdint>
#include <random>

namespace fff::test {

/// The same numbers everywhere, which the distributions of the standard library need not give.
class Dice
{
public:
    explicit Dice(std::uint64_t seed) : m_random(seed) {}

    double between(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(m_random() >> 11) * 0x1p-53);
    }
    int below(int count) { return static_cast<int>(m_random() % static_cast<unsigned>(count)); }
    bool oneIn(int count) { return below(count) == 0; }

private:
    std::mt19937_64 m_random;
};

} // namespace fff::test
