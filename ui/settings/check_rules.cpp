#include "ui/settings/check_rules.h"

#include "core/base/units.h"
#include "ui/settings/settings.h"

namespace fff::ui {

CheckRules checkRules(const Settings &settings)
{
    CheckRules rules;
    rules.shallowAngle = radians(settings.shallowAngle());
    rules.touching = 0.001 * settings.touching();
    rules.planningTime = std::chrono::milliseconds(settings.planningTime());
    constexpr double kTenth = 0.1;
    rules.strength.safety = kTenth * settings.safetyFactor();
    rules.strength.notch.cap = kTenth * settings.notchFactor();
    rules.strength.isLasting = settings.isLoadLasting();
    rules.strength.isElastic = settings.bendsSections();
    return rules;
}

} // namespace fff::ui
