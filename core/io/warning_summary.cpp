#include "core/io/warning_summary.h"

#include "core/io/error_text.h"
#include "core/io/full_stop.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <utility>
#include <vector>

namespace fff::io {

namespace {

struct SummaryTexts
{
    Q_DECLARE_TR_FUNCTIONS(Error)
};

/// What happened to several, 2 or more.
QString sentenceOfMany(WarningCode code, int count)
{
    switch (code) {
    case WarningCode::SkewFrame:
        return SummaryTexts::tr("%n sections were slightly skewed and have been straightened.",
                                nullptr, count);
    case WarningCode::SelfCrossingContour:
        return SummaryTexts::tr(
            "%n contours crossed themselves; the largest loop of each was kept.", nullptr, count);
    case WarningCode::HoleOutside:
        return SummaryTexts::tr("%n holes reached beyond their contours and were left out.",
                                nullptr, count);
    case WarningCode::DegenerateHole:
        return SummaryTexts::tr("%n holes had no area and were left out.", nullptr, count);
    case WarningCode::MergedHoles:
        return SummaryTexts::tr("Holes of %n sections overlapped and were merged.", nullptr, count);
    case WarningCode::NotchedContour:
        return SummaryTexts::tr("%n holes reached beyond their contours and were cut out of them.",
                                nullptr, count);
    case WarningCode::TrailingLines:
        return SummaryTexts::tr("Text after the last section was ignored in %n places.", nullptr,
                                count);
    case WarningCode::MissingBlob:
        return SummaryTexts::tr("%n pictures or meshes could not be read and were left out.",
                                nullptr, count);
    case WarningCode::MissingTemplate:
        return SummaryTexts::tr("%n templates could not be read; their places were kept.", nullptr,
                                count);
    case WarningCode::LostBinding:
        return SummaryTexts::tr("%n numbers no longer follow what was typed for them.", nullptr,
                                count);
    }
    return {}; // not reached: every code is above
}

} // namespace

QString wholeSentence(const Warning &warning)
{
    QString sentence = warningSentence(warning);
    const bool beginsWithName = !warning.args.empty() && !warning.args.front().empty() &&
                                sentence.startsWith(QString::fromStdString(warning.args.front()));
    if (!beginsWithName)
        sentence = sentence.left(1).toUpper() + sentence.mid(1);
    return withFullStop(sentence);
}

QStringList warningSummary(std::span<const Warning> warnings)
{
    std::vector<std::pair<const Warning *, int>> kinds; // the first of each, and how many
    for (const Warning &warning : warnings) {
        const auto known = std::find_if(kinds.begin(), kinds.end(), [&](const auto &kind) {
            return kind.first->code == warning.code;
        });
        if (known == kinds.end())
            kinds.emplace_back(&warning, 1);
        else
            ++known->second;
    }
    QStringList sentences;
    for (const auto &[first, count] : kinds)
        sentences += count == 1 ? wholeSentence(*first) : sentenceOfMany(first->code, count);
    return sentences;
}

QStringList warningLines(std::span<const Warning> warnings)
{
    QStringList lines;
    for (const Warning &warning : warnings)
        lines += warningText(warning);
    return lines;
}

} // namespace fff::io
