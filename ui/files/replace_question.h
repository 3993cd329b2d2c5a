// Asks before files replace those that are there: a file dialog asks about one only, and only when
// it has the name that is written.
#pragma once

#include "core/io/file_set.h"

class QWidget;

namespace fff::ui {

/// True at once where none of them is there.
bool mayReplace(QWidget &window, const std::vector<io::NamedBytes> &files);

} // namespace fff::ui
