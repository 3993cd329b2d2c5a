// What a crash left (core/session/recovery.h) and no reader of ours can read. It may be the only
// copy of somebody's work, so nothing of it is ever removed here.
#pragma once

#include "core/base/result.h"

#include <QList>
#include <QString>

namespace fff {

struct UnreadableWork
{
    QString path; // where its document is kept
    Error why;    // NewerVersion: it stays in its slot, for the program that made it
};

/// Of the slots that nobody holds. A damaged one goes, blobs and all, into the folder "damaged" in
/// the recovery folder, where nobody looks for slots, so that it is told once; where it cannot be
/// moved it stays in its slot. One that cannot be opened may be later: it is not among them.
QList<UnreadableWork> setUnreadableAside(const QString &folder);

} // namespace fff
