// Asks before several files replace those that are there: a file dialog asks about one only.
#pragma once

#include "core/io/file_set.h"

class QWidget;

namespace fff::ui {

/// True at once where none of them is there.
bool mayReplace(QWidget &window, const std::vector<io::NamedBytes> &files);

} // namespace fff::ui
