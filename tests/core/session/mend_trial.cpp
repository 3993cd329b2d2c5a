#include "tests/core/session/mend_trial.h"

#include "core/analysis/findings/standing.h"
#include "core/analysis/findings/strength_findings.h"
#include "core/io/fff_file.h"
#include "core/session/message_text.h"
#include "core/session/session.h"

#include <algorithm>
#include <array>
#include <map>

namespace fff::test {

namespace {

constexpr Subject kSubjects[] = {Subject::Connection, Subject::Stability, Subject::Assembly,
                                 Subject::Strength,   Subject::Size,      Subject::Joints};

int weightOf(const Finding &finding)
{
    return finding.kind->weight ? finding.kind->weight(finding) : 1;
}

/// How many of what a person would see in red, and how many in amber.
std::pair<int, int> seenOf(const std::vector<Finding> &all, Subject subject)
{
    std::pair<int, int> seen;
    for (const Finding &finding : all) {
        if (finding.subject() != subject)
            continue;
        if (finding.severity == Severity::Error)
            seen.first += weightOf(finding);
        else if (finding.severity == Severity::Warning)
            seen.second += weightOf(finding);
    }
    return seen;
}

/// Of what is said of certain sections: its kind and their ids.
std::string keyOf(const Finding &finding)
{
    std::string key = finding.kind->name;
    for (const auto *refs : {&finding.sections, &finding.others}) {
        key += ':';
        for (const SectionRef &ref : *refs)
            key += std::to_string(ref.drawn.value) + ' ';
    }
    return key;
}

/// Errors and warnings, by that.
std::map<std::string, std::pair<int, int>> seenOfEach(const std::vector<Finding> &all)
{
    std::map<std::string, std::pair<int, int>> seen;
    for (const Finding &finding : all) {
        if (finding.severity == Severity::Error)
            seen[keyOf(finding)].first += weightOf(finding);
        else if (finding.severity == Severity::Warning)
            seen[keyOf(finding)].second += weightOf(finding);
    }
    return seen;
}

/// Notes are no fault.
Severity faultIn(const std::vector<Finding> &all, Subject subject)
{
    Severity fault = Severity::Good;
    for (const Finding &finding : all)
        if (finding.subject() == subject && finding.severity != Severity::Note)
            fault = std::max(fault, finding.severity);
    return fault;
}

bool isSaid(const std::vector<Finding> &all, Subject subject)
{
    return std::any_of(all.begin(), all.end(), [subject](const Finding &finding) {
        return finding.subject() == subject && finding.severity != Severity::Note;
    });
}

QString worseOf(const std::vector<Finding> &before, const std::vector<Finding> &after)
{
    // Of what did not stand nobody could say whether it holds.
    const auto isSilent = [&before](Subject subject) {
        return subject == Subject::Strength && !isSaid(before, subject);
    };
    for (const Subject subject : kSubjects)
        if (!isSilent(subject) && (seenOf(after, subject) > seenOf(before, subject) ||
                                   faultIn(after, subject) > faultIn(before, subject)))
            return QStringLiteral("it is worse by subject %1").arg(static_cast<int>(subject));
    for (const Finding &finding : after) {
        const Footing *is = finding.is(kUnsteady) ? finding.details<Footing>() : nullptr;
        for (const Finding &known : before)
            if (is && known.is(kUnsteady) &&
                is->tipAngle < 0.89 * known.details<Footing>()->tipAngle)
                return QStringLiteral("it tips more easily");
    }
    // Weights that lie on material stay there.
    const auto beside = [](const std::vector<Finding> &all) {
        return std::count_if(all.begin(), all.end(),
                             [](const Finding &finding) { return finding.is(kWeightBeside); });
    };
    if (beside(after) > beside(before))
        return QStringLiteral("a weight is off the material");
    // Of the very same sections: what was in two pieces is not in three.
    const auto was = seenOfEach(before);
    for (const auto &[key, is] : seenOfEach(after))
        if (const auto known = was.find(key); known != was.end() && is > known->second)
            return QStringLiteral("it is worse: ") + QString::fromStdString(key);
    return {};
}

bool isLess(const Finding &finding, const std::vector<Finding> &before,
            const std::vector<Finding> &after)
{
    const auto was = seenOfEach(before), is = seenOfEach(after);
    const auto left = is.find(keyOf(finding));
    const auto known = was.find(keyOf(finding));
    return left == is.end() || known == was.end() || left->second < known->second;
}

/// Of each kind so many as are not there any more, whomever they are about: what is less grave than
/// before was solved as far as that, what is graver was not.
int solvedIn(const std::vector<Finding> &before, const std::vector<Finding> &after)
{
    std::map<const FindingKind *, std::array<int, 2>> was, is; // warnings and errors
    for (const Finding &finding : before)
        if (finding.severity >= Severity::Warning)
            ++was[finding.kind][finding.severity == Severity::Error];
    for (const Finding &finding : after)
        if (finding.severity >= Severity::Warning)
            ++is[finding.kind][finding.severity == Severity::Error];
    int solved = 0;
    for (const auto &[kind, counts] : was) {
        const int moreErrors = std::max(0, is[kind][1] - counts[1]);
        solved += std::max(0, counts[1] - is[kind][1]) +
                  std::max(0, counts[0] - is[kind][0] - moreErrors);
    }
    return solved;
}

/// What is promised in numbers is counted in the documents themselves.
QString falseWordsOf(const Mend &mend, const Document &before, const Staged &was, const Staged &is)
{
    const QString said = messageText(mend.changes);
    const auto claim = [&](int count, const char *one, const char *many) -> QString {
        const QString words = count == 1 ? QString::fromLatin1(one)
                                         : QString::number(count) + QString::fromLatin1(many);
        const bool says =
            said.contains(QString::fromLatin1(one)) || said.contains(QString::fromLatin1(many));
        return count > 0 ? said.contains(words) ? QString() : words : says ? words : QString();
    };
    const Document &after = mend.edit->document;
    int made = 0, gone = 0, moved = 0, turned = 0, reshaped = 0;
    for (const SectionPointer &section : after.sections) {
        const Section *old = before.find(section->id);
        made += old == nullptr;
        reshaped += old && old->shape != section->shape;
        if (!old || old->shape != section->shape || old->frame == section->frame)
            continue;
        const bool isTurned =
            (old->frame.x - section->frame.x).norm() + (old->frame.y - section->frame.y).norm() >
            0.01; // no unit
        ++(isTurned ? turned : moved);
    }
    for (const SectionPointer &section : before.sections)
        gone += after.find(section->id) == nullptr;
    const QString wrong[] = {
        claim(made, " added", " sections added"),
        claim(gone, " deleted", " sections deleted"),
        claim(moved, " moved by ", " sections moved"),
        claim(turned, " turned by ", " sections turned"),
        claim(reshaped, " reshaped", " sections reshaped"),
        claim(solvedIn(was.found, is.found), "1 problem solved", " problems solved")};
    for (const QString &words : wrong)
        if (!words.isEmpty())
            return QStringLiteral("\"%1\" does not say \"%2\" as it is").arg(said, words);
    if (said.contains(QStringLiteral("nothing more is cut through")))
        for (std::size_t i = 0; i < was.analysis->model.sectionCount(); ++i) {
            const int now = is.analysis->model.indexOf(was.analysis->model.ref(i));
            if (now >= 0 && is.analysis->bodies.countOf(now) >
                                was.analysis->bodies.countOf(static_cast<int>(i)))
                return QStringLiteral("\"%1\", but something is").arg(said);
        }
    const QString again =
        messageText(changesBetween(*was.analysis, *is.analysis, was.found, is.found));
    return said == again ? QString() : QStringLiteral("\"%1\", but \"%2\"").arg(said, again);
}

} // namespace

QString faultOf(const Mend &mend, const Finding &finding, const Document &document,
                const Staged &before)
{
    const Staged after = staged(mend.edit->document);
    if (!after.analysis)
        return QStringLiteral("a stage fails of it");
    if (const QString worse = worseOf(before.found, after.found); !worse.isEmpty())
        return worse;
    if (!isLess(finding, before.found, after.found))
        return QStringLiteral("what it is to mend is as it was");
    if (const QString words = falseWordsOf(mend, document, before, after); !words.isEmpty())
        return words;
    const std::string file = *io::writeFffFile(document);
    Session session;
    session.reset(document);
    session.commit(messageText(mend.edit->step.words), mend.edit->document);
    if (*io::writeFffFile(session.committed().document) == file)
        return QStringLiteral("it does nothing");
    session.history()->undo();
    if (!session.committed().document.isSame(document) ||
        *io::writeFffFile(session.committed().document) != file)
        return QStringLiteral("undo gives back something else");
    return {};
}

} // namespace fff::test
