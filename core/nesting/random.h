// Numbers that are the same on every machine. Internal to nesting.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace fff::nest {

/// S. Vigna 2015, SplitMix64: a step of a counter, well mixed.
class Random
{
public:
    explicit Random(std::uint64_t seed) : m_state(seed) {}

    std::uint64_t next()
    {
        std::uint64_t z = (m_state += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// 0 ≤ … < 1.
    double share() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * share(); }
    /// 0 … count − 1.
    std::size_t below(std::size_t count)
    {
        return static_cast<std::size_t>(share() * static_cast<double>(count));
    }
    /// About a normal distribution of mean 0 and deviation 1: a sum of twelve.
    double bell()
    {
        double sum = -6.0;
        for (int i = 0; i < 12; ++i)
            sum += share();
        return sum;
    }
    template <class T>
    void shuffle(std::vector<T> &items)
    {
        for (std::size_t i = items.size(); i > 1; --i)
            std::swap(items[i - 1], items[below(i)]);
    }

private:
    std::uint64_t m_state;
};

} // namespace fff::nest
