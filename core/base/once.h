// What is worked out when it is first asked for, once, from any thread.
#pragma once

#include <atomic>

namespace fff {

/// In place of std::once_flag, which calls the system after every run, whether or not anybody
/// waits: with thousands of small things that takes longer than the work. A run that throws counts
/// as none; who waited for it tries next.
class Once
{
public:
    template <class Work>
    void run(Work work)
    {
        if (m_state.load(std::memory_order_acquire) == kDone || !begin())
            return;
        try {
            work();
        } catch (...) {
            end(kNotYet);
            throw;
        }
        end(kDone);
    }

private:
    enum State : int { kNotYet, kRunning, kAwaited, kDone };

    /// Whether this thread has to do it; else it is done.
    bool begin()
    {
        for (;;) {
            int state = kNotYet;
            if (m_state.compare_exchange_strong(state, kRunning, std::memory_order_acquire))
                return true;
            if (state == kDone)
                return false;
            if (state == kAwaited ||
                m_state.compare_exchange_strong(state, kAwaited, std::memory_order_acquire))
                m_state.wait(kAwaited, std::memory_order_acquire);
        }
    }
    void end(State state)
    {
        if (m_state.exchange(state, std::memory_order_release) == kAwaited)
            m_state.notify_all();
    }

    std::atomic<int> m_state = kNotYet;
};

} // namespace fff
