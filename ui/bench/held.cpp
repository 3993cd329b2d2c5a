#include "ui/bench/held.h"

#include "core/analysis/accurate.h"
#include "core/session/scheduler.h"

namespace fff::ui {

std::shared_ptr<const Holding> heldNow(const Scheduler &scheduler)
{
    const auto accurate = scheduler.result(kAccurate);
    if (accurate && accurate->held && !scheduler.failureOf(kAccurate.name) &&
        scheduler.revisionOf(kAccurate.name) == scheduler.revisionOf(kHolding.name))
        return accurate->held;
    return scheduler.result(kHolding);
}

std::shared_ptr<const BentModel> bentNow(const Scheduler &scheduler)
{
    const auto accurate = scheduler.result(kAccurate);
    return accurate && accurate->held && heldNow(scheduler) == accurate->held ? accurate->bent
                                                                              : nullptr;
}

std::optional<Movement> movementNow(const Scheduler &scheduler)
{
    const auto held = heldNow(scheduler);
    if (!held || scheduler.age(kHolding.name) != Scheduler::Age::Current)
        return {};
    return movementOf(*held, bentNow(scheduler));
}

bool isOfHolding(std::string_view stage)
{
    return stage == kHolding.name || stage == kAccurate.name;
}

} // namespace fff::ui
