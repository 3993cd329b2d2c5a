// The formats of files as a table, which Open, Save, Insert, Import, Export, the command line and
// the words for what cannot be read are made from. A format is a file of its own and its line in
// formats.cpp.
#pragma once

#include "core/io/loaded_document.h"
#include "core/io/read_options.h"

#include <QtCore/QString>
#include <QtCore/QStringList>

#include <optional>
#include <span>
#include <vector>

namespace fff {
class Bodies;
class TriangleMesh;
struct CuttingDrawing;
struct Model;
} // namespace fff

namespace fff::io {

struct NamedBytes;
struct SvgDrawing;

/// What a file that is exported is for: the first thing that Export asks.
enum class FileUse { Cutting, Paper, Solids, Parts, Workshop };

/// A number that a reader or a writer may be told, or one of a few words: on the command line
/// "--NAME VALUE".
struct FormatOption
{
    enum class Of { Reading, Writing };
    struct Choice
    {
        const char *name = ""; // "r12"
        /// What Export offers in a row of its own, context "Format"; none for the usual one, which
        /// is the format's own, and for what is asked for on the command line alone.
        const char *title = "", *titleOfSheets = "";
        std::optional<FileUse> use = {}; // another one than the format's
    };

    const char *name = "";
    const char *value = ""; // how help calls it: "MM"
    const char *help = "";  // context "CommandLine"
    double least = 0.0, most = 0.0;
    Of of = Of::Writing;
    std::vector<Choice> choices = {}; // in place of a number: its value is its place among these
};

/// Texts are marked with QT_TRANSLATE_NOOP where they stand. Functions are null for what a format
/// cannot do. Names for errors, and Errors, are those of the reader or writer behind it.
struct Format
{
    const char *key = "";               // in what machines read
    std::vector<const char *> suffixes; // without a dot; the first is that of what is written
    const char *program = "";           // whose it is, by name; empty: ours, or everybody's
    // What is written, as a file dialog calls it, where each sheet has a file (none: one has all),
    // and where it is the skin; context "Format".
    const char *title = "", *titleOfSheets = "", *titleOfSkin = "";
    const char *titleOfFolder = ""; // where a folder has what else is packed; context "Format"
    const char *help = ""; // what `export` writes in it, within a sentence; context "CommandLine"
    std::vector<FormatOption> options = {};
    FileUse use = FileUse::Cutting; // of what is cut; solids and skins are FileUse::Solids
    bool isColoured = false;        // its colours are to be looked at, or may be

    /// By the first bytes, whatever the file is called.
    bool (*recognises)(std::string_view bytes) = nullptr;
    Result<LoadedDocument> (*readModel)(std::string_view bytes, const std::string &name,
                                        const ReadOptions &options) = nullptr;
    Result<SvgDrawing> (*readDrawing)(std::string_view bytes, const std::string &name) = nullptr;
    Result<std::string> (*writeModel)(const Document &, const FormatValues &) = nullptr;
    Result<std::string> (*writeCutting)(const CuttingDrawing &, const FormatValues &) = nullptr;
    /// What writeCutting() packs into one, by names within it.
    Result<std::vector<NamedBytes>> (*writeUnpacked)(const CuttingDrawing &) = nullptr;
    Result<std::string> (*writeSolids)(const Model &, const Bodies &,
                                       const FormatValues &) = nullptr;
    std::string (*writeSkin)(const TriangleMesh &) = nullptr;

    QString suffix() const { return QLatin1String(suffixes.front()); }
    bool readsModels() const { return readModel; }
    bool readsDrawings() const { return readDrawing; }
    bool writesModels() const { return writeModel; }
    bool writesCutting() const { return writeCutting; }
    bool writesSolids() const { return writeSolids; }
    bool writesSkins() const { return writeSkin; }
    bool showsJointColours() const { return isColoured; }
    bool isWritten() const { return writeModel || isExported(); }
    /// What is made from a model, for other programs and machines.
    bool isExported() const { return writeCutting || writeSolids || writeSkin; }
};

/// In the order in which they are offered.
std::span<const Format *const> formats();
using Ability = bool (Format::*)() const;
std::vector<const Format *> formatsThat(Ability ability);
/// That of Save: the first that writes models.
const Format &nativeFormat();

/// By the end of a file's name; null when none that can do this has it.
const Format *formatRead(const QString &path, Ability ability);
/// Of these only the first suffix counts. suffix  whatever the case
const Format *formatWritten(const QString &suffix, Ability ability = &Format::isWritten);

/// "*.fff *.txt": what can be read so, or is written so.
QString patternsRead(Ability ability);
QString patternOf(const Format &format);

/// For tests: one more, at the end, while this lives. On the main thread, when nothing is read.
class AddedFormat
{
public:
    explicit AddedFormat(const Format &format);
    ~AddedFormat();
    AddedFormat(const AddedFormat &) = delete;
    AddedFormat &operator=(const AddedFormat &) = delete;
};

} // namespace fff::io
