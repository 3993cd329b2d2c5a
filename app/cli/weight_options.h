// Weights that are hung on a model for one run.
#pragma once

#include "app/cli/command_line.h"

namespace fff::cli {

/// --weight "NAME[@X,Y]=350g", as often as one likes.
void addWeightOptions(QCommandLineParser &parser);

/// Hangs them on the analysed model, at the middle of the section or at X, Y in its frame, mm. The
/// status after printing, if one makes no sense.
std::optional<int> hangWeights(const QCommandLineParser &parser, const Verb &verb,
                               Analysis &analysis);

} // namespace fff::cli
