// The sentence of the status bar for what the next gesture does (ui/UI.md, section 8).
#pragma once

#include "core/interaction/interaction.h"

#include <QString>

namespace fff::ui {

/// Rich text: names and what is to be pressed are bold.
QString hintSentence(const Hint &hint);

} // namespace fff::ui
