// Keeps a window's unsaved work for the case of a crash, and gives back what an earlier one left.
#pragma once

#include <QObject>
#include <QString>

#include <memory>
#include <vector>

namespace fff {
class Autosave;
struct RecoveryEntry;
} // namespace fff

namespace fff::ui {

class DocumentFiles;
class MessageBar;
class Workbench;

/// One row of what can be recovered.
struct RecoveredWork
{
    QString id;   // for adopt and discard
    QString text; // "untitled, 14 steps, 2 minutes ago"
};

/// A row of what cannot be recovered, but is kept.
struct UnreadableCopy
{
    QString path; // of the file
    QString text; // that it is kept, and where
    QString why;  // in words
};

class UnsavedWork : public QObject
{
    Q_OBJECT
public:
    UnsavedWork(Workbench &bench, DocumentFiles &files, MessageBar &messages, QObject *parent);
    ~UnsavedWork() override;

    /// The window shows it from now on, unsaved. False when it is there no more; said in the
    /// window's message bar.
    bool adopt(const QString &id);
    /// What is not saved may be lost: the window closes.
    void discard();

    /// What crashes have left, the newest first.
    static std::vector<RecoveredWork> recoverable();
    /// A person wants it no more.
    static void forget(const QString &id);

    /// What crashes have left that cannot be read, until a person has taken note of it; what is
    /// damaged in no later run of the program.
    static std::vector<UnreadableCopy> unreadable();
    static void takeNote(const QString &path);
    static void showInFolder(const QString &path);

private:
    void follow();

    Workbench &m_bench;
    DocumentFiles &m_files;
    MessageBar &m_messages;
    std::unique_ptr<Autosave> m_autosave;
};

} // namespace fff::ui
