// The verdicts on the model that is shown, worked out beside it: what the docks and the badges
// show.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers
#include <QTimer>

#include "core/analysis/checks.h"
#include "core/analysis/flips.h"
#include "core/analysis/plan_checks.h"
#include "core/session/check_actions.h"
#include "core/session/latest_job.h"

#include <cstdint>
#include <memory>
#include <utility>

namespace fff {

class Session;

/// More checks of one kind than this say less than a number does; nothing is offered for each of
/// the others.
inline constexpr int kMostAlike = 12;

/// Whether it is the same verdict after a change of the model; its numbers may differ.
bool isSameVerdict(const Check &a, const Check &b);

/// What can be done about some checks.
using ActionsOfChecks = std::vector<std::pair<Check, std::vector<CheckAction>>>;

struct PlannedAnalysis
{
    AnalysisPointer analysis;
    ModelPlan plan;
    std::vector<Check> checks;
    std::optional<Flips> flips; // where parts are locked
    ActionsOfChecks actions;    // of `checks`
};

class CheckList : public QObject
{
    Q_OBJECT
public:
    enum class Age {
        Current, // the verdicts are those on the model that is shown
        Older,   // it has changed since, long enough ago that a person sees them
        Late,    // for half a second by now
    };

    /// The session outlives it.
    explicit CheckList(const Session &session, QObject *parent = nullptr);
    ~CheckList() override;

    /// The newest ones, of sections of model(), those of planChecks() with them; in the order of
    /// their subjects.
    const std::vector<Check> &all() const { return m_all; }
    /// The one that they are about; older than the session's unless age() is Current.
    const Model &model() const { return m_verdicts->model; }
    Age age() const { return m_age; }
    /// The newest plan of the assembly, null at first, and the analysis that it is about.
    const std::shared_ptr<const PlannedAnalysis> &plan() const { return m_plan; }
    /// What frees the locked parts of what is there now, null when nothing does.
    const Flips *flips() const;
    /// What can be done about one of all(), as far as it is worked out; until then what could be
    /// done about the same verdict before.
    const std::vector<CheckAction> &actionsOf(const Check &check) const;
    /// What it goes by from now on; looks again where that differs.
    void setRules(const CheckRules &rules);
    /// Waits for what is worked out: for tests.
    void finish();

Q_SIGNALS:
    /// The verdicts or their age.
    void changed();

private:
    struct Verdicts
    {
        AnalysisPointer analysis; // null: of an empty model
        Model model;
        std::vector<Check> checks;
    };
    using VerdictsPointer = std::shared_ptr<const Verdicts>;

    struct Question
    {
        AnalysisPointer analysis;
        CheckRules rules;
    };

    void modelChanged();
    void requestChecks();
    void grow(Age age);
    void requestPlan();
    void requestActions();
    /// After a result: whether all are of the model that is shown by now.
    void refresh();

    const Session &m_session;
    CheckRules m_rules;
    CheckCaches m_caches;    // touched by the job alone
    PlanCaches m_planCaches; // by the planning alone
    WebCaches m_webCaches;   // and so is this
    VerdictsPointer m_verdicts = std::make_shared<const Verdicts>();
    std::uint64_t m_revision = 0; // that they belong to
    std::shared_ptr<const PlannedAnalysis> m_plan;
    AnalysisPointer m_toPlan;  // of what is or was being planned last
    AnalysisPointer m_toActOn; // the same of what can be done about m_verdicts
    ActionsOfChecks m_actions;
    std::vector<Check> m_all;
    Age m_age = Age::Current;
    QTimer m_becomesOlder, m_becomesLate;
    // Last: they wait for their workers.
    LatestJob<Question, VerdictsPointer> m_job;
    LatestJob<Question, std::shared_ptr<const PlannedAnalysis>> m_planning;
    LatestJob<VerdictsPointer, ActionsOfChecks> m_acting;
};

} // namespace fff
