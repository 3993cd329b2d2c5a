#include "core/io/document_file.h"

#include "core/io/formats.h"
#include "core/io/pipes.h"
#include "core/io/replacement.h"
#include "core/io/svg_reader.h"
#include "core/io/template_file.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#ifdef Q_OS_UNIX
#include <fcntl.h>
#include <unistd.h>
#endif

namespace fff::io {

namespace {

constexpr const char *kNoNameReason = QT_TRANSLATE_NOOP("Error", "a file needs a name");

tl::unexpected<Error> cannot(ErrorCode code, const QString &path, const QString &reason)
{
    return failure(code, path.toStdString(), {reason.toStdString()});
}

tl::unexpected<Error> tooLarge(const std::string &place, std::size_t size)
{
    return failure(
        ErrorCode::BadCount, place,
        {std::to_string(size), std::to_string(kMaxFileSize), QT_TRANSLATE_NOOP("Error", "bytes")});
}

/// Why a file could not be written to `target`, or made beside it and put in its place.
QString whyNot(int number, const QString &target)
{
    const QFileInfo info(target);
    if (info.exists() && !info.isWritable())
        return QLatin1String(QT_TRANSLATE_NOOP("Error", "this file is read-only"));
    if (isRefusal(number) && QFileInfo(info.path()).isDir())
        return QLatin1String(QT_TRANSLATE_NOOP("Error", "this folder is read-only"));
    return systemReason(number);
}

/// So that the rename itself outlasts a power cut. Nothing is lost where it cannot be.
void putFolderOnDisk(const QString &folder)
{
#ifdef Q_OS_UNIX
    const int handle = ::open(QFile::encodeName(folder).constData(), O_RDONLY | O_CLOEXEC);
    if (handle < 0)
        return;
    fsync(handle);
    ::close(handle);
#else
    Q_UNUSED(folder)
#endif
}

/// A second name for the file, or a copy; never half of one.
void keepBackup(const QString &path)
{
    const QString backup = backupPath(path);
#ifdef Q_OS_UNIX
    const QString temporary = backup + QStringLiteral(".new");
    const QByteArray from = QFile::encodeName(path), made = QFile::encodeName(temporary);
    ::unlink(made.constData()); // of a save that was killed
    if (::link(from.constData(), made.constData()) == 0) {
        if (std::rename(made.constData(), QFile::encodeName(backup).constData()) != 0)
            ::unlink(made.constData());
        return;
    }
#endif
    QFile old(path);
    Replacement copy(backup);
    if (old.open(QIODevice::ReadOnly) && copy.write(old.readAll().toStdString()) == 0)
        copy.commit();
}

Result<void> writeStraight(const QString &path, const std::string &bytes)
{
    QFile file;
    if (const Result<void> opened = openForWriting(path, file); !opened)
        return opened;
    const auto size = static_cast<qint64>(bytes.size());
    errno = 0;
    if (file.write(bytes.data(), size) != size)
        return cannot(ErrorCode::CannotWrite, path,
                      errno == 0 ? file.errorString() : whyNot(errno, path));
    return {};
}

Result<void> writeStandardOutput(const std::string &bytes)
{
    QFile out;
    const auto size = static_cast<qint64>(bytes.size());
    if (!out.open(stdout, QIODevice::WriteOnly) || out.write(bytes.data(), size) != size ||
        !out.flush())
        return cannot(ErrorCode::CannotWrite, QStringLiteral("-"), out.errorString());
    return {};
}

} // namespace

Result<const Format *> detectFormat(std::string_view bytes, const std::string &name)
{
    const std::string_view text = withoutByteOrderMark(bytes);
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        return failure(ErrorCode::Truncated, placeIn(name, "1"),
                       {QT_TRANSLATE_NOOP("Error", "a model")});
    for (const Format *format : formats())
        if (format->readsModels() && format->recognises(bytes))
            return format;
    return failure(ErrorCode::NotAModel, name);
}

Result<std::string> readFile(const QString &path, const std::string &name)
{
    const std::string place = name.empty() ? path.toStdString() : name;
    const QFileInfo info(path);
    if (path.isEmpty())
        return failure(ErrorCode::CannotOpen, place, {kNoNameReason});
    if (info.isDir())
        return failure(ErrorCode::CannotOpen, place,
                       {QT_TRANSLATE_NOOP("Error", "it is a folder")});
    constexpr auto kMost = static_cast<std::size_t>(kMaxFileSize);
    if (info.exists() && !info.isFile()) {
        Result<std::string> bytes = readPipe(path, kMaxFileSize, place);
        if (bytes && bytes->size() > kMost)
            return tooLarge(place, bytes->size());
        return bytes;
    }
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::CannotOpen, place, {file.errorString().toStdString()});
    if (file.size() > kMaxFileSize)
        return tooLarge(place, static_cast<std::size_t>(file.size()));
    // One byte more than allowed: files of /proc do not tell their size.
    const QByteArray bytes = file.read(kMaxFileSize + 1);
    if (file.error() != QFileDevice::NoError)
        return failure(ErrorCode::CannotOpen, place, {file.errorString().toStdString()});
    if (bytes.size() > kMaxFileSize)
        return tooLarge(place, static_cast<std::size_t>(bytes.size()));
    return bytes.toStdString();
}

