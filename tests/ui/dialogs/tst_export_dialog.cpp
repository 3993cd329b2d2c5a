// The Export panel by real events: what it shows, what it changes, what it keeps, and what it
// writes.
#include <QTest>

#include "core/assembly/joint_editing.h"
#include "core/model/edits.h"
#include "core/operations/evaluate.h"
#include "core/session/check_list.h"
#include "core/session/sheet_nesting.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"
#include "tests/ui/dialogs/export_hand.h"
#include "tests/ui/work_folder.h"
#include "ui/base/sentence_label.h"
#include "ui/base/translations.h"
#include "ui/dialogs/export_preview.h"
#include "ui/dialogs/sheet_view.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDesktopServices>
#include <QRegularExpression>
#include <QTreeWidget>
#include <QUndoStack>
#include <QUrl>

#include <csignal>
#include <sys/resource.h>

using namespace fff;
using namespace fff::ui;

/// In place of a file manager.
class FolderOpened : public QObject
{
    Q_OBJECT
public:
    QStringList folders;
public Q_SLOTS:
    void open(const QUrl &url) { folders += url.toLocalFile(); }
};

class TestExportDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void aNewPersonCutsInThreeActions();
    void theSlitWidthIsWorkedOut();
    void cancelTakesAllBack();
    void whatIsChangedIsOneStep();
    void thePictureOfTheSlitFollows();
    void theThicknessIsAskedForOnce();
    void eachMachineHasItsKerf();
    void aSheetOfOnesOwn();
    void choicesAreKept();
    void aColourForEachJoint();
    void nonsenseInTheSettingsIsPassedOver();
    void manySheetsAreTurned();
    void aSearchIsSaid();
    void severalStocksAreChosenFrom();
    void allPartsAreListed();
    void solidsHaveNoSheets();
    void problemsAreShownAndForbidNothing();
    void notesTakeNoTickAway();
    void whatCannotBeCutIsSaid();
    void exportAgainAsksNothing();
    void exportAgainNeedsAnExport();
    void aFullDiskLeavesTheOldFile();
    void theFolderIsOpened();
    void theSheetZoomsAndFits();

private:
    QString file(const char *name) const { return m_folder->filePath(QLatin1String(name)); }
    Session &session() { return m_window->bench().session(); }
    const Stock &stock() { return *session().committed().document.stocks.front(); }
    void draw(const Document &document) { session().commit(QStringLiteral("draw"), document); }
    std::string written(const char *name) const
    {
        return io::readFile(file(name)).value_or(std::string());
    }
    static QStringList remarks(QDialog *dialog);

    std::unique_ptr<QTemporaryDir> m_folder;
    MainWindow *m_window = nullptr;
};

void TestExportDialog::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(file("settings.ini"));
    m_window = openWindow();
    m_window->show();
    m_window->showDocument();
}

void TestExportDialog::cleanup()
{
    closeEverything();
}

QStringList TestExportDialog::remarks(QDialog *dialog)
{
    QStringList texts;
    auto *area = dialog->findChild<QWidget *>(QStringLiteral("exportRemarks"));
    for (const QLabel *label : area->findChildren<QLabel *>(QStringLiteral("remarkText")))
        if (!label->isHidden() && !label->parentWidget()->isHidden())
            texts += label->text();
    return texts;
}

// Wrong: who has drawn the first section looks for the way to a file.
void TestExportDialog::aNewPersonCutsInThreeActions()
{
    workIn(m_folder->path());
    draw(squareDocument());                         // the first action
    inExportPanel(*m_window, [&](QDialog *dialog) { // the second
        QCOMPARE(dialog->focusWidget(), exportButton(dialog));
        QTest::keyClick(exportButton(dialog), Qt::Key_Return); // and the third
    });
    QVERIFY(written("untitled.svg").find("<svg") != std::string::npos);
}

