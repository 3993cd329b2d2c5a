// Files and windows: what is opened where, and that nothing is lost on the way.
#include <QTest>

#include "core/model/edits.h"
#include "core/session/autosave.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/files/recent_menu.h"
#include "ui/files/unsaved_work.h"
#include "ui/start/start_page.h"

#include <QDesktopServices>
#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QRegularExpression>
#include <QSettings>
#include <QTimer>
#include <QToolButton>
#include <QUrl>

using namespace fff;
using namespace fff::ui;

/// In place of a file manager.
class FolderShown : public QObject
{
    Q_OBJECT
public:
    QStringList folders;
public Q_SLOTS:
    void show(const QUrl &url) { folders += url.toLocalFile(); }
};

class TestWindows : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void aFileOpensInAnUntouchedWindow();
    void aSecondFileOpensInAWindowOfItsOwn();
    void aFileThatIsOpenIsBroughtForward();
    void newModelsBeginAsWasSet();
    void newKeepsWhatIsThere();
    void eachWindowHasItsOwnHistory();
    void quitAsksForEachUnsavedWindow();
    void aDroppedModelOpens();
    void severalDroppedModelsOpenInSeveralWindows();
    void whatIsNoModelIsSaid();
    void aMissingFileIsSaidAndForgotten();
    void recentFilesAreListed();
    void revertIsAStep();
    void revertKeepsTheSelection();
    void revertWaitsForAFileAndAChange();
    void aChangeByAnotherProgramIsAskedAbout_data();
    void aChangeByAnotherProgramIsAskedAbout();
    void aChangeIsAskedAboutAlsoAfterAFailedSave();
    void aTouchedFileIsNoChange();
    void aModelIsSavedAsOne();
    void aModelIsNotExportedOver();
    void savingWhereNothingCanBeSaysWhatToDo();
    void aBackupIsKeptAsSet();
    void solidsAreExportedByTheirSuffix();
    void sheetsHaveAFileEach();
    void aCrashIsRecoveredFrom();
    void whatCannotBeReadIsKeptAndSaid();
    void whatCannotBeReadIsAMessageWithoutAStartPage();
    void whatIsDiscardedIsGone();
    void savedAndForgottenWorkIsNotOffered();

private:
    QString file(const char *name) const { return m_folder->filePath(QLatin1String(name)); }
    QString model(const char *name, double side = 40.0) const;
    void drop(QWidget *on, const QStringList &paths);
    void change(MainWindow &window, double side);
    void crash(double side);
    QStringList unreadableRows();

    std::unique_ptr<QTemporaryDir> m_folder;
    MainWindow *m_window = nullptr;
};

void TestWindows::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(file("settings.ini"));
    m_window = openWindow();
}

void TestWindows::cleanup()
{
    closeEverything();
}

QString TestWindows::model(const char *name, double side) const
{
    const QString path = file(name);
    return io::writeDocument(path, squareDocument(side)) ? path : QString();
}

void TestWindows::change(MainWindow &window, double side)
{
    window.bench().session().commit(QStringLiteral("draw"), squareDocument(side));
}

