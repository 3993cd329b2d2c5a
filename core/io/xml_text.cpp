#include "core/io/xml_text.h"

#include <QtCore/QString>

#include <algorithm>

namespace fff::io {

namespace {

bool isPlainText(const std::string &text)
{
    return std::all_of(text.begin(), text.end(), [](char c) {
        return c >= ' ' && c <= '~' && c != '&' && c != '<' && c != '>' && c != '"';
    });
}

} // namespace

std::string escaped(const std::string &text)
{
    if (isPlainText(text))
        return text;
    QString result;
    for (const QChar c : QString::fromStdString(text)) {
        if (c == QLatin1Char('&'))
            result += QStringLiteral("&amp;");
        else if (c == QLatin1Char('<'))
            result += QStringLiteral("&lt;");
        else if (c == QLatin1Char('>'))
            result += QStringLiteral("&gt;");
        else if (c == QLatin1Char('"'))
            result += QStringLiteral("&quot;");
        else if ((c < QLatin1Char(' ') && c != QLatin1Char('\t') && c != QLatin1Char('\n') &&
                  c != QLatin1Char('\r')) ||
                 c.unicode() >= 0xFFFE)
            result += QChar(QChar::ReplacementCharacter);
        else
            result += c;
    }
    return result.toStdString();
}

} // namespace fff::io
