// Meshes on the command line: put beside a model (--template), and made into one of their own.
#pragma once

#include "app/cli/command_line.h"

namespace fff::cli {

/// --template TEMPLATE[@SIZE], which may be given several times.
void addTemplateOption(QCommandLineParser &parser);
/// Reads these meshes and puts them beside the model, as the window would. The status to return
/// after the reason was printed, where one cannot be read or its size is none.
std::optional<int> addTemplates(Document &document, const QCommandLineParser &parser,
                                const Verb &verb);

/// -o OUT.fff and --size of verbs that make a model of a mesh.
void addMeshModelOptions(QCommandLineParser &parser);

/// What such a verb starts from.
struct MeshModel
{
    std::optional<int> status; // to return; the reason was printed
    Document document;         // a new one with the mesh as its only template, and the options
};
/// Looks at all options before it reads the mesh; what was mended in it is said on standard error.
MeshModel readMeshModel(const QString &file, const QCommandLineParser &parser, const Verb &verb);

/// Writes the model as a .fff file. The exit status.
int writeMeshModel(const Document &document, const QCommandLineParser &parser);

/// A whole number from an option, if it was given. Prints and sets `status` as number() does.
std::optional<int> wholeNumber(const QCommandLineParser &parser, const Verb &verb,
                               const char *option, int least, int most, std::optional<int> &status);

} // namespace fff::cli
