// The cross-sections of a model that are strained most, as lines to be drawn.
#pragma once

#include "core/analysis/strength.h"

#include <vector>

namespace fff {

struct StressLine
{
    int body = 0;
    int section = 0;                             // index in the model
    Vec3 from = Vec3::Zero(), to = Vec3::Zero(); // on the mid-plane, world, mm
    Vec3 normal = Vec3::UnitZ();                 // of the sheet, unit
    double half = 0.0;                           // of its thickness, mm
    double use = 0.0;                            // of what the sheet bears; 1 is all of it
    double limit = 0.0;                          // MPa, what it bears
    NeckStress stress;
};

/// Whether forces are known and can be trusted; else nothing is shown of the stresses.
bool areStressesKnown(const Strength &strength);

/// Of all lines that are strained by at least `least` of what the sheet bears, with the notch
/// factor, the worst: at most one in 3 mm along a neck and four at a corner; the worst last. Empty
/// where forces are not known or not to be trusted.
std::vector<StressLine> stressLines(const Analysis &analysis, const Strength &strength,
                                    double least);

} // namespace fff
