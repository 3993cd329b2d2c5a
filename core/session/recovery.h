// What a crash leaves: documents that the program kept beside the person's own files while they
// were edited (core/session/autosave.h). For the start page's "Recovered" rows; holds no widget.
//
// A recovery folder has two files a slot: "NAME.fff", the document (a text of that format, with an
// object "recovery" that says what it is), and "NAME.lock", held by the program that writes it
// (core/session/slot_lock.h); and "NAME.blobs", a folder, while the document has blobs
// (core/session/slot_blobs.h). The document is replaced as a whole, so that it is complete at any
// moment, and by none that could not be opened again.
#pragma once

#include "core/io/loaded_document.h"
#include "core/session/slot_lock.h"

#include <QDateTime>
#include <QList>
#include <QString>

#include <memory>

namespace fff {

struct RecoveryEntry
{
    QString slot;         // path of the slot without its suffixes
    QString originalPath; // of the file that was open; empty: never saved
    QString name;         // as the window called it; may be empty
    int steps = 0;        // since it was saved
    QDateTime time;       // UTC, when it was kept
};

/// Newest first: every slot whose program is gone. Those of running programs, this one included,
/// are never among them. What is left of a slot without a document is cleaned away; one that cannot
/// be read stays (core/session/unreadable_work.h). No entries for a folder that is not there.
QList<RecoveryEntry> listRecoverable(const QString &folder);

/// To look at, say for a thumbnail; Autosave::adopt opens it. Errors  those of io::readDocument
/// Warnings  MissingBlob: a picture or a mesh that was lost; the rest is there
Result<io::LoadedDocument> readRecoverable(const RecoveryEntry &entry);

/// The person wants it no more. False when another window has opened it meanwhile.
bool discardRecoverable(const RecoveryEntry &entry);

/// One slot, held: nobody else lists, opens or removes it. Used by Autosave on its worker.
class RecoverySlot
{
public:
    /// A new slot in this folder, which is made when it is not there; null when that is not
    /// possible.
    static std::unique_ptr<RecoverySlot> make(const QString &folder);
    /// A slot that is there. Null when somebody holds it.
    static std::unique_ptr<RecoverySlot> take(const QString &slot);
    static bool isHeld(const QString &slot);
    ~RecoverySlot(); // lets go of it; what was written stays

    /// slot is that of this object, whatever the entry says. Blobs are there before the document
    /// that names them is, and go after it.
    Result<void> write(const Document &document, const RecoveryEntry &entry);
    /// The document goes, and the slot with it: last call.
    void remove();
    const QString &path() const { return m_path; }

private:
    explicit RecoverySlot(const QString &path);

    QString m_path;
    std::unique_ptr<SlotLock> m_lock;
};

} // namespace fff
