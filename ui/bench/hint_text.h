// The sentence of the status bar for what the next gesture does (ui/UI.md, section 8).
#pragma once

#include "core/model/hint.h"

#include <QString>

namespace fff::ui {

/// With marks (ui/sentence_label.h): names and what is to be pressed are bold.
///
/// undoKeys  the keys that undo now, as people write them; empty: there are none
QString hintSentence(const Hint &hint, const QString &undoKeys);

} // namespace fff::ui
