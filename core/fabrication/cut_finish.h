// How cuts begin and end, and which of them are made at all.
#pragma once

namespace fff {

struct CutFinish
{
    int tabs = 0;            // round each part: bridges that hold it in its sheet until all is cut
    double tabWidth = 0.3;   // mm, of each
    double lead = 0.0;       // mm that a cut begins, and ends, beside its line, in the waste
    bool sharesCuts = false; // where edges of two parts lie on each other one cut is made for both

    bool isPlain() const { return tabs == 0 && lead == 0.0 && !sharesCuts; }
    bool operator==(const CutFinish &) const = default;
};

// What can be asked for.
inline constexpr int kMostTabs = 100;
inline constexpr double kLeastTabWidth = 0.05, kMostTabWidth = 20.0; // mm
inline constexpr double kMostLead = 50.0;                            // mm

} // namespace fff
