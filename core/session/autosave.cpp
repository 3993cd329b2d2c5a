#include "core/session/autosave.h"

#include "core/session/journal.h"
#include "core/session/latest_job.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTimer>
#include <QUndoStack>

#include <algorithm>
#include <optional>

namespace fff {

namespace {

/// What the worker is asked for: a document to keep, or nothing to keep any more.
struct Request
{
    std::optional<Document> document;
    RecoveryEntry entry;
};

struct Answer
{
    std::optional<Document> document; // kept
    std::optional<Error> error;
};

} // namespace

AutosaveClock AutosaveClock::system()
{
    auto since = std::make_shared<QElapsedTimer>();
    since->start();
    return {[since] { return since->elapsed(); }, [] { return QDateTime::currentDateTimeUtc(); }};
}

class Autosave::Private
{
public:
    Private(Autosave *autosave, Session &session, const QString &folder, AutosaveClock clock);

    void changed();
    void write();
    void clear();
    int steps() const;
    Answer work(const Request &request);
    void publish(Answer answer);

    Autosave *q;
    Session &session;
    const QString folder;
    AutosaveClock clock;
    QTimer timer;
    int interval = kDefaultInterval;
    QString path, name;
    int adoptedSteps = 0; // made before the crash

    // A change that is not kept: since when it must be, on the clock.
    std::optional<qint64> due;
    std::optional<qint64> lastWrite;   // when the newest write of this slot was asked for
    std::optional<Document> requested; // the newest document that was given to the worker
    bool hasFailed = false;
    std::uint64_t sequence = 0;

    std::unique_ptr<RecoverySlot> slot; // the worker's, while it runs
    LatestJob<Request, Answer> job;     // last: waits for its worker before the slot goes
};

Autosave::Private::Private(Autosave *autosave, Session &ofSession, const QString &inFolder,
                           AutosaveClock injected)
    : q(autosave), session(ofSession), folder(inFolder), clock(std::move(injected)),
      job([this](const Request &request) { return work(request); },
          [this](std::uint64_t, Answer answer) { publish(std::move(answer)); })
{
    timer.setSingleShot(true);
}

/// The session's committed document may be another one, or clean.
void Autosave::Private::changed()
{
    if (folder.isEmpty())
        return;
    if (session.isClean()) {
        clear();
        return;
    }
    const qint64 now = clock.elapsed();
    if (due) {
        // Edits that come thick and fast may not leave the timer its turn.
        if (now >= *due)
            write();
        return;
    }
    if (requested && requested->isSame(session.committed().document))
        return;
    due = lastWrite ? std::max(now, *lastWrite + interval)
                    : now + std::min<qint64>(interval, kFirstDelay);
    timer.start(static_cast<int>(*due - now));
}

void Autosave::Private::clear()
{
    timer.stop();
    due.reset();
    lastWrite.reset();
    adoptedSteps = 0;
    if (!std::exchange(requested, std::nullopt))
        return; // there is no slot, or it is to go already
    job.request(++sequence, Request{});
}

/// From the saved state, wherever in the history it is; when it is in no history any more, from the
/// oldest. Something is not saved, so it is one at least.
int Autosave::Private::steps() const
{
    const QUndoStack &history = *session.history();
    const int clean = std::max(history.cleanIndex(), 0);
    return std::max(1, adoptedSteps + std::abs(history.index() - clean));
}

void Autosave::Private::write()
{
    timer.stop();
    due.reset();
    lastWrite = clock.elapsed();
    requested = session.committed().document;
    Request request;
    request.document = requested;
    request.entry.originalPath = path;
    request.entry.name = name;
    request.entry.steps = steps();
    request.entry.time = clock.now();
    job.request(++sequence, std::move(request));
}

/// On the worker. One request at a time and the newest last: nothing older replaces anything newer.
Answer Autosave::Private::work(const Request &request)
{
    if (!request.document) {
        if (slot)
            slot->remove();
        slot.reset();
        return {};
    }
    if (!slot)
        slot = RecoverySlot::make(folder);
    if (!slot)
        return {std::nullopt, Error{ErrorCode::CannotWrite,
                                    folder.toStdString(),
                                    {QT_TRANSLATE_NOOP("Error", "the folder cannot be used")}}};
    if (const Result<void> written = slot->write(*request.document, request.entry); !written)
        return {std::nullopt, written.error()};
    return {request.document, std::nullopt};
}

void Autosave::Private::publish(Answer answer)
{
    if (answer.document) {
        hasFailed = false;
        qCDebug(journal, "kept %s", digestOf(*answer.document).constData());
        Q_EMIT q->kept(*answer.document);
    } else if (!answer.error) {
        qCDebug(journal, "cleared");
        Q_EMIT q->cleared();
    } else {
        // Again after an interval, also without another change.
        if (requested && !due) {
            due = clock.elapsed() + interval;
            timer.start(interval);
        }
        if (!std::exchange(hasFailed, true))
            Q_EMIT q->failed(*answer.error);
    }
}

Autosave::Autosave(Session &session, const QString &folder, QObject *parent, AutosaveClock clock)
    : QObject(parent), d(std::make_unique<Private>(this, session, folder, std::move(clock)))
{
    connect(&d->timer, &QTimer::timeout, this, &Autosave::writeIfDue);
    // A commit of what a preview shows already is announced by the history alone.
    connect(session.history(), &QUndoStack::indexChanged, this, [this] { d->changed(); });
    connect(&session, &Session::modelChanged, this, [this] { d->changed(); });
    connect(&session, &Session::cleanChanged, this, [this] { d->changed(); });
}

Autosave::~Autosave()
{
    flush();
}

void Autosave::setInterval(int milliseconds)
{
    d->interval = std::clamp(milliseconds, 0, kLongestInterval);
    if (d->due && d->lastWrite) {
        d->due = std::min(*d->due, *d->lastWrite + d->interval);
        d->timer.start(static_cast<int>(std::max<qint64>(0, *d->due - d->clock.elapsed())));
    }
}

int Autosave::interval() const
{
    return d->interval;
}

void Autosave::setDocument(const QString &path, const QString &name)
{
    d->path = path;
    d->name = name;
}

Result<std::vector<Warning>> Autosave::adopt(const RecoveryEntry &entry)
{
    std::unique_ptr<RecoverySlot> slot = RecoverySlot::take(entry.slot);
    if (!slot)
        return failure(ErrorCode::CannotOpen, entry.name.toStdString(),
                       {RecoverySlot::isHeld(entry.slot)
                            ? QT_TRANSLATE_NOOP("Error", "it is open in another window")
                            : QT_TRANSLATE_NOOP("Error", "the folder cannot be used")});
    Result<io::LoadedDocument> loaded = readRecoverable(entry);
    if (!loaded)
        return tl::unexpected(loaded.error());
    d->session.reset(std::move(loaded->document)); // clears the slot of what was open
    d->job.finish();
    d->slot = std::move(slot);
    d->requested = d->session.committed().document; // what the slot holds
    d->adoptedSteps = entry.steps;
    d->lastWrite = d->clock.elapsed();
    d->session.setUnsaved();
    return std::move(loaded->warnings);
}

void Autosave::discard()
{
    d->clear();
    d->job.finish();
}

void Autosave::flush()
{
    if (d->due)
        d->write();
    d->job.finish();
}

void Autosave::writeIfDue()
{
    if (!d->due)
        return;
    const qint64 left = *d->due - d->clock.elapsed();
    if (left > 0)
        d->timer.start(static_cast<int>(left));
    else
        d->write();
}

} // namespace fff