void TestWindows::drop(QWidget *on, const QStringList &paths)
{
    QMimeData data;
    QList<QUrl> urls;
    for (const QString &path : paths)
        urls += QUrl::fromLocalFile(path);
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction | Qt::MoveAction, &data, Qt::LeftButton,
                          {});
    QCoreApplication::sendEvent(on, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event(QPointF(50, 50), Qt::CopyAction | Qt::MoveAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(on, &event);
    QVERIFY(event.isAccepted());
    QCOMPARE(event.dropAction(), Qt::CopyAction);
}

void TestWindows::aFileOpensInAnUntouchedWindow()
{
    QCOMPARE(openFiles(*m_window, {model("a.fff")}), 1);
    QCOMPARE(mainWindows().size(), 1);
    QCOMPARE(m_window->files().path(), file("a.fff"));
    QVERIFY(m_window->files().isSaved());
}

void TestWindows::aSecondFileOpensInAWindowOfItsOwn()
{
    openFiles(*m_window, {model("a.fff")});
    openFiles(*m_window, {model("b.fff")});
    QCOMPARE(mainWindows().size(), 2);
    QCOMPARE(m_window->files().path(), file("a.fff"));
}

void TestWindows::aFileThatIsOpenIsBroughtForward()
{
    openFiles(*m_window, {model("a.fff"), model("b.fff")});
    QCOMPARE(mainWindows().size(), 2);
    QCOMPARE(
        openFiles(*m_window, {m_folder->path() + QStringLiteral("/../") +
                              QFileInfo(m_folder->path()).fileName() + QStringLiteral("/b.fff")}),
        1);
    QCOMPARE(mainWindows().size(), 2);
}

// Wrong: what new models begin with counts as work, so that each file opens another window.
void TestWindows::newModelsBeginAsWasSet()
{
    const QString wanted = model("new.fff", 25.0);
    {
        QSettings(file("settings.ini"), QSettings::IniFormat)
            .setValue(QStringLiteral("files/newModel"), wanted);
    }
    Settings::setFile(file("settings.ini"));
    MainWindow *window = openWindow();
    QCOMPARE(window->bench().session().committed().sectionCount(), std::size_t(1));
    QVERIFY(window->files().path().isEmpty());
    QVERIFY(window->files().isUntouched());
    QCOMPARE(openFiles(*window, {model("a.fff")}), 1);
    QCOMPARE(window->files().path(), file("a.fff"));

    QFile::remove(wanted);
    QTest::ignoreMessage(QtWarningMsg, QRegularExpression(QStringLiteral("^New models are empty")));
    MainWindow *other = openWindow();
    QCOMPARE(other->bench().session().committed().sectionCount(), std::size_t(0));
}

void TestWindows::newKeepsWhatIsThere()
{
    actionOf(*m_window, "file.new")->trigger();
    QCOMPARE(mainWindows().size(), 1); // there was nothing to keep
    change(*m_window, 40);
    actionOf(*m_window, "file.new")->trigger();
    QCOMPARE(mainWindows().size(), 2);
    QCOMPARE(m_window->bench().session().committed().sectionCount(), std::size_t(1));
}

void TestWindows::eachWindowHasItsOwnHistory()
{
    change(*m_window, 40);
    actionOf(*m_window, "file.new")->trigger();
    MainWindow *other =
        mainWindows().front() == m_window ? mainWindows().back() : mainWindows().front();
    QVERIFY(!other->bench().session().history()->canUndo());
    QVERIFY(!actionOf(*other, "edit.undo")->isEnabled());
    actionOf(*m_window, "edit.undo")->trigger();
    QCOMPARE(m_window->bench().session().committed().sectionCount(), std::size_t(0));
}

void TestWindows::quitAsksForEachUnsavedWindow()
{
    change(*m_window, 40);
    change(*openWindow(), 50);
    openWindow();
    int asked = 0;
    answer(QStringLiteral("Cancel"), &asked);
    QVERIFY(!closeAllWindows());
    QCOMPARE(asked, 1);
    QCOMPARE(mainWindows().size(), 3);
    answer(QStringLiteral("Don’t save"), &asked);
    QTimer::singleShot(100, this, [&asked] { answer(QStringLiteral("Don’t save"), &asked); });
    QVERIFY(closeAllWindows());
    QCOMPARE(asked, 3);
    QVERIFY(mainWindows().isEmpty());
}

void TestWindows::aDroppedModelOpens()
{
    drop(m_window, {model("a.fff")});
    QTRY_COMPARE(m_window->files().path(), file("a.fff"));
    QCOMPARE(mainWindows().size(), 1);
    QVERIFY(QFile::exists(file("a.fff")));
}

void TestWindows::severalDroppedModelsOpenInSeveralWindows()
{
    drop(m_window, {model("a.fff"), model("b.fff"), model("c.fff")});
    QTRY_COMPARE(mainWindows().size(), 3);
}

void TestWindows::whatIsNoModelIsSaid()
{
    const QString notes = file("notes.pdf");
    QVERIFY(io::writeFile(notes, "%PDF-1.4"));
    change(*m_window, 40);
    drop(m_window, {notes});
    QTRY_VERIFY(messagesOf(*m_window)->isVisible());
    QCOMPARE(messagesOf(*m_window)->text(),
             QStringLiteral("notes.pdf is not a model. FlatFitFab opens .fff and FlatFab’s .txt."));
    QVERIFY(messagesOf(*m_window)->details().contains(notes));
    QCOMPARE(mainWindows().size(), 1);
    QCOMPARE(m_window->bench().session().committed().sectionCount(), std::size_t(1));
    auto *verb = m_window->findChild<QPushButton *>(QStringLiteral("messageVerb"));
    QCOMPARE(verb->text(), QStringLiteral("Choose another file"));
}

void TestWindows::aMissingFileIsSaidAndForgotten()
{
    const QString path = file("gone.fff");
    settings().addRecentFile(path);
    QCOMPARE(openFiles(*m_window, {path}), 0);
    QVERIFY(messagesOf(*m_window)->isVisible());
    QVERIFY(messagesOf(*m_window)->text().contains(QStringLiteral("gone.fff")));
    QVERIFY(settings().recentFiles().contains(path));
    for (auto *verb : m_window->findChildren<QPushButton *>(QStringLiteral("messageVerb"))) {
        if (verb->text() == QStringLiteral("Remove from the list"))
            verb->click();
    }
    QVERIFY(!settings().recentFiles().contains(path));
}

void TestWindows::recentFilesAreListed()
{
    openFiles(*m_window, {model("a.fff")});
    QVERIFY(m_window->files().saveFile(file("b.fff")));
    QVERIFY(QFile::remove(file("a.fff")));
    auto *menu = m_window->findChild<QMenu *>(QStringLiteral("recentMenu"));
    QVERIFY(menu);
    Q_EMIT menu->aboutToShow();
    const QList<QAction *> entries = menu->actions();
    QCOMPARE(entries.size(), 4); // two files, a line, Clear
    QCOMPARE(entries[0]->text(), QStringLiteral("b.fff"));
    QCOMPARE(entries[1]->text(), QStringLiteral("a.fff (missing)"));
    entries[3]->trigger();
    QVERIFY(settings().recentFiles().isEmpty());
    QTRY_VERIFY(!menu->menuAction()->isEnabled());
}

void TestWindows::revertIsAStep()
{
    openFiles(*m_window, {model("a.fff", 40)});
    Session &session = m_window->bench().session();
    const Document saved = session.committed().document;
    change(*m_window, 55);
    const Document changed = session.committed().document;
    actionOf(*m_window, "file.revert")->trigger();
    QVERIFY(session.committed().document == saved);
    QVERIFY(session.isClean());
    session.history()->undo();
    QVERIFY(session.committed().document == changed);
    QVERIFY(!session.isClean());
}

// Wrong: Revert works like Esc where nothing is being drawn.
void TestWindows::revertKeepsTheSelection()
{
    openFiles(*m_window, {model("a.fff", 40)});
    change(*m_window, 55);
    const std::vector<SectionRef> first{m_window->bench().session().committed().ref(0)};
    m_window->bench().select(first);
    actionOf(*m_window, "file.revert")->trigger();
    QVERIFY(m_window->bench().session().isClean());
    QVERIFY(m_window->bench().interaction().selection() == first);
}

void TestWindows::revertWaitsForAFileAndAChange()
{
    QAction *revert = actionOf(*m_window, "file.revert");
    change(*m_window, 40);
    QVERIFY(!revert->isEnabled());
    QVERIFY(m_window->files().saveFile(file("a.fff")));
    QVERIFY(!revert->isEnabled());
    change(*m_window, 50);
    QVERIFY(revert->isEnabled());
}

void TestWindows::aChangeByAnotherProgramIsAskedAbout_data()
{
    QTest::addColumn<QString>("button");
    QTest::addColumn<bool>("isSaved");
    QTest::newRow("saved over it") << QStringLiteral("Overwrite") << true;
    QTest::newRow("left as it is") << QStringLiteral("Cancel") << false;
}

void TestWindows::aChangeByAnotherProgramIsAskedAbout()
{
    QFETCH(QString, button);
    QFETCH(bool, isSaved);
    openFiles(*m_window, {model("a.fff", 40)});
    change(*m_window, 50);
    const QString path = model("a.fff", 77);
    int asked = 0;
    answer(button, &asked);
    QCOMPARE(m_window->files().save(), isSaved);
    QCOMPARE(asked, 1);
    const Result<io::LoadedDocument> onDisk = io::readDocument(path);
    QVERIFY(onDisk);
    QCOMPARE(onDisk->document.sections.front()->shape->bounds().size().x(), isSaved ? 50.0 : 77.0);
}

// Wrong: a Save as that failed leaves the document's own file unguarded.
void TestWindows::aChangeIsAskedAboutAlsoAfterAFailedSave()
{
    openFiles(*m_window, {model("a.fff", 40)});
    change(*m_window, 50);
    const QString folder = file("there.fff");
    QVERIFY(QDir().mkdir(folder));
    QTimer::singleShot(0, this, [folder] {
        auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
        QVERIFY(dialog);
        dialog->selectFile(folder);
        dialog->QDialog::done(QDialog::Accepted); // with no regard to what is there
    });
    QVERIFY(!m_window->files().saveAs());
    model("a.fff", 77);
    int asked = 0;
    answer(QStringLiteral("Cancel"), &asked);
    QVERIFY(!m_window->files().save());
    QCOMPARE(asked, 1);
}

void TestWindows::aTouchedFileIsNoChange()
{
    openFiles(*m_window, {model("a.fff", 40)});
    change(*m_window, 50);
    QFile touched(file("a.fff"));
    QVERIFY(touched.open(QIODevice::ReadWrite));
    QVERIFY(touched.setFileTime(QDateTime::currentDateTime().addSecs(100),
                                QFileDevice::FileModificationTime));
    touched.close();
    QVERIFY(m_window->files().save()); // a question would wait for ever
}

namespace {

/// Types the name into the dialog that comes up, and accepts.
void typeName(const QString &name)
{
    QTimer::singleShot(0, qApp, [name] {
        auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
        QVERIFY(dialog);
        dialog->selectFile(name); // what was chosen is no more
        dialog->findChild<QLineEdit *>(QStringLiteral("fileNameEdit"))
            ->setText(QFileInfo(name).fileName());
        QTimer::singleShot(0, dialog, [dialog] {
            if (auto *question = dialog->findChild<QMessageBox *>())
                question->reject(); // no name of a file that is there is to be asked about
        });
        QMetaObject::invokeMethod(dialog, "accept");
    });
}

} // namespace

/// Wrong: a model called sa.svg, which no dialog for models lists.
void TestWindows::aModelIsSavedAsOne()
{
    openFiles(*m_window, {model("a.fff", 40)});
    typeName(file("sa.svg"));
    QVERIFY(m_window->files().saveAs());
    QVERIFY(!QFile::exists(file("sa.svg")));
    QVERIFY(io::readDocument(file("sa.svg.fff")));
    typeName(file("Sb.FFF"));
    QVERIFY(m_window->files().saveAs());
    QVERIFY(QFile::exists(file("Sb.FFF")));
}

/// Wrong: who types the model's name when exporting has a drawing in its place, and no model.
void TestWindows::aModelIsNotExportedOver()
{
    const QString path = model("a.fff", 40);
    openFiles(*m_window, {path});
    whenShown<QDialog>("exportDialog", [&path](QDialog *panel) {
        typeName(path);
        auto *change = panel->findChild<QWidget *>(QStringLiteral("exportChangePlace"));
        QTest::mouseClick(change->findChild<QAbstractButton *>(), Qt::LeftButton);
        QTest::mouseClick(panel->findChild<QPushButton *>(QStringLiteral("exportNow")),
                          Qt::LeftButton);
    });
    QVERIFY(m_window->files().exportCuttingFile());
    QVERIFY(io::readDocument(path));
    QVERIFY(QFile::exists(path + QStringLiteral(".svg")));
}

void TestWindows::savingWhereNothingCanBeSaysWhatToDo()
{
    change(*m_window, 40);
    const QString path = m_folder->path() + QStringLiteral("/nowhere/a.fff");
    QVERIFY(!m_window->files().saveFile(path));
    QVERIFY(messagesOf(*m_window)->text().contains(QStringLiteral("Could not save a.fff")));
    QVERIFY(!m_window->files().isSaved());
    auto *verb = m_window->findChild<QPushButton *>(QStringLiteral("messageVerb"));
    QCOMPARE(verb->text(), QStringLiteral("Save somewhere else…"));
}

void TestWindows::aBackupIsKeptAsSet()
{
    openFiles(*m_window, {model("a.fff", 40)});
    settings().setKeepsBackup(false);
    change(*m_window, 50);
    QVERIFY(m_window->files().save());
    QVERIFY(!QFile::exists(io::backupPath(file("a.fff"))));
    settings().setKeepsBackup(true);
    change(*m_window, 60);
    QVERIFY(m_window->files().save());
    const Result<io::LoadedDocument> before = io::readDocument(io::backupPath(file("a.fff")));
    QVERIFY(before);
    QCOMPARE(before->document.sections.front()->shape->bounds().size().x(), 50.0);
}

void TestWindows::solidsAreExportedByTheirSuffix()
{
    change(*m_window, 40);
    QVERIFY(m_window->files().exportFile(file("a.obj")));
    QVERIFY(m_window->files().exportFile(file("a.svg")));
    const Result<std::string> obj = io::readFile(file("a.obj")), svg = io::readFile(file("a.svg"));
    QVERIFY(obj && obj->find("\nf ") != std::string::npos);
    QVERIFY(svg && svg->find("<svg") != std::string::npos);
}

// Wrong: files of an earlier export lost without a question, or one that is asked about none.
void TestWindows::sheetsHaveAFileEach()
{
    change(*m_window, 320); // two of them do not lie beside each other on a sheet
    Document document = m_window->bench().session().committed().document;
    document =
        fff::test::withSection(document, document.sections.front()->shape, fff::test::front(100.0));
    m_window->bench().session().commit(QStringLiteral("Another"), document);
    QVERIFY(m_window->files().exportSheets(file("a.svg")));
    QVERIFY(!QFile::exists(file("a.svg")));
    for (const char *name : {"a-1.svg", "a-2.svg"}) {
        const Result<std::string> svg = io::readFile(file(name));
        QVERIFY2(svg && svg->find("<g id=\"part") != std::string::npos, name);
    }
    QVERIFY(!QFile::exists(file("a-3.svg")));

    QVERIFY(QFile::remove(file("a-1.svg")));
    QVERIFY(io::writeFile(file("a-2.svg"), "mine"));
    int asked = 0;
    answer(QStringLiteral("Cancel"), &asked);
    QVERIFY(!m_window->files().exportSheets(file("a.svg")));
    QCOMPARE(asked, 1);
    QVERIFY(!QFile::exists(file("a-1.svg")));
    QCOMPARE(io::readFile(file("a-2.svg")).value(), std::string("mine"));
    answer(QStringLiteral("Replace"), &asked);
    QVERIFY(m_window->files().exportSheets(file("a.svg")));
    QCOMPARE(asked, 2);
    QVERIFY(io::readFile(file("a-2.svg")).value() != "mine");
    QVERIFY(!messagesOf(*m_window)->text().contains(QStringLiteral("Older")));

    // Wrong: who cuts all files that are there cuts sheets of another model.
    QVERIFY(io::writeFile(file("a-3.svg"), "older"));
    answer(QStringLiteral("Replace"), &asked);
    QVERIFY(m_window->files().exportSheets(file("a.svg")));
    QVERIFY2(messagesOf(*m_window)->text().contains(
                 QStringLiteral("Sheets of an earlier export are still there: a-3.svg.")),
             qPrintable(messagesOf(*m_window)->text()));
    QCOMPARE(io::readFile(file("a-3.svg")).value(), std::string("older"));
}

/// What a program that was killed leaves: the slot, and a lock that nobody holds.
void TestWindows::crash(double side)
{
    QTemporaryDir elsewhere;
    Session session;
    Autosave autosave(session, elsewhere.path());
    autosave.setDocument({}, QStringLiteral("untitled"));
    session.commit(QStringLiteral("draw"), squareDocument(side));
    autosave.flush();
    const QStringList kept =
        QDir(elsewhere.path()).entryList({QStringLiteral("*.fff")}, QDir::Files);
    QCOMPARE(kept.size(), 1);
    const QString folder = m_folder->filePath(QStringLiteral("recovery"));
    QVERIFY(QDir().mkpath(folder));
    QVERIFY(QFile::copy(elsewhere.filePath(kept.front()), folder + u'/' + kept.front()));
    autosave.discard();
}

void TestWindows::aCrashIsRecoveredFrom()
{
    crash(63);
    m_window->showStartPage();
    auto *page = m_window->findChild<StartPage *>();
    auto *row = page->findChild<QWidget *>(QStringLiteral("recoveredRow"));
    QVERIFY(row);
    QVERIFY2(row->findChildren<QLabel *>().back()->text().startsWith(
                 QStringLiteral("Recovered: untitled, 1 ")),
             qPrintable(row->findChildren<QLabel *>().back()->text()));
    page->findChild<QPushButton *>(QStringLiteral("recoverOpen"))->click();
    const Session &session = m_window->bench().session();
    QCOMPARE(session.committed().sectionCount(), std::size_t(1));
    QCOMPARE(session.committed().section(0)->shape->bounds().size().x(), 63.0);
    QVERIFY(!m_window->files().isSaved());
    QVERIFY(m_window->isWindowModified());
    QVERIFY(m_window->files().path().isEmpty());
    QVERIFY(!page->isVisible());
    QVERIFY(UnsavedWork::recoverable().empty()); // it is this window's now
}

/// Of a window's start page, as they are said.
QStringList TestWindows::unreadableRows()
{
    QCoreApplication::processEvents(); // rows are shown with the next layout
    QStringList texts;
    for (QFrame *row : m_window->findChildren<QFrame *>(QStringLiteral("unreadableRow")))
        if (row->isVisible())
            texts += row->findChildren<QLabel *>().back()->text();
    return texts;
}

// Wrong: the only copy of somebody's work is gone, or nobody learns that it is there.
void TestWindows::whatCannotBeReadIsKeptAndSaid()
{
    const QString folder = m_folder->filePath(QStringLiteral("recovery"));
    QVERIFY(QDir().mkpath(folder));
    QVERIFY(io::writeFile(folder + QStringLiteral("/old.fff"), "{\"format\": \"FlatF"));
    QVERIFY(io::writeFile(folder + QStringLiteral("/new.fff"),
                          "{\"format\": \"FlatFitFab\", \"version\": 99}"));
    const QString kept = folder + QStringLiteral("/damaged/old.fff");
    m_window->showStartPage();
    const QStringList both{
        QStringLiteral("A copy of unsaved work was made by a newer FlatFitFab; it is kept as %1.")
            .arg(QDir::toNativeSeparators(folder + QStringLiteral("/new.fff"))),
        QStringLiteral("A copy of unsaved work could not be read; it is kept as %1.")
            .arg(QDir::toNativeSeparators(kept))};
    QCOMPARE(unreadableRows(), both);
    QCOMPARE(io::readFile(kept).value(), std::string("{\"format\": \"FlatF"));
    m_window->showStartPage(); // still to be read
    QCOMPARE(unreadableRows(), both);

    FolderShown shown;
    QDesktopServices::setUrlHandler(QStringLiteral("file"), &shown, "show");
    const auto press = [this](int row, const char *button) {
        QList<QPushButton *> visible;
        for (auto *one : m_window->findChildren<QPushButton *>(QLatin1String(button)))
            if (one->isVisible())
                visible += one;
        QTest::mouseClick(visible.at(row), Qt::LeftButton);
    };
    press(1, "unreadableShow");
    QDesktopServices::unsetUrlHandler(QStringLiteral("file"));
    QCOMPARE(shown.folders, QStringList{QFileInfo(kept).absolutePath()});
    press(1, "unreadableNote");
    QCOMPARE(unreadableRows(), both.mid(0, 1));
    press(0, "unreadableNote");
    m_window->showStartPage();
    QVERIFY(unreadableRows().isEmpty());
    QVERIFY(QFile::exists(kept) && QFile::exists(folder + QStringLiteral("/new.fff")));
}

// Wrong: who has switched the start page off is told nothing, or only the last of several things.
void TestWindows::whatCannotBeReadIsAMessageWithoutAStartPage()
{
    crash(63);
    const QString folder = m_folder->filePath(QStringLiteral("recovery"));
    QVERIFY(io::writeFile(folder + QStringLiteral("/old.fff"), ""));
    openFiles(*m_window, {file("gone.fff")});
    m_window->offerRecovered();
    QVERIFY(messagesOf(*m_window)->text().startsWith(QStringLiteral("gone.fff")));
    m_window->findChild<QToolButton *>(QStringLiteral("closeMessage"))->click();
    QVERIFY(messagesOf(*m_window)->text().startsWith(
        QStringLiteral("A copy of unsaved work could not be read; it is kept as ")));
    m_window->findChild<QToolButton *>(QStringLiteral("closeMessage"))->click();
    QVERIFY(messagesOf(*m_window)->text().startsWith(QStringLiteral("Recovered: untitled")));
}

void TestWindows::whatIsDiscardedIsGone()
{
    crash(63);
    openFiles(*m_window, {file("gone.fff")});
    m_window->offerRecovered(); // no start page: a message, when the one before was read
    QVERIFY(messagesOf(*m_window)->text().startsWith(QStringLiteral("gone.fff")));
    m_window->findChild<QToolButton *>(QStringLiteral("closeMessage"))->click();
    QVERIFY(messagesOf(*m_window)->isVisible());
    QVERIFY(messagesOf(*m_window)->text().startsWith(QStringLiteral("Recovered: untitled")));
    for (auto *verb : m_window->findChildren<QPushButton *>(QStringLiteral("messageVerb"))) {
        if (verb->text() == QStringLiteral("Discard"))
            verb->click();
    }
    QVERIFY(UnsavedWork::recoverable().empty());
    QCOMPARE(m_window->bench().session().committed().sectionCount(), std::size_t(0));
}

void TestWindows::savedAndForgottenWorkIsNotOffered()
{
    change(*m_window, 40);
    const QDir folder(m_folder->filePath(QStringLiteral("recovery")));
    const auto kept = [&folder] {
        return folder.entryList({QStringLiteral("*.fff")}, QDir::Files).size();
    };
    QTRY_COMPARE(kept(), 1);
    QVERIFY(m_window->files().saveFile(file("a.fff")));
    QTRY_COMPARE(kept(), 0);
    change(*m_window, 50);
    QTRY_COMPARE(kept(), 1);
    m_window->closeUnasked(); // "Don't save"
    QTRY_COMPARE(kept(), 0);
}

FFF_TEST_WITH(TestWindows, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    TestWindows test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_windows.moc"
