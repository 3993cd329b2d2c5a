#include "core/session/check_list.h"

#include "core/analysis/analysed.h"
#include "core/session/session.h"
#include "core/session/set_aside.h"

#include <algorithm>

namespace fff {

CheckList::CheckList(const Session &session, const QString &reports, QObject *parent)
    : QObject(parent), m_session(session), m_scheduler(session.scheduler()), m_reportFolder(reports)
{
    connect(&m_scheduler, &Scheduler::published, this, &CheckList::take);
    connect(&m_scheduler, &Scheduler::aged, this, &CheckList::changed);
    connect(&session, &Session::modelChanged, this, [this](const Model &, const Model &now) {
        if (now.sectionCount() == 0) // nothing follows from nothing
            refresh();
    });
    m_scheduler.want(kMends.name); // and all that it is derived from
    for (const Stage &stage : m_scheduler.stages())
        take(stage.name);
}

void CheckList::take(std::string_view stage)
{
    if (stage == kVerdicts.name)
        m_verdicts = m_scheduler.result(kVerdicts);
    else if (stage == kPlanned.name)
        m_plan = m_scheduler.result(kPlanned);
    else if (stage == kFlips.name)
        m_flips = m_scheduler.result(kFlips);
    else if (stage == kMends.name)
        m_mends = m_scheduler.result(kMends);
    const std::optional<Error> &why = m_scheduler.failureOf(stage);
    const bool wasFailing = m_failing.contains(stage);
    if (why)
        keepReport(stage, *why);
    else
        m_failing.erase(stage);
    // Each place of a drag has joints before it has verdicts: the list follows from those alone.
    if (stage != kAnalysed.name || why || wasFailing)
        refresh();
}

/// Of models at which the stage goes on breaking the first one: a drag has dozens.
void CheckList::keepReport(std::string_view stage, const Error &why)
{
    QString &report = m_failing[stage];
    if (report.isEmpty() && why.code == ErrorCode::StageFailed && !m_reportFolder.isEmpty())
        report = setAside(m_reportFolder, m_session.model().document, stage, why).value_or(report);
}

/// In the place of what a stage would have found.
void CheckList::addFailures()
{
    for (const Stage &stage : m_scheduler.stages()) {
        if (const std::optional<Error> &why = m_scheduler.failureOf(stage.name)) {
            Check check;
            check.code = CheckCode::NotWorkedOut;
            check.severity = CheckSeverity::Unknown;
            check.stage = stage.name;
            check.failure = why;
            m_all.push_back(std::move(check));
        }
    }
}

void CheckList::refresh()
{
    m_all.clear();
    if (m_session.model().sectionCount() == 0) {
        m_verdicts.reset();
        m_plan.reset();
    }
    if (m_verdicts && !m_scheduler.failureOf(kVerdicts.name))
        m_all = m_verdicts->checks;
    const auto isThere = [&](const SectionRef &ref) { return model().indexOf(ref) >= 0; };
    if (m_plan && !m_scheduler.failureOf(kPlanned.name))
        for (const Check &check : m_plan->checks)
            if (std::all_of(check.sections.begin(), check.sections.end(), isThere) &&
                std::all_of(check.guests.begin(), check.guests.end(), isThere))
                m_all.push_back(check);
    if (m_session.model().sectionCount() > 0)
        addFailures();
    std::stable_sort(m_all.begin(), m_all.end(),
                     [](const Check &a, const Check &b) { return subjectOf(a) < subjectOf(b); });
    Q_EMIT changed();
}

const Model &CheckList::model() const
{
    static const Model nothing;
    return m_verdicts ? m_verdicts->analysis->model : nothing;
}

CheckList::Age CheckList::age() const
{
    if (m_session.model().sectionCount() == 0)
        return Age::Current;
    Age age = Age::Current;
    for (const char *stage : {kVerdicts.name, kPlanned.name})
        if (!m_scheduler.failureOf(stage)) // else none of its verdicts are among these
            age = std::max(age, m_scheduler.age(stage));
    return age;
}

const std::vector<CheckAction> &CheckList::actionsOf(const Check &check) const
{
    using Kind = CheckAction::Kind;
    static const std::vector<CheckAction> kNone, kAgain{{Kind::TryAgain, {}}},
        kAgainOrReport{{Kind::TryAgain, {}}, {Kind::ShowReport, {}}};
    if (check.code == CheckCode::NotWorkedOut)
        return reportOf(check).isEmpty() ? kAgain : kAgainOrReport;
    const std::vector<CheckAction> *actions = m_mends ? m_mends->of(check) : nullptr;
    return actions ? *actions : kNone;
}

QString CheckList::reportOf(const Check &check) const
{
    const auto report = check.stage ? m_failing.find(check.stage) : m_failing.end();
    return report == m_failing.end() ? QString() : report->second;
}

const Flips *CheckList::flips() const
{
    const bool isCurrent =
        m_plan && m_plan->analysis->model.document.isSame(m_session.committed().document) &&
        m_scheduler.revisionOf(kFlips.name) == m_scheduler.revisionOf(kPlanned.name);
    return isCurrent && m_flips && m_flips->flips ? &*m_flips->flips : nullptr;
}

void CheckList::finish()
{
    m_scheduler.finish();
}

} // namespace fff
