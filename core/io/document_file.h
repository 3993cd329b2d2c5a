// Models and other files on disk: which format a file has is decided by what is in it; what is
// written is written whole or not at all.
#pragma once

#include "core/io/loaded_document.h"
#include "core/io/read_options.h"

#include <QtCore/QString>

#include <cstdint>

namespace fff::io {

struct SvgDrawing;

/// The format of these bytes by their first words, whatever the file is called: one that reads
/// models. Never null. Errors  Truncated for no bytes (or blanks only), NotAModel for anything else
/// that is no model.
Result<const Format *> detectFormat(std::string_view bytes, const std::string &name = {});

/// Largest file that is read, bytes: a hundred times the largest model anyone drew.
inline constexpr std::int64_t kMaxFileSize = std::int64_t(256) * 1024 * 1024;

/// The bytes of a file, or of a pipe or device until it ends (pipes.h). Errors  CannotOpen,
/// with the reason, also for a folder and for no name; BadCount above kMaxFileSize.
Result<std::string> readFile(const QString &path, const std::string &name = {});

/// Reads a model of whatever format. Errors  those of readFile, detectFormat and of the format.
Result<LoadedDocument> readDocument(const QString &path, const ReadOptions &options = {});

/// Reads a drawing. Its format is decided by what is in it, else by its name; errors call it by
/// that without the folder. Errors  those of readFile and of the format.
Result<SvgDrawing> readDrawing(const QString &path);

struct WriteOptions
{
    bool keepsBackup = false; // what the file was before goes to backupPath()
    // Where there was no file before, it is there before it is on the disk: a disk that is busy
    // for seconds must not keep it from those who would read it after a crash of the program.
    bool isThereAtOnce = false;
};

/// Where the version before the last save is kept: "fish.fff~" beside "fish.fff".
QString backupPath(const QString &path);

/// A model's bytes in a format that writes them, read back if the format can: what could not be
/// opened again is an error. name  how these call the file. Errors  those of the format; BadCount
/// above kMaxFileSize.
Result<std::string> modelBytes(const Document &document, const std::string &name,
                               const Format &format, const FormatValues &values = {});

/// Writes `.fff`, whatever the suffix. A document that could not be opened again does not replace
/// one that can. Errors  CannotWrite, those of modelBytes. The file that was there before stays as
/// it was when anything fails.
Result<void> writeDocument(const QString &path, const Document &document,
                           const WriteOptions &options = {});

/// Puts the bytes into a temporary file beside `path`, onto the disk, and renames it: at any moment
/// the file is the old one or the new one. "-" is standard output; to what is no file (a device, a
/// pipe) it is written straight. A symbolic link stays, what it points to is replaced; permissions
/// are kept. Errors  CannotWrite, args: "the disk is full", "this folder is read-only", "this file
/// is read-only" or else the system's reason; the old file is kept.
///
/// keepsBackup  the backup is replaced as a whole, too, once the new bytes are on the disk, and the
///              file is there all the while. Where neither a link nor a copy can be made, the file
///              is saved without one.
Result<void> writeFile(const QString &path, const std::string &bytes,
                       const WriteOptions &options = {});

} // namespace fff::io
