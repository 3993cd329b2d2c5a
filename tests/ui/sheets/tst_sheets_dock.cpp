// The Sheets dock as a person uses it, in a window without its view.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/model/edits.h"
#include "core/session/scheduler.h"
#include "core/session/sheet_nesting.h"
#include "tests/core/assembly/known_models.h"
#include "tests/test_program.h"
#include "tests/ui/dialogs/export_hand.h"
#include "ui/base/translations.h"
#include "ui/dialogs/sheet_view.h"
#include "ui/properties/choice_box.h"
#include "ui/properties/link_row.h"
#include "ui/sheets/sheets_dock.h"
#include "ui/sheets/sheets_view.h"

#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QLocale>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QWheelEvent>

#include <memory>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

class TestSheetsDock : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void withoutSectionsItSaysSo();
    void partsLieThereAndTheFootSaysHowWell();
    void aHoveredPartIsLitInTheView();
    void aHoveredRowLightsItsPart();
    void aClickSelects();
    void pagesGoFromPartToPart();
    void theWheelZoomsAndHomeFits();
    void theMiddleButtonPans();
    void anEditIsLaidAgain();
    void choicesAreThoseOfExport();
    void whatLiesThereIsExported();
    void tooLargePartsAreToldAndSplit();
    void aSearchIsStopped();
    void closedNothingIsWorkedOut();

private:
    void open(const Document &document);
    void settle();
    MainWindow &window() { return *m_window; }
    Workbench &bench() { return m_window->bench(); }
    SheetsView &view() { return *m_window->findChild<SheetsView *>(); }
    QString text(const char *label)
    {
        return m_window->findChild<QLabel *>(QLatin1String(label))->text();
    }
    /// In the middle of a part's number, or of its material.
    QPoint placeOf(std::size_t sheet, std::size_t part)
    {
        return view()
            .transform(sheet)
            .map(view().content().sheets()[sheet].parts[part].roomiest)
            .toPoint();
    }
    const SectionRef &sectionAt(std::size_t sheet, std::size_t part)
    {
        return view().content().facts[sheet].parts[part].section;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    MainWindow *m_window = nullptr;
};

void TestSheetsDock::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
    m_window = openWindow();
    m_window->resize(1440, 900);
    m_window->show();
    m_window->showDocument();
}

void TestSheetsDock::cleanup()
{
    closeEverything();
    m_window = nullptr;
}

void TestSheetsDock::open(const Document &document)
{
    bench().session().reset(document);
    if (auto *dock = m_window->findChild<SheetsDock *>(); dock->isHidden())
        actionOf(window(), "fabricate.sheets")->trigger();
    settle();
}

void TestSheetsDock::settle()
{
    QTRY_VERIFY_WITH_TIMEOUT(bench().nesting().isCurrent() && !view().content().isOlder, 30000);
    QCoreApplication::processEvents();
}

void TestSheetsDock::withoutSectionsItSaysSo()
{
    open(newDocument());
    QCOMPARE(view().content().note,
             QStringLiteral("Draw a section and it will lie here, ready to cut."));
    QVERIFY(text("sheetsTotals").isEmpty());
}

void TestSheetsDock::partsLieThereAndTheFootSaysHowWell()
{
    open(combModel(12));
    QVERIFY(view().content().note.isEmpty());
    QCOMPARE(view().content().sheets().size(), std::size_t(1));
    QCOMPARE(view().content().facts[0].parts.size(), std::size_t(13));
    const QRegularExpression foot(QStringLiteral(
        "^<b>13 parts</b> on <b>1 sheet</b> \u00B7 \\d+\\.\\d % filled \u00B7 \\d+\\.\\d m of "
        "cutting$"));
    QVERIFY2(foot.match(text("sheetsTotals")).hasMatch(), qPrintable(text("sheetsTotals")));
}

void TestSheetsDock::aHoveredPartIsLitInTheView()
{
    open(combModel(4));
    QTest::mouseMove(&view(), placeOf(0, 2));
    QTRY_VERIFY(view().hovered().has_value());
    QCOMPARE(bench().outlined(), std::vector<SectionRef>{sectionAt(0, 2)});
    const QString tip = view().tipOf(*view().hovered());
    QVERIFY2(tip.contains(QStringLiteral("turned")) && tip.contains(QStringLiteral("×")),
             qPrintable(tip));
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&view(), &leave);
    QVERIFY(bench().outlined().empty());
}

void TestSheetsDock::aHoveredRowLightsItsPart()
{
    open(combModel(4));
    const QImage before = view().grab().toImage();
    bench().setOutlined({sectionAt(0, 1)});
    const QImage lit = view().grab().toImage();
    QVERIFY(lit != before);
    bench().setOutlined({});
    QVERIFY(view().grab().toImage() == before);
}

void TestSheetsDock::aClickSelects()
{
    open(combModel(4));
    QTest::mouseClick(&view(), Qt::LeftButton, {}, placeOf(0, 1));
    QCOMPARE(bench().interaction().selection(), std::vector<SectionRef>{sectionAt(0, 1)});
    QTest::mouseClick(&view(), Qt::LeftButton, Qt::ControlModifier, placeOf(0, 3));
    QCOMPARE(bench().interaction().selection().size(), std::size_t(2));
    QTest::mouseClick(&view(), Qt::LeftButton, {}, QPoint(3, 3));
    QVERIFY(bench().interaction().selection().empty());
    const QImage before = view().grab().toImage();
    bench().select({sectionAt(0, 2)});
    QVERIFY(view().grab().toImage() != before);
}

