// What the checks go by, as a person has set it.
#pragma once

#include "core/analysis/checks.h"

namespace fff::ui {

class Settings;

/// From degrees and milliseconds.
CheckRules checkRules(const Settings &settings);

} // namespace fff::ui
