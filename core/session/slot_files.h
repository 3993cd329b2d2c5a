// What a slot of the recovery folder (core/session/recovery.h) has on disk. A slot is named by its
// path without suffixes.
#pragma once

#include "core/io/loaded_document.h"

#include <QString>
#include <QStringList>

#include <string>

namespace fff {

QString slotDocument(const QString &slot); // a file
QString slotLock(const QString &slot);     // a file
QString slotBlobFolder(const QString &slot);

/// The document and copies of it that were being written: their names, in the slot's folder.
QStringList slotDocuments(const QString &slot);

/// Slots by their paths, each once, whichever of their files are there. Not those of which
/// something is a symbolic link, which no FlatFitFab makes: what it leads to is somebody else's.
QStringList slotsIn(const QString &folder);

/// What is left of a slot goes: its document, copies of it, and its blobs.
void removeSlotFiles(const QString &slot);

/// What is in a slot's document, without its blobs. Errors  those of io::readFffFile
Result<io::LoadedDocument> readSlotDocument(const std::string &bytes);

} // namespace fff
