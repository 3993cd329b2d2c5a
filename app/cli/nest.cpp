#include "app/cli/nest.h"

#include "app/cli/terminal.h"
#include "core/nesting/nester.h"

#include <QCoreApplication>
#include <chrono>
#include <cmath>
#include <numbers>

namespace fff::cli {

namespace {

/// Where the machine is so slow that the work takes this many times as long as was asked for, the
/// best so far has to do.
constexpr double kPatience = 2.0;

} // namespace

NestGuard::NestGuard(double seconds)
    : m_thread([this, seconds](std::stop_token over) {
          std::unique_lock lock(m_mutex);
          const auto time = std::chrono::duration<double>(kPatience * seconds + 1.0);
          if (!m_wakeUp.wait_for(lock, over, time, [&over] { return over.stop_requested(); }))
              m_stop.request_stop();
      })
{
}

NestGuard::~NestGuard()
{
    if (m_stop.stop_requested())
        printError(QCoreApplication::translate(
            "CommandLine", "The search was stopped before its end, since this machine is busy: "
                           "another run may come to another layout."));
}

double degreesOf(const Vec2 &turn)
{
    const double degrees = std::atan2(turn.y(), turn.x()) * 180.0 / std::numbers::pi;
    return degrees < 0.0 ? degrees + 360.0 : degrees;
}

double secondsOf(std::int64_t work)
{
    return static_cast<double>(work) / nest::kWorkPerSecond;
}

} // namespace fff::cli
