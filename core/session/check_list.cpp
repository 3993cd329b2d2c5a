#include "core/session/check_list.h"

#include "core/session/session.h"

#include <algorithm>

namespace fff {

CheckList::CheckList(const Session &session, QObject *parent)
    : QObject(parent), m_session(session), m_scheduler(session.scheduler())
{
    connect(&m_scheduler, &Scheduler::published, this, &CheckList::take);
    connect(&m_scheduler, &Scheduler::workChanged, this, &CheckList::changed);
    connect(&session, &Session::modelChanged, this, [this](const Model &, const Model &now) {
        if (now.sectionCount() == 0) // nothing follows from nothing
            refresh();
    });
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
    else
        return;
    refresh();
}

void CheckList::refresh()
{
    m_all.clear();
    if (m_session.model().sectionCount() == 0) {
        m_verdicts.reset();
        m_plan.reset();
    }
    if (m_verdicts)
        m_all = m_verdicts->checks;
    const auto isThere = [&](const SectionRef &ref) { return model().indexOf(ref) >= 0; };
    if (m_plan)
        for (const Check &check : m_plan->checks)
            if (std::all_of(check.sections.begin(), check.sections.end(), isThere) &&
                std::all_of(check.guests.begin(), check.guests.end(), isThere))
                m_all.push_back(check);
    std::stable_sort(m_all.begin(), m_all.end(), [](const Check &a, const Check &b) {
        return subjectOf(a.code) < subjectOf(b.code);
    });
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
    return std::max(m_scheduler.age(kVerdicts.name), m_scheduler.age(kPlanned.name));
}

const std::vector<CheckAction> &CheckList::actionsOf(const Check &check) const
{
    static const std::vector<CheckAction> kNone;
    const std::vector<CheckAction> *actions = m_mends ? m_mends->of(check) : nullptr;
    return actions ? *actions : kNone;
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
