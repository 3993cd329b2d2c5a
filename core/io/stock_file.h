// One stock as a file, to hand around in a class: what a workshop has measured once.
#pragma once

#include "core/base/result.h"
#include "core/model/stock.h"

#include <QtCore/QString>

namespace fff::io {

/// A model without sections that has this stock alone: `.fff`, which opens like any other.
/// Errors  as writeDocument().
Result<void> writeStock(const QString &path, const Stock &stock);

/// The stock of the next section in a model of any kind, without an id: whoever has one already
/// gives it another.
/// Errors  as readDocument().
Result<Stock> readStock(const QString &path);

} // namespace fff::io
