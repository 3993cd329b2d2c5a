// Where an export goes: shown before it is written, changed from there, and nobody's file is
// replaced unasked. If this fails, somebody looks for what was cut, or has lost what was there.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"
#include "tests/ui/dialogs/export_hand.h"
#include "tests/ui/work_folder.h"
#include "ui/base/translations.h"

#include <QCheckBox>
#include <QDir>

using namespace fff;
using namespace fff::ui;

class TestExportPlace : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void itIsShownAndWritten();
    void whatOthersWroteIsAskedAbout();
    void itsOwnFileIsReplacedUnasked();
    void whatWasChangedSinceIsAskedAbout();
    void everySheetOfOthersIsAskedAbout();
    void twoModelsWithOneFile();
    void aLinkThatLeadsElsewhere();
    void enterOnASwitchGoesOn();
    void anotherPlaceIsKept();
    void aCancelledChangeChangesNothing();
    void theNameFollowsTheFormat();
    void everySheetIsNumbered();
    void aFolderForTheWorkshopIsNamed();
    void aFolderThatHasGone();
    void longNamesLoseTheirMiddle();
    void theQuestionIsReadInTheDark();
    void namesOfPlaceholders();

private:
    QString file(const QString &name) const { return folder() + u'/' + name; }
    /// Of a short name: it is shown beside those of files.
    QString folder() const { return m_folder->filePath(QStringLiteral("docs")); }
    bool has(const QString &name) const { return QFileInfo::exists(file(name)); }
    QString where() const { return QStringLiteral("docs"); }
    void save(const QString &name);
    void put(const QString &name, const char *bytes) const;
    QByteArray bytesOf(const QString &name) const;

    std::unique_ptr<QTemporaryDir> m_folder;
    MainWindow *m_window = nullptr;
};

namespace {

QString placeOf(QDialog *dialog)
{
    return dialog->findChild<QLabel *>(QStringLiteral("exportPlaceWords"))->toolTip();
}

QString shownPlace(QDialog *dialog)
{
    return textOf(dialog, "exportPlaceWords");
}

void enter(QDialog *dialog)
{
    QTest::keyClick(dialog->focusWidget(), Qt::Key_Return);
}

} // namespace

void TestExportPlace::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(QDir().mkdir(folder()));
    workIn(folder());
    m_window = openWindow();
    m_window->show();
    m_window->bench().session().commit(QStringLiteral("draw"), squareDocument());
}

void TestExportPlace::cleanup()
{
    closeEverything();
}

void TestExportPlace::save(const QString &name)
{
    QVERIFY(m_window->files().saveFile(file(name)));
}

void TestExportPlace::put(const QString &name, const char *bytes) const
{
    QFile put(file(name));
    QVERIFY(put.open(QIODevice::WriteOnly));
    put.write(bytes);
}

QByteArray TestExportPlace::bytesOf(const QString &name) const
{
    QFile read(file(name));
    return read.open(QIODevice::ReadOnly) ? read.readAll() : QByteArray();
}

// Three actions from a model to what is cut: a slider, the panel, Enter.
void TestExportPlace::itIsShownAndWritten()
{
    save(QStringLiteral("shelf.fff"));
    inExportPanel(*m_window, [&](QDialog *dialog) {
        QCOMPARE(shownPlace(dialog), QStringLiteral("shelf.svg in %1").arg(where()));
        QCOMPARE(placeOf(dialog), QDir::toNativeSeparators(file(QStringLiteral("shelf.svg"))));
        QCOMPARE(exportButton(dialog)->text(), QStringLiteral("Export"));
        enter(dialog);
    });
    QVERIFY(bytesOf(QStringLiteral("shelf.svg")).contains("<svg"));
}

// Wrong: a drawing of somebody's own, gone because it had the model's name.
void TestExportPlace::whatOthersWroteIsAskedAbout()
{
    save(QStringLiteral("shelf.fff"));
    put(QStringLiteral("shelf.svg"), "mine");
    int asked = 0;
    inExportPanel(*m_window, [&](QDialog *dialog) {
        answer(QStringLiteral("Cancel"), &asked);
        enter(dialog);
        QVERIFY2(dialog->isVisible(), "the panel stays for another place");
        QCOMPARE(bytesOf(QStringLiteral("shelf.svg")), QByteArray("mine"));
        answer(QStringLiteral("Replace"), &asked);
        enter(dialog);
    });
    QCOMPARE(asked, 2);
    QVERIFY(bytesOf(QStringLiteral("shelf.svg")).contains("<svg"));
}

