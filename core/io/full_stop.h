// Where sentences end, in whatever writing: with a full stop and a blank, or with 。 alone.
#pragma once

#include <QString>

namespace fff {

/// The sentence behind which no full stop stands yet, with one.
QString withFullStop(const QString &sentence);
QString withoutFullStop(QString sentence);

struct FirstSentence
{
    QString first; // without its full stop
    QString rest;  // empty: there is no other one, and `first` is all of the text
};

FirstSentence firstSentence(const QString &text);

} // namespace fff
