// What a reader mended, as a person wants to know it: of sections, not of lines of the file, and
// what happened to many said once. The lines are what error_text.h makes of each warning.
#pragma once

#include "core/base/result.h"

#include <QtCore/QStringList>

#include <span>

namespace fff::io {

/// A sentence for each kind of warning, in the order in which kinds are met first: "7 sections were
/// slightly skewed and have been straightened." Of a kind that is met once its own sentence.
QStringList warningSummary(std::span<const Warning> warnings);

/// warningSentence() as it stands by itself: with a capital, unless a name begins it, and a full
/// stop.
QString wholeSentence(const Warning &warning);

/// Where each of them is in the file, a line each.
QStringList warningLines(std::span<const Warning> warnings);

} // namespace fff::io
