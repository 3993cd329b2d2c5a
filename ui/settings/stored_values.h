// Values of the settings' file, which anybody may have written by hand: what is no value there is
// the default.
#pragma once

#include <QString>
#include <QVariant>

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace fff::ui {

template <class Value>
using Words = std::initializer_list<std::pair<Value, const char *>>;

/// The first of `words` is the default.
template <class Value>
Value valueOf(const QVariant &stored, Words<Value> words)
{
    const QString text = stored.toString();
    for (const auto &[value, word] : words) {
        if (text == QLatin1String(word))
            return value;
    }
    return words.begin()->first;
}

template <class Value>
QString wordOf(Value value, Words<Value> words)
{
    for (const auto &[known, word] : words) {
        if (known == value)
            return QLatin1String(word);
    }
    return {};
}

inline int numberOf(const QVariant &stored, int least, int most, int byDefault)
{
    bool isNumber = false;
    const int number = stored.toInt(&isNumber);
    return isNumber ? std::clamp(number, least, most) : byDefault;
}

inline bool truthOf(const QVariant &stored, bool byDefault)
{
    const QString text = stored.toString();
    return text == QStringLiteral("true")    ? true
           : text == QStringLiteral("false") ? false
                                             : byDefault;
}

} // namespace fff::ui
