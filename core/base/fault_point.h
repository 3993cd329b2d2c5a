// Where tests make a geometric call fail that hardly ever fails by itself, so that all that follows
// from it can be seen: what the person is told, and that no wrong file is written. Each kind of
// call that can fail on input that is in order asks failsHere() where the failure would come about.
#pragma once

#include <array>
#include <atomic>

namespace fff {

enum class FaultPoint {
    Boolean,   // regions from Clipper
    Curves,    // these with their curves
    Triangles, // of a region
    Line,      // what of a line lies in a region
    Contour    // a contour of points that may be any
};
inline constexpr std::size_t kFaultPoints = 5;

/// While it lives the calls are counted, and one of them fails. One at a time; the calls may come
/// from any thread.
class FaultWatch
{
public:
    /// Counts only.
    FaultWatch();
    /// Makes the call of this kind and number fail, the first one being 0.
    FaultWatch(FaultPoint point, int call);
    ~FaultWatch();
    FaultWatch(const FaultWatch &) = delete;
    FaultWatch &operator=(const FaultWatch &) = delete;

    int calls(FaultPoint point) const { return m_calls[static_cast<std::size_t>(point)]; }

    static bool isWatching() { return s_watch.load(std::memory_order_relaxed) != nullptr; }
    static bool count(FaultPoint point);

private:
    static std::atomic<FaultWatch *> s_watch;

    std::array<std::atomic<int>, kFaultPoints> m_calls{};
    FaultPoint m_point = FaultPoint::Boolean;
    int m_failing = -1; // none
};

/// Whether this call is to fail. Without a watch one load.
inline bool failsHere(FaultPoint point)
{
    return FaultWatch::isWatching() && FaultWatch::count(point);
}

} // namespace fff
