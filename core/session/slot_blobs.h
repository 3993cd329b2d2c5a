// The blobs of a document that is kept in a slot of the recovery folder: files by their hash, in a
// folder of the slot's own, so that no other program's slot has a say in which of them are needed.
// Whoever holds the slot calls.
#pragma once

#include "core/io/blobs.h"
#include "core/model/document.h"

#include <QString>

namespace fff {

/// A folder is that of one slot; it need not exist. Each blob is written once: one that is there
/// stays as it is. Errors  CannotWrite
Result<void> writeSlotBlobs(const QString &folder, const Document &document);

/// Those that the document does not have go, and the folder when it is empty.
void removeOtherSlotBlobs(const QString &folder, const Document &document);

/// Errors of what it reads  BadArchive: missing, or other bytes than they were.
io::BlobSource slotBlobs(const QString &folder);

} // namespace fff
