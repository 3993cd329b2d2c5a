// Lengths as people read them: in the unit that they have set. Everything else has millimetres.
#pragma once

#include "ui/settings/settings.h"

#include <QLocale>
#include <QString>

namespace fff::ui {

/// "Millimetres"
QString unitName(LengthUnit unit);

/// The number alone, in the unit that is set; the digits are those for millimetres, larger units
/// get one more.
QString lengthNumber(double millimetres, int least, int most, const QLocale &locale);
/// "84.0 mm"
QString lengthText(double millimetres, int least, int most, const QLocale &locale);

} // namespace fff::ui
