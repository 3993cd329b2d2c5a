// What a long computation is told by whoever waits for it, and tells them.
#pragma once

#include <functional>
#include <stop_token>

namespace fff {

struct LongWork
{
    std::stop_token stop;
    std::function<void(double)> progress; // given 0 … 1, never falling; may be empty

    bool isStopped() const { return stop.stop_requested(); }
    void tell(double share) const
    {
        if (progress)
            progress(share);
    }
};

} // namespace fff
