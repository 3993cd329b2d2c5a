// Trials of the values, worked out beside the window.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include "core/analysis/value_trials.h"
#include "core/session/latest_job.h"

#include <QTimer>

#include <cstdint>
#include <memory>
#include <stop_token>

namespace fff::ui {

class ValueTrialJob : public QObject
{
    Q_OBJECT
public:
    explicit ValueTrialJob(QObject *parent = nullptr);
    ~ValueTrialJob() override;

    /// From now on. What ran before is given up.
    void start(const Model &model, const CheckRules &rules);
    /// What runs is given up, and what was found is forgotten.
    void drop();

    bool isRunning() const { return m_isRunning; }
    /// 0 … 1
    double progress() const;
    /// Null until there is one.
    const std::shared_ptr<const ValueTrials> &result() const { return m_result; }

Q_SIGNALS:
    void changed();

private:
    using Found = std::shared_ptr<const ValueTrials>; // null: given up
    struct Asked
    {
        ModelPointer model;
        CheckRules rules;
        std::shared_ptr<Progress> progress;
        std::stop_token stop;
    };

    std::uint64_t m_revision = 0;
    bool m_isRunning = false;
    std::stop_source m_stop; // of what runs
    std::shared_ptr<Progress> m_progress;
    Found m_result;
    QTimer m_ticks;                // it comes further
    LatestJob<Asked, Found> m_job; // last: its destructor waits
};

} // namespace fff::ui
