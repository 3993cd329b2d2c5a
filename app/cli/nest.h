// What `nest` does for models and for problems of strip packing alike.
#pragma once

#include "app/cli/command_line.h"
#include "core/base/long_work.h"
#include "core/geometry/vector.h"
#include "core/nesting/problem.h"

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace fff::cli {

inline constexpr double kNestSeconds = 10.0; // where nothing else is asked for

/// What was asked for.
struct NestAsked
{
    double seconds = kNestSeconds;
    std::uint64_t seed = 1;
    std::optional<nest::Turning> turning;
    std::optional<double> margin, spacing; // mm
    bool asJson = false;
};

/// The items of an instance on its strip.
int nestInstance(const QString &file, const NestAsked &asked);
/// The parts of a model on its sheets.
int nestModel(const QString &file, const DocumentOptions &documentOptions, const NestAsked &asked,
              const Verb &verb);

/// Stops what takes too long by the clock, and says so when it is over: how far it came hangs on
/// the machine.
class NestGuard
{
public:
    explicit NestGuard(double seconds);
    ~NestGuard();
    LongWork work() const { return {m_stop.get_token(), {}}; }

private:
    std::stop_source m_stop;
    std::mutex m_mutex;
    std::condition_variable_any m_wakeUp;
    std::jthread m_thread; // last: it uses the others
};

/// 0 … 360.
double degreesOf(const Vec2 &turn);
/// Of the work that was done, as seconds are asked for: the same for the same seed.
double secondsOf(std::int64_t work);

} // namespace fff::cli
