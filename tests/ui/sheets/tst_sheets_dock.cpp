// The Sheets dock as a person uses it, in a window without its view.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/model/edits.h"
#include "core/session/scheduler.h"
#include "core/session/sheet_nesting.h"
#include "tests/core/assembly/known_models.h"
#include "tests/test_program.h"
#include "tests/ui/dialogs/export_hand.h"
#include "ui/base/translations.h"
#include "ui/dialogs/sheet_painting.h"
#include "ui/dialogs/sheet_view.h"
#include "ui/properties/choice_box.h"
#include "ui/properties/link_row.h"
#include "ui/sheets/sheets_dock.h"
#include "ui/sheets/sheets_view.h"

#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QLocale>
#include <QMouseEvent>
#include <QProgressBar>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QUndoStack>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
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
    void aSheetWithoutRoomIsNotSplitFor();
    void aDraggedPartStaysWhereItIsPut();
    void onOthersItGoesBack();
    void escapePutsItBack();
    void theHandleTurnsIt();
    void keysMoveTurnAndPin();
    void aClickOnThePinUnpins();
    void whatKeepsToTheGrainIsNotTurned();
    void whatIsPutThereIsExported();
    void aSearchIsStopped();
    void closedNothingIsWorkedOut();

private:
    void open(const Document &document);
    void settle();
    void drag(const QPoint &from, const QPoint &to);
    std::size_t partOf(const SectionRef &section);
    const Document &document() { return m_window->bench().session().committed().document; }
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

/// In steps, and not let go of.
void TestSheetsDock::drag(const QPoint &from, const QPoint &to)
{
    QTest::mousePress(&view(), Qt::LeftButton, {}, from);
    constexpr int kSteps = 5;
    for (int i = 1; i <= kSteps; ++i) {
        const QPointF at = QPointF(from) + QPointF(to - from) * (static_cast<double>(i) / kSteps);
        QMouseEvent move(QEvent::MouseMove, at, view().mapToGlobal(at), Qt::NoButton,
                         Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&view(), &move);
    }
}

/// Of the first sheet.
std::size_t TestSheetsDock::partOf(const SectionRef &section)
{
    const std::vector<PartOnSheet> &parts = view().content().facts[0].parts;
    const auto found = std::find_if(parts.begin(), parts.end(), [&](const PartOnSheet &part) {
        return part.section == section;
    });
    return static_cast<std::size_t>(found - parts.begin());
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
    const QRegularExpression foot(
        QStringLiteral("<b>13 parts</b> on <b>1 sheet</b> \u00B7 \\d+\\.\\d[\u00A0\u202F]% used "
                       "\u00B7 \\d+\\.\\d m of "
                       "cutting"));
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
    const double fitted = view().transform(0).m11();
    for (int i = 0; i < 6; ++i) // what is smaller than the view stands in its middle
        QTest::keyClick(&view(), Qt::Key_Plus);
    const QPoint at = view().rect().center();
    const QPointF under = view().transform(0).inverted().map(QPointF(at));
    const double before = view().transform(0).m11();
    QWheelEvent wheel(at, view().mapToGlobal(at), {}, {0, 240}, {}, {}, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view(), &wheel);
    QVERIFY(view().transform(0).m11() > 1.5 * before);
    QVERIFY((view().transform(0).map(under) - QPointF(at)).manhattanLength() < 1.0);
    QTest::keyClick(&view(), Qt::Key_Home);
    QCOMPARE(view().transform(0).m11(), fitted);
}

void TestSheetsDock::theMiddleButtonPans()
{
    open(combModel(4));
    for (int i = 0; i < 10; ++i) // the sheet is larger than the view both ways
        QTest::keyClick(&view(), Qt::Key_Plus);
    const QPoint at = view().rect().center(), way(-30, 14);
    const QPoint before = placeOf(0, 0);
    QTest::mousePress(&view(), Qt::MiddleButton, {}, at);
    QTest::mouseMove(&view(), at + way / 2);
    QTest::mouseMove(&view(), at + way);
    QTest::mouseRelease(&view(), Qt::MiddleButton, {}, at + way);
    const QPoint moved = placeOf(0, 0) - before;
    QVERIFY2((moved - way).manhattanLength() <= 2,
             qPrintable(QStringLiteral("%1, %2").arg(moved.x()).arg(moved.y())));
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
    const auto &operations = bench().session().committed().document.operations;
    QCOMPARE(operations.size(), std::size_t(1));
    QCOMPARE(operations[0]->kind, std::string("grid"));
}

