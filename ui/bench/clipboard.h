// The system's clipboard, for what is copied: a model's text, which other programs can keep too.
#pragma once

#include "core/session/copy_commands.h"

#include <string>

class QMimeData;

namespace fff::ui {

Clipboard systemClipboard();
/// What of it may be a model.
std::string modelTextIn(const QMimeData &data);

} // namespace fff::ui