void TestExportPlace::itsOwnFileIsReplacedUnasked()
{
    save(QStringLiteral("shelf.fff"));
    for (int time = 0; time < 2; ++time) // a question would hang here
        inExportPanel(*m_window, [&](QDialog *dialog) {
            // That it is replaced can be seen all the same: its values may have been others.
            QCOMPARE(shownPlace(dialog), (time == 0 ? QStringLiteral("shelf.svg in %1")
                                                    : QStringLiteral("Replaces shelf.svg in %1"))
                                             .arg(where()));
            enter(dialog);
        });
    QVERIFY(has(QStringLiteral("shelf.svg")));
    // As a file of another kind it is none of its own.
    put(QStringLiteral("shelf.dxf"), "mine");
    int asked = 0;
    inExportPanel(*m_window, [&](QDialog *dialog) {
        chooseRow(dialog, "exportFile", QStringLiteral("DXF, true"));
        answer(QStringLiteral("Cancel"), &asked);
        QTest::mouseClick(exportButton(dialog), Qt::LeftButton);
    });
    QCOMPARE(asked, 1);
    QCOMPARE(bytesOf(QStringLiteral("shelf.dxf")), QByteArray("mine"));
}

// Wrong: what was written once is ours for good, whoever has worked on it since.
void TestExportPlace::whatWasChangedSinceIsAskedAbout()
{
    save(QStringLiteral("shelf.fff"));
    inExportPanel(*m_window, enter);
    put(QStringLiteral("shelf.svg"), "edited by hand");
    int asked = 0;
    inExportPanel(*m_window, [&](QDialog *dialog) {
        answer(QStringLiteral("Cancel"), &asked);
        enter(dialog);
    });
    answer(QStringLiteral("Cancel"), &asked);
    actionOf(*m_window, "file.exportAgain")->trigger();
    QCOMPARE(asked, 2);
    QCOMPARE(bytesOf(QStringLiteral("shelf.svg")), QByteArray("edited by hand"));
    // The next day as well; and what was written last is known then.
    closeEverything();
    m_window = openWindow();
    QVERIFY(m_window->files().openFile(file(QStringLiteral("shelf.fff"))));
    answer(QStringLiteral("Replace"), &asked);
    actionOf(*m_window, "file.exportAgain")->trigger();
    QCOMPARE(asked, 3);
    closeEverything();
    m_window = openWindow();
    QVERIFY(m_window->files().openFile(file(QStringLiteral("shelf.fff"))));
    actionOf(*m_window, "file.exportAgain")->trigger(); // a question would hang here
    QVERIFY(bytesOf(QStringLiteral("shelf.svg")).contains("<svg"));
}

// Wrong: of several files the first was known, so all went.
void TestExportPlace::everySheetOfOthersIsAskedAbout()
{
    save(QStringLiteral("shelf.fff"));
    const auto perSheet = [](QDialog *dialog) {
        auto *box = dialog->findChild<QCheckBox *>(QStringLiteral("exportFilePerSheet"));
        if (!box->isChecked())
            QTest::mouseClick(box, Qt::LeftButton, {}, {8, 8});
        QTest::mouseClick(exportButton(dialog), Qt::LeftButton);
    };
    inExportPanel(*m_window, perSheet);
    QVERIFY(has(QStringLiteral("shelf-1.svg")));
    put(QStringLiteral("shelf-2.svg"), "mine");
    Document document = squareDocument(320); // two of them do not lie beside each other
    document = test::withSection(document, document.sections.front()->shape, test::front(100.0));
    m_window->bench().session().commit(QStringLiteral("draw"), document);
    int asked = 0;
    answer(QStringLiteral("Cancel"), &asked);
    inExportPanel(*m_window, perSheet);
    QCOMPARE(asked, 1);
    QCOMPARE(bytesOf(QStringLiteral("shelf-2.svg")), QByteArray("mine"));
}

