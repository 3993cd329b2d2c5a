#include "core/session/check_list.h"

#include "core/analysis/analysed.h"
#include "core/analysis/findings/doubted_verdicts.h"
#include "core/analysis/findings/few_sheets.h"
#include "core/analysis/findings/sheet_fit.h"
#include "core/analysis/findings/standing.h"
#include "core/analysis/nested.h"
#include "core/analysis/pulling.h"
#include "core/session/session.h"
#include "core/session/set_aside.h"

#include <algorithm>
#include <utility>

namespace fff {

namespace {

/// Of a model that is only begun.
Finding soFar(Finding finding)
{
    if (finding.severity == Severity::Error && finding.kind->yet.source) {
        finding.severity = Severity::Unknown;
        finding.isYet = true;
    }
    return finding;
}

} // namespace

CheckList::CheckList(const Session &session, const QString &reports, QObject *parent)
    : QObject(parent), m_session(session), m_scheduler(session.scheduler()), m_reportFolder(reports)
{
    connect(&m_scheduler, &Scheduler::published, this, &CheckList::take);
    connect(&m_scheduler, &Scheduler::aged, this, &CheckList::changed);
    connect(&session, &Session::modelChanged, this, [this](const Model &, const Model &now) {
        if (now.sectionCount() == 0) // nothing follows from nothing
            refresh();
    });
    for (const Stage &stage : m_scheduler.stages())
        if (stage.findings)
            m_scheduler.want(stage.name);
    m_scheduler.want(kMends.name);
    for (const Stage &stage : m_scheduler.stages())
        take(stage.name);
}

void CheckList::take(std::string_view stage)
{
    m_results[stage] = m_scheduler.resultNamed(stage);
    if (stage == kVerdicts.name)
        m_verdicts = m_scheduler.result(kVerdicts);
    else if (stage == kPlanned.name)
        m_plan = m_scheduler.result(kPlanned);
    else if (const auto nested = m_scheduler.result(kNested); nested && nested->question)
        m_nested = nested; // stays when nobody looks at it any more
    const std::optional<Error> &why = m_scheduler.failureOf(stage);
    const bool wasFailing = m_failing.contains(stage);
    if (why)
        keepReport(stage, *why);
    else
        m_failing.erase(stage);
    // Each place of a drag has joints before it has verdicts: the list follows from those alone.
    // Nor does it from magnets where there are none, unless it waits for the last stage to end.
    const auto pulled = stage == kPulled.name ? m_scheduler.result(kPulled) : nullptr;
    const bool isNothing = pulled && pulled->all.empty() && m_failing.empty();
    if ((stage != kAnalysed.name && !isNothing) || why || wasFailing)
        refresh();
}

/// Of models at which the stage goes on breaking the first one: a drag has dozens.
void CheckList::keepReport(std::string_view stage, const Error &why)
{
    QString &report = m_failing[stage];
    if (report.isEmpty() && why.code == ErrorCode::StageFailed && !m_reportFolder.isEmpty())
        report = setAside(m_reportFolder, m_session.model().document, stage, why).value_or(report);
}

void CheckList::setBeginning(bool isBeginning)
{
    if (std::exchange(m_isBeginning, isBeginning) != isBeginning)
        refresh();
}

/// What the stage has found of sections that are there, or why it has not.
void CheckList::add(const Stage &stage)
{
    if (const std::optional<Error> &why = m_scheduler.failureOf(stage.name)) {
        m_all.push_back(notWorkedOut(stage, *why));
        return;
    }
    const auto &result = m_results[stage.name];
    if (!result || !stage.findings)
        return;
    const auto isThere = [&](const SectionRef &ref) { return model().indexOf(ref) >= 0; };
    const auto isBegun = [&](const Finding &finding) {
        return m_isBeginning || (finding.is(kNoContact) && model().sectionCount() == 1);
    };
    for (const Finding &finding : stage.findings(result.get()))
        if (std::all_of(finding.sections.begin(), finding.sections.end(), isThere) &&
            std::all_of(finding.others.begin(), finding.others.end(), isThere))
            m_all.push_back(isBegun(finding) ? soFar(finding) : finding);
}

/// Another stage knows better of the same model.
bool CheckList::isRefined(const Stage &stage) const
{
    const auto knowsBetter = [&](const Stage &other) {
        return other.isRefining() && other.refines == stage.name && other.findings &&
               !m_scheduler.failureOf(other.name) &&
               m_scheduler.revisionOf(other.name) == m_scheduler.revisionOf(stage.name) &&
               m_scheduler.resultNamed(other.name) &&
               !other.findings(m_scheduler.resultNamed(other.name).get()).empty();
    };
    return std::any_of(m_scheduler.stages().begin(), m_scheduler.stages().end(), knowsBetter);
}

/// Nobody shall be told two counts of sheets.
void CheckList::speakOfSheets()
{
    if (!m_nested || !m_verdicts || m_nested->analysis != m_verdicts->analysis)
        return;
    const std::optional<SheetUse> use = sheetUseOf(*m_nested);
    if (!use)
        return;
    const auto isOfSheets = [](const Finding &finding) {
        const auto *packed = finding.details<SheetUse>();
        return (packed && packed->sheets > 0) || finding.is(kFewSheets);
    };
    if (std::erase_if(m_all, isOfSheets) == 0)
        return;
    const std::size_t before = m_all.size();
    findFewSheets(m_nested->analysis->model, *m_nested->layout, m_all);
    if (m_all.size() == before)
        m_all.push_back(makeFinding(kFitsSheet, Severity::Good, *use));
}

void CheckList::refresh()
{
    m_all.clear();
    if (m_session.model().sectionCount() == 0) {
        m_results.clear(); // what comes next is another model
        m_verdicts.reset();
        m_plan.reset();
        m_nested.reset();
    } else {
        for (const Stage &stage : m_scheduler.stages())
            if (!isRefined(stage))
                add(stage);
    }
    speakOfSheets();
    doubtVerdicts(m_all);
    std::stable_sort(m_all.begin(), m_all.end(),
                     [](const Finding &a, const Finding &b) { return a.subject() < b.subject(); });
    Q_EMIT changed();
}

const Model &CheckList::model() const
{
    static const Model nothing;
    return m_verdicts ? m_verdicts->analysis->model : nothing;
}

CheckList::Age CheckList::age() const
{
    Age age = Age::Current;
    if (m_session.model().sectionCount() == 0)
        return age;
    for (const Stage &stage : m_scheduler.stages())
        if (stage.findings && !stage.isRefining() && !m_scheduler.failureOf(stage.name))
            age = std::max(age, m_scheduler.age(stage.name)); // else none of it is among these
    return age;
}

const std::vector<Mend> &CheckList::mendsOf(const Finding &finding) const
{
    static const std::vector<Mend> kNone, kAgain{Mend{{&kTryAgain}, {}, {}}},
        kAgainOrReport{Mend{{&kTryAgain}, {}, {}}, Mend{{&kShowReport}, {}, {}}};
    if (finding.details<StageFailure>())
        return reportOf(finding).isEmpty() ? kAgain : kAgainOrReport;
    const auto mends = m_scheduler.result(kMends);
    const std::vector<Mend> *known = mends ? mends->of(finding) : nullptr;
    return known ? *known : kNone;
}

bool CheckList::isMendless(const Finding &finding) const
{
    const auto mends = m_scheduler.result(kMends);
    const std::vector<Mend> *known = mends ? mends->of(finding) : nullptr;
    return known && known->empty();
}

bool CheckList::areMendsOf(const Model &model) const
{
    const auto mends = m_scheduler.result(kMends);
    return mends && mends->analysis->model.document.isSame(model.document);
}

const Mend *CheckList::mendFor(const FindingAction &action, const Finding &finding) const
{
    const auto mends = m_scheduler.result(kMends);
    const std::vector<Mend> *known = mends ? mends->of(finding) : nullptr;
    if (!known)
        return nullptr;
    const auto mend = std::find_if(known->begin(), known->end(),
                                   [&](const Mend &other) { return other.action == action; });
    return mend == known->end() || !mend->isEdit() ? nullptr : &*mend;
}

QString CheckList::reportOf(const Finding &finding) const
{
    const auto *failure = finding.details<StageFailure>();
    const auto report = failure ? m_failing.find(failure->stage) : m_failing.end();
    return report == m_failing.end() ? QString() : report->second;
}

void CheckList::finish()
{
    m_scheduler.finish();
}

} // namespace fff
