// Which sheets there are: options of every verb that reads a model.
#pragma once

#include "app/cli/command_line.h"

namespace fff::cli {

/// --sheet, --offcut.
void addSheetOptions(QCommandLineParser &parser);
/// Prints and sets `status` where one makes no sense.
void readSheets(const QCommandLineParser &parser, const Verb &verb, DocumentOptions &options,
                std::optional<int> &status);
/// Each offcut to its stock. The status after printing, where it is of none, or nobody can tell of
/// which.
std::optional<int> applyOffcuts(Document &document, const DocumentOptions &options,
                                const Verb &verb);

} // namespace fff::cli