// Wrong: an export whose slit width was never shown.
void TestExportDialog::theSlitWidthIsWorkedOut()
{
    draw(squareDocument());
    inExportPanel(*m_window, [&](QDialog *dialog) {
        typeInto(dialog, "exportKerf", QStringLiteral("0.2"));
        typeInto(dialog, "exportClearance", QStringLiteral("0.1"));
        QCOMPARE(textOf(dialog, "exportSlitWidth"),
                 QStringLiteral("2.90\u202Fmm = 3.00 + 0.10 − 0.20"));
        typeInto(dialog, "exportClearance", QStringLiteral("-0.05"));
        QCOMPARE(textOf(dialog, "exportSlitWidth"),
                 QStringLiteral("2.75\u202Fmm = 3.00 − 0.05 − 0.20"));
        typeInto(dialog, "exportKerf", QStringLiteral("4"));
        QCOMPARE(textOf(dialog, "exportSlitWidth"),
                 QStringLiteral("none: the kerf is wider than the slit"));
    });
}

void TestExportDialog::cancelTakesAllBack()
{
    draw(squareDocument());
    session().setClean();
    const Document before = session().committed().document;
    inExportPanel(*m_window, [&](QDialog *dialog) {
        typeInto(dialog, "exportKerf", QStringLiteral("0.3"));
        typeInto(dialog, "exportClearance", QStringLiteral("0.1"));
        QCOMPARE(stock().kerf, 0.3);
        QVERIFY(!session().isClean());
        QTest::mouseClick(dialog->findChild<QAbstractButton *>(QStringLiteral("exportCancel")),
                          Qt::LeftButton);
    });
    QVERIFY(session().committed().document.isSame(before));
    QVERIFY(session().isClean());
    // Escape is the same.
    inExportPanel(*m_window, [&](QDialog *dialog) {
        typeInto(dialog, "exportKerf", QStringLiteral("0.3"));
        exportButton(dialog)->setFocus();
        QTest::keyClick(exportButton(dialog), Qt::Key_Escape);
    });
    QVERIFY(session().committed().document.isSame(before));
}

void TestExportDialog::whatIsChangedIsOneStep()
{
    draw(squareDocument());
    const int steps = session().history()->index();
    for (int time : {1, 2}) { // what the panel changed before is a step of its own
        inExportPanel(*m_window, [&](QDialog *dialog) {
            typeInto(dialog, "exportKerf", QString::number(0.3 * time));
            typeInto(dialog, "exportClearance", QString::number(0.1 * time));
            exportTo(dialog, file(time == 1 ? "a.svg" : "b.svg"));
        });
        QCOMPARE(session().history()->index(), steps + time);
    }
    QCOMPARE(stock().kerf, 0.6);
    session().history()->undo();
    QCOMPARE(stock().kerf, 0.3);
    QCOMPARE(stock().clearance, 0.1);
    session().history()->undo();
    QCOMPARE(stock().kerf, birchPlywood().kerf);
}

/// What is typed is seen.
void TestExportDialog::thePictureOfTheSlitFollows()
{
    draw(squareDocument());
    inExportPanel(*m_window, [&](QDialog *dialog) {
        auto *picture = dialog->findChild<QWidget *>(QStringLiteral("exportSlitPicture"));
        QVERIFY(picture && picture->isVisible());
        const QImage before = picture->grab().toImage();
        typeInto(dialog, "exportKerf", QStringLiteral("0.6"));
        const QImage wide = picture->grab().toImage();
        QVERIFY(wide != before);
        typeInto(dialog, "exportClearance", QStringLiteral("-0.4"));
        QVERIFY(picture->grab().toImage() != wide);
        typeInto(dialog, "exportKerf", QStringLiteral("4")); // wider than the slit
        QVERIFY(!picture->grab().toImage().isNull());
    });
}

