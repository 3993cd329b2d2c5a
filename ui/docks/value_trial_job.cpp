#include "ui/docks/value_trial_job.h"

#include <algorithm>
#include <utility>

namespace fff::ui {

namespace {

constexpr int kTrialTick = 200; // ms between two looks at how far it is

} // namespace

ValueTrialJob::ValueTrialJob(QObject *parent)
    : QObject(parent), m_progress(std::make_shared<Progress>()),
      m_job(
          [](const Asked &asked) -> Found {
              auto found = tryValues(*asked.model, asked.rules, {}, *asked.progress, asked.stop);
              return found ? std::make_shared<const ValueTrials>(*std::move(found)) : nullptr;
          },
          [this](std::uint64_t revision, Found found) {
              if (revision != m_revision)
                  return; // of another model
              m_isRunning = false;
              m_ticks.stop();
              m_result = std::move(found);
              Q_EMIT changed();
          })
{
    connect(&m_ticks, &QTimer::timeout, this, &ValueTrialJob::changed);
}

ValueTrialJob::~ValueTrialJob()
{
    m_stop.request_stop();
}

void ValueTrialJob::start(const Model &model, const CheckRules &rules)
{
    drop();
    m_stop = {};
    m_progress = std::make_shared<Progress>();
    m_isRunning = true;
    m_ticks.start(kTrialTick);
    m_job.request(m_revision,
                  {std::make_shared<const Model>(model), rules, m_progress, m_stop.get_token()});
    Q_EMIT changed();
}

void ValueTrialJob::drop()
{
    m_stop.request_stop();
    ++m_revision;
    m_ticks.stop();
    const bool hadAny = std::exchange(m_isRunning, false) || m_result;
    m_result.reset();
    if (hadAny)
        Q_EMIT changed();
}

double ValueTrialJob::progress() const
{
    return std::max(0.0, m_progress->share());
}

} // namespace fff::ui
