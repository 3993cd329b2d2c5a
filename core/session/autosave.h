// Keeps the open document in the recovery folder while it has unsaved changes, so that a crash
// costs no more than the last seconds. The window never waits for it: documents are written on a
// worker.
#pragma once

#include <QObject> // first: moc fails on standard headers that it meets before one of Qt's

#include "core/session/recovery.h"
#include "core/session/session.h"

#include <functional>
#include <memory>
#include <vector>

namespace fff {

/// Both injected by tests.
struct AutosaveClock
{
    std::function<qint64()> elapsed; // ms, never backwards, not the wall's
    std::function<QDateTime()> now;  // UTC, for people

    static AutosaveClock system();
};

/// From the first step on, also of a document that was never saved. A step after a clean state is
/// kept within kFirstDelay, later ones within the interval; an edit during a write leads to another
/// one. The slot is removed as soon as the session is clean: saved, undone, or another document.
class Autosave : public QObject
{
    Q_OBJECT
public:
    static constexpr int kFirstDelay = 500;         // ms
    static constexpr int kDefaultInterval = 10'000; // ms
    static constexpr int kLongestInterval = 28'000; // ms: with the write, 30 s are lost at most

    /// The session outlives it. `folder` need not exist; empty: nothing is kept.
    Autosave(Session &session, const QString &folder, QObject *parent = nullptr,
             AutosaveClock clock = AutosaveClock::system());
    /// Keeps what is not kept yet and lets go of the slot, which is listed from then on: discard()
    /// before when the document may go.
    ~Autosave() override;

    /// ms, taken into [0, kLongestInterval].
    void setInterval(int milliseconds);
    int interval() const;

    /// What the entry will say from the next write on. path: empty for one that was never saved.
    void setDocument(const QString &path, const QString &name);

    /// Opens what a crash left: it becomes the session's document, unsaved, and its slot becomes
    /// this one's, so that it is never without one. setDocument() is the caller's to do after. What
    /// of it was lost is said in the warnings.
    /// Errors  those of readRecoverable, CannotOpen when another window has it
    Result<std::vector<Warning>> adopt(const RecoveryEntry &entry);

    /// What is not saved may be lost: the slot goes, and nothing more is written until the next
    /// change. Call when a person closes without saving.
    void discard();

    /// Writes now what is not kept yet, and waits for it. For logging out, and tests.
    void flush();

    /// Writes if it is time; called by a timer of its own.
    void writeIfDue();

Q_SIGNALS:
    /// This document is on disk.
    void kept(const fff::Document &document);
    /// The slot is gone: there is nothing that a crash could cost.
    void cleared();
    /// The document could not be kept. Once, until it can be again; tried again meanwhile.
    void failed(const fff::Error &error);

private:
    class Private;
    std::unique_ptr<Private> d;
};

} // namespace fff
