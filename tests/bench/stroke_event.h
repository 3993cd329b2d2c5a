// What drawing costs: every event of one stroke, from the press to the release.
#pragma once

#include <string>
#include <vector>

namespace fff::bench {

struct StrokeTiming
{
    std::string hand; // what kind of stroke
    int samples = 0;  // events between press and release
    // ms of CPU time: all of its events, the dearest of them but the release, and the release
    double total = 0.0, dearest = 0.0, release = 0.0;
    int kept = 0;        // samples that the stroke kept
    double kernel = 0.0; // ms, of the kernel in the same minutes; 0 when it was not run
};

/// The kinds of strokes there are: "smooth", "tremor", …
std::vector<std::string> strokeHands();

/// Draws one of so many samples in an empty document.
StrokeTiming drawStroke(const std::string &hand, int samples);

/// Times, growth from one number of samples to the next, the dearest event and the release.
std::string strokeTable(const std::vector<StrokeTiming> &rows);

} // namespace fff::bench