/// Once: whoever says that it is right, or types another, is not asked again.
void TestExportDialog::theThicknessIsAskedForOnce()
{
    draw(squareDocument());
    inExportPanel(*m_window, [&](QDialog *dialog) {
        auto *field = dialog->findChild<QDoubleSpinBox *>(QStringLiteral("exportThickness"));
        QVERIFY(field->isVisible());
        auto *measure = dialog->findChild<QWidget *>(QStringLiteral("exportMeasure"));
        QTest::mouseClick(measure->findChild<QAbstractButton *>(), Qt::LeftButton);
        QVERIFY(!field->isVisible() && stock().isMeasured);
        QCOMPARE(stock().thickness, 3.0);
        exportTo(dialog, file("a.svg"));
    });
    inExportPanel(*m_window, [&](QDialog *dialog) {
        auto *field = dialog->findChild<QDoubleSpinBox *>(QStringLiteral("exportThickness"));
        QVERIFY(!field->isVisible());
        QVERIFY(textOf(dialog, "exportOnlyStock").contains(QStringLiteral("measured")));
        auto *measure = dialog->findChild<QWidget *>(QStringLiteral("exportMeasure"));
        QTest::mouseClick(measure->findChild<QAbstractButton *>(), Qt::LeftButton);
        QVERIFY(field->isVisible());
        QCOMPARE(dialog->focusWidget(), field);
        typeInto(dialog, "exportThickness", QStringLiteral("2.95"));
        QCOMPARE(stock().thickness, 2.95);
        QVERIFY(textOf(dialog, "exportOnlyStock").contains(QStringLiteral("2.95\u202Fmm")));
        QVERIFY(textOf(dialog, "exportSlitWidth").contains(QStringLiteral("= 2.95 +")));
    });
    QCOMPARE(stock().thickness, 3.0); // cancelled
    QVERIFY(stock().isMeasured);
}

/// What is typed while a machine is chosen is cut for that one again.
void TestExportDialog::eachMachineHasItsKerf()
{
    draw(squareDocument());
    const double usual = stock().kerf;
    const auto choose = [](QDialog *dialog, const char *machine) {
        auto *box = dialog->findChild<QComboBox *>(QStringLiteral("exportMachine"));
        const int index = box->findText(QLatin1String(machine), Qt::MatchStartsWith);
        QVERIFY2(index >= 0, machine);
        box->setCurrentIndex(index);
        Q_EMIT box->activated(index);
    };
    inExportPanel(*m_window, [&](QDialog *dialog) {
        choose(dialog, "K40");
        QCOMPARE(stock().kerf, usual); // nothing is known of it yet
        typeInto(dialog, "exportKerf", QStringLiteral("0.3"));
        choose(dialog, "Trotec");
        typeInto(dialog, "exportKerf", QStringLiteral("0.1"));
        choose(dialog, "K40");
        QCOMPARE(stock().kerf, 0.3);
        QCOMPARE(dialog->findChild<QDoubleSpinBox *>(QStringLiteral("exportKerf"))->value(), 0.3);
        choose(dialog, "Trotec");
        QCOMPARE(stock().kerf, 0.1);
        exportTo(dialog, file("a.svg"));
    });
    QCOMPARE(stock().kerfs.size(), std::size_t(2));
    session().history()->undo(); // all of it is one step
    QCOMPARE(stock().kerf, usual);
    QVERIFY(stock().kerfs.empty());
}

void TestExportDialog::aSheetOfOnesOwn()
{
    draw(squareDocument());
    inExportPanel(*m_window, [&](QDialog *dialog) {
        auto *box = dialog->findChild<QComboBox *>(QStringLiteral("exportSheet"));
        auto *width = dialog->findChild<QDoubleSpinBox *>(QStringLiteral("exportSheetWidth"));
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Home);
        QCOMPARE(stock().sheet, Vec2(297, 210));
        QVERIFY(!width->isVisible());
        QTest::keyClick(box, Qt::Key_End);
        QVERIFY(width->isVisible());
        QCOMPARE(stock().sheet, Vec2(297, 210)); // until it is said which
        typeInto(dialog, "exportSheetWidth", QStringLiteral("250"));
        typeInto(dialog, "exportSheetHeight", QStringLiteral("150"));
        QCOMPARE(stock().sheet, Vec2(250, 150));
        awaitSheets(dialog);
        const auto *view = dialog->findChild<SheetView *>();
        QTRY_COMPARE(view->content().sheet->size, QSizeF(250, 150));
        QVERIFY(view->content().caption.contains(QStringLiteral("250 × 150")));
    });
}

