// What Export can write, and where to: what it is for, then the format; a folder for a workshop. If
// this fails, somebody searches for a format, or a workshop lacks a file.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/archive.h"
#include "core/io/document_file.h"
#include "tests/test_program.h"
#include "tests/ui/dialogs/export_hand.h"
#include "ui/base/translations.h"
#include "ui/dialogs/export_choices.h"
#include "ui/dialogs/sheet_view.h"
#include "ui/properties/link_row.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QLabel>

#include <algorithm>

using namespace fff;
using namespace fff::ui;

class TestExportFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void aUseThenAFile();
    void aFolderForTheWorkshop();
    void bridgesAreSeenAndSwitchedOff();
    void aCouponIsWritten();
    void thePanelOffersTheCoupon();

private:
    QString file(const char *name) const { return m_folder->filePath(QLatin1String(name)); }
    std::string written(const char *name) const
    {
        return io::readFile(file(name)).value_or(std::string());
    }
    void draw(const Document &document);

    std::unique_ptr<QTemporaryDir> m_folder;
    MainWindow *m_window = nullptr;
};

void TestExportFiles::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(file("settings.ini"));
    m_window = openWindow();
    m_window->show();
}

void TestExportFiles::cleanup()
{
    closeEverything();
}

void TestExportFiles::draw(const Document &document)
{
    m_window->bench().session().commit(QStringLiteral("draw"), document);
}

// Few rows instead of one for each way of each format.
void TestExportFiles::aUseThenAFile()
{
    draw(squareDocument());
    inExportPanel(*m_window, [&](QDialog *dialog) {
        const auto box = [dialog](const char *name) {
            return dialog->findChild<QComboBox *>(QLatin1String(name));
        };
        auto *perSheet = dialog->findChild<QCheckBox *>(QStringLiteral("exportFilePerSheet"));
        QCOMPARE(box("exportUse")->count(), 5);
        QCOMPARE(box("exportFile")->count(), 6);
        chooseRow(dialog, "exportFile", QStringLiteral("LightBurn"));
        QVERIFY(perSheet->isVisible() && !perSheet->isChecked());
        QTest::mouseClick(perSheet, Qt::LeftButton, {}, {8, 8});
        QVERIFY(perSheet->isChecked());
        QVERIFY(box("exportFile")->currentText().startsWith(QStringLiteral("LightBurn")));
        // A box that is checked stays so where the next format has a file for each sheet, too.
        chooseRow(dialog, "exportFile", QStringLiteral("DXF, true"));
        QVERIFY(perSheet->isChecked());
        chooseRow(dialog, "exportFile", QStringLiteral("DXF for old"));
        QVERIFY(!perSheet->isVisible());
        chooseRow(dialog, "exportUse", QStringLiteral("List"));
        QVERIFY(!box("exportFile")->isVisible()); // there is but one
        chooseRow(dialog, "exportUse", QStringLiteral("Paper"));
        chooseRow(dialog, "exportFile", QStringLiteral("PDF, tiled on Letter"));
        chooseRow(dialog, "exportUse", QStringLiteral("Cutting"));
        QVERIFY(box("exportFile")->currentText().startsWith(QStringLiteral("DXF for old")));
        exportTo(dialog, file("old.dxf"));
    });
    QVERIFY(written("old.dxf").find("AC1009") != std::string::npos);
    inExportPanel(*m_window, [&](QDialog *dialog) {
        auto *box = dialog->findChild<QComboBox *>(QStringLiteral("exportFile"));
        QVERIFY(box->currentText().startsWith(QStringLiteral("DXF for old")));
        chooseRow(dialog, "exportUse", QStringLiteral("Paper"));
        QCOMPARE(box->currentText(), QStringLiteral("PDF, tiled on Letter"));
    });
}

