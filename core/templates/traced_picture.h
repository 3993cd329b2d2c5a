// What is dark in a picture, as boundaries: for those who want it cut or engraved.
#pragma once

#include "core/base/long_work.h"
#include "core/base/result.h"
#include "core/geometry/contour.h"

#include <cstdint>
#include <vector>

namespace fff {

/// As seen on white paper: what lets light through is lighter.
struct GreyPicture
{
    int width = 0, height = 0;      // px
    std::vector<std::uint8_t> grey; // 0 black … 255 white; row by row from the top

    std::uint8_t at(int x, int y) const
    {
        return grey[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x)];
    }
};

/// Beyond this a picture is looked at through larger pixels.
inline constexpr double kMostTracedPixels = 16e6;

struct TraceOptions
{
    double threshold = 0.5;  // darker than this share of white counts
    bool isInverted = false; // lighter counts
    double smoothing = 0.5;  // 0: every step of the pixels is a corner; 1: no corner is left
    int smallest = 16;       // px²: what is smaller is dirt
};

/// What hangs together, in pixels about the middle of the picture, x to the right and y up.
struct TracedRegion
{
    Contour outer;
    std::vector<Contour> holes;
};

/// Largest first. White enough around it is taken for granted: what is dark at an edge of the
/// picture ends there.
///
/// Errors  BadValue, place = "picture", for one without pixels or with another number of them than
///         it says; Cancelled, before or after the work, which goes on to its end.
/// Source  P. Selinger 2003, Potrace: a polygon-based tracing algorithm; its library.
Result<std::vector<TracedRegion>> traced(const GreyPicture &picture, const TraceOptions &options,
                                         const LongWork &work = {});

/// The threshold between what is dark and what is light in it, by N. Otsu 1979, A Threshold
/// Selection Method from Gray-Level Histograms, IEEE Transactions on Systems, Man, and Cybernetics
/// 9(1); 0.5 of a picture of one shade.
double suggestedThreshold(const GreyPicture &picture);

} // namespace fff
