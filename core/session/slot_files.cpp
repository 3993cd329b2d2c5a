#include "core/session/slot_files.h"

#include "core/io/fff_file.h"
#include "core/session/slot_blobs.h"

#include <QDir>
#include <QFileInfo>

namespace fff {

namespace {

const QString kDocumentSuffix = QStringLiteral(".fff");
const QString kLockSuffix = QStringLiteral(".lock");
const QString kBlobsSuffix = QStringLiteral(".blobs");

bool isLinked(const QString &slot)
{
    for (const QString &path : {slotDocument(slot), slotLock(slot), slotBlobFolder(slot)})
        if (QFileInfo(path).isSymLink())
            return true;
    return false;
}

} // namespace

QString slotDocument(const QString &slot)
{
    return slot + kDocumentSuffix;
}

QString slotLock(const QString &slot)
{
    return slot + kLockSuffix;
}

QString slotBlobFolder(const QString &slot)
{
    return slot + kBlobsSuffix;
}

QStringList slotDocuments(const QString &slot)
{
    const QFileInfo document(slotDocument(slot));
    return document.dir().entryList({document.fileName() + u'*'}, QDir::Files);
}

QStringList slotsIn(const QString &folder)
{
    QStringList paths;
    const QDir dir(folder);
    const auto all = QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot | QDir::Hidden;
    for (const QFileInfo &file : dir.entryInfoList(all)) {
        // A copy that was being written is called "NAME.fff.XXXXXX".
        const QString name = file.fileName();
        const bool isOurs = file.isDir()
                                ? name.endsWith(kBlobsSuffix)
                                : name.contains(kDocumentSuffix) || name.endsWith(kLockSuffix);
        const QString path = dir.filePath(name.left(name.indexOf(u'.')));
        if (isOurs && name.indexOf(u'.') > 0 && !paths.contains(path) && !isLinked(path))
            paths.append(path);
    }
    return paths;
}

void removeSlotFiles(const QString &slot)
{
    QDir dir = QFileInfo(slot).dir();
    for (const QString &name : slotDocuments(slot))
        dir.remove(name);
    removeOtherSlotBlobs(slotBlobFolder(slot), {});
}

Result<io::LoadedDocument> readSlotDocument(const std::string &bytes)
{
    return io::readFffFile(bytes, {}, [](const std::string &) -> Result<io::BlobBytes> {
        return failure(ErrorCode::BadArchive);
    });
}

} // namespace fff
