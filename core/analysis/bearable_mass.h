// How much of what hangs on a model it would bear, and what gives way then.
#pragma once

#include "core/analysis/strength.h"

namespace fff {

/// How much all weights together may be, scaled alike.
struct BearableMass
{
    /// kg in sum, at which the worst corner, and the worst neck, reach what the sheet bears,
    /// without the safety factor. None: it gives way otherwise before, or bears more than
    /// kMostScale times what is there.
    std::optional<double> cracksFrom, breaksAt;
    int cracksIn = -1, breaksIn = -1; // bodies
    /// kg in sum, from which on it does not stand, or is pulled apart. None: it breaks before, or
    /// stands under all that was tried.
    std::optional<double> fallsFrom;
    bool isPulledOut = false; // that is how
    bool isFound = false;     // all of this was looked for to its end
};
inline constexpr double kMostScale = 1e4;

/// kg: all weights of the model that are there; pushes count as the mass that would weigh as much.
double placedMass(const Structure &structure);

/// `strength` belongs to the analysis and the rules. Nothing without weights, or where it does not
/// stand. About ten solutions of the structure, and the stresses of all bodies for two or three of
/// them.
BearableMass bearableMass(const Analysis &analysis, const Strength &strength,
                          const StrengthRules &rules, StrengthCaches &caches,
                          const LongWork &work = {});

} // namespace fff
