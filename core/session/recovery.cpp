#include "core/session/recovery.h"

#include "core/io/document_file.h"
#include "core/io/fff_format.h"
#include "core/io/json_writer.h"
#include "core/session/slot_blobs.h"
#include "core/session/slot_files.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QUuid>

#include <algorithm>

namespace fff {

namespace {

/// {"recovery": {...},} as the first member of the document's object: readers of `.fff` pass it
/// over, and both are replaced in one go.
std::string withEntry(const std::string &document, const RecoveryEntry &entry)
{
    io::JsonWriter json;
    json.beginObject(io::JsonWriter::Layout::Line);
    json.member("path", entry.originalPath.toStdString());
    json.member("name", entry.name.toStdString());
    json.member("steps", entry.steps);
    json.member("time", entry.time.toUTC().toString(Qt::ISODateWithMs).toStdString());
    json.endObject();
    std::string text = json.take();
    text.pop_back(); // its line end
    return "{\n  \"recovery\": " + text + "," + document.substr(1);
}

RecoveryEntry entryOf(const QString &slot, const std::string &bytes)
{
    const QJsonObject recovery =
        QJsonDocument::fromJson(QByteArray::fromStdString(bytes))[QLatin1String("recovery")]
            .toObject();
    RecoveryEntry entry;
    entry.slot = slot;
    entry.originalPath = recovery[QLatin1String("path")].toString();
    entry.name = recovery[QLatin1String("name")].toString();
    entry.steps = std::max(0, recovery[QLatin1String("steps")].toInt());
    entry.time =
        QDateTime::fromString(recovery[QLatin1String("time")].toString(), Qt::ISODateWithMs);
    if (!entry.time.isValid())
        entry.time = QFileInfo(slotDocument(slot)).lastModified();
    entry.time = entry.time.toUTC();
    return entry;
}

} // namespace

RecoverySlot::RecoverySlot(const QString &path)
    : m_path(path), m_lock(std::make_unique<SlotLock>(slotLock(path)))
{
}

RecoverySlot::~RecoverySlot() = default;

std::unique_ptr<RecoverySlot> RecoverySlot::take(const QString &slot)
{
    std::unique_ptr<RecoverySlot> taken(new RecoverySlot(slot));
    return taken->m_lock->tryLock() ? std::move(taken) : nullptr;
}

bool RecoverySlot::isHeld(const QString &slot)
{
    return SlotLock::isHeld(slotLock(slot));
}

std::unique_ptr<RecoverySlot> RecoverySlot::make(const QString &folder)
{
    if (!QDir().mkpath(folder))
        return nullptr;
    return take(QDir(folder).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces)));
}

Result<void> RecoverySlot::write(const Document &document, const RecoveryEntry &entry)
{
    const Result<std::string> bytes = io::writeFff(document);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const std::string text = withEntry(*bytes, entry);
    // Nothing that could not be opened again replaces a copy that can.
    if (const auto again = io::readFff(text); !again)
        return tl::unexpected(again.error());
    if (Result<void> kept = writeSlotBlobs(slotBlobFolder(m_path), document); !kept)
        return kept;
    io::WriteOptions options;
    options.isThereAtOnce = true;
    Result<void> written = io::writeFile(slotDocument(m_path), text, options);
    if (written)
        removeOtherSlotBlobs(slotBlobFolder(m_path), document);
    return written;
}

void RecoverySlot::remove()
{
    removeSlotFiles(m_path);
    m_lock.reset();
}

QList<RecoveryEntry> listRecoverable(const QString &folder)
{
    QList<RecoveryEntry> entries;
    for (const QString &path : slotsIn(folder)) {
        if (RecoverySlot::isHeld(path))
            continue; // its program runs
        const Result<std::string> bytes = io::readFile(slotDocument(path));
        if (bytes && readSlotDocument(*bytes)) {
            entries.append(entryOf(path, *bytes));
        } else if (!QFile::exists(slotDocument(path))) {
            // It may have become another program's slot by now, and a document.
            const std::unique_ptr<RecoverySlot> slot = RecoverySlot::take(path);
            if (slot && !QFile::exists(slotDocument(path)))
                slot->remove();
        }
    }
    std::stable_sort(
        entries.begin(), entries.end(),
        [](const RecoveryEntry &a, const RecoveryEntry &b) { return a.time > b.time; });
    return entries;
}

Result<io::LoadedDocument> readRecoverable(const RecoveryEntry &entry)
{
    io::ReadOptions options;
    options.name = entry.name.toStdString();
    options.blobs = slotBlobs(slotBlobFolder(entry.slot));
    return io::readDocument(slotDocument(entry.slot), options);
}

bool discardRecoverable(const RecoveryEntry &entry)
{
    const std::unique_ptr<RecoverySlot> slot = RecoverySlot::take(entry.slot);
    if (slot)
        slot->remove();
    return slot != nullptr;
}

} // namespace fff