void TestExportPlace::twoModelsWithOneFile()
{
    save(QStringLiteral("m.fff"));
    inExportPanel(*m_window,
                  [&](QDialog *dialog) { exportTo(dialog, file(QStringLiteral("same.svg"))); });
    // Another model, another drawing, over it.
    m_window->bench().session().commit(QStringLiteral("draw"), squareDocument(70));
    save(QStringLiteral("n.fff"));
    inExportPanel(*m_window,
                  [&](QDialog *dialog) { exportTo(dialog, file(QStringLiteral("other.svg"))); });
    QVERIFY(QFile::remove(file(QStringLiteral("same.svg"))));
    QVERIFY(QFile::copy(file(QStringLiteral("other.svg")), file(QStringLiteral("same.svg"))));
    const QByteArray others = bytesOf(QStringLiteral("same.svg"));
    closeEverything();
    m_window = openWindow();
    QVERIFY(m_window->files().openFile(file(QStringLiteral("m.fff"))));
    int asked = 0;
    answer(QStringLiteral("Cancel"), &asked);
    actionOf(*m_window, "file.exportAgain")->trigger();
    QCOMPARE(asked, 1);
    QCOMPARE(bytesOf(QStringLiteral("same.svg")), others);
}

// Wrong: a copy in another folder is taken for what was written here.
void TestExportPlace::aLinkThatLeadsElsewhere()
{
#ifndef Q_OS_UNIX
    QSKIP("links are for administrators there");
#endif
    save(QStringLiteral("shelf.fff"));
    inExportPanel(*m_window, enter);
    QVERIFY(QDir(folder()).mkdir(QStringLiteral("other")));
    const QString path = file(QStringLiteral("shelf.svg"));
    const QString kept = file(QStringLiteral("other/backup.svg"));
    QVERIFY(QFile::rename(path, kept) && QFile::link(kept, path));
    const QByteArray before = bytesOf(QStringLiteral("other/backup.svg"));
    m_window->bench().session().commit(QStringLiteral("draw"), squareDocument(70));
    int asked = 0;
    answer(QStringLiteral("Cancel"), &asked);
    actionOf(*m_window, "file.exportAgain")->trigger();
    QCOMPARE(asked, 1);
    QCOMPARE(bytesOf(QStringLiteral("other/backup.svg")), before);
    const QString said = m_window->findChild<QLabel *>(QStringLiteral("statusSentence"))->text();
    QVERIFY2(said.startsWith(QStringLiteral("Not exported")), qPrintable(said));
    QVERIFY(QFile::remove(kept)); // it leads nowhere
    answer(QStringLiteral("Cancel"), &asked);
    actionOf(*m_window, "file.exportAgain")->trigger();
    QCOMPARE(asked, 2);
    QVERIFY(!QFileInfo::exists(kept));
}

// Wrong: Enter switches what was switched last, and writes nothing.
void TestExportPlace::enterOnASwitchGoesOn()
{
    save(QStringLiteral("shelf.fff"));
    inExportPanel(*m_window, [&](QDialog *dialog) {
        auto *box = dialog->findChild<QCheckBox *>(QStringLiteral("exportFilePerSheet"));
        QTest::mouseClick(box, Qt::LeftButton, {}, {8, 8});
        box->setFocus();
        enter(dialog);
    });
    QVERIFY(has(QStringLiteral("shelf-1.svg")));
}

void TestExportPlace::anotherPlaceIsKept()
{
    save(QStringLiteral("shelf.fff"));
    QVERIFY(QDir(folder()).mkdir(QStringLiteral("shop")));
    inExportPanel(*m_window, [&](QDialog *dialog) {
        chooseFile(dialog, file(QStringLiteral("shop/first.svg")));
        QCOMPARE(shownPlace(dialog), QStringLiteral("first.svg in shop"));
        QCOMPARE(dialog->focusWidget(), exportButton(dialog)); // Enter is what is left
        enter(dialog);
    });
    QVERIFY(has(QStringLiteral("shop/first.svg")));
    QVERIFY(!has(QStringLiteral("shelf.svg")));
    inExportPanel(*m_window, [&](QDialog *dialog) {
        QCOMPARE(shownPlace(dialog), QStringLiteral("Replaces first.svg in shop"));
        // A name without its suffix gets it; the choice stands though it is not written yet.
        chooseFile(dialog, file(QStringLiteral("shop/second")));
        QCOMPARE(shownPlace(dialog), QStringLiteral("second.svg in shop"));
    });
    inExportPanel(*m_window, [&](QDialog *dialog) {
        // That was given up.
        QCOMPARE(shownPlace(dialog), QStringLiteral("Replaces first.svg in shop"));
    });
}