// Wrong: a grid of a sheet that its margins leave nothing of cuts the model to crumbs.
void TestSheetsDock::aSheetWithoutRoomIsNotSplitFor()
{
    open(onSheets(withSection(newDocument(), polygonShape(rectangle(0, 0, 50, 50)), front()),
                  {9, 9}));
    QVERIFY2(text("sheetsTooLarge")
                 .startsWith(QStringLiteral("A sheet of Birch plywood has no room within margins "
                                            "of 5")),
             qPrintable(text("sheetsTooLarge")));
    QVERIFY(!m_window->findChild<LinkRow *>(QStringLiteral("sheetsSplit"))->isVisible());
    QVERIFY2(!text("sheetsTotals").contains(u'%'), qPrintable(text("sheetsTotals")));
}

namespace {

/// Far from where parts are laid first.
QPoint emptyCorner(const SheetsView &view)
{
    const QSizeF size = view.content().sheets()[0].size;
    return view.transform(0).map(QPointF(size.width() - 60.0, size.height() - 60.0)).toPoint();
}

} // namespace

// And the others stay where they are; with one step it is back.
void TestSheetsDock::aDraggedPartStaysWhereItIsPut()
{
    open(combModel(6));
    const SectionRef section = sectionAt(0, 2);
    std::vector<QPoint> before;
    for (std::size_t i = 0; i < 7; ++i)
        before.push_back(placeOf(0, partOf(bench().session().committed().ref(i))));
    const int index = bench().session().committed().indexOf(section);
    const QPoint from = placeOf(0, 2), to = emptyCorner(view());
    drag(from, to);
    QVERIFY(view().hand() && view().hand()->isSound());
    QVERIFY(document().pins.empty());
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, to);
    QCOMPARE(document().pins.size(), std::size_t(1));
    QCOMPARE(document().pins[0].section, section);
    settle();
    QVERIFY(!view().hand());
    QVERIFY(view().content().facts[0].parts[partOf(section)].isPinned);
    QVERIFY((placeOf(0, partOf(section)) - to).manhattanLength() <= 20); // snapping
    for (std::size_t i = 0; i < 7; ++i)
        if (static_cast<int>(i) != index)
            QCOMPARE(placeOf(0, partOf(bench().session().committed().ref(i))), before[i]);
    auto *unpin = m_window->findChild<LinkRow *>(QStringLiteral("sheetsUnpin"));
    QVERIFY(unpin->isVisible());
    bench().session().history()->undo();
    settle();
    QVERIFY(!unpin->isVisible());
    for (std::size_t i = 0; i < 7; ++i)
        QCOMPARE(placeOf(0, partOf(bench().session().committed().ref(i))), before[i]);
    bench().session().history()->redo();
    settle();
    Q_EMIT unpin->clicked(0, false);
    QVERIFY(document().pins.empty());
}

void TestSheetsDock::onOthersItGoesBack()
{
    open(combModel(6));
    const QPoint from = placeOf(0, 2), to = placeOf(0, 4);
    drag(from, to);
    QVERIFY(view().hand() && !view().hand()->isSound());
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, to);
    QVERIFY(!view().hand());
    QVERIFY(document().pins.empty());
    QCOMPARE(placeOf(0, 2), from);
    QCOMPARE(text("sheetsState"), QStringLiteral("There is no room for it."));
}

void TestSheetsDock::escapePutsItBack()
{
    open(combModel(6));
    const QPoint from = placeOf(0, 2), to = emptyCorner(view());
    drag(from, to);
    QTest::keyClick(&view(), Qt::Key_Escape);
    QVERIFY(!view().hand());
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, to);
    QVERIFY(document().pins.empty());
    QCOMPARE(placeOf(0, 2), from);
}

void TestSheetsDock::theHandleTurnsIt()
{
    open(combModel(3));
    const SectionRef section = sectionAt(0, 1);
    drag(placeOf(0, 1), emptyCorner(view()));
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, emptyCorner(view()));
    settle();
    QVERIFY(view().handle());
    const double before = view().content().facts[0].parts[partOf(section)].turn;
    const QPointF handle = *view().handle();
    const QRectF box = view()
                           .transform(0)
                           .map(view().content().sheets()[0].parts[partOf(section)].cuts)
                           .boundingRect();
    const QPointF way = handle - box.center();
    drag(handle.toPoint(), (box.center() + QPointF(-way.y(), way.x())).toPoint());
    QVERIFY(view().hand() && view().hand()->isMoved());
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, QPoint());
    settle();
    const double turned = view().content().facts[0].parts[partOf(section)].turn - before;
    QVERIFY2(std::abs(std::remainder(std::abs(turned) - 90.0, 360.0)) < 8.0 ||
                 std::abs(std::remainder(std::abs(turned) - 270.0, 360.0)) < 8.0,
             qPrintable(QString::number(turned)));
}

