// Writing what a verb made, by the kind of its file.
#pragma once

#include "app/cli/command_line.h"

namespace fff::cli {

/// -o, --format and what belongs to cutting files.
void addOutputOptions(QCommandLineParser &parser);

/// Empty when -o names a file of a kind that can be written; else why not.
QString whyNoOutput(const QCommandLineParser &parser);

/// Writes the document in the format that -o or --format names: the model itself, what is cut of it
/// (in one file or one a sheet), its solids, or its skin. Says on standard error what was made and
/// what does not fit. `input` names the file it came from in errors. Returns the exit status.
int writeOutput(const QCommandLineParser &parser, const Verb &verb, const Document &document,
                const QString &input);

} // namespace fff::cli
