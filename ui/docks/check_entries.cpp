#include "ui/docks/check_entries.h"

#include "core/analysis/findings/total_mass.h"
#include "core/fabrication/summary.h"
#include "core/session/check_list.h"
#include "core/session/message_text.h"
#include "ui/base/theme.h"
#include "ui/bench/check_words.h"

#include <QCoreApplication>

#include <algorithm>

namespace fff::ui {

namespace {

struct CheckEntryTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::ChecksDock)
};

/// With what a person can do themselves.
QString withAdvice(const QString &text, const Finding &finding)
{
    const Text advised = adviceOf(finding);
    if (!advised.source)
        return text;
    const QString advice = messageText(advised);
    return text.isEmpty() ? advice : text + u' ' + advice;
}

/// Of many: what they have in common, and the sentence of the one that is looked at.
CheckWords wordsOf(const CheckEntry &entry, const Model &model)
{
    CheckWords words = checkWords(entry.finding(), model);
    if (entry.count() == 1)
        return words;
    const QString title = verdictText(entry.finding());
    const QString sentence = words.title == title ? words.text
                             : words.text.isEmpty()
                                 ? words.title
                                 : words.title + QStringLiteral(". ") + words.text;
    //: %1 is what is wrong, such as "Sections overlap"
    return {
        CheckEntryTexts::tr("%1 in %n places", nullptr, entry.count()).arg(title),
        //: %1 of %2 places, and the sentence about that one
        CheckEntryTexts::tr("%1 of %2: %3").arg(entry.place + 1).arg(entry.count()).arg(sentence)};
}

std::optional<Vec3> placeOf(const Finding &finding, const Model &model)
{
    if (finding.at)
        return finding.at;
    Box3 box;
    for (const SectionRef &ref : finding.sections)
        if (const int index = model.indexOf(ref); index >= 0) {
            const Section &section = *model.section(static_cast<std::size_t>(index));
            box.extend(slabBounds(section, model.document.stockOf(section)));
        }
    return box.isEmpty() ? std::nullopt : std::optional(Vec3(box.center()));
}

} // namespace

bool isProblem(const Finding &finding)
{
    return finding.severity >= Severity::Warning;
}

int CheckEntry::placeOf(const Finding &finding) const
{
    // Between the same sections there may be several: it is the one at the same place, if any is.
    int same = -1;
    for (std::size_t i = 0; i < row.all.size(); ++i) {
        if (!isSameVerdict(row.all[i], finding))
            continue;
        if (row.all[i].at == finding.at)
            return static_cast<int>(i);
        same = same < 0 ? static_cast<int>(i) : same;
    }
    return same;
}

std::vector<CheckEntry> checkEntries(const CheckList &list, const std::vector<CheckEntry> &before)
{
    std::vector<CheckEntry> entries;
    for (FindingRow &row : inRows(list.all()))
        if (!row.finding.is(kMass)) // good or bad it is neither: the status bar has it
            entries.push_back({std::move(row)});
    std::stable_sort(entries.begin(), entries.end(), [](const CheckEntry &a, const CheckEntry &b) {
        return comesBefore(a.row.finding, b.row.finding);
    });
    int number = 0;
    for (CheckEntry &entry : entries) {
        if (isProblem(entry.row.finding))
            entry.number = ++number;
        for (const CheckEntry &old : before)
            if (const int place = entry.placeOf(old.finding()); old.count() > 1 && place >= 0)
                entry.place = place;
        if (entry.count() > 1)
            for (const Mend &mend : list.mendsOf(entry.row.finding))
                entry.offers.push_back({mend, entry.row.finding});
        for (const Mend &mend : list.mendsOf(entry.finding()))
            entry.offers.push_back({mend, entry.finding()});
    }
    return entries;
}

CheckRow::Content contentOf(const CheckEntry &entry, const CheckList &list)
{
    const bool isOlder = list.age() != CheckList::Age::Current;
    const Finding &finding = entry.finding();
    CheckWords words = wordsOf(entry, list.model());
    if (isProblem(finding) && list.isMendless(finding))
        words.text = withAdvice(words.text, finding);
    QStringList links;
    for (const CheckEntry::Offer &offer : entry.offers)
        links += mendText(offer.mend, offer.finding, list.model());
    const QColor colour = isOlder && finding.severity == Severity::Good
                              ? theme().muted
                              : checkColour(finding.severity);
    return {checkGlyph(finding.severity),
            colour,
            severityWord(finding.severity),
            entry.number,
            words.title,
            words.text,
            links,
            isOlder};
}

std::vector<ProblemMark> marksOf(const std::vector<CheckEntry> &entries, const Model &model,
                                 const std::optional<Finding> &chosen)
{
    std::vector<ProblemMark> marks;
    for (const CheckEntry &entry : entries) {
        if (entry.number == 0)
            continue;
        const int chosenPlace = chosen ? entry.placeOf(*chosen) : -1;
        for (int place = 0; place < entry.count(); ++place) {
            const Finding &finding = entry.row.all[static_cast<std::size_t>(place)];
            const std::optional<Vec3> at = placeOf(finding, model);
            if (!at)
                continue;
            const CheckWords words = checkWords(finding, model);
            const QString said = words.text.isEmpty()
                                     ? words.title
                                     : words.title + QStringLiteral(". ") + words.text;
            marks.push_back({entry.number, *at, finding.sections,
                             finding.severity == Severity::Error, place, place == chosenPlace,
                             said.toStdString()});
        }
    }
    return marks;
}

} // namespace fff::ui
