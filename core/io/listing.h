// Lists within sentences, as the language of the window writes them.
#pragma once

#include <QString>
#include <QStringList>

namespace fff {

/// "a, b, c"; in Japanese "a、b、c".
QString separated(const QStringList &list);

namespace io {

/// "a, b or c": lastTwo is "%1 or %2" in the language of the list.
/// between  what separates the others; empty: as separated() has it
QString enumerated(const QStringList &list, const QString &lastTwo, const QString &between = {});

} // namespace io
} // namespace fff
