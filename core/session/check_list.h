// The verdicts on the model that is shown, worked out beside it: what the docks and the badges
// show.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers
#include <QTimer>

#include "core/session/checks.h"
#include "core/session/latest_job.h"

#include <cstdint>
#include <memory>

namespace fff {

class Session;

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

    /// The newest ones, of model(); in the order of checks().
    const std::vector<Check> &all() const { return m_verdicts->checks; }
    /// The one that they are about; older than the session's unless age() is Current.
    const Model &model() const { return m_verdicts->model; }
    Age age() const { return m_age; }
    /// Waits for what is worked out: for tests.
    void finish();

Q_SIGNALS:
    /// The verdicts or their age.
    void changed();

private:
    struct Verdicts
    {
        Model model;
        std::vector<Check> checks;
    };
    using VerdictsPointer = std::shared_ptr<const Verdicts>;

    void modelChanged();
    void grow(Age age);

    const Session &m_session;
    CheckCaches m_caches; // touched by the job alone
    VerdictsPointer m_verdicts = std::make_shared<const Verdicts>();
    std::uint64_t m_revision = 0; // that they belong to
    Age m_age = Age::Current;
    QTimer m_becomesOlder, m_becomesLate;
    LatestJob<AnalysisPointer, VerdictsPointer> m_job; // last: waits for its worker
};

} // namespace fff