// All that a workshop asks for, with the steps; the second time without a question.
void TestExportFiles::aFolderForTheWorkshop()
{
    draw(squareDocument());
    QVERIFY(m_window->files().saveFile(file("chair.fff")));
    inExportPanel(*m_window, [&](QDialog *dialog) {
        chooseRow(dialog, "exportUse", QStringLiteral("Everything"));
        chooseRow(dialog, "exportFile", QStringLiteral("All for the workshop, in a folder"));
        exportTo(dialog, QFileInfo(file("chair.fff")).absolutePath());
    });
    const QDir folder(file("chair for the workshop"));
    QVERIFY(folder.exists());
    const QStringList names = folder.entryList(QDir::Files);
    for (const char *name : {"sheets.svg", "sheets.dxf", "sheets-r12.dxf", "sheets-a4.pdf",
                             "sheets.lbrn2", "sheets.gcode", "parts.csv", "coupon.svg"})
        QVERIFY2(names.contains(QLatin1String(name)), name);
    // Pictures of the steps need a display; where there is none, that is said.
    const bool hasSteps = names.contains(QStringLiteral("steps.pdf"));
    QVERIFY(hasSteps ||
            messagesOf(*m_window)->text().startsWith(QStringLiteral("The steps are not among")));
    QVERIFY(QFile::remove(folder.filePath(QStringLiteral("sheets.svg"))));
    actionOf(*m_window, "file.exportAgain")->trigger(); // a question would hang here
    QVERIFY(QFileInfo::exists(folder.filePath(QStringLiteral("sheets.svg"))));
    // Another file goes beside the folder, by the model's name.
    inExportPanel(*m_window, [&](QDialog *dialog) {
        chooseRow(dialog, "exportFile", QStringLiteral("All for the workshop, packed"));
        exportTo(dialog, file("chair.zip"));
    });
    const auto packed = io::entryNames(written("chair.zip"), "chair.zip");
    QVERIFY(packed);
    QCOMPARE(std::find(packed->begin(), packed->end(), "steps.pdf") != packed->end(), hasSteps);
}

// Wrong: bridges that nobody sees before the file, or that stay when they are switched off.
void TestExportFiles::bridgesAreSeenAndSwitchedOff()
{
    draw(squareDocument(120));
    const auto followed = [](QDialog *dialog) {
        return dialog->findChild<SheetView *>()->content().sheet->parts.front().followed;
    };
    inExportPanel(*m_window, [&](QDialog *dialog) {
        QVERIFY(followed(dialog).isEmpty());
        typeInto(dialog, "exportBridges", QStringLiteral("3"));
        QTRY_VERIFY(followed(dialog).toSubpathPolygons().size() >= 3);
        exportTo(dialog, file("bridges.svg"));
    });
    QVERIFY(rememberedChoices().cuts().tabs == 3);
    inExportPanel(*m_window, [&](QDialog *dialog) {
        QTRY_VERIFY(followed(dialog).toSubpathPolygons().size() >= 3);
        typeInto(dialog, "exportBridges", QStringLiteral("0"));
        QTRY_VERIFY(followed(dialog).isEmpty());
        exportTo(dialog, file("whole.svg"));
    });
    const auto count = [](const std::string &svg) {
        return QString::fromStdString(svg).count(QStringLiteral("stroke=\"#ff0000\""));
    };
    QVERIFY(count(written("bridges.svg")) > count(written("whole.svg")));
    // Said, not left open: a machine with bridges of its own has none then.
    QCOMPARE(rememberedChoices().cutting().finish, std::optional(CutFinish()));
    // Another machine that has none of its own leaves them so.
    inExportPanel(*m_window, [&](QDialog *dialog) {
        chooseRow(dialog, "exportMachine", QStringLiteral("Atomstack"));
        exportTo(dialog, file("other.svg"));
    });
    QCOMPARE(rememberedChoices().finish, std::optional(CutFinish()));
}

// Wrong: a test piece that only the command line knows.
void TestExportFiles::aCouponIsWritten()
{
    draw(squareDocument());
    nameTheFile(file("piece.dxf"));
    actionOf(*m_window, "fabricate.coupon")->trigger();
    QVERIFY(written("piece.dxf").find("AC1015") != std::string::npos);
    nameTheFile(file("piece.svg"));
    actionOf(*m_window, "fabricate.coupon")->trigger();
    QVERIFY(written("piece.svg").find("Slits to try") != std::string::npos);
}

// Where clearance is asked for, whoever does not know it finds the way.
void TestExportFiles::thePanelOffersTheCoupon()
{
    draw(squareDocument());
    inExportPanel(*m_window, [&](QDialog *dialog) {
        const auto *said = dialog->findChild<QLabel *>(QStringLiteral("exportCouponSaid"));
        QVERIFY(!said->isVisible());
        nameTheFile(file("tried.svg"));
        dialog->findChild<LinkRow *>(QStringLiteral("exportCoupon"))
            ->findChild<QAbstractButton *>()
            ->click();
        QVERIFY(written("tried.svg").find("Slits to try") != std::string::npos);
        QVERIFY(said->isVisible() && said->text().contains(QStringLiteral("tried.svg")));
        // How long the machine that is chosen takes.
        const auto *foot = dialog->findChild<QLabel *>(QStringLiteral("exportTotals"));
        QTRY_VERIFY2(foot->text().contains(QStringLiteral("about 1")), qPrintable(foot->text()));
    });
}

FFF_TEST_WITH(TestExportFiles, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    installTranslations(application);
    TestExportFiles test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_export_files.moc"
