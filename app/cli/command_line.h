// The verbs of flatfitfab-cli and what they share: options, reading, exit statuses.
#pragma once

#include "app/cli/terminal.h"
#include "core/analysis/analysis.h"
#include "core/base/result.h"
#include "core/base/tolerances.h"
#include "core/io/document_file.h"
#include "core/io/formats.h"

#include <QCommandLineParser>
#include <QStringList>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fff::cli {

/// The published exit statuses.
enum ExitStatus { Done = 0, WrongUse = 1, BadInput = 2, ProblemsFound = 3, CannotWrite = 4 };

struct Verb
{
    const char *name;
    const char *usage;   // behind the name, untranslated; %1: the suffixes of what is written
    const char *purpose; // one line; none: what it writes, by the table of formats
    int (*run)(const QStringList &arguments);
    bool isOfModels = false; // formats of models are named before others
};

/// All verbs; a new one is one file and one line here.
std::span<const Verb> verbs();

int runInfo(const QStringList &arguments);
int runCheck(const QStringList &arguments);
int runSimulate(const QStringList &arguments);
int runParts(const QStringList &arguments);
int runExport(const QStringList &arguments);
int runRender(const QStringList &arguments); // only where the window is built
int runSteps(const QStringList &arguments);  // the same
int runOperations(const QStringList &arguments);
int runCut(const QStringList &arguments);
int runSuggest(const QStringList &arguments);
int runSlices(const QStringList &arguments);
int runFacets(const QStringList &arguments);
int runNest(const QStringList &arguments);
int runReplay(const QStringList &arguments);
int runValues(const QStringList &arguments);
int runVariants(const QStringList &arguments);

/// The arguments of one verb: options from `parser`, and exactly `files` file names in front of or
/// between them. When they make no sense, or help was asked for, the texts are printed and `status`
/// is what to return.
struct Arguments
{
    std::optional<int> status;
    QStringList files;
};
Arguments parse(QCommandLineParser &parser, const Verb &verb, const QStringList &arguments,
                int files);
const Verb &verbNamed(const char *name);

/// "a .fff file or a FlatFab .txt file": what can be read.
QString modelFiles();

/// "export FILE -o OUT.{svg,obj,fff} [options]", and what it is for.
QString usageOf(const Verb &verb);
QString purposeOf(const Verb &verb);

/// --set, --thickness, --stock, --kerf, --clearance, --sheet, --offcut: they override the document
/// for this run, values first, so that a plain number counts in place of what is made of them; and
/// what readers may be told (core/io/formats.h), and --verbose.
void addDocumentOptions(QCommandLineParser &parser);

/// A sheet besides those that its stock has.
struct AskedOffcut
{
    QString text;  // as it was typed
    QString stock; // its name; empty: the model's only one
    SpareSheet sheet;
};

/// Their values, as asked for.
struct DocumentOptions
{
    std::optional<double> thickness, kerf, clearance; // mm
    std::optional<Vec2> sheet;                        // mm
    std::optional<int> sheetCount;                    // of whole ones
    std::vector<AskedOffcut> offcuts;
    std::optional<QString> stock;
    QStringList values;       // NAME=VALUE
    io::FormatValues reading; // of the formats' options
    bool isVerbose = false;   // each warning of the reader with its line, not only what they mean
};
/// Nothing, and `status` to return, when one makes no sense; the reason was printed.
std::optional<DocumentOptions> documentOptions(const QCommandLineParser &parser, const Verb &verb,
                                               std::optional<int> &status);

/// A document read with its options applied, or the status to return after the reason was printed.
/// What the reader mended is said on standard error.
struct Loaded
{
    std::optional<int> status;
    Document document;
    std::string format; // its key, "fff" or "flatfab"
    std::vector<Warning> warnings;
};
Loaded load(const QString &file, const DocumentOptions &options, const Verb &verb);
/// Applies the options to a document. The status after printing, if wrong.
std::optional<int> applyOptions(Document &document, const DocumentOptions &options,
                                const Verb &verb);

/// "600x400": two positive numbers.
std::optional<Vec2> sizeOf(const QString &text);

/// Prints one line on standard error and gives the status that fits the error's code.
int report(const Error &error);
/// The same of an error that is about all of a file.
int report(Error error, const QString &file);
int wrongUse(const Verb &verb, const QString &reason);

/// The options of all formats for reading, or for writing, and their values as far as they are
/// given. Prints and sets `status` as number() does.
void addFormatOptions(QCommandLineParser &parser, io::FormatOption::Of of);
io::FormatValues formatValues(const QCommandLineParser &parser, const Verb &verb,
                              io::FormatOption::Of of, std::optional<int> &status);

/// Value of an option as a number, mm, if it was given. Prints and sets `status` when it is none or
/// not within the limits.
std::optional<double> number(const QCommandLineParser &parser, const Verb &verb, const char *option,
                             double minimum, std::optional<int> &status,
                             double maximum = kMaxCoordinate);

} // namespace fff::cli
