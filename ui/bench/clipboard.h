// The system's clipboard, for what is copied: a model's text, which other programs can keep too.
#pragma once

#include "core/session/copy_commands.h"

namespace fff::ui {

Clipboard systemClipboard();

} // namespace fff::ui
