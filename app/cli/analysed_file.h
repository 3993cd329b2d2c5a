// What every verb that looks at one model begins with.
#pragma once

#include "app/cli/command_line.h"

namespace fff::cli {

/// A model that was asked for, analysed, or the status to return after the reason was printed.
struct AnalysedFile
{
    std::optional<int> status;
    QString file;
    std::string format; // "fff" or "flatfab"
    std::vector<Warning> warnings;
    Analysis analysis;
    bool asJson = false;
};

/// For a verb with one file, --json and the options that override the document, besides those that
/// the parser has already.
AnalysedFile analysedFile(const char *verb, const QStringList &arguments,
                          QCommandLineParser &parser);
AnalysedFile analysedFile(const char *verb, const QStringList &arguments);

} // namespace fff::cli
