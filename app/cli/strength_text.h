// What holds and what does not, as JSON and as text.
#pragma once

#include "core/analysis/bearable_mass.h"
#include "core/analysis/bent_model.h"
#include "core/analysis/findings/doubted_verdicts.h"

#include <QStringList>

#include <string>

namespace fff::cli {

/// What simulate has worked out.
struct Simulated
{
    Strength strength;
    BearableMass bearable;
    std::optional<BentModel> bent; // with sections that bend
    VerdictDoubts doubts;          // of all of it
    double millisecondsOfForces = 0.0, millisecondsOfStresses = 0.0;
};

/// Sentences about what a person has to know besides the verdict.
QStringList strengthWarnings(const Simulated &simulated, const Analysis &analysis);

std::string strengthJson(const Simulated &simulated, const Analysis &analysis, const QString &file);
QStringList strengthText(const Simulated &simulated, const Analysis &analysis);

} // namespace fff::cli