void TestExportDialog::choicesAreKept()
{
    draw(squareDocument());
    inExportPanel(*m_window, [&](QDialog *dialog) {
        typeInto(dialog, "exportSpacing", QStringLiteral("4"));
        typeInto(dialog, "exportMargin", QStringLiteral("12"));
        typeInto(dialog, "exportBridges", QStringLiteral("2"));
        auto *rotation = dialog->findChild<QComboBox *>(QStringLiteral("exportRotation"));
        rotation->setFocus();
        QTest::keyClick(rotation, Qt::Key_End);
        dialog->findChild<QCheckBox *>(QStringLiteral("exportReference"))->click();
        auto *machine = dialog->findChild<QComboBox *>(QStringLiteral("exportMachine"));
        machine->setFocus();
        QTest::keyClick(machine, Qt::Key_End);
        exportTo(dialog, file("a.svg"));
    });
    QVERIFY(written("a.svg").find("reference-100mm") == std::string::npos);
    QVERIFY2(written("a.svg").find("<path stroke=\"#00ffff\"") != std::string::npos,
             "numbers in the colour of LightBurn's program");
    Settings::setFile(file("settings.ini")); // as at the next start
    inExportPanel(*m_window, [&](QDialog *dialog) {
        const auto value = [dialog](const char *name) {
            return dialog->findChild<QDoubleSpinBox *>(QLatin1String(name))->value();
        };
        QCOMPARE(value("exportSpacing"), 4.0);
        QCOMPARE(value("exportMargin"), 12.0);
        QCOMPARE(value("exportBridges"), 2.0);
        QCOMPARE(dialog->findChild<QComboBox *>(QStringLiteral("exportRotation"))->currentIndex(),
                 3);
        QVERIFY(!dialog->findChild<QCheckBox *>(QStringLiteral("exportReference"))->isChecked());
        QCOMPARE(dialog->findChild<QComboBox *>(QStringLiteral("exportMachine"))->currentText(),
                 QStringLiteral("Atomstack S40 Max"));
        QCOMPARE(dialog->findChild<SheetView *>()->content().margin, 12.0);
        // What is given up is not kept.
        typeInto(dialog, "exportSpacing", QStringLiteral("9"));
    });
    QCOMPARE(rememberedChoices().layout.spacing, 4.0);
}

// In the preview as in the file, and only where colours are looked at.
void TestExportDialog::aColourForEachJoint()
{
    using namespace fff::test;
    Document document = withSection(newDocument(), plateOf(-60, 0, 60, 60), front());
    for (const double at : {-30.0, 30.0})
        document = withSection(std::move(document), plateOf(-40, 0, 40, 60), side(at));
    draw(document);
    inExportPanel(*m_window, [&](QDialog *dialog) {
        auto *box = dialog->findChild<QCheckBox *>(QStringLiteral("exportJointColours"));
        const auto colours = [dialog] {
            std::size_t count = 0;
            for (const PartPaths &part : dialog->findChild<SheetView *>()->content().sheet->parts)
                count += part.jointLabels.size();
            return count;
        };
        QVERIFY(!box->isHidden() && !box->isChecked());
        QCOMPARE(colours(), std::size_t(0));
        box->click();
        QTRY_COMPARE(colours(), std::size_t(4)); // two joints, on two parts each
        chooseRow(dialog, "exportFile", QStringLiteral("DXF"));
        QTRY_COMPARE(colours(), std::size_t(0));
        QVERIFY(!box->isVisible());
        chooseRow(dialog, "exportFile", QStringLiteral("SVG"));
        QTRY_COMPARE(colours(), std::size_t(4));
        exportTo(dialog, file("joints.svg"));
    });
    QVERIFY(written("joints.svg").find("<path stroke=\"#1b6ca8\"") != std::string::npos);
    QVERIFY(rememberedChoices().hasJointColours);
}

void TestExportDialog::nonsenseInTheSettingsIsPassedOver()
{
    const LayoutOptions usual;
    settings().setMemory(QStringLiteral("export/spacing"), QStringLiteral("wide"));
    settings().setMemory(QStringLiteral("export/margin"), -3);
    settings().setMemory(QStringLiteral("export/file"), QStringLiteral("stl/none"));
    QCOMPARE(rememberedChoices().layout.spacing, usual.spacing);
    QCOMPARE(rememberedChoices().layout.margin, usual.margin);
    draw(squareDocument());
    inExportPanel(*m_window, [&](QDialog *dialog) {
        QCOMPARE(dialog->findChild<QComboBox *>(QStringLiteral("exportFile"))->currentIndex(), 0);
    });
}