void TestSheetsDock::pagesGoFromPartToPart()
{
    open(combModel(3));
    const Model &model = bench().session().committed();
    view().setFocus();
    for (const std::size_t expected : {0, 1, 2, 3, 0}) {
        QTest::keyClick(&view(), Qt::Key_PageDown);
        QCOMPARE(bench().interaction().selection(), std::vector<SectionRef>{model.ref(expected)});
    }
    QTest::keyClick(&view(), Qt::Key_PageUp);
    QCOMPARE(bench().interaction().selection(), std::vector<SectionRef>{model.ref(3)});
}

void TestSheetsDock::theWheelZoomsAndHomeFits()
{
    open(combModel(4));
    const QPoint at = placeOf(0, 1);
    const double before = view().transform(0).m11();
    QWheelEvent wheel(at, view().mapToGlobal(at), {}, {0, 240}, {}, {}, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view(), &wheel);
    QVERIFY(view().transform(0).m11() > 1.5 * before);
    QVERIFY((placeOf(0, 1) - at).manhattanLength() <= 2); // it stays under the cursor
    QTest::keyClick(&view(), Qt::Key_Home);
    QCOMPARE(view().transform(0).m11(), before);
}

void TestSheetsDock::theMiddleButtonPans()
{
    open(combModel(4));
    for (int i = 0; i < 6; ++i)
        QTest::keyClick(&view(), Qt::Key_Plus);
    const QPoint at = view().rect().center(), way(-30, 14);
    const QPoint before = placeOf(0, 0);
    QTest::mousePress(&view(), Qt::MiddleButton, {}, at);
    QTest::mouseMove(&view(), at + way / 2);
    QTest::mouseMove(&view(), at + way);
    QTest::mouseRelease(&view(), Qt::MiddleButton, {}, at + way);
    QVERIFY((placeOf(0, 0) - before - way).manhattanLength() <= 2);
    QVERIFY(bench().interaction().selection().empty());
}

void TestSheetsDock::anEditIsLaidAgain()
{
    open(combModel(4));
    Document document = bench().session().committed().document;
    const SectionId last[] = {document.sections.back()->id};
    bench().commit(QStringLiteral("Less"), removeSections(document, last));
    QVERIFY(!bench().nesting().isCurrent());
    settle();
    QCOMPARE(view().content().facts[0].parts.size(), std::size_t(4));
    bench().session().history()->undo();
    settle();
    QCOMPARE(view().content().facts[0].parts.size(), std::size_t(5));
}

void TestSheetsDock::choicesAreThoseOfExport()
{
    open(combModel(4));
    auto *rotation = m_window->findChild<ChoiceBox *>(QStringLiteral("sheetsRotation"));
    rotation->setCurrentIndex(3);
    Q_EMIT rotation->activated(3);
    settle();
    QVERIFY(view().content().hasGrain);
    for (const PartOnSheet &part : view().content().facts[0].parts)
        QCOMPARE(part.turn, 0.0);
    QCOMPARE(rememberedChoices().turning, nest::Turning::None);
    inExportPanel(window(), [](QDialog *dialog) {
        QCOMPARE(dialog->findChild<ChoiceBox *>(QStringLiteral("exportRotation"))->currentIndex(),
                 3);
    });
}

// The panel's sheets and the file's numbers are those of the dock.
void TestSheetsDock::whatLiesThereIsExported()
{
    open(combModel(20));
    const std::shared_ptr<const Layout> lying = bench().nesting().result()->layout;
    inExportPanel(window(), [&](QDialog *dialog) {
        const auto &sheet = *dialog->findChild<SheetView *>()->content().sheet;
        const SheetPaths &shown = view().content().sheets()[0];
        QCOMPARE(sheet.parts.size(), shown.parts.size());
        for (std::size_t i = 0; i < shown.parts.size(); ++i)
            QCOMPARE(sheet.parts[i].cuts, shown.parts[i].cuts);
    });
    settle();
    QCOMPARE(bench().nesting().result()->layout->sheets.size(), lying->sheets.size());
}

void TestSheetsDock::tooLargePartsAreToldAndSplit()
{
    Document document =
        withSection(newDocument(), polygonShape(rectangle(0, 0, 900, 500)), front());
    document = withSection(std::move(document), polygonShape(rectangle(0, 0, 50, 50)), front(90));
    open(document);
    QVERIFY(text("sheetsTooLarge").contains(QStringLiteral("is too large for its sheet")));
    std::size_t large = 0;
    for (const SheetFacts &facts : view().content().facts)
        large += facts.isTooLarge ? 1 : 0;
    QCOMPARE(large, std::size_t(1));
    auto *split = m_window->findChild<LinkRow *>(QStringLiteral("sheetsSplit"));
    QVERIFY(split->isVisible());
    Q_EMIT split->clicked(0, false);
    QCOMPARE(bench().interaction().selection(),
             std::vector<SectionRef>{bench().session().committed().ref(0)});
    QVERIFY(bench().interaction().tool());
    bench().escape();
}

void TestSheetsDock::aSearchIsStopped()
{
    open(eggCrate(5, 5));
    auto *stop = m_window->findChild<QPushButton *>(QStringLiteral("sheetsStop"));
    QVERIFY(!stop->isVisible());
    bench().nesting().nest(NestLevel::Best);
    QVERIFY(stop->isVisible());
    QTest::mouseClick(stop, Qt::LeftButton);
    QVERIFY(!stop->isVisible());
    settle();
}

void TestSheetsDock::closedNothingIsWorkedOut()
{
    open(combModel(4));
    actionOf(window(), "fabricate.sheets")->trigger();
    QVERIFY(m_window->findChild<SheetsDock *>()->isHidden());
    QVERIFY(!bench().nesting().isWanted());
    QVERIFY(!bench().session().scheduler().questions().sheets);
}

FFF_TEST_WITH(TestSheetsDock, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    installTranslations(application);
    TestSheetsDock test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_sheets_dock.moc"
