#include "ui/view/heading_weight.h"

#include <QLocale>

namespace fff::ui {

QFont::Weight headingWeight()
{
    const QLocale::Language language = QLocale().language();
    return language == QLocale::Chinese || language == QLocale::Japanese ? QFont::Bold
                                                                         : QFont::DemiBold;
}

} // namespace fff::ui