void TestExportDialog::manySheetsAreTurned()
{
    Document document = squareDocument(320); // two of them do not lie beside each other
    for (const double at : {100.0, 200.0})
        document = test::withSection(document, document.sections.front()->shape, test::front(at));
    draw(document);
    inExportPanel(*m_window, [&](QDialog *dialog) {
        auto *preview = dialog->findChild<ExportPreview *>();
        auto *next = dialog->findChild<QAbstractButton *>(QStringLiteral("exportNextSheet"));
        auto *previous =
            dialog->findChild<QAbstractButton *>(QStringLiteral("exportPreviousSheet"));
        QCOMPARE(preview->sheetCount(), 3);
        QVERIFY(next->isVisible() && !previous->isEnabled());
        QVERIFY(!dialog->findChild<SheetView *>()->content().hasReference);
        QTest::mouseClick(next, Qt::LeftButton);
        QTest::keyClick(dialog, Qt::Key_PageDown);
        QCOMPARE(preview->sheet(), 2);
        QVERIFY(!next->isEnabled());
        QVERIFY(dialog->findChild<SheetView *>()->content().hasReference); // below the last one
        QCOMPARE(dialog->findChild<QWidget *>(QStringLiteral("exportTabs"))
                     ->findChild<QAbstractButton *>(QStringLiteral("segment"))
                     ->text(),
                 QStringLiteral("Sheet 3 of 3"));
        QVERIFY(textOf(dialog, "exportTotals").contains(QStringLiteral("3 sheets")));
        // Fewer sheets than the one that is shown.
        auto *box = dialog->findChild<QComboBox *>(QStringLiteral("exportSheet"));
        box->setFocus();
        QTest::keyClick(box, Qt::Key_End);
        typeInto(dialog, "exportSheetWidth", QStringLiteral("2000"));
        QTRY_COMPARE(preview->sheetCount(), 1);
        QCOMPARE(preview->sheet(), 0);
        QVERIFY(!next->isVisible());
    });
}

// Wrong: a search goes on, and the number of sheets changes without a word.
void TestExportDialog::aSearchIsSaid()
{
    draw(squareDocument());
    inExportPanel(*m_window, [&](QDialog *dialog) {
        const auto isSaid = [dialog] {
            return textOf(dialog, "exportTotals").endsWith(QStringLiteral("Nesting…"));
        };
        QTRY_VERIFY(!isSaid());
        SheetNesting &nesting = m_window->bench().nesting();
        nesting.nest(NestLevel::Best);
        QVERIFY(isSaid());
        nesting.stop();
        QTRY_VERIFY(!isSaid());
    });
}

void TestExportDialog::severalStocksAreChosenFrom()
{
    Document document = *addStock(squareDocument(), flatfabAcrylic());
    const Vec2 size = document.stocks.back()->sheet;
    document = test::withSection(document, document.sections.front()->shape, test::front(50.0));
    QVERIFY(document.sections.back()->stock != document.sections.front()->stock);
    draw(document);
    inExportPanel(*m_window, [&](QDialog *dialog) {
        auto *box = dialog->findChild<QComboBox *>(QStringLiteral("exportStock"));
        QVERIFY(box->isVisible());
        QVERIFY(!dialog->findChild<QLabel *>(QStringLiteral("exportOnlyStock"))->isVisible());
        QCOMPARE(box->count(), 2);
        box->setFocus();
        QTest::keyClick(box, Qt::Key_End);
        const auto *view = dialog->findChild<SheetView *>();
        QCOMPARE(view->content().sheet->size, QSizeF(size.x(), size.y()));
        QCOMPARE(view->content().sheet->number, 2);
        typeInto(dialog, "exportKerf", QStringLiteral("0.4"));
        QCOMPARE(session().committed().document.stocks.back()->kerf, 0.4);
        QCOMPARE(stock().kerf, birchPlywood().kerf); // that of the other
        exportTo(dialog, file("both.svg"));
    });
    QVERIFY(written("both.svg").find("sheet-2") != std::string::npos); // all are exported
}

