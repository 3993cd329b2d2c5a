#include "ui/dialogs/stock_words.h"

#include "core/io/machine_library.h"
#include "ui/bench/measures.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

struct StockWordsTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::StockFields)
};

// Names of sheets (core/model/materials.cpp), for lupdate.
[[maybe_unused]] const char *const kSheetNames[] = {
    QT_TRANSLATE_NOOP("fff::ui::Sheet", "A4"),
    QT_TRANSLATE_NOOP("fff::ui::Sheet", "A3"),
    QT_TRANSLATE_NOOP("fff::ui::Sheet", "Letter"),
    QT_TRANSLATE_NOOP("fff::ui::Sheet", "K40 laser"),
    QT_TRANSLATE_NOOP("fff::ui::Sheet", "12 × 20 in"),
    QT_TRANSLATE_NOOP("fff::ui::Sheet", "Whole plywood board"),
};

} // namespace

QString sheetText(const SheetSize &sheet, const QLocale &locale)
{
    const QString size = sizeText({sheet.size.x(), sheet.size.y()}, 0, locale);
    return *sheet.name ? QStringLiteral("%1  (%2)")
                             .arg(size, QCoreApplication::translate("fff::ui::Sheet", sheet.name))
                       : size;
}

QString drawnSlitText(const Stock &stock, const QLocale &locale)
{
    const double width = stock.thickness + stock.clearance - stock.kerf;
    if (width <= 0.0)
        return StockWordsTexts::tr("none: the kerf is wider than the slit");
    const auto text = [&locale](double mm) { return lengthNumber(mm, 2, 3, locale); };
    // A clearance below 0 presses: it is taken off, as the kerf is.
    const QString sum = stock.clearance < 0.0 ? QStringLiteral("%1 = %2 − %3 − %4")
                                              : QStringLiteral("%1 = %2 + %3 − %4");
    return sum.arg(lengthText(width, 2, 3, locale), text(stock.thickness),
                   text(std::abs(stock.clearance)), text(stock.kerf));
}

QString machineKerfsText(const Stock &stock, const QLocale &locale)
{
    QStringList kerfs;
    for (const MachineKerf &one : stock.kerfs) {
        const auto library = io::machineLibrary();
        const auto known = std::find_if(library.begin(), library.end(), [&](const auto &machine) {
            return machine->key == one.machine;
        });
        const std::string &name = known != library.end() ? (*known)->name : one.machine;
        kerfs += QStringLiteral("%1: %2").arg(QString::fromStdString(name),
                                              lengthText(one.kerf, 2, 3, locale));
    }
    return kerfs.join(QStringLiteral(", "));
}

QString drawnSlitTip()
{
    return StockWordsTexts::tr("Thickness, clearance and kerf of two sections of this stock that "
                               "stand square on each other");
}

} // namespace fff::ui
