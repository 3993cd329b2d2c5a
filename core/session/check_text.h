// The words for checks: the one place where a Check becomes a name or a sentence.
#pragma once

#include "core/analysis/checks.h"

#include <QString>

#include <functional>

namespace fff {

/// The published name of what is wrong, as in `check --json`: "topples", "notConnected", …
QString checkName(CheckCode code);
/// "note", "warning", "error"; "good" and "unknown" for what is no problem.
QString severityName(CheckSeverity severity);

/// How a sentence says lengths, masses and angles.
struct CheckUnits
{
    std::function<QString(double millimetres)> length;    // "45.4 mm"
    std::function<QString(double millimetres)> width;     // "2.70 mm", of slits and tools
    std::function<QString(const Vec2 &millimetres)> size; // "420 × 297 mm"
    std::function<QString(double kilograms)> mass;        // "115.7 g"
};
/// Millimetres and grams, numbers as the locale writes them.
CheckUnits metricUnits();

/// A verdict in a few words, for a badge: "Stands", "Falls over", "Not connected".
QString checkTitle(const Check &check);
/// Why, in whole sentences, for a row and for the command line: "Falls over forwards. The centre of
/// mass lies 45.4 mm in front of the feet." The title is not repeated where it does not begin the
/// sentence. `model` is the one that was checked: it has the sections' names.
QString checkText(const Check &check, const Model &model, const CheckUnits &units = metricUnits());

} // namespace fff
