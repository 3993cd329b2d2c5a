#include "ui/base/rich_text.h"

namespace fff::ui {

QString keepingUnits(const QString &html)
{
    constexpr QChar kNarrowSpace(0x202f);
    return html.contains(kNarrowSpace)
               ? QStringLiteral("<span style=\"white-space:pre-wrap\">%1</span>").arg(html)
               : html;
}

} // namespace fff::ui
