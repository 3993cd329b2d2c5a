// The names that new and imported sections get, in the language of the window.
#pragma once

#include "core/model/naming.h"

namespace fff::ui {

/// With the patterns of all other languages that the program speaks: a model that two people draw
/// in two languages has no number twice.
Naming naming();

} // namespace fff::ui
