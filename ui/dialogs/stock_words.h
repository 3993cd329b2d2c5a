// What is said of a stock in more than one dialog.
#pragma once

#include "core/model/materials.h"

#include <QLocale>
#include <QString>

namespace fff::ui {

/// "420 × 297 mm  (A3)"
QString sheetText(const SheetSize &sheet, const QLocale &locale);

/// How wide a slit is drawn between two sections of this stock that stand square on each other, and
/// what that is made of: "2.70 mm = 2.95 − 0.05 − 0.20". Thickness, clearance, kerf.
QString drawnSlitText(const Stock &stock, const QLocale &locale);
/// What that is, for a tip.
QString drawnSlitTip();
/// "K40 with MeerK40t: 0.2 mm, Trotec: 0.12 mm": what machines remove of it, where that is known.
QString machineKerfsText(const Stock &stock, const QLocale &locale);

} // namespace fff::ui
