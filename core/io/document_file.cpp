#include "core/io/document_file.h"

#include "core/io/fff_format.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QSaveFile>
#include <cstdio>

namespace fff::io {

namespace {

tl::unexpected<Error> cannot(ErrorCode code, const QString &path, const QString &reason)
{
    return failure(code, path.toStdString(), {reason.toStdString()});
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

Result<ModelFormat> detectFormat(std::string_view bytes, const std::string &name)
{
    const std::string_view text = withoutByteOrderMark(bytes);
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos)
        return failure(ErrorCode::Truncated, placeIn(name, "1"),
                       {QT_TRANSLATE_NOOP("Error", "a model")});
    if (looksLikeFlatfab(text))
        return ModelFormat::Flatfab;
    // Text has no zero bytes; what has is a picture, a program or the like.
    if (text[begin] == '{' && text.find('\0') == std::string_view::npos)
        return ModelFormat::Fff;
    return failure(ErrorCode::NotAModel, name);
}

Result<std::string> readFile(const QString &path, const std::string &name)
{
    const std::string place = name.empty() ? path.toStdString() : name;
    if (QFileInfo(path).isDir())
        return failure(ErrorCode::CannotOpen, place,
                       {QT_TRANSLATE_NOOP("Error", "it is a folder")});
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::CannotOpen, place, {file.errorString().toStdString()});
    const auto tooLarge = [&](qint64 size) {
        return failure(ErrorCode::BadCount, place,
                       {std::to_string(size), std::to_string(kMaxFileSize),
                        QT_TRANSLATE_NOOP("Error", "bytes")});
    };
    if (file.size() > kMaxFileSize)
        return tooLarge(file.size());
    // One byte more than allowed: devices and pipes do not tell their size.
    const QByteArray bytes = file.read(kMaxFileSize + 1);
    if (file.error() != QFileDevice::NoError)
        return failure(ErrorCode::CannotOpen, place, {file.errorString().toStdString()});
    if (bytes.size() > kMaxFileSize)
        return tooLarge(bytes.size());
    return bytes.toStdString();
}

Result<LoadedDocument> readDocument(const QString &path, const ReadOptions &options)
{
    const std::string name = options.name.empty() ? path.toStdString() : options.name;
    const Result<std::string> bytes = readFile(path, name);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const Result<ModelFormat> format = detectFormat(*bytes, name);
    if (!format)
        return tl::unexpected(format.error());
    switch (*format) {
    case ModelFormat::Fff:
        return readFff(*bytes, name);
    case ModelFormat::Flatfab:
        break;
    }
    return readFlatfab(*bytes, name, options.flatfab);
}

Result<void> writeDocument(const QString &path, const Document &document)
{
    const Result<std::string> bytes = writeFff(document);
    if (!bytes)
        return tl::unexpected(bytes.error());
    if (const auto again = readFff(*bytes, path.toStdString()); !again)
        return tl::unexpected(again.error());
    return writeFile(path, *bytes);
}

Result<void> writeFile(const QString &path, const std::string &bytes)
{
    if (path == QLatin1String("-"))
        return writeStandardOutput(bytes);
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return cannot(ErrorCode::CannotWrite, path, file.errorString());
    const auto size = static_cast<qint64>(bytes.size());
    // Flushed by hand: commit() puts the new file in place although its own flush failed.
    if (file.write(bytes.data(), size) != size || !file.flush() || !file.commit())
        return cannot(ErrorCode::CannotWrite, path, file.errorString());
    return {};
}

} // namespace fff::io
