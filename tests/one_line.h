// Whether a text is one line that steers nothing: what is said of a file must not have the file's
// control characters in it.
#pragma once

#include <QString>

#include <algorithm>

namespace fff::test {

inline bool isOneLine(const QString &text)
{
    return std::none_of(text.begin(), text.end(), [](QChar c) {
        return c.category() == QChar::Other_Control || c.category() == QChar::Separator_Line ||
               c.category() == QChar::Separator_Paragraph;
    });
}

} // namespace fff::test
