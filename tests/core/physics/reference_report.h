// The table that comparisons with reference cases print, and whether all of it was within
// tolerance.
#pragma once

#include "tests/core/physics/reference_index.h"

#include <string>

namespace fff::test {

/// What becomes of a number that is outside.
enum class Judging {
    Judged,  // OUT: the case fails
    Flagged, // (doubt): ours says itself that its method does not reach there
    Told,    // (open): the truth is another's, or for information
};

class Report
{
public:
    explicit Report(std::string name) : m_case(std::move(name)) {}

    /// Within `tolerance` of each other, in their unit.
    void number(const std::string &what, double truth, double ours, double tolerance,
                Judging judging = Judging::Judged);
    /// ours / truth − 1 within the band.
    void share(const std::string &what, double truth, double ours, const Band &band,
               Judging judging = Judging::Judged);
    void vector(const std::string &what, const Vec3 &truth, const Vec3 &ours, double tolerance,
                Judging judging = Judging::Judged);
    void claim(const std::string &what, const std::string &truth, const std::string &ours,
               Judging judging = Judging::Judged);

    bool isWithin() const { return m_isWithin; }
    int doubtful() const { return m_doubtful; } // numbers outside that are not judged

private:
    void line(const std::string &what, double truth, double ours, bool hasRatio, bool isIn,
              Judging judging);
    const char *verdict(bool isIn, Judging judging);

    std::string m_case;
    bool m_isWithin = true;
    int m_doubtful = 0;
};

} // namespace fff::test
