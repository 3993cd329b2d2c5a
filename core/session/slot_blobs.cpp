#include "core/session/slot_blobs.h"

#include "core/io/document_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace fff {

namespace {

QString pathOf(const QString &folder, const std::string &sha256)
{
    return folder + u'/' + QString::fromStdString(sha256);
}

} // namespace

Result<void> writeSlotBlobs(const QString &folder, const Document &document)
{
    if (document.blobs.empty())
        return {};
    if (!QDir().mkpath(folder))
        return failure(ErrorCode::CannotWrite, folder.toStdString(),
                       {QT_TRANSLATE_NOOP("Error", "the folder cannot be used")});
    for (const BlobPointer &blob : document.blobs) {
        const QString path = pathOf(folder, blob->sha256);
        // A file gets its name when all of it is there.
        const QFileInfo there(path);
        if (there.exists() && there.size() == static_cast<qint64>(blob->bytes->size()))
            continue;
        if (Result<void> written = io::writeFile(path, *blob->bytes); !written)
            return written;
    }
    return {};
}

void removeOtherSlotBlobs(const QString &folder, const Document &document)
{
    QDir dir(folder);
    if (!dir.exists())
        return;
    for (const QString &name : dir.entryList(QDir::Files | QDir::Hidden))
        if (!document.findBlob(name.toStdString()))
            dir.remove(name);
    QDir().rmdir(folder); // not while something is in it
}

io::BlobSource slotBlobs(const QString &folder)
{
    return [folder](const std::string &sha256) -> Result<io::BlobBytes> {
        Result<std::string> bytes = io::readFile(pathOf(folder, sha256));
        if (!bytes)
            return failure(ErrorCode::BadArchive, {},
                           {QT_TRANSLATE_NOOP("Error", "its data is missing")});
        if (io::sha256Of(*bytes) != sha256)
            return failure(ErrorCode::BadArchive, {},
                           {QT_TRANSLATE_NOOP("Error", "its data is damaged")});
        return std::make_shared<const std::string>(*std::move(bytes));
    };
}

} // namespace fff