void TestExportDialog::allPartsAreListed()
{
    Document document = squareDocument(40);
    document = test::withSection(document, document.sections.front()->shape, test::front(100.0));
    document = test::withSection(document, test::plateOf(0, 0, 30, 20), test::front(200.0));
    draw(document);
    inExportPanel(*m_window, [&](QDialog *dialog) {
        const auto segments = dialog->findChild<QWidget *>(QStringLiteral("exportTabs"))
                                  ->findChildren<QAbstractButton *>(QStringLiteral("segment"));
        QTest::mouseClick(segments.last(), Qt::LeftButton);
        auto *table = dialog->findChild<QTreeWidget *>(QStringLiteral("partsTable"));
        QVERIFY(table->isVisible());
        QCOMPARE(table->topLevelItemCount(), 2); // two are the same
        const auto *first = table->topLevelItem(0), *second = table->topLevelItem(1);
        QCOMPARE(first->text(0), QStringLiteral("1, 2"));
        QCOMPARE(first->text(4), QStringLiteral("2"));
        QCOMPARE(first->text(2), QStringLiteral("40.0 × 40.0\u202Fmm"));
        QCOMPARE(second->text(2), QStringLiteral("30.0 × 20.0\u202Fmm"));
        QCOMPARE(second->text(3), QStringLiteral("6.0\u202Fcm²"));
        // Four sides of two squares, and of one plate, half a kerf outside.
        QVERIFY2(textOf(dialog, "exportTotals").contains(QStringLiteral("0.4 m of cutting")),
                 qPrintable(textOf(dialog, "exportTotals")));
    });
}

void TestExportDialog::solidsHaveNoSheets()
{
    draw(squareDocument());
    inExportPanel(*m_window, [&](QDialog *dialog) {
        chooseRow(dialog, "exportUse", QStringLiteral("Solids"));
        auto *box = dialog->findChild<QComboBox *>(QStringLiteral("exportFile"));
        QCOMPARE(box->count(), 7);
        box->setFocus();
        QTest::keyClick(box, Qt::Key_End);
        QCOMPARE(box->currentText(), QStringLiteral("STL, skin as a mesh"));
        QCOMPARE(textOf(dialog, "exportTotals"), QStringLiteral("Skin over <b>1 section</b>"));
        while (!box->currentText().startsWith(QStringLiteral("OBJ, solids"))) {
            const int before = box->currentIndex();
            QTest::keyClick(box, Qt::Key_Up);
            QVERIFY(box->currentIndex() < before);
        }
        for (const char *name : {"exportSheet", "exportKerf", "exportSpacing", "exportTabs"})
            QVERIFY2(!dialog->findChild<QWidget *>(QLatin1String(name))->isVisible(), name);
        QVERIFY(dialog->findChild<QWidget *>(QStringLiteral("exportClearance"))->isVisible());
        QCOMPARE(textOf(dialog, "exportTotals"), QStringLiteral("<b>1 section</b> as solids"));
        exportTo(dialog, file("solids"));
    });
    QVERIFY(written("solids.obj").find("\nf ") != std::string::npos);
}

void TestExportDialog::problemsAreShownAndForbidNothing()
{
    Document document = squareDocument();
    // Beside the other, touching nothing.
    document = test::withSection(document, test::plateOf(0, 0, 30, 20), test::front(200.0));
    draw(document);
    auto *checks = m_window->findChild<CheckList *>();
    QTRY_COMPARE(checks->age(), CheckList::Age::Current);
    const auto isError = [](const Finding &finding) {
        return finding.severity == Severity::Error && !finding.sections.empty();
    };
    QTRY_VERIFY(std::any_of(checks->all().begin(), checks->all().end(), isError));
    inExportPanel(*m_window, [&](QDialog *dialog) {
        QTRY_COMPARE(exportButton(dialog)->text(), QStringLiteral("Export anyway"));
        QVERIFY(exportButton(dialog)->isEnabled());
        exportTo(dialog, file("wrong.svg"));
    });
    QVERIFY(!written("wrong.svg").empty());

    m_window->bench().select({});
    const int steps = session().history()->index();
    inExportPanel(*m_window, [&](QDialog *dialog) {
        typeInto(dialog, "exportKerf", QStringLiteral("0.25"));
        auto *row = dialog->findChild<QWidget *>(QStringLiteral("remark0"));
        QVERIFY(row);
        auto *link = row->findChild<QAbstractButton *>(QStringLiteral("checkLink0"));
        QVERIFY(link);
        QTest::mouseClick(link, Qt::LeftButton);
        QVERIFY(!dialog->isVisible());
    });
    QVERIFY(!m_window->bench().interaction().selection().empty());
    QCOMPARE(stock().kerf, 0.25); // who looks at a problem goes on from there
    QCOMPARE(session().history()->index(), steps + 1);
}

