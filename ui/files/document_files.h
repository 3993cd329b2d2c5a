// Open, Save, Save as, Revert and Export of the one document of a window: asks what must be asked,
// says what was done, and loses nothing without a question. Which window a file opens in is not
// decided here (ui/windows.h).
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include "core/model/section.h"
#include "ui/files/file_stamp.h"

#include <QString>
#include <QStringList>

#include <optional>

class QWidget;

namespace fff {
class CheckList;
struct Finding;
namespace io {
struct LoadedDocument;
}
} // namespace fff

namespace fff::ui {

class Exporting;
class MessageBar;
class StatusLine;
class Workbench;

class DocumentFiles : public QObject
{
    Q_OBJECT
public:
    /// window  parent of the questions; its title is the file's name
    DocumentFiles(Workbench &bench, const CheckList &checks, MessageBar &messages,
                  StatusLine &status, QWidget &window);

    /// A new model, whatever there was.
    void begin();

    /// Ask for what is not given. False when nothing was done.
    bool startNew();
    bool open(); // says which with chosen()
    bool save();
    bool saveAs();
    bool exportCuttingFile();
    /// As it was exported last, over that; without a question.
    bool exportAgain();
    bool canExportAgain() const;
    /// Where and under which name it would be exported, without a suffix.
    QString suggestion() const;
    /// True when the document may go: it is saved, or may be lost.
    bool mayClose();
    /// Back to what the file holds, as a step that can be taken back. So there is no question.
    bool revert();
    bool canRevert() const;

    /// Another model beside what is there, as a step that can be taken back.
    bool insert();
    /// The path of a drawing; empty: none was chosen.
    QString askForDrawing();
    /// The same of a mesh.
    QString askForMesh();

    /// Without a question. A copy is named like the file, but saving it asks where to.
    bool openFile(const QString &path, bool asCopy = false);
    bool insertFile(const QString &path);
    bool saveFile(const QString &path);
    bool exportFile(const QString &path);
    /// A test piece for the stocks of the model.
    bool exportCoupon();
    /// A file for each sheet; asks only before it replaces some.
    bool exportSheets(const QString &path);

    /// The two halves of openFile. What cannot be read is said in this window's message bar.
    std::optional<io::LoadedDocument> read(const QString &path);
    void show(const io::LoadedDocument &loaded, const QString &path, bool asCopy);
    /// The session has what a crash left: name it after the file it was in, or was called after.
    /// kept  when: a file that is newer is not saved over without a question
    void showRecovered(const QString &path, const QString &name, const QDateTime &kept);

    /// Of the open document; empty for one that was never saved, and for a copy.
    QString path() const { return m_isOnDisk ? m_path : QString(); }
    bool isSaved() const;
    /// As the window's title has it.
    QString name() const;
    /// Nothing was done in it yet: a file may be opened in its place without a question.
    bool isUntouched() const;
    /// Nothing is in it, and it is no file: whoever wants a new model can draw here.
    bool isEmpty() const;

Q_SIGNALS:
    /// Files that a person wants to see, in this window or another.
    void chosen(const QStringList &paths);
    /// path() or name() is another one now, or the same file was read or written again.
    void pathChanged();
    void stocksWanted();
    // Who is about to export wants to see it in the model.
    void problemWanted(const fff::Finding &problem);
    void sectionsWanted(const std::vector<fff::SectionRef> &sections);
    void exported();

private:
    void showWarnings(const io::LoadedDocument &loaded);
    QString folder() const;
    QString baseName() const;
    QString askForTarget(const QString &title, const QString &filter, const QString &suffix);
    bool maySaveOver(const QString &path, bool *asksForName);
    void setPath(const QString &path, bool isNative, bool isOnDisk);
    void refreshTitle();

    Workbench &m_bench;
    MessageBar &m_messages;
    StatusLine &m_status;
    QWidget &m_window;
    Exporting *m_exporting;
    Document m_new;          // what it began as
    QString m_path;          // where the document is, or would be saved by default
    bool m_isNative = false; // saving may overwrite it
    bool m_isOnDisk = false; // it was read from there or written there
    FileStamp m_stamp;
};

} // namespace fff::ui
