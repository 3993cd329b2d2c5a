#include "core/io/full_stop.h"

#include <QCoreApplication>

namespace fff {

namespace {

constexpr QChar kIdeographic(0x3002); // 。

struct FullStopTexts
{
    Q_DECLARE_TR_FUNCTIONS(FullStop)
};

} // namespace

QString withFullStop(const QString &sentence)
{
    //: %1 is a sentence; what ends one in this language
    return FullStopTexts::tr("%1.").arg(sentence);
}

QString withoutFullStop(QString sentence)
{
    if (sentence.endsWith(u'.') || sentence.endsWith(kIdeographic))
        sentence.chop(1);
    return sentence;
}

FirstSentence firstSentence(const QString &text)
{
    const qsizetype latin = text.indexOf(QStringLiteral(". "));
    const qsizetype other = text.indexOf(kIdeographic);
    if (latin >= 0 && (other < 0 || latin < other))
        return {text.first(latin), text.mid(latin + 2)};
    if (other >= 0 && other + 1 < text.size())
        return {text.first(other), text.mid(other + 1)};
    return {text, {}};
}

} // namespace fff