// Wrong: Checks says that it is strong enough, and notes what hangs by friction; Export says
// nothing of strength.
void TestExportDialog::notesTakeNoTickAway()
{
    const ShapePointer leg = test::plateOf(-30, 0, 30, 50);
    Document document =
        test::withSection(newDocument(), test::plateOf(-60, 35, 60, 75), test::front());
    for (const double x : {-40.0, 40.0})
        document = test::withSection(std::move(document), leg, test::side(x));
    Stock changed = *document.stocks.front();
    changed.clearance = 0.0;
    document = *setStock(std::move(document), changed);
    const Model model = evaluate(document);
    const auto flipped = [&] {
        Document next = document;
        for (const std::size_t guest : {1, 2})
            next = flipSlits(evaluate(next), JointRef(model.ref(0), model.ref(guest)))->document;
        return next;
    };
    auto *checks = m_window->findChild<CheckList *>();
    int noted = 0;
    for (const Document &way : {document, flipped()}) {
        draw(way);
        checks->finish();
        QTRY_COMPARE(checks->age(), CheckList::Age::Current);
        const bool isStrong = worst(checks->all(), Subject::Strength) <= Severity::Note;
        QVERIFY(isStrong);
        noted += worst(checks->all(), Subject::Strength) == Severity::Note ? 1 : 0;
        inExportPanel(*m_window, [&](QDialog *dialog) {
            QTRY_VERIFY2(remarks(dialog).join(u'\n').contains(QStringLiteral("Strong enough")),
                         qPrintable(remarks(dialog).join(u'\n')));
        });
    }
    QCOMPARE(noted, 1);
}

// Wrong: a button that writes nothing and does not say why.
void TestExportDialog::whatCannotBeCutIsSaid()
{
    const Model cross = test::twoSections(test::plateOf(-50, 0, 50, 60), test::front(),
                                          test::plateOf(-50, 0, 50, 60), test::side());
    draw(cross.document);
    inExportPanel(*m_window, [&](QDialog *dialog) {
        QVERIFY(exportButton(dialog)->isEnabled());
        typeInto(dialog, "exportKerf", QStringLiteral("4"));
        QTRY_VERIFY(!exportButton(dialog)->isEnabled());
        QVERIFY2(remarks(dialog).first().startsWith(QStringLiteral("<b>Cannot be cut.</b>")),
                 qPrintable(remarks(dialog).join(u'\n')));
        typeInto(dialog, "exportKerf", QStringLiteral("0.2"));
        QTRY_VERIFY(exportButton(dialog)->isEnabled());
        QVERIFY(!remarks(dialog).isEmpty() && !remarks(dialog).first().isEmpty());
    });
}

void TestExportDialog::exportAgainAsksNothing()
{
    draw(squareDocument(40));
    QVERIFY(m_window->files().saveFile(file("model.fff")));
    inExportPanel(*m_window, [&](QDialog *dialog) {
        typeInto(dialog, "exportMargin", QStringLiteral("7"));
        exportTo(dialog, file("again.svg"));
    });
    const std::string first = written("again.svg");
    QVERIFY(!first.empty());
    draw(squareDocument(55));
    QAction *again = actionOf(*m_window, "file.exportAgain");
    QVERIFY(again->isEnabled());
    QCOMPARE(again->shortcut(), QKeySequence(QStringLiteral("Ctrl+Shift+X")));
    again->trigger(); // a question would hang here
    QVERIFY(written("again.svg") != first);
    // From the left edge by the margin that was chosen, and as much more as chords may be off.
    const double reach = 7.0 + 55.0 + stock().kerf;
    const QString text = QString::fromStdString(written("again.svg"));
    bool isThere = false;
    for (const QString &number : text.split(QRegularExpression(QStringLiteral("[^0-9.]+"))))
        isThere |= number.toDouble() >= reach && number.toDouble() <= reach + 0.02;
    QVERIFY(isThere);
    const QString said =
        m_window->findChild<SentenceLabel *>(QStringLiteral("statusSentence"))->text();
    QVERIFY2(said.startsWith(QStringLiteral("Exported 1 part on 1 sheet to again.svg")),
             qPrintable(said));
    // Another day, another window: the model's file knows where it went.
    QVERIFY(m_window->files().saveFile(file("model.fff")));
    closeEverything();
    m_window = openWindow();
    QVERIFY(m_window->files().openFile(file("model.fff")));
    QVERIFY(QFile::remove(file("again.svg")));
    QVERIFY(actionOf(*m_window, "file.exportAgain")->isEnabled());
    actionOf(*m_window, "file.exportAgain")->trigger();
    QVERIFY(!written("again.svg").empty());
}