void TestExportPlace::aCancelledChangeChangesNothing()
{
    save(QStringLiteral("shelf.fff"));
    inExportPanel(*m_window, [&](QDialog *dialog) {
        whenShown<QFileDialog>("exportFileDialog", [](QFileDialog *) {});
        auto *change = dialog->findChild<QWidget *>(QStringLiteral("exportChangePlace"));
        QTest::mouseClick(change->findChild<QAbstractButton *>(), Qt::LeftButton);
        QVERIFY(dialog->isVisible());
        QCOMPARE(shownPlace(dialog), QStringLiteral("shelf.svg in %1").arg(where()));
    });
    QVERIFY(!has(QStringLiteral("shelf.svg")));
}

void TestExportPlace::theNameFollowsTheFormat()
{
    save(QStringLiteral("shelf.v2.fff"));
    inExportPanel(*m_window, [&](QDialog *dialog) {
        QVERIFY(shownPlace(dialog).startsWith(QStringLiteral("shelf.v2.svg in ")));
        chooseRow(dialog, "exportFile", QStringLiteral("DXF, true"));
        QVERIFY(shownPlace(dialog).startsWith(QStringLiteral("shelf.v2.dxf in ")));
        chooseFile(dialog, file(QStringLiteral("other.DXF")));
        QVERIFY(shownPlace(dialog).startsWith(QStringLiteral("other.DXF in ")));
        chooseRow(dialog, "exportFile", QStringLiteral("SVG, true"));
        QVERIFY(shownPlace(dialog).startsWith(QStringLiteral("other.svg in ")));
        chooseRow(dialog, "exportUse", QStringLiteral("List"));
        QVERIFY(shownPlace(dialog).startsWith(QStringLiteral("other.csv in ")));
        QTest::mouseClick(exportButton(dialog), Qt::LeftButton);
    });
    QVERIFY(has(QStringLiteral("other.csv")));
}

void TestExportPlace::everySheetIsNumbered()
{
    save(QStringLiteral("shelf.fff"));
    put(QStringLiteral("shelf-1.svg"), "mine");
    int asked = 0;
    const auto perSheet = [&](QDialog *dialog, const QString &button) {
        auto *box = dialog->findChild<QCheckBox *>(QStringLiteral("exportFilePerSheet"));
        if (!box->isChecked())
            QTest::mouseClick(box, Qt::LeftButton, {}, {8, 8});
        QCOMPARE(shownPlace(dialog), QStringLiteral("Replaces shelf-1.svg in %1").arg(where()));
        if (!button.isEmpty())
            answer(button, &asked);
        QTest::mouseClick(exportButton(dialog), Qt::LeftButton);
    };
    inExportPanel(*m_window, [&](QDialog *dialog) { perSheet(dialog, QStringLiteral("Cancel")); });
    QCOMPARE(bytesOf(QStringLiteral("shelf-1.svg")), QByteArray("mine"));
    inExportPanel(*m_window, [&](QDialog *dialog) { perSheet(dialog, QStringLiteral("Replace")); });
    QVERIFY(bytesOf(QStringLiteral("shelf-1.svg")).contains("<svg"));
    inExportPanel(*m_window, [&](QDialog *dialog) { perSheet(dialog, {}); }); // its own
    QCOMPARE(asked, 2);
}

