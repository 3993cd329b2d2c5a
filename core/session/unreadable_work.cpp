#include "core/session/unreadable_work.h"

#include "core/io/document_file.h"
#include "core/session/recovery.h"
#include "core/session/slot_files.h"

#include <QDir>
#include <QFileInfo>

#include <optional>

namespace fff {

namespace {

/// Why a document that is there and can be opened cannot be read.
std::optional<Error> whyUnreadable(const QString &slot)
{
    const Result<std::string> bytes = io::readFile(slotDocument(slot));
    if (!bytes)
        return std::nullopt;
    const Result<io::LoadedDocument> document = readSlotDocument(*bytes);
    return document ? std::nullopt : std::optional(document.error());
}

/// "damaged/NAME", or "damaged/NAME-2" and so on where an earlier one has that name.
QString freeSlot(const QString &slot, const QString &folder)
{
    const QString first = QDir(folder).filePath(QFileInfo(slot).fileName());
    const bool hasBlobs = QFileInfo::exists(slotBlobFolder(slot));
    QString free = first;
    for (int i = 2; QFileInfo::exists(slotDocument(free)) ||
                    (hasBlobs && QFileInfo::exists(slotBlobFolder(free)));
         ++i)
        free = first + u'-' + QString::number(i);
    return free;
}

/// Where its document is then. Blobs go first: alone in a slot they would be waste.
QString movedAside(const QString &slot)
{
    QDir dir = QFileInfo(slot).dir();
    const QString folder = dir.filePath(QStringLiteral("damaged"));
    if (!dir.mkpath(folder))
        return slotDocument(slot);
    const QString to = freeSlot(slot, folder);
    if (QFileInfo::exists(slotBlobFolder(slot)) &&
        !dir.rename(slotBlobFolder(slot), slotBlobFolder(to)))
        return slotDocument(slot);
    const QString name = QFileInfo(slotDocument(slot)).fileName();
    bool isMoved = true;
    for (const QString &file : slotDocuments(slot)) // copies that were being written, too
        isMoved = dir.rename(file, slotDocument(to) + file.mid(name.size())) && isMoved;
    return isMoved ? slotDocument(to) : slotDocument(slot);
}

} // namespace

QList<UnreadableWork> setUnreadableAside(const QString &folder)
{
    QList<UnreadableWork> works;
    for (const QString &path : slotsIn(folder)) {
        std::optional<Error> why = RecoverySlot::isHeld(path) ? std::nullopt : whyUnreadable(path);
        if (!why)
            continue;
        if (why->code == ErrorCode::NewerVersion) {
            works.append({slotDocument(path), *why});
            continue;
        }
        // It may have become another program's slot by now, and a document.
        const std::unique_ptr<RecoverySlot> slot = RecoverySlot::take(path);
        why = slot ? whyUnreadable(path) : std::nullopt;
        if (why)
            works.append({movedAside(path), *why});
    }
    return works;
}

} // namespace fff
