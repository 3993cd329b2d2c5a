#include "ui/settings/check_rules.h"

#include "core/base/units.h"
#include "ui/settings/settings.h"

namespace fff::ui {

CheckRules checkRules(const Settings &settings)
{
    return {radians(settings.shallowAngle()), 0.001 * settings.touching(),
            std::chrono::milliseconds(settings.planningTime())};
}

} // namespace fff::ui
