// Whether the model holds: what breaks, what comes apart, and of what that is not known.
#pragma once

#include "core/analysis/bearable_mass.h"
#include "core/analysis/finding.h"
#include "core/analysis/weak_place.h"

namespace fff {

extern const FindingKind kHolds;
extern const FindingKind kWouldHold; // if it held together, which something else says it does not
extern const FindingKind kBarelyHolds, kTooWeak, kNotRated, kStrengthUnknown, kMovesWithin, kFolds,
    kWeightBeside;

/// Of the verdict on all of it.
struct Held
{
    double placed = 0.0; // kg: weights, and pushes as what would weigh as much; 0: none
    double weights = 0.0, pushes = 0.0; // kg, N: of either
    double cornerUse = 0.0, neckUse = 0.0;
    double safety = 1.0;
    std::optional<WeakPlace> weakest, cracks, breaks;
    BearableMass bearable;
    double bends = 0.0; // mm, as far as it gives; 0: not known, or too little to be told
    Text provided = {}; // kWouldHold: what keeps it from it, "if it held together"
};

/// One verdict on all of it where it stands, and what is wrong beside that.
std::vector<Finding> strengthFindings(const Analysis &analysis, const Strength &strength,
                                      const BearableMass &bearable, const StrengthRules &rules);

/// mm: what gives less is as good as stiff to a person.
inline constexpr double kToldBending = 1.0;
/// Has the verdict say how far the model gives, mm, where that is worth telling.
void tellBending(std::vector<Finding> &findings, double bends);

} // namespace fff
