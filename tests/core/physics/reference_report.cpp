#include "tests/core/physics/reference_report.h"

#include <cmath>
#include <cstdio>

namespace fff::test {

const char *Report::verdict(bool isIn, Judging judging)
{
    if (isIn)
        return "ok";
    if (judging == Judging::Judged) {
        m_isWithin = false;
        return "OUT";
    }
    ++m_doubtful;
    return judging == Judging::Flagged ? "(doubt)" : "(open)";
}

void Report::line(const std::string &what, double truth, double ours, bool hasRatio, bool isIn,
                  Judging judging)
{
    char ratio[32] = "-";
    if (hasRatio)
        std::snprintf(ratio, sizeof(ratio), "%.5f", ours / truth);
    std::printf("%-34s %-34s %13.6g %13.6g %9s  %s\n", m_case.c_str(), what.c_str(), truth, ours,
                ratio, verdict(isIn, judging));
}

void Report::number(const std::string &what, double truth, double ours, double tolerance,
                    Judging judging)
{
    const bool isIn = std::abs(ours - truth) <= tolerance; // not so for NaN
    line(what, truth, ours, std::abs(truth) > tolerance, isIn, judging);
}

void Report::share(const std::string &what, double truth, double ours, const Band &band,
                   Judging judging)
{
    const double ratio = ours / truth;
    const bool isNothing = truth == 0.0 && ours == 0.0;
    const bool isIn = isNothing || (ratio >= 1.0 + band.low && ratio <= 1.0 + band.high);
    line(what, truth, ours, truth != 0.0, isIn, judging);
}

void Report::vector(const std::string &what, const Vec3 &truth, const Vec3 &ours, double tolerance,
                    Judging judging)
{
    // Parts that are nothing in both say nothing.
    constexpr double kNothing = 1e-3; // of the tolerance
    for (int i = 0; i < 3; ++i) {
        const double least = kNothing * tolerance;
        if (std::abs(truth[i]) > least || !(std::abs(ours[i]) <= least))
            number(what + "." + "xyz"[i], truth[i], ours[i], tolerance, judging);
    }
}

void Report::claim(const std::string &what, const std::string &truth, const std::string &ours,
                   Judging judging)
{
    std::printf("%-34s %-34s %13s %13s %9s  %s\n", m_case.c_str(), what.c_str(), truth.c_str(),
                ours.c_str(), "-", verdict(truth == ours, judging));
}

} // namespace fff::test
