// What the checks go by, as a person has set it.
#pragma once

#include "core/analysis/check_rules.h"

namespace fff::ui {

class Settings;

/// From degrees and milliseconds.
CheckRules checkRules(const Settings &settings);

} // namespace fff::ui
