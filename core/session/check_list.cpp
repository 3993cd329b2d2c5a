#include "core/session/check_list.h"

#include "core/session/session.h"

#include <algorithm>
#include <map>

namespace fff {

namespace {

// ms. Most answers come sooner than the eye sees a change; saying in between that they are older
// would only flicker.
constexpr int kSeen = 100, kLate = 500;

ActionsOfChecks actionsOfAll(const std::vector<Check> &checks, const Analysis &analysis,
                             const Flips *flips)
{
    ActionsOfChecks all;
    std::map<CheckCode, int> alike;
    for (const Check &check : checks)
        if (alike[check.code]++ < kMostAlike)
            all.emplace_back(check, fff::actionsOf(check, analysis, flips));
    return all;
}

const std::vector<CheckAction> *found(const ActionsOfChecks &all, const Check &check)
{
    const auto known = std::find_if(all.begin(), all.end(),
                                    [&](const auto &of) { return isSameVerdict(of.first, check); });
    return known == all.end() ? nullptr : &known->second;
}

} // namespace

bool isSameVerdict(const Check &a, const Check &b)
{
    return a.code == b.code && a.sections == b.sections;
}

CheckList::CheckList(const Session &session, QObject *parent)
    : QObject(parent), m_session(session),
      m_job(
          [this](const Question &question) -> VerdictsPointer {
              const Analysis &analysis = *question.analysis;
              return std::make_shared<const Verdicts>(
                  Verdicts{question.analysis, analysis.model,
                           checks(analysis, m_caches, {}, question.rules)});
          },
          [this](std::uint64_t revision, VerdictsPointer verdicts) {
              if (revision != m_session.revision() && m_session.model().sectionCount() == 0)
                  return; // late, on what is gone
              m_verdicts = std::move(verdicts);
              m_revision = revision;
              refresh();
          }),
      m_planning(
          [this](const Question &question) {
              const Analysis &analysis = *question.analysis;
              const auto limit = [&] { return timeLimit(question.rules.planningTime); };
              PlannedAnalysis planned{
                  question.analysis, planOf(analysis, m_planCaches, limit()), {}, {}, {}};
              planned.checks = planChecks(analysis, planned.plan, m_webCaches);
              planned.flips = flipsThatHelp(analysis, planned.plan, limit());
              planned.actions =
                  actionsOfAll(planned.checks, analysis, planned.flips ? &*planned.flips : nullptr);
              return std::make_shared<const PlannedAnalysis>(std::move(planned));
          },
          [this](std::uint64_t, std::shared_ptr<const PlannedAnalysis> plan) {
              if (m_session.model().sectionCount() == 0)
                  return;
              m_plan = std::move(plan);
              refresh();
          }),
      m_acting(
          [](const VerdictsPointer &verdicts) {
              return actionsOfAll(verdicts->checks, *verdicts->analysis, nullptr);
          },
          [this](std::uint64_t, ActionsOfChecks actions) {
              m_actions = std::move(actions);
              Q_EMIT changed();
          })
{
    m_becomesOlder.setSingleShot(true);
    m_becomesOlder.setInterval(kSeen);
    m_becomesLate.setSingleShot(true);
    m_becomesLate.setInterval(kLate);
    connect(&m_becomesOlder, &QTimer::timeout, this, [this] { grow(Age::Older); });
    connect(&m_becomesLate, &QTimer::timeout, this, [this] { grow(Age::Late); });
    connect(&session, &Session::modelChanged, this, &CheckList::modelChanged);
    connect(&session, &Session::analysisChanged, this, [this] {
        requestChecks();
        requestPlan();
    });
    connect(&session, &Session::committedChanged, this, [this] {
        requestPlan();
        requestActions();
    });
    requestChecks();
    requestPlan();
    if (session.analysedRevision() != session.revision())
        modelChanged();
}

CheckList::~CheckList() = default;

/// The verdicts age from the first change on that they do not know.
void CheckList::modelChanged()
{
    if (m_session.model().sectionCount() == 0) {
        // Nothing follows from nothing.
        m_verdicts = std::make_shared<const Verdicts>();
        m_plan.reset();
        m_all.clear();
        m_becomesOlder.stop();
        m_becomesLate.stop();
        m_age = Age::Current;
        Q_EMIT changed();
        return;
    }
    if (m_age != Age::Current || m_becomesOlder.isActive())
        return;
    m_becomesOlder.start();
    m_becomesLate.start();
}

void CheckList::setRules(const CheckRules &rules)
{
    if (rules == m_rules)
        return;
    m_rules = rules;
    m_toPlan.reset();
    requestChecks();
    requestPlan();
}

void CheckList::requestChecks()
{
    m_job.request(m_session.analysedRevision(), {m_session.analysisPointer(), m_rules});
}

void CheckList::grow(Age age)
{
    m_age = age;
    Q_EMIT changed();
}

/// A plan is for what is there, not for each place on the way of a drag.
void CheckList::requestPlan()
{
    if (m_session.hasPreview() || m_session.analysedRevision() != m_session.revision() ||
        m_toPlan == m_session.analysisPointer())
        return;
    m_toPlan = m_session.analysisPointer();
    m_planning.request(m_session.analysedRevision(), {m_toPlan, m_rules});
}

/// The same goes for what can be done.
void CheckList::requestActions()
{
    if (m_session.hasPreview() || m_revision != m_session.revision() || !m_verdicts->analysis ||
        m_toActOn == m_verdicts->analysis)
        return;
    m_toActOn = m_verdicts->analysis;
    m_acting.request(m_revision, m_verdicts);
}

void CheckList::refresh()
{
    m_all = m_verdicts->checks;
    const auto isThere = [&](const SectionRef &ref) { return m_verdicts->model.indexOf(ref) >= 0; };
    if (m_plan)
        for (const Check &check : m_plan->checks)
            if (std::all_of(check.sections.begin(), check.sections.end(), isThere) &&
                std::all_of(check.guests.begin(), check.guests.end(), isThere))
                m_all.push_back(check);
    std::stable_sort(m_all.begin(), m_all.end(), [](const Check &a, const Check &b) {
        return subjectOf(a.code) < subjectOf(b.code);
    });
    const bool isPlanned =
        m_session.hasPreview() || (m_plan && m_plan->analysis == m_session.analysisPointer());
    if (m_revision == m_session.revision() && isPlanned) {
        m_becomesOlder.stop();
        m_becomesLate.stop();
        m_age = Age::Current;
    }
    requestActions();
    Q_EMIT changed();
}

const std::vector<CheckAction> &CheckList::actionsOf(const Check &check) const
{
    static const std::vector<CheckAction> kNone;
    const std::vector<CheckAction> *actions = found(m_actions, check);
    if (!actions && m_plan)
        actions = found(m_plan->actions, check);
    return actions ? *actions : kNone;
}

const Flips *CheckList::flips() const
{
    const bool isCurrent =
        m_plan && m_plan->analysis->model.document.isSame(m_session.committed().document);
    return isCurrent && m_plan->flips ? &*m_plan->flips : nullptr;
}

void CheckList::finish()
{
    m_job.finish();
    m_planning.finish();
    m_acting.finish();
}

} // namespace fff
