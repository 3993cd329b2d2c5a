#include "ui/base/rich_text.h"

#include <QRegularExpression>

namespace fff::ui {

QString keepingUnits(const QString &html)
{
    constexpr QChar kNarrowSpace(0x202f);
    static const QRegularExpression percent(QStringLiteral("(\\d(?:</b>)?) %"));
    const QString kept = QString(html).replace(percent, QStringLiteral("\\1\u202f%"));
    return kept.contains(kNarrowSpace)
               ? QStringLiteral("<span style=\"white-space:pre-wrap\">%1</span>").arg(kept)
               : kept;
}

} // namespace fff::ui
