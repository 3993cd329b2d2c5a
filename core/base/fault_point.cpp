#include "core/base/fault_point.h"

#include <cassert>

namespace fff {

std::atomic<FaultWatch *> FaultWatch::s_watch = nullptr;

FaultWatch::FaultWatch()
{
    [[maybe_unused]] FaultWatch *other = s_watch.exchange(this);
    assert(!other && "one watch at a time");
}

FaultWatch::FaultWatch(FaultPoint point, int call) : FaultWatch()
{
    m_point = point;
    m_failing = call;
}

FaultWatch::~FaultWatch()
{
    s_watch = nullptr;
}

bool FaultWatch::count(FaultPoint point)
{
    FaultWatch *watch = s_watch.load();
    if (!watch)
        return false;
    const int call = watch->m_calls[static_cast<std::size_t>(point)]++;
    return point == watch->m_point && call == watch->m_failing;
}

} // namespace fff
