#include "ui/files/unsaved_work.h"

#include "core/io/error_text.h"
#include "core/io/warning_summary.h"
#include "core/session/autosave.h"
#include "core/session/unreadable_work.h"
#include "ui/base/ago_text.h"
#include "ui/base/message_bar.h"
#include "ui/bench/workbench.h"
#include "ui/files/document_files.h"
#include "ui/settings/settings.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QSet>
#include <QUrl>

#include <algorithm>
#include <optional>

namespace fff::ui {

namespace {

constexpr int kMilliseconds = 1000; // a second

QString folder()
{
    return Settings::dataFolder() + QStringLiteral("/recovery");
}

std::optional<RecoveryEntry> entryOf(const QString &id)
{
    for (const RecoveryEntry &entry : listRecoverable(folder())) {
        if (entry.slot == id)
            return entry;
    }
    return std::nullopt;
}

/// Of all windows: what was set aside is found once, and told until somebody has read it.
struct Unreadable
{
    QList<UnreadableWork> found;
    QSet<QString> noted;
};

Unreadable &unreadableSoFar()
{
    static Unreadable unreadable;
    return unreadable;
}

} // namespace

UnsavedWork::UnsavedWork(Workbench &bench, DocumentFiles &files, MessageBar &messages,
                         QObject *parent)
    : QObject(parent), m_bench(bench), m_files(files), m_messages(messages),
      m_autosave(std::make_unique<Autosave>(bench.session(), folder()))
{
    connect(&settings(), &Settings::autosaveChanged, this, &UnsavedWork::follow);
    connect(&files, &DocumentFiles::pathChanged, this, &UnsavedWork::follow);
    connect(m_autosave.get(), &Autosave::failed, this, [this](const Error &error) {
        m_messages.show(
            MessageBar::Severity::Warning,
            {tr("Unsaved work cannot be backed up in case of a crash. Save it to be safe.")}, {},
            io::errorText(error));
    });
    follow();
}

UnsavedWork::~UnsavedWork() = default;

void UnsavedWork::follow()
{
    m_autosave->setInterval(settings().autosaveInterval() * kMilliseconds);
    m_autosave->setDocument(m_files.path(), m_files.name());
}

bool UnsavedWork::adopt(const QString &id)
{
    const std::optional<RecoveryEntry> entry = entryOf(id);
    if (!entry) {
        m_messages.show(MessageBar::Severity::Warning, {tr("This work was opened or discarded in "
                                                           "another window.")});
        return false;
    }
    const Result<std::vector<Warning>> adopted = m_autosave->adopt(*entry);
    if (!adopted) {
        m_messages.show(
            MessageBar::Severity::Error,
            {tr("The backup could not be opened: %1.").arg(io::errorSentence(adopted.error()))}, {},
            io::errorText(adopted.error()));
        return false;
    }
    m_files.showRecovered(entry->originalPath, entry->name, entry->time);
    m_messages.show(MessageBar::Severity::Warning, io::warningSummary(*adopted), {},
                    io::warningLines(*adopted).join(u'\n')); // hides without any
    return true;
}

void UnsavedWork::discard()
{
    m_autosave->discard();
}

std::vector<RecoveredWork> UnsavedWork::recoverable()
{
    std::vector<RecoveredWork> works;
    const QDateTime now = QDateTime::currentDateTime();
    for (const RecoveryEntry &entry : listRecoverable(folder())) {
        const QString name = entry.name.isEmpty() ? tr("untitled") : entry.name;
        //: %1 is a model's name, %2 how many steps, %3 when: "untitled, 14 steps, 2 minutes ago"
        works.push_back({entry.slot, tr("%1, %2, %3")
                                         .arg(name, tr("%n step(s)", nullptr, entry.steps),
                                              agoText(entry.time.toLocalTime(), now, QLocale()))});
    }
    return works;
}

void UnsavedWork::forget(const QString &id)
{
    if (const std::optional<RecoveryEntry> entry = entryOf(id))
        discardRecoverable(*entry);
}

std::vector<UnreadableCopy> UnsavedWork::unreadable()
{
    auto &[found, noted] = unreadableSoFar();
    found.removeIf([](const UnreadableWork &work) { return !QFileInfo::exists(work.path); });
    for (const UnreadableWork &work : setUnreadableAside(folder())) {
        if (std::none_of(found.begin(), found.end(),
                         [&](const UnreadableWork &one) { return one.path == work.path; }))
            found.append(work);
    }
    std::vector<UnreadableCopy> copies;
    for (const UnreadableWork &work : found) {
        if (noted.contains(work.path))
            continue;
        const QString path = QDir::toNativeSeparators(work.path);
        copies.push_back(
            {work.path,
             work.why.code == ErrorCode::NewerVersion
                 ? tr("A copy of unsaved work was made by a newer FlatFitFab; it is "
                      "kept as %1.")
                       .arg(path)
                 : tr("A copy of unsaved work could not be read; it is kept as %1.").arg(path),
             io::errorText(work.why)});
    }
    return copies;
}

void UnsavedWork::takeNote(const QString &path)
{
    unreadableSoFar().noted.insert(path);
}

void UnsavedWork::showInFolder(const QString &path)
{
    QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(path).absolutePath()));
}

} // namespace fff::ui
