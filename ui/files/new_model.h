// What a new model begins with.
#pragma once

#include "core/model/document.h"

namespace fff::ui {

/// The model that Settings::newModelFile() names, else an empty one. One that cannot be read is
/// told of in the log.
Document newModel();

} // namespace fff::ui
