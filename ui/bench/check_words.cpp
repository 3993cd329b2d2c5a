#include "ui/bench/check_words.h"

#include "core/analysis/findings/of_sections.h"
#include "core/io/full_stop.h"
#include "core/session/message_text.h"
#include "ui/base/theme.h"
#include "ui/bench/measures.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>
#include <variant>

namespace fff::ui {

namespace {

struct CheckTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::CheckWords)
};

int rankOf(Severity severity)
{
    switch (severity) {
    case Severity::Error:
        return 0;
    case Severity::Warning:
        return 1;
    case Severity::Unknown:
        return 2;
    case Severity::Good:
        return 3;
    case Severity::Note:
        return 4;
    }
    return 4; // not reached: every severity is above
}

} // namespace

CheckWords checkWords(const Finding &finding, const Model &model)
{
    const UnitWords units = unitsInUse();
    Message said = finding.kind->sentence(finding, model);
    QString whose;
    if (said.text == kOfSections) { // a heading is short: names come below it
        whose = argumentText(said.arguments.front(), units);
        said = Message(std::get<Message>(said.arguments.back()));
    }
    const QString whole = messageText(said, units);
    const FirstSentence split = firstSentence(whole);
    // Its first sentence is the verdict.
    const bool isVerdictFirst = !split.rest.isEmpty() && !finding.isYet;
    const QString title = isVerdictFirst ? split.first : verdictText(finding);
    const QString text = split.rest.isEmpty() ? whole : split.rest;
    if (whose.isEmpty())
        return {title, text};
    //: %1 names sections, %2 is a sentence about them such as "Tips only past 12°."
    return {title, CheckTexts::tr("%1: %2").arg(whose, text)};
}

QString verdictText(const Finding &finding)
{
    return messageText(titleOf(finding), unitsInUse());
}

QString mendText(const Mend &mend, const Finding &finding, const Model &model)
{
    if (mend.edit && mend.edit->offered.text.source)
        return messageText(mend.edit->offered, unitsInUse());
    return messageText(mend.action.kind->words(mend.action, finding, model), unitsInUse());
}

QString checkGlyph(Severity severity)
{
    switch (severity) {
    case Severity::Good:
        return QStringLiteral("check");
    case Severity::Unknown:
        return QStringLiteral("unknown");
    case Severity::Note:
        return QStringLiteral("note");
    case Severity::Warning:
        return QStringLiteral("warn");
    case Severity::Error:
        return QStringLiteral("err");
    }
    return {};
}

QColor checkColour(Severity severity)
{
    switch (severity) {
    case Severity::Good:
        return theme().good;
    case Severity::Unknown:
    case Severity::Note:
        return theme().muted;
    case Severity::Warning:
        return theme().warning;
    case Severity::Error:
        return theme().problem;
    }
    return {};
}

bool comesBefore(const Finding &a, const Finding &b)
{
    const auto rank = [](const Finding &finding) {
        return std::pair(
            rankOf(finding.severity),
            std::find(kBadgeSubjects.begin(), kBadgeSubjects.end(), finding.subject()));
    };
    return rank(a) < rank(b);
}

QString severityWord(Severity severity)
{
    switch (severity) {
    case Severity::Good:
        return CheckTexts::tr("Good");
    case Severity::Unknown:
        return CheckTexts::tr("Unknown");
    case Severity::Note:
        return CheckTexts::tr("Note");
    case Severity::Warning:
        return CheckTexts::tr("Warning");
    case Severity::Error:
        return CheckTexts::tr("Problem");
    }
    return {};
}

} // namespace fff::ui
