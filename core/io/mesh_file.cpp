#include "core/io/mesh_file.h"

#include "core/io/document_file.h"
#include "core/io/loaded_document.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>

#include <algorithm>

namespace fff::io {

namespace {

constexpr std::int64_t kHeadBytes = 1 << 16;
/// How much of the time reading takes, beside mending.
constexpr double kReadingShare = 0.6;

/// Progress of a part of the work as progress of all of it.
LongWork partOf(const LongWork &work, double from, double to)
{
    LongWork part;
    part.stop = work.stop;
    if (work.progress)
        part.progress = [tell = work.progress, from, to](double share) {
            tell(from + share * (to - from));
        };
    return part;
}

/// A file beside the mesh, by a name that stays in its folder.
Result<std::string> fileBeside(const QString &folder, const std::string &name)
{
    const QString relative = QString::fromStdString(name);
    const QString clean = QDir::cleanPath(relative);
    if (relative.isEmpty() || QDir::isAbsolutePath(relative) ||
        clean.startsWith(QLatin1String("..")) || relative.contains(QLatin1String(":")))
        return failure(ErrorCode::CannotOpen, name,
                       {QT_TRANSLATE_NOOP("Error", "it is in another folder")});
    return readFile(QDir(folder).filePath(clean), name);
}

std::optional<Error> whyTooLarge(const MeshFormat &format, std::string_view head,
                                 std::uint64_t size, const MeshOptions &options)
{
    const std::uint64_t claimed = format.claimed ? format.claimed(head, size) : 0;
    if (claimed > options.mostTriangles)
        return Error{ErrorCode::BadCount,
                     options.name,
                     {std::to_string(claimed), std::to_string(options.mostTriangles),
                      QT_TRANSLATE_NOOP("Error", "triangles")}};
    if (size > static_cast<std::uint64_t>(kMostMeshBytes))
        return Error{ErrorCode::BadCount,
                     options.name,
                     {std::to_string(size), std::to_string(kMostMeshBytes),
                      QT_TRANSLATE_NOOP("Error", "bytes")}};
    return std::nullopt;
}

Error withPlace(Error error, const std::string &name)
{
    if (error.place.empty())
        error.place = name;
    return error;
}

Result<LoadedMesh> readMeshKeeping(std::string bytes, const MeshOptions &options)
{
    Result<LoadedMesh> loaded = readMeshBytes(bytes, options);
    if (loaded)
        loaded->bytes = std::move(bytes);
    return loaded;
}

} // namespace

Result<LoadedMesh> readMeshBytes(std::string_view bytes, const MeshOptions &options)
{
    const Result<const MeshFormat *> format = meshFormatOf(bytes, options.name);
    if (!format)
        return tl::unexpected(format.error());
    if (const auto error = whyTooLarge(**format, bytes, bytes.size(), options))
        return tl::unexpected(*error);
    MeshOptions reading = options;
    reading.work = partOf(options.work, 0.0, kReadingShare);
    Result<MeshDraft> draft = (*format)->read(bytes, reading);
    if (!draft)
        return tl::unexpected(withPlace(draft.error(), options.name));
    Result<MendedMesh> mesh = mended(*std::move(draft), partOf(options.work, kReadingShare, 1.0));
    if (!mesh)
        return tl::unexpected(withPlace(mesh.error(), options.name));
    return LoadedMesh{std::move(mesh->mesh), mesh->report, *format, {}};
}

Result<LoadedMesh> readMesh(const QString &path, MeshOptions options)
{
    if (options.name.empty())
        options.name = path.toStdString();
    const QFileInfo info(path);
    if (!options.beside)
        options.beside = [folder = info.path()](const std::string &name) {
            return fileBeside(folder, name);
        };
    // Pipes and what cannot be opened are as with other files.
    if (!info.isFile()) {
        Result<std::string> bytes = readFile(path, options.name);
        if (!bytes)
            return tl::unexpected(std::move(bytes.error()));
        return readMeshKeeping(*std::move(bytes), options);
    }
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::CannotOpen, options.name, {file.errorString().toStdString()});
    std::string bytes = file.read(kHeadBytes).toStdString();
    const Result<const MeshFormat *> format = meshFormatOf(bytes, options.name);
    const auto size = static_cast<std::uint64_t>(std::max<qint64>(file.size(), 0));
    if (format)
        if (const auto error = whyTooLarge(**format, bytes, size, options))
            return tl::unexpected(*error);
    if (size > static_cast<std::uint64_t>(kMostMeshBytes))
        return tl::unexpected(*whyTooLarge({}, bytes, size, options));
    const auto head = static_cast<qint64>(bytes.size());
    bytes.resize(std::max(size, static_cast<std::uint64_t>(head)));
    const qint64 rest = file.read(bytes.data() + head, std::ssize(bytes) - head);
    if (rest < 0)
        return failure(ErrorCode::CannotOpen, options.name, {file.errorString().toStdString()});
    bytes.resize(static_cast<std::size_t>(head + rest));
    return readMeshKeeping(std::move(bytes), options);
}

} // namespace fff::io
