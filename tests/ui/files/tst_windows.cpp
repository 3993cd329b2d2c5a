// Files and windows: what is opened where, and that nothing is lost on the way.
#include <QTest>

#include "tests/ui/window_fixture.h"
#include "ui/files/recent_menu.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QUrl>

using namespace fff;
using namespace fff::ui;

class TestWindows : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void aFileOpensInAnUntouchedWindow();
    void aSecondFileOpensInAWindowOfItsOwn();
    void aFileThatIsOpenIsBroughtForward();
    void newKeepsWhatIsThere();
    void eachWindowHasItsOwnHistory();
    void quitAsksForEachUnsavedWindow();
    void aDroppedModelOpens();
    void severalDroppedModelsOpenInSeveralWindows();
    void whatIsNoModelIsSaid();
    void aMissingFileIsSaidAndForgotten();
    void recentFilesAreListed();
    void revertIsAStep();
    void revertWaitsForAFileAndAChange();
    void aChangeByAnotherProgramIsAskedAbout_data();
    void aChangeByAnotherProgramIsAskedAbout();
    void aTouchedFileIsNoChange();
    void aReadOnlyFolderKeepsTheOldFile();

private:
    QString file(const char *name) const { return m_folder->filePath(QLatin1String(name)); }
    QString model(const char *name, double side = 40.0) const;
    void drop(QWidget *on, const QStringList &paths);
    void change(MainWindow &window, double side);

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
    QTest::newRow("saved over it") << QStringLiteral("Save over it") << true;
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

void TestWindows::aReadOnlyFolderKeepsTheOldFile()
{
    // A folder that is not there stands for one that cannot be written to: tests may run as root.
    change(*m_window, 40);
    const QString path = m_folder->path() + QStringLiteral("/nowhere/a.fff");
    QVERIFY(!m_window->files().saveFile(path));
    QVERIFY(messagesOf(*m_window)->text().contains(QStringLiteral("Could not save a.fff")));
    QVERIFY(!m_window->files().isSaved());
    auto *verb = m_window->findChild<QPushButton *>(QStringLiteral("messageVerb"));
    QCOMPARE(verb->text(), QStringLiteral("Save as…"));
}

int main(int argc, char *argv[])
{
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    TestWindows test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_windows.moc"
