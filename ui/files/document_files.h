// New, Open, Save, Save as and Export of the one open document: asks what must be asked, says what
// was done, and loses nothing without a question.
#pragma once

#include <QObject>
#include <QString>

class QWidget;

namespace fff::ui {

class MessageBar;
class StatusLine;
class Workbench;

class DocumentFiles : public QObject
{
    Q_OBJECT
public:
    /// window  parent of the questions; its title is the file's name
    DocumentFiles(Workbench &bench, MessageBar &messages, StatusLine &status, QWidget &window);

    /// Ask for what is not given. False when nothing was done.
    bool startNew();
    bool open();
    bool save();
    bool saveAs();
    bool exportCuttingFile();
    /// True when the document may go: it is saved, or may be lost.
    bool mayClose();

    /// Without a question. A copy is named like the file, but saving it asks where to.
    bool openFile(const QString &path, bool asCopy = false);
    bool saveFile(const QString &path);
    bool exportFile(const QString &path);

    /// Of the open document; empty for one that was never saved.
    const QString &path() const { return m_path; }

private:
    QString folder() const;
    QString baseName() const;
    QString askForTarget(const QString &title, const QString &filter, const QString &suffix);
    void setPath(const QString &path, bool isNative);
    void refreshTitle();

    Workbench &m_bench;
    MessageBar &m_messages;
    StatusLine &m_status;
    QWidget &m_window;
    QString m_path;
    bool m_isNative = false; // saving may overwrite it
};

} // namespace fff::ui
