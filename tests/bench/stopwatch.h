// CPU time of the calling thread: what the work costs, not how long others kept it waiting.
#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

namespace fff::bench {

/// Milliseconds of CPU time that this thread has used.
inline double threadMilliseconds()
{
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

/// The middle one; the lower of two. Not of an empty list.
inline double median(std::vector<double> values)
{
    const auto middle =
        values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / std::size_t(2));
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Milliseconds that `work` takes; what it makes is destroyed outside of the measured time.
template <class Work>
auto timed(double &milliseconds, Work &&work)
{
    const double begin = threadMilliseconds();
    auto result = work();
    milliseconds = threadMilliseconds() - begin;
    return result;
}

} // namespace fff::bench