void TestExportDialog::exportAgainNeedsAnExport()
{
    const auto whyNot = [&] { return actionOf(*m_window, "file.exportAgain")->toolTip(); };
    QVERIFY(!actionOf(*m_window, "file.export")->isEnabled());
    QVERIFY(actionOf(*m_window, "file.export")
                ->toolTip()
                .contains(QStringLiteral("There is no section yet")));
    draw(squareDocument());
    QVERIFY(actionOf(*m_window, "file.export")->isEnabled());
    QVERIFY(!actionOf(*m_window, "file.exportAgain")->isEnabled());
    QVERIFY2(whyNot().contains(QStringLiteral("It has not been exported yet")),
             qPrintable(whyNot()));
    QVERIFY(m_window->files().exportFile(file("a.svg")));
    QVERIFY(actionOf(*m_window, "file.exportAgain")->isEnabled());
}

void TestExportDialog::aFullDiskLeavesTheOldFile()
{
    draw(squareDocument());
    QVERIFY(m_window->files().exportFile(file("full.svg")));
    const std::string old = written("full.svg");
    draw(squareDocument(50));
    rlimit before{};
    QCOMPARE(getrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit full{64, before.rlim_max};
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &full), 0);
    actionOf(*m_window, "file.exportAgain")->trigger();
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, SIG_DFL);
    QVERIFY2(messagesOf(*m_window)->text().contains(QStringLiteral("full.svg")),
             qPrintable(messagesOf(*m_window)->text()));
    QCOMPARE(written("full.svg"), old);
    auto *verb = m_window->findChild<QPushButton *>(QStringLiteral("messageVerb"));
    QCOMPARE(verb->text(), QStringLiteral("Export somewhere else…"));
    nameTheFile(file("elsewhere.svg"));
    verb->click();
    QVERIFY(!written("elsewhere.svg").empty());
}

void TestExportDialog::theFolderIsOpened()
{
    FolderOpened desktop;
    QDesktopServices::setUrlHandler(QStringLiteral("file"), &desktop, "open");
    draw(squareDocument());
    inExportPanel(*m_window, [&](QDialog *dialog) {
        QTest::mouseClick(dialog->findChild<QCheckBox *>(QStringLiteral("exportOpensFolder")),
                          Qt::LeftButton, {}, {8, 8});
        exportTo(dialog, file("a.svg"));
    });
    QDesktopServices::unsetUrlHandler(QStringLiteral("file"));
    QCOMPARE(desktop.folders, QStringList{QFileInfo(file("a.svg")).absolutePath()});
}

void TestExportDialog::theSheetZoomsAndFits()
{
    draw(squareDocument());
    inExportPanel(*m_window, [&](QDialog *dialog) {
        auto *view = dialog->findChild<SheetView *>();
        const QPointF place = view->transform().map(QPointF(25.0, 25.0)); // on the plate
        QCOMPARE(view->partAt(place), 0);
        QCOMPARE(view->partAt({1.0, 1.0}), -1);
        QWheelEvent wheel(place, view->mapToGlobal(place), {}, {0, 480}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(view, &wheel);
        QVERIFY(!view->isFitted());
        // What is under the cursor stays there.
        const QPointF now = view->transform().map(QPointF(25.0, 25.0));
        QVERIFY((now - place).manhattanLength() < 1e-6);
        auto *fit = dialog->findChild<QAbstractButton *>(QStringLiteral("exportFitSheet"));
        QVERIFY(fit->isEnabled());
        QTest::mouseClick(fit, Qt::LeftButton);
        QVERIFY(view->isFitted() && !fit->isEnabled());
        view->setFocus();
        QTest::keyClick(view, Qt::Key_Plus);
        QVERIFY(!view->isFitted());
        QTest::keyClick(view, Qt::Key_Home);
        QVERIFY(view->isFitted());
    });
}

FFF_TEST_WITH(TestExportDialog, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    installTranslations(application);
    TestExportDialog test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_export_dialog.moc"
