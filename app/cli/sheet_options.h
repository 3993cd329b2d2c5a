// Which sheets there are: options of every verb that reads a model.
#pragma once

#include "app/cli/command_line.h"

namespace fff::cli {

/// --sheet, --offcut.
void addSheetOptions(QCommandLineParser &parser);
/// Prints and sets `status` where one makes no sense.
void readSheets(const QCommandLineParser &parser, const Verb &verb, DocumentOptions &options,
                std::optional<int> &status);

} // namespace fff::cli