void TestExportPlace::aFolderForTheWorkshopIsNamed()
{
    save(QStringLiteral("shelf.fff"));
    inExportPanel(*m_window, [&](QDialog *dialog) {
        chooseRow(dialog, "exportUse", QStringLiteral("Everything"));
        chooseRow(dialog, "exportFile", QStringLiteral("All for the workshop, in a folder"));
        QCOMPARE(shownPlace(dialog), QStringLiteral("shelf for the workshop in %1").arg(where()));
        QTest::mouseClick(exportButton(dialog), Qt::LeftButton);
    });
    QVERIFY(has(QStringLiteral("shelf for the workshop/sheets.svg")));
    inExportPanel(*m_window, [&](QDialog *dialog) {
        QCOMPARE(shownPlace(dialog), QStringLiteral("shelf for the workshop in %1").arg(where()));
        chooseRow(dialog, "exportFile", QStringLiteral("All for the workshop, packed"));
        QCOMPARE(shownPlace(dialog), QStringLiteral("shelf.zip in %1").arg(where()));
    });
}

// Wrong: a place on a stick that is not there any more, and Enter fails.
void TestExportPlace::aFolderThatHasGone()
{
    QVERIFY(QDir(folder()).mkdir(QStringLiteral("stick")));
    save(QStringLiteral("shelf.fff"));
    inExportPanel(*m_window, [&](QDialog *dialog) {
        exportTo(dialog, file(QStringLiteral("stick/out.svg")));
    });
    QVERIFY(QDir(file(QStringLiteral("stick"))).removeRecursively());
    inExportPanel(*m_window, [&](QDialog *dialog) {
        QCOMPARE(shownPlace(dialog), QStringLiteral("shelf.svg in %1").arg(where()));
    });
    // The model's own folder, too.
    QVERIFY(QDir(folder()).mkdir(QStringLiteral("stick")));
    save(QStringLiteral("stick/lamp.fff"));
    QVERIFY(QDir(file(QStringLiteral("stick"))).removeRecursively());
    inExportPanel(*m_window, [&](QDialog *dialog) {
        QCOMPARE(shownPlace(dialog), QStringLiteral("lamp.svg in %1").arg(where()));
        enter(dialog);
    });
    QVERIFY(has(QStringLiteral("lamp.svg")));
}

void TestExportPlace::longNamesLoseTheirMiddle()
{
    const QString name(120, u'n');
    save(name + QStringLiteral(".fff"));
    inExportPanel(*m_window, [&](QDialog *dialog) {
        const auto *words = dialog->findChild<QLabel *>(QStringLiteral("exportPlaceWords"));
        QVERIFY(words->text().contains(u'…'));
        QVERIFY(words->text().endsWith(QStringLiteral("nn.svg in ") + where()));
        QVERIFY(words->fontMetrics().horizontalAdvance(words->text()) <= words->width());
        QVERIFY(words->toolTip().contains(name));
        auto *area = dialog->findChild<QWidget *>(QStringLiteral("exportChoices"));
        QVERIFY(area->width() < 600);
    });
}

// Wrong: the name of what would be replaced is black on black.
void TestExportPlace::theQuestionIsReadInTheDark()
{
    settings().setColourScheme(ColourScheme::Dark);
    save(QStringLiteral("shelf.fff"));
    put(QStringLiteral("shelf.svg"), "mine");
    bool isSeen = false;
    inExportPanel(*m_window, [&](QDialog *dialog) {
        whenShown<QMessageBox>("replaceQuestion", [&](QMessageBox *question) {
            isSeen = true;
            for (const QWidget *part : question->findChildren<QWidget *>())
                if (part->isVisible())
                    QVERIFY2(part->palette().windowText().color().lightness() >
                                 part->palette().window().color().lightness() + 100,
                             part->metaObject()->className());
        });
        enter(dialog);
    });
    QVERIFY(isSeen);
    settings().setColourScheme(ColourScheme::System);
}

// Wrong: a name that is taken for a place where another word goes.
void TestExportPlace::namesOfPlaceholders()
{
    save(QStringLiteral("a%2b%1.fff"));
    inExportPanel(*m_window, [&](QDialog *dialog) {
        QCOMPARE(shownPlace(dialog), QStringLiteral("a%2b%1.svg in ") + where());
        enter(dialog);
    });
    QVERIFY(has(QStringLiteral("a%2b%1.svg")));
    const QString said = m_window->findChild<QLabel *>(QStringLiteral("statusSentence"))->text();
    QVERIFY2(said.contains(QStringLiteral("to a%2b%1.svg")), qPrintable(said));
}

FFF_TEST_WITH(TestExportPlace, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    installTranslations(application);
    TestExportPlace test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_export_place.moc"
