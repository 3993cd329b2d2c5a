// How a language writes what people type into number fields (core/base/expression.h), and what is
// said of what cannot be read.
#pragma once

#include "core/base/expression.h"

#include <QString>

class QLocale;

namespace fff::ui {

Commas commasOf(const QLocale &locale);

/// One sentence for the person who typed it; empty without a fault.
QString refusalText(const Expression &expression);

} // namespace fff::ui