void TestSheetsDock::keysMoveTurnAndPin()
{
    open(combModel(6));
    const SectionRef section = sectionAt(0, 2);
    QTest::mouseClick(&view(), Qt::LeftButton, {}, placeOf(0, 2));
    QTest::keyClick(&view(), Qt::Key_P);
    QCOMPARE(document().pins.size(), std::size_t(1));
    settle();
    QTest::keyClick(&view(), Qt::Key_P);
    QVERIFY(document().pins.empty());
    settle();
    drag(placeOf(0, partOf(section)), emptyCorner(view()));
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, emptyCorner(view()));
    settle();
    const PinnedPlace put = document().pins[0];
    const int steps = bench().session().history()->count();
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(&view(), Qt::Key_Left);
    QTest::keyClick(&view(), Qt::Key_Down);
    QVERIFY((document().pins[0].offset - put.offset - Vec2(-3.0, -1.0)).norm() < 1e-9);
    QCOMPARE(bench().session().history()->count(), steps + 1);
    settle();
    QTest::keyClick(&view(), Qt::Key_R);
    QVERIFY((document().pins[0].turn - Vec2(-put.turn.y(), put.turn.x())).norm() < 1e-9);
    settle();
}

void TestSheetsDock::aClickOnThePinUnpins()
{
    open(combModel(6));
    const SectionRef section = sectionAt(0, 2);
    drag(placeOf(0, 2), emptyCorner(view()));
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, emptyCorner(view()));
    settle();
    QCOMPARE(document().pins.size(), std::size_t(1));
    const std::size_t part = partOf(section);
    const QPointF pin = pinPlace(view().content().sheets()[0].parts[part], {view().transform(0)});
    QVERIFY(view().pinAt(pin) == SheetSpot({0, part}));
    QVERIFY(!view().pinAt(placeOf(0, part)));
    QTest::mouseMove(&view(), pin.toPoint());
    QTRY_COMPARE(view().cursor().shape(), Qt::PointingHandCursor);
    QTest::mouseClick(&view(), Qt::LeftButton, {}, pin.toPoint());
    QVERIFY(document().pins.empty());
    settle();
    QVERIFY(!view().pinAt(pin));
}

void TestSheetsDock::whatKeepsToTheGrainIsNotTurned()
{
    open(combModel(6));
    const SectionRef section = sectionAt(0, 2);
    bench().run(QStringLiteral("sheets.turning"),
                {{"section", bench().session().committed().nameOf(section)}, {"turning", "none"}});
    settle();
    const PartOnSheet &part = view().content().facts[0].parts[partOf(section)];
    QVERIFY(part.keepsToGrain);
    QCOMPARE(part.turn, 0.0);
    QTest::mouseClick(&view(), Qt::LeftButton, {}, placeOf(0, partOf(section)));
    QVERIFY(!view().handle());
    QTest::keyClick(&view(), Qt::Key_R);
    QVERIFY(document().pins.empty());
    QCOMPARE(text("sheetsState"), QStringLiteral("It lies as it is drawn."));
}

void TestSheetsDock::whatIsPutThereIsExported()
{
    open(combModel(6));
    drag(placeOf(0, 2), emptyCorner(view()));
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, emptyCorner(view()));
    settle();
    inExportPanel(window(), [&](QDialog *dialog) {
        const auto &sheet = *dialog->findChild<SheetView *>()->content().sheet;
        const SheetPaths &shown = view().content().sheets()[0];
        QCOMPARE(sheet.parts.size(), shown.parts.size());
        for (std::size_t i = 0; i < shown.parts.size(); ++i)
            QCOMPARE(sheet.parts[i].cuts, shown.parts[i].cuts);
    });
}

void TestSheetsDock::aSearchIsStopped()
{
    open(eggCrate(5, 5));
    auto *stop = m_window->findChild<QPushButton *>(QStringLiteral("sheetsStop"));
    QVERIFY(!stop->isVisible());
    bench().nesting().nest(NestLevel::Best);
    QVERIFY(stop->isVisible());
    // Wrong: two numbers for how full the sheets are, or nothing that moves.
    const auto *bar = m_window->findChild<QProgressBar *>(QStringLiteral("sheetsBar"));
    QVERIFY(bar->isVisible());
    const QRegularExpressionMatch told =
        QRegularExpression(QStringLiteral("^Nesting… (\\d+\\.\\d)\\W% used$")).match(bar->text());
    QVERIFY2(told.hasMatch(), qPrintable(bar->text()));
    QVERIFY2(text("sheetsTotals").contains(told.captured(1)), qPrintable(text("sheetsTotals")));
    QVERIFY2(QRegularExpression(QStringLiteral("^keeps the best so far, \\d+ s$"))
                 .match(text("sheetsState"))
                 .hasMatch(),
             qPrintable(text("sheetsState")));
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
