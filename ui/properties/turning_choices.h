// How parts may be turned on their sheets, to choose.
#pragma once

#include "core/nesting/problem.h"
#include "ui/properties/choice_box.h"

namespace fff::ui {

Choices turningChoices(nest::Turning current);
nest::Turning turningOf(int choice);

} // namespace fff::ui
