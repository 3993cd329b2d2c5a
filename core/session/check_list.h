// The verdicts on the model that is shown, as the docks and the badges show them: what the stages
// have found out, in one list.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include "core/analysis/mends.h"
#include "core/analysis/planned.h"
#include "core/analysis/verdicts.h"
#include "core/session/scheduler.h"

#include <memory>

namespace fff {

class Session;
struct Nested;

class CheckList : public QObject
{
    Q_OBJECT
public:
    using Age = Scheduler::Age;

    /// reports  the folder where a model is set aside at which a stage broke; empty: nowhere
    /// The session outlives it.
    explicit CheckList(const Session &session, const QString &reports = {},
                       QObject *parent = nullptr);

    /// The newest ones of all stages that have such, of sections of model(); in the order of their
    /// subjects. In place of those of a stage that failed one that says why. Of sheets they say
    /// what Sheets and Export show, once parts lie on them.
    const std::vector<Finding> &all() const { return m_all; }
    /// While the first sections are drawn: what these may still mend is not wrong so far. That
    /// a single section hangs in the air never is: the next one is drawn out of it.
    void setBeginning(bool isBeginning);
    /// The one that they are about; older than the session's unless age() is Current.
    const Model &model() const;
    /// Of the oldest of them.
    Age age() const;
    /// The newest plan of the assembly, null at first, and the analysis that it is about.
    const std::shared_ptr<const PlannedAnalysis> &plan() const { return m_plan; }
    /// What can be done about one of all(), as far as it is worked out; until then what could be
    /// done about the same verdict before.
    const std::vector<Mend> &mendsOf(const Finding &finding) const;
    /// It is known that nothing is offered.
    bool isMendless(const Finding &finding) const;
    /// Whether what can be done is worked out of this model.
    bool areMendsOf(const Model &model) const;
    /// What an action makes of the model that it is worked out of; null where it is not offered.
    const Mend *mendFor(const FindingAction &action, const Finding &finding) const;
    /// Where the model was set aside at which the finding's stage broke; empty: nowhere.
    QString reportOf(const Finding &finding) const;
    Scheduler &scheduler() const { return m_scheduler; }
    /// Waits for what is worked out: for tests.
    void finish();

Q_SIGNALS:
    /// The verdicts or their age.
    void changed();

private:
    void take(std::string_view stage);
    void keepReport(std::string_view stage, const Error &why);
    void add(const Stage &stage);
    bool isRefined(const Stage &stage) const;
    void speakOfSheets();
    void refresh();

    const Session &m_session;
    Scheduler &m_scheduler;
    std::map<std::string_view, std::shared_ptr<const void>> m_results; // by stage
    std::shared_ptr<const Verdicts> m_verdicts; // null: none yet, or of an empty model
    std::shared_ptr<const PlannedAnalysis> m_plan;
    std::shared_ptr<const Nested> m_nested; // the newest that somebody asked for
    std::vector<Finding> m_all;
    bool m_isBeginning = false;
    QString m_reportFolder;
    std::map<std::string_view, QString> m_failing; // stages, and where a model was set aside
};

} // namespace fff