Result<LoadedDocument> readDocument(const QString &path, const ReadOptions &options)
{
    const std::string name = options.name.empty() ? path.toStdString() : options.name;
    const Result<std::string> bytes = readFile(path, name);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const Result<const Format *> format = detectFormat(*bytes, name);
    if (!format)
        return tl::unexpected(format.error());
    Result<LoadedDocument> loaded = (*format)->readModel(*bytes, name, options);
    if (loaded) {
        loaded->format = *format;
        loaded->document =
            withTemplateContents(std::move(loaded->document), loaded->warnings, options.work);
    }
    return loaded;
}

Result<SvgDrawing> readDrawing(const QString &path)
{
    const std::string name = QFileInfo(path).fileName().toStdString();
    const Result<std::string> bytes = readFile(path, name);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const std::vector<const Format *> known = formatsThat(&Format::readsDrawings);
    const auto recognised = std::find_if(known.begin(), known.end(), [&](const Format *format) {
        return format->recognises(*bytes);
    });
    const Format *named = formatRead(path, &Format::readsDrawings);
    const Format *format = recognised != known.end() ? *recognised : named ? named : known.front();
    return format->readDrawing(*bytes, name);
}

QString backupPath(const QString &path)
{
    return path + u'~';
}

Result<std::string> modelBytes(const Document &document, const std::string &name,
                               const Format &format, const FormatValues &values)
{
    Result<std::string> bytes = format.writeModel(document, values);
    if (!bytes)
        return bytes;
    if (bytes->size() > static_cast<std::size_t>(kMaxFileSize))
        return tooLarge(name, bytes->size());
    if (format.readsModels()) {
        if (const auto again = format.readModel(*bytes, name, {}); !again)
            return tl::unexpected(again.error());
    }
    return bytes;
}

Result<void> writeDocument(const QString &path, const Document &document,
                           const WriteOptions &options)
{
    return modelBytes(document, path.toStdString(), nativeFormat())
        .and_then([&](const std::string &bytes) { return writeFile(path, bytes, options); });
}

Result<void> writeFile(const QString &path, const std::string &bytes, const WriteOptions &options)
{
    if (path == QLatin1String("-"))
        return writeStandardOutput(bytes);
    if (path.isEmpty())
        return failure(ErrorCode::CannotWrite, {}, {kNoNameReason});
    const QFileInfo there(path);
    if (there.isDir())
        return cannot(ErrorCode::CannotWrite, path,
                      QLatin1String(QT_TRANSLATE_NOOP("Error", "it is a folder")));
    if (there.exists() && !there.isFile())
        return writeStraight(path, bytes);
    Replacement file(path);
    const QString &target = file.target();
    const auto failed = [&](int number) {
        return cannot(ErrorCode::CannotWrite, path, whyNot(number, target));
    };
    if (const int number = file.write(bytes))
        return failed(number);
    const bool isNamedFirst = options.isThereAtOnce && !there.exists();
    if (const int number = isNamedFirst ? 0 : file.putOnDisk())
        return failed(number);
    if (options.keepsBackup && there.exists())
        keepBackup(target);
    if (const int number = file.commit())
        return failed(number);
    if (const int number = isNamedFirst ? file.putOnDisk() : 0)
        return failed(number);
    putFolderOnDisk(QFileInfo(target).path());
    return {};
}

} // namespace fff::io
