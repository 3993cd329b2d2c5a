// Docks, checks, history, stocks and units as a person uses them, in a window without its view.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/interaction/view_cube.h"
#include "core/model/edits.h"
#include "core/session/check_list.h"
#include "tests/core/assembly/known_models.h"
#include "tests/test_program.h"
#include "ui/base/field_style.h"
#include "ui/base/panes.h"
#include "ui/base/sentence_label.h"
#include "ui/bench/workbench.h"
#include "ui/docks/check_row.h"
#include "ui/docks/outline_dock.h"
#include "ui/settings/settings.h"
#include "ui/window/badge.h"
#include "ui/window/main_window.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSignalSpy>
#include <QSlider>
#include <QTabBar>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTranslator>
#include <QTreeWidget>

#include <algorithm>

#include <functional>
#include <set>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

const char *const kDocks[] = {"outlineDock", "historyDock", "checksDock", "propertiesDock"};

/// Two plates that stand across each other.
Document cross()
{
    return twoSections(polygonShape(rectangle(-50, 0, 50, 60)), front(),
                       polygonShape(rectangle(-50, 0, 50, 60)), side())
        .document;
}

/// So many plates on a bar.
Document plateComb(int count)
{
    Document document =
        withSection(newDocument(), polygonShape(rectangle(0, 0, 10.0 * count + 10.0, 40)), front());
    const ShapePointer plate = polygonShape(rectangle(-30, 0, 30, 60));
    for (int i = 0; i < count; ++i) {
        NewSection section;
        section.shape = plate;
        section.frame = side(10.0 * i + 10.0);
        section.parent = Parent{document.sections.front()->id, {0, 0}, {0, 20}};
        document = *addSection(std::move(document), std::move(section));
    }
    return document;
}

} // namespace

class TestDocks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void f9HidesAllDocksAndBringsThemBack();
    void theArrangementIsKept();
    void startingAgainKeepsTheSizes();
    void checksHaveTheirShareOfTheColumn();
    void aNarrowWindowLeavesRoomForTheView_data();
    void aNarrowWindowLeavesRoomForTheView();
    void aStateOfAnotherVersionIsLeftOut();
    void aJumpInTheHistoryIsAnnouncedOnce();
    void checksSayWhatIsWrong_data();
    void checksSayWhatIsWrong();
    void marksHaveTheNumbersOfTheirRows();
    void equalOnesAreOneRowThatSteps();
    void aRowUnderTheCursorLightsItsMark();
    void aStepUnderTheCursorIsOutlined();
    void aCheckSelectsWhomItIsAbout();
    void aCheckOfAJointSelectsTheJoint();
    void whoBlocksWhomIsShown();
    void howItFallsIsShown();
    void anotherDocumentHasNothingSelected();
    void whatCanBeDoneIsOneStep();
    void propertiesSayWhatIsWrong();
    void badgesLeaveTheCubeFree();
    void slitsAreTurnedInOneStep();
    void theFocusStaysWithItsCheck();
    void draggingTheThicknessIsOneStep();
    void escapeEndsADragWithoutAStep();
    void aKeyOnTheSliderIsForTheStockThatIsShown();
    void undoAfterAKeyOnTheSliderTakesItBack();
    void aNameIsForTheSectionItWasTypedAt();
    void aUsedStockIsReplaced();
    void slitEndsFollowAtOnce();
    void slitNumbersAreTyped_data();
    void slitNumbersAreTyped();
    void lengthsFollowTheUnit();
    void fieldsReckonWithTheThickness();
    void fieldsOfSectionsThatDifferSayMixed();
    void longSentencesAreCutShort();
    void anEditTouchesOneRowOfTheOutline();
    void theFilterKeepsParents();
    void f6GoesRoundTheWindow();

private:
    void open();
    Session &session() { return m_window->bench().session(); }
    template <class Widget>
    Widget *find(const char *name)
    {
        return m_window->findChild<Widget *>(QLatin1String(name));
    }
    /// Once it is where a mouse can reach it.
    QString firstCheck()
    {
        const auto *row = find<CheckRow>("checkRow0");
        return row->height() > 0 ? row->accessibleName() : QString();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

void TestDocks::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
    open();
}

void TestDocks::open()
{
    m_window = std::make_unique<MainWindow>();
    if (!m_window->restoreGeometry(settings().windowGeometry()))
        m_window->resize(1400, 900);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    QApplication::setActiveWindow(m_window.get());
}

void TestDocks::cleanup()
{
    m_window.reset();
}

// Wrong: of ten problems two are seen, beside an outline of three rows and much that is empty.
void TestDocks::checksHaveTheirShareOfTheColumn()
{
    auto *checks = find<QDockWidget>("checksDock"), *outline = find<QDockWidget>("outlineDock");
    const auto share = [&] {
        return double(checks->height()) / (checks->height() + outline->height());
    };
    for (const QSize &size : {QSize(1400, 900), QSize(1440, 700), QSize(1900, 960)}) {
        m_window->resize(size);
        QCoreApplication::processEvents();
        m_window->resizeDocks({checks}, {size.height()}, Qt::Vertical); // as high as can be
        QTRY_VERIFY(share() > 0.5);
        find<QAction>("view.resetWindow")->trigger();
        QTRY_VERIFY2(std::abs(share() - 0.4) < 0.03, qPrintable(QString::number(share())));
    }
    m_window.reset();
    open();
    checks = find<QDockWidget>("checksDock");
    outline = find<QDockWidget>("outlineDock");
    QTRY_VERIFY2(std::abs(share() - 0.4) < 0.03, qPrintable(QString::number(share())));
}

void TestDocks::aNarrowWindowLeavesRoomForTheView_data()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << QString();
    QTest::newRow("German") << QStringLiteral("de");
}

// Wrong: so that the names of tabs can be read, the column takes almost half of the window.
void TestDocks::aNarrowWindowLeavesRoomForTheView()
{
    QFETCH(QString, language);
    QTranslator translator;
    if (!language.isEmpty()) {
        QVERIFY(translator.load(QStringLiteral(":/i18n/flatfitfab_") + language));
        QCoreApplication::installTranslator(&translator);
    }
    m_window.reset();
    open();
    m_window->resize(1024, 640);
    QCoreApplication::processEvents();
    find<QAction>("view.resetWindow")->trigger();
    QCoreApplication::removeTranslator(&translator);
    const auto *properties = find<QDockWidget>("propertiesDock");
    QTRY_VERIFY2(properties->width() <= 366, qPrintable(QString::number(properties->width())));
    int tabs = 0;
    for (const QTabBar *bar :
         m_window->findChildren<QTabBar *>(QString(), Qt::FindDirectChildrenOnly))
        for (int i = 0; bar->isVisible() && i < bar->count(); ++i, ++tabs)
            QVERIFY2(bar->tabRect(i).width() >=
                         bar->fontMetrics().horizontalAdvance(bar->tabText(i)) + 2,
                     qPrintable(bar->tabText(i)));
    QCOMPARE(tabs, 5);
}

// Wrong: a key pressed twice that leaves another window than before.
void TestDocks::f9HidesAllDocksAndBringsThemBack()
{
    find<QDockWidget>("historyDock")->close();
    find<QDockWidget>("checksDock")->setFloating(true);
    QCoreApplication::processEvents();
    const auto state = [this] {
        QStringList all;
        for (const char *name : kDocks) {
            auto *dock = find<QDockWidget>(name);
            all += QStringLiteral("%1 %2 %3 %4")
                       .arg(QLatin1String(name))
                       .arg(dock->isHidden())
                       .arg(dock->isFloating())
                       .arg(m_window->dockWidgetArea(dock));
        }
        return all;
    };
    const QStringList before = state();
    QTest::keyClick(m_window.get(), Qt::Key_F9);
    for (const char *name : kDocks)
        QVERIFY2(find<QDockWidget>(name)->isHidden(), name);
    QVERIFY(find<QAction>("view.docks")->isChecked());
    QTest::keyClick(m_window.get(), Qt::Key_F9);
    QCOMPARE(state(), before);
    QVERIFY(!find<QAction>("view.docks")->isChecked());
}

void TestDocks::theArrangementIsKept()
{
    find<QDockWidget>("historyDock")->close();
    m_window->addDockWidget(Qt::RightDockWidgetArea, find<QDockWidget>("outlineDock"));
    QTest::keyClick(m_window.get(), Qt::Key_F9); // what is kept is what F9 would bring back
    QVERIFY(m_window->close());
    open();
    QVERIFY(find<QDockWidget>("historyDock")->isHidden());
    QVERIFY(!find<QDockWidget>("checksDock")->isHidden());
    QCOMPARE(m_window->dockWidgetArea(find<QDockWidget>("outlineDock")), Qt::RightDockWidgetArea);
    find<QAction>("view.resetWindow")->trigger();
    QVERIFY(!find<QDockWidget>("historyDock")->isHidden());
    QCOMPARE(m_window->dockWidgetArea(find<QDockWidget>("outlineDock")), Qt::LeftDockWidgetArea);
}

// Wrong: docks that shrink a little at every start.
void TestDocks::startingAgainKeepsTheSizes()
{
    auto *const outline = find<QDockWidget>("outlineDock"), *const checks =
                                                                find<QDockWidget>("checksDock");
    m_window->resizeDocks({outline, checks}, {300, 400}, Qt::Vertical);
    m_window->resizeDocks({outline}, {310}, Qt::Horizontal);
    QCoreApplication::processEvents();
    const QSize first = checks->size();
    for (int i = 0; i < 3; ++i) {
        QVERIFY(m_window->close());
        open();
        QCoreApplication::processEvents();
        QCOMPARE(find<QDockWidget>("checksDock")->size(), first);
    }
}

void TestDocks::aStateOfAnotherVersionIsLeftOut()
{
    find<QDockWidget>("checksDock")->close();
    settings().setWindowState(m_window->saveState(999));
    settings().setWindowGeometry(QByteArray("no geometry"));
    open();
    for (const char *name : kDocks)
        QVERIFY2(!find<QDockWidget>(name)->isHidden(), name);
    QCOMPARE(m_window->dockWidgetArea(find<QDockWidget>("checksDock")), Qt::LeftDockWidgetArea);
}

void TestDocks::aJumpInTheHistoryIsAnnouncedOnce()
{
    auto *list = find<QAbstractItemView>("historyList");
    QVERIFY(find<QLabel>("historyEmpty")->isVisibleTo(list));
    Document document = newDocument();
    for (int i = 0; i < 4; ++i) {
        document = withSection(document, polygonShape(rectangle(0, 0, 10, 10)), front(5.0 * i));
        session().commit(QStringLiteral("Step %1").arg(i), document);
    }
    QVERIFY(!find<QLabel>("historyEmpty")->isVisibleTo(list));
    find<QDockWidget>("historyDock")->raise();
    QTRY_VERIFY(list->isVisible());
    QSignalSpy announced(&session(), &Session::modelChanged);
    const QModelIndex first = list->model()->index(1, 0); // row 0 stands before all steps
    QCOMPARE(first.data().toString(), QStringLiteral("Step 0"));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(first).center());
    QCOMPARE(session().history()->index(), 1);
    QCOMPARE(announced.count(), 1);
    QCOMPARE(session().model().sectionCount(), std::size_t(1));
}

void TestDocks::checksSayWhatIsWrong_data()
{
    QTest::addColumn<Document>("document");
    QTest::addColumn<QString>("title");
    QTest::newRow("two plates across each other stand") << cross() << "Good: Stands";
    QTest::newRow("one plate on its edge tips easily")
        << withSection(newDocument(), polygonShape(rectangle(0, 0, 50, 50)), front())
        << "Warning 1: Barely stands";
    QTest::newRow("what hangs over falls")
        << withSection(newDocument(), polygonShape({{0, 0}, {10, 0}, {120, 60}, {0, 60}}), front())
        << "Problem 1: Falls over to its right";
    QTest::newRow("a plate in the air is not connected")
        << withSection(cross(), polygonShape(rectangle(-50, 0, 50, 60)), front(90))
        << "Problem 1: Nothing touches Section 3";
    QTest::newRow("a plate is larger than its sheet")
        << twoSections(polygonShape(rectangle(-500, 0, 500, 60)), front(),
                       polygonShape(rectangle(-50, 0, 50, 60)), side())
               .document
        << "Problem 1: Too large for the sheet";
}

void TestDocks::checksSayWhatIsWrong()
{
    QFETCH(Document, document);
    QFETCH(QString, title);
    QVERIFY(find<QLabel>("checksEmpty")->isVisibleTo(m_window.get()));
    session().reset(document);
    QTRY_VERIFY2(find<CheckRow>("checkRow0") && firstCheck().startsWith(title),
                 qPrintable(find<CheckRow>("checkRow0") ? firstCheck() : title));
    QVERIFY(!find<QLabel>("checksEmpty")->isVisibleTo(m_window.get()));
}

// Wrong: a number in the view that is another one in the list, or numbers of a list that is closed.
void TestDocks::marksHaveTheNumbersOfTheirRows()
{
    Document document = withSection(cross(), polygonShape(rectangle(-50, 0, 50, 60)), front(90));
    document = withSection(document, polygonShape(rectangle(-20, 0, 20, 20)), front(-90));
    session().reset(document);
    Workbench &bench = m_window->bench();
    QTRY_VERIFY(bench.interaction().marks().size() >= 2);
    for (const ProblemMark &mark : bench.interaction().marks()) {
        const QByteArray row = "checkRow" + QByteArray::number(mark.number - 1);
        const QString name = find<CheckRow>(row.constData())->accessibleName();
        QVERIFY2(name.contains(QStringLiteral(" %1: ").arg(mark.number)), qPrintable(name));
        const int section = session().model().indexOf(mark.sections.front());
        QVERIFY2(name.contains(QString::fromStdString(
                     session().model().section(static_cast<std::size_t>(section))->name)),
                 qPrintable(name));
    }

    Q_EMIT bench.problemChosen(2, 0);
    QVERIFY(find<CheckRow>("checkRow1")->isChecked());
    QVERIFY(bench.interaction().selection() == bench.interaction().marks()[1].sections);

    find<QDockWidget>("checksDock")->toggleViewAction()->trigger();
    QVERIFY(bench.interaction().marks().empty());
    find<QDockWidget>("checksDock")->toggleViewAction()->trigger();
    QVERIFY(!bench.interaction().marks().empty());
}

// Wrong: ten rows that say the same, or one row from which one cannot come to each place.
void TestDocks::equalOnesAreOneRowThatSteps()
{
    Document document = cross();
    for (const double at : {90.0, -90.0, 130.0})
        document = withSection(document, polygonShape(rectangle(-50, 0, 50, 60)), front(at));
    session().reset(document);
    Workbench &bench = m_window->bench();
    const auto count = [&] { // of the first row
        const auto &marks = bench.interaction().marks();
        return std::count_if(marks.begin(), marks.end(),
                             [](const ProblemMark &mark) { return mark.number == 1; });
    };
    QTRY_COMPARE(count(), 3);
    for (int i = 0; i < 3; ++i) {
        const ProblemMark &mark = bench.interaction().marks()[static_cast<std::size_t>(i)];
        QCOMPARE(mark.place, i);
        QVERIFY(!mark.words.empty());
    }
    const auto name = [this] { return find<CheckRow>("checkRow0")->accessibleName(); };
    QVERIFY2(name().contains(QStringLiteral("in 3 places")), qPrintable(name()));
    const auto chosen = [&] {
        int at = -1;
        for (const ProblemMark &mark : bench.interaction().marks())
            at = mark.isChosen && mark.number == 1 ? mark.place : at;
        return at;
    };
    QCOMPARE(chosen(), -1);
    for (const int place : {0, 1, 2, 0}) {
        find<CheckRow>("checkRow0")->click(); // its links move about until it is known what helps
        QCOMPARE(chosen(), place);
        QVERIFY(find<CheckRow>("checkRow0")->isChecked());
        QVERIFY2(name().contains(QStringLiteral("%1 of 3").arg(place + 1)), qPrintable(name()));
        const auto &marks = bench.interaction().marks();
        QCOMPARE(bench.interaction().selection(), marks[static_cast<std::size_t>(place)].sections);
    }
    QTest::keyClick(m_window.get(), Qt::Key_F8);
    QCOMPARE(chosen(), 1);
    Q_EMIT bench.problemChosen(1, 2); // its mark was clicked
    QCOMPARE(chosen(), 2);
    bench.select({});
    QCOMPARE(chosen(), -1);
}

// Wrong: one looks for the row or for the place by reading numbers.
void TestDocks::aRowUnderTheCursorLightsItsMark()
{
    session().reset(withSection(cross(), polygonShape(rectangle(-50, 0, 50, 60)), front(90)));
    QTRY_VERIFY(find<CheckRow>("checkRow0") && !firstCheck().isEmpty());
    auto *row = find<CheckRow>("checkRow0");
    QTRY_VERIFY(firstCheck().startsWith(QStringLiteral("Problem 1")));
    QEnterEvent enter({5, 5}, {5, 5}, {5, 5});
    QCoreApplication::sendEvent(row, &enter);
    QCOMPARE(m_window->bench().litProblem(), 1);
    QVERIFY(!m_window->bench().interaction().view().faulty.empty()); // and whom it is about
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(row, &leave);
    QCOMPARE(m_window->bench().litProblem(), 0);
    QVERIFY(m_window->bench().interaction().view().faulty.empty());
}

// Wrong: the view says nothing about the step, or keeps on saying it.
void TestDocks::aStepUnderTheCursorIsOutlined()
{
    session().reset(cross());
    Workbench &bench = m_window->bench();
    const SectionRef b = session().model().ref(1);
    bench.commit(QStringLiteral("Rename"),
                 renameSection(session().committed().document, b.drawn, "Fin"));
    const auto outlined = [&] { return bench.outlined(); };
    auto *list = find<QAbstractItemView>("historyList");
    auto *rows = list->viewport();
    const auto hover = [&](int row) {
        const QPoint at = list->visualRect(list->model()->index(row, 0)).center();
        QTest::mouseMove(rows, at);
    };
    m_window->findChild<QDockWidget *>(QStringLiteral("historyDock"))->raise();
    QTRY_VERIFY(rows->isVisible());
    QSignalSpy seen(&bench, &Workbench::viewChanged);
    hover(1);
    QTRY_VERIFY(outlined() == std::vector{b});
    const auto told = seen.count();
    QTest::mouseMove(rows, list->visualRect(list->model()->index(1, 0)).center() + QPoint(5, 0));
    QTest::qWait(20);
    QCOMPARE(seen.count(), told); // the same step: nothing to paint
    hover(0);
    QTRY_VERIFY(outlined().empty());
    hover(1);
    QTRY_VERIFY(!outlined().empty());
    QTest::mouseMove(rows, {20, rows->height() - 3}); // below the last step
    QTRY_VERIFY(outlined().empty());
    hover(1);
    QTRY_VERIFY(!outlined().empty());
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(rows, &leave);
    QVERIFY(outlined().empty());
}

void TestDocks::aCheckSelectsWhomItIsAbout()
{
    session().reset(withSection(cross(), polygonShape(rectangle(-50, 0, 50, 60)), front(90)));
    QTRY_VERIFY(find<CheckRow>("checkRow0") && firstCheck().startsWith(QStringLiteral("Problem")));
    QTest::mouseClick(find<CheckRow>("checkRow0"), Qt::LeftButton);
    const auto third = std::vector{session().model().ref(2)};
    QCOMPARE(m_window->bench().interaction().selection(), third);
    QCOMPARE(m_window->bench().interaction().view().problems.size(), std::size_t(1));
    m_window->bench().select({});
    QVERIFY(m_window->bench().interaction().view().problems.empty());
    QTest::keyClick(m_window.get(), Qt::Key_F8);
    QVERIFY(!m_window->bench().interaction().selection().empty());
}

// Wrong: a person is told of a joint and left to find it, to see what can be set of it.
void TestDocks::aCheckOfAJointSelectsTheJoint()
{
    session().reset(twoSections(polygonShape(rectangle(-50, 0, 50, 60)), front(),
                                polygonShape(rectangle(-50, 0, 50, 60)), turned(0.4))
                        .document);
    QTRY_VERIFY(find<CheckRow>("checkRow0") && firstCheck().contains(QStringLiteral(" meet ")));
    QTest::mouseClick(find<CheckRow>("checkRow0"), Qt::LeftButton);
    const Interaction &interaction = m_window->bench().interaction();
    QVERIFY(interaction.selectedJoint() ==
            JointRef(session().model().ref(0), session().model().ref(1)));
    QCOMPARE(interaction.view().problems.size(), std::size_t(2));
    QVERIFY(find<CheckRow>("checkRow0")->isChecked());
}

// Wrong: one reads that sections block each other, and searches for where.
void TestDocks::whoBlocksWhomIsShown()
{
    Workbench &bench = m_window->bench();
    session().reset(moveAll(triangle(), {0, 30, 0}));
    QTRY_VERIFY(find<CheckRow>("checkRow0") &&
                firstCheck().contains(QStringLiteral("block each other")));
    QVERIFY(bench.problemLook().links.empty());
    QVERIFY(bench.interaction().view().faulty.empty()); // dots say enough of what nobody looks at
    QTest::mouseClick(find<CheckRow>("checkRow0"), Qt::LeftButton);
    QCOMPARE(bench.problemLook().links.size(), std::size_t(3));
    QCOMPARE(bench.interaction().view().problems.size(), std::size_t(3));
    QVERIFY(bench.interaction().view().faulty.empty()); // it has the hatch
    bench.setMarksAside(true);
    QVERIFY(bench.problemLook().isEmpty());
    bench.setMarksAside(false);
    bench.select({});
    QVERIFY(bench.problemLook().links.empty());
}

// Wrong: a model that falls over without a sign of where to.
void TestDocks::howItFallsIsShown()
{
    Workbench &bench = m_window->bench();
    session().reset(
        withSection(newDocument(), polygonShape({{0, 0}, {10, 0}, {120, 60}, {0, 60}}), front()));
    QTRY_COMPARE(bench.problemLook().grounds.size(), std::size_t(1));
    const GroundMark mark = bench.problemLook().grounds.front();
    QVERIFY(mark.isProblem && mark.margin < 0.0);
    QVERIFY(std::abs(mark.edge.x() - 10.0) < 0.2); // of its foot, and what is as good as on it
    QVERIFY(std::abs(mark.centreOfMass.x() - mark.edge.x() + mark.margin) < 1e-6);
    QTRY_VERIFY(find<CheckRow>("checkRow0") && firstCheck().contains(QStringLiteral("Falls over")));
    QVERIFY(bench.interaction().view().faulty.empty());
    QTest::mouseClick(find<CheckRow>("checkRow0"), Qt::LeftButton);
    QVERIFY(bench.interaction().view().problems.empty()); // the section is as it should be
    QCOMPARE(bench.interaction().view().faulty.size(), std::size_t(1)); // but stands on too little
    bench.select({session().model().ref(0)});
    QVERIFY(bench.interaction().view().faulty.empty());
    find<QDockWidget>("checksDock")->toggleViewAction()->trigger();
    QVERIFY(bench.problemLook().isEmpty());
    find<QDockWidget>("checksDock")->toggleViewAction()->trigger();

    session().reset(cross()); // it stands: only whoever asks sees how
    QTRY_VERIFY(firstCheck().startsWith(QStringLiteral("Good")));
    QVERIFY(bench.problemLook().isEmpty());
    for (int row = 0; bench.problemLook().isEmpty() && row < 4; ++row)
        QTest::mouseClick(m_window->findChild<CheckRow *>(QStringLiteral("checkRow%1").arg(row)),
                          Qt::LeftButton);
    QCOMPARE(bench.problemLook().grounds.size(), std::size_t(1));
    QVERIFY(!bench.problemLook().grounds.front().isProblem);
}

// Wrong: Delete takes sections of the file that was just opened which nobody has chosen.
void TestDocks::anotherDocumentHasNothingSelected()
{
    Workbench &bench = m_window->bench();
    session().reset(cross());
    bench.select({session().model().ref(1)});
    session().reset(eggCrate(2, 2));
    QVERIFY(bench.interaction().selection().empty());
    bench.selectJoint(JointRef(session().model().ref(0), session().model().ref(2)));
    session().reset(eggCrate(2, 3));
    QVERIFY(!bench.interaction().selectedJoint());
    QVERIFY(bench.interaction().selection().empty());
    // Nor what was deleted in the one before: an edit here brings nothing back.
    bench.select({session().model().ref(0)});
    bench.run(QStringLiteral("edit.delete"));
    session().reset(cross());
    session().commit(QStringLiteral("Rename"),
                     *renameSection(session().committed().document,
                                    session().committed().document.sections[0]->id, "Fin"));
    QVERIFY(bench.interaction().selection().empty());
}

// Wrong: links that say something else than they do, cannot be reached with keys, or a step of the
// history that cannot be taken back.
void TestDocks::whatCanBeDoneIsOneStep()
{
    Document loose = withSection(cross(), polygonShape(rectangle(-20, 0, 20, 40)), side(120));
    loose = *renameSection(loose, loose.sections[0]->id, "Body");
    loose = *renameSection(loose, loose.sections[2]->id, "Fin");
    session().reset(loose);
    const auto link = [this](int index) {
        return find<CheckRow>("checkRow0")
            ->findChild<QAbstractButton *>(QStringLiteral("checkLink%1").arg(index));
    };
    QTRY_VERIFY(find<CheckRow>("checkRow0") && link(1) && link(1)->isVisible());
    QVERIFY2(firstCheck().contains(QStringLiteral("Fin")), qPrintable(firstCheck()));
    QCOMPARE(link(0)->accessibleName(), QStringLiteral("Move it to Body"));
    QCOMPARE(link(1)->accessibleName(), QStringLiteral("Delete it"));

    find<CheckRow>("checkRow0")->setFocus();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QCOMPARE(QApplication::focusWidget(), link(0));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QCOMPARE(QApplication::focusWidget(), link(1));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backtab);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QCOMPARE(session().history()->count(), 1);
    QCOMPARE(session().history()->text(0), QStringLiteral("Move Fin to Body"));
    QCOMPARE(session().committed().sectionCount(), std::size_t(3));
    QTRY_VERIFY(!firstCheck().contains(QStringLiteral("Nothing touches")));

    session().history()->undo();
    QVERIFY(session().committed().document == loose);
    QTRY_VERIFY(firstCheck().contains(QStringLiteral("Nothing touches")) && link(1)->isVisible());
    QTest::mouseClick(link(1), Qt::LeftButton);
    QCOMPARE(session().history()->text(0), QStringLiteral("Delete Fin"));
    QCOMPARE(session().committed().sectionCount(), std::size_t(2));
    QTRY_VERIFY(firstCheck().startsWith(QStringLiteral("Good")));
}

// Wrong: one selects what is red and does not read what is wrong with it.
void TestDocks::propertiesSayWhatIsWrong()
{
    Document loose = withSection(cross(), polygonShape(rectangle(-20, 0, 20, 40)), side(120));
    loose = *renameSection(loose, loose.sections[2]->id, "Fin & <b>");
    session().reset(loose);
    QTRY_VERIFY(find<CheckRow>("checkRow0") &&
                firstCheck().contains(QStringLiteral("Nothing touches")));
    auto *problem = find<QLabel>("sectionProblem");
    QVERIFY(problem && !problem->isVisible());
    m_window->bench().select({session().committed().ref(2)});
    QTRY_VERIFY(problem->isVisible());
    QVERIFY2(problem->text().contains(QStringLiteral("<b>Nothing touches Fin &amp; &lt;b&gt;.")),
             qPrintable(problem->text()));
    m_window->bench().select({session().committed().ref(0)});
    QTRY_VERIFY(!problem->isVisible());
    m_window->bench().select({session().committed().ref(2)});
    QTRY_VERIFY(problem->isVisible());
    session().commit(QStringLiteral("Move"),
                     *moveSection(session().committed().document,
                                  session().committed().document.sections[2]->id, side(30)));
    QTRY_VERIFY(!problem->isVisible());
}

// Wrong: a badge lies on the view cube, or a problem has no words though there is room for them.
void TestDocks::badgesLeaveTheCubeFree()
{
    Document loose = withSection(roundabout(eggCrate(2, 2), 0),
                                 polygonShape(rectangle(-20, 0, 20, 40)), side(120));
    session().reset(moveAll(loose, {0, 5, 0}));
    auto *badges = m_window->findChild<QWidget *>(QStringLiteral("badges"));
    const auto badge = [&](int index) {
        return badges->findChild<Badge *>(QStringLiteral("badge%1").arg(index));
    };
    QTRY_VERIFY(badge(2) && badge(2)->isVisible() && badge(2)->severity() == Severity::Error);
    std::set<int> widths;
    for (int width = 1700; width >= 1024; width -= 25) {
        m_window->resize(width, 700);
        const QWidget *view = badges->parentWidget();
        const auto cube = cubeCentre({view->width(), view->height()});
        QVERIFY(cube);
        QTRY_VERIFY2(badges->geometry().right() < cube->x() - 0.5 * kCubeRoom,
                     QByteArray::number(width));
        for (int i = 0; i < 5; ++i)
            if (badge(i)->isVisible())
                QTRY_COMPARE(badge(i)->width(), badge(i)->sizeHint().width());
        widths.insert(badges->width());
    }
    QVERIFY2(widths.size() >= 2, QByteArray::number(int(widths.size())));
}

// Wrong: a person is told that it cannot be assembled and left to find out what helps, or cannot
// take back what did.
void TestDocks::slitsAreTurnedInOneStep()
{
    const Document locked = roundabout(eggCrate(2, 2), 0);
    session().reset(locked);
    QTRY_VERIFY(find<CheckRow>("checkRow0") &&
                firstCheck().contains(QStringLiteral("Sections block each other")));
    const auto link = [this] {
        return find<CheckRow>("checkRow0")
            ->findChild<QAbstractButton *>(QStringLiteral("checkLink0"));
    };
    QTRY_VERIFY(link() && link()->text() == QStringLiteral("Make assemblable"));
    QTest::mouseClick(link(), Qt::LeftButton);
    QCOMPARE(session().history()->count(), 1);
    QCOMPARE(session().history()->text(0), QStringLiteral("Make assemblable"));
    QCOMPARE(session().committed().document.jointOverrides.size(),
             locked.jointOverrides.size() - 1); // turned back, a joint is as it is by itself
    QTRY_VERIFY(!firstCheck().contains(QStringLiteral("Sections block each other")));
    session().history()->undo();
    QVERIFY(session().committed().document == locked);
    QTRY_VERIFY(firstCheck().contains(QStringLiteral("Sections block each other")));
}

// Wrong: a person who works with keys is at another check after they have mended one.
void TestDocks::theFocusStaysWithItsCheck()
{
    session().reset(roundabout(eggCrate(2, 2), 0));
    QTRY_VERIFY(find<CheckRow>("checkRow0") &&
                firstCheck().contains(QStringLiteral("Sections block each other")));
    find<CheckRow>("checkRow0")->setFocus();
    // The link is there once it is known what helps.
    QTRY_VERIFY(
        find<CheckRow>("checkRow0")->findChild<QAbstractButton *>(QStringLiteral("checkLink0")));
    QTest::keyClick(find<CheckRow>("checkRow0"), Qt::Key_Tab);
    QCOMPARE(QApplication::focusWidget()->accessibleName(), QStringLiteral("Make assemblable"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QCOMPARE(session().history()->count(), 1);
    const auto focused = []() -> QString {
        for (QWidget *at = QApplication::focusWidget(); at; at = at->parentWidget())
            if (auto *row = qobject_cast<CheckRow *>(at))
                return row->accessibleName();
        return {};
    };
    QTRY_VERIFY(!firstCheck().contains(QStringLiteral("Sections block each other")));
    QTRY_VERIFY2(focused().contains(QStringLiteral("Can be assembled")), qPrintable(focused()));
}

// Wrong: a hundred steps of the history for one drag, or slits that follow only at its end.
void TestDocks::draggingTheThicknessIsOneStep()
{
    session().reset(cross());
    find<QAction>("fabricate.stocks")->trigger();
    auto *slider = find<QWidget>("stockThickness")->findChild<QSlider *>();
    QTRY_VERIFY(slider->isVisible());
    const double before = session().committed().document.stocks.front()->thickness;
    const int steps = session().history()->index();

    const int y = slider->height() / 2;
    const auto at = [slider](double mm) {
        const double share =
            (mm / 0.05 - slider->minimum()) / (slider->maximum() - slider->minimum());
        return static_cast<int>(5 + share * (slider->width() - 10));
    };
    QTest::mousePress(slider, Qt::LeftButton, {}, {at(before), y});
    for (int x = at(before); x <= at(4.5); x += 3)
        QTest::mouseMove(slider, {x, y});
    QVERIFY(session().hasPreview());
    QCOMPARE(session().history()->index(), steps);
    const double shown = session().model().document.stocks.front()->thickness;
    QVERIFY(shown > before + 1.0);
    QVERIFY(std::abs(session().currentAnalysis().assembly.slits[0][0].width - shown) < 1e-9);
    QTest::mouseRelease(slider, Qt::LeftButton, {}, {at(4.5), y});
    QCOMPARE(session().history()->index(), steps + 1);
    const QString step = session().history()->text(steps);
    QVERIFY2(step.startsWith(QStringLiteral("Birch plywood: 3.0 → 4.")), qPrintable(step));
    QVERIFY(!session().hasPreview());
    session().history()->undo();
    QCOMPARE(session().committed().document.stocks.front()->thickness, before);
}

void TestDocks::escapeEndsADragWithoutAStep()
{
    session().reset(cross());
    find<QAction>("fabricate.stocks")->trigger();
    auto *slider = find<QWidget>("stockThickness")->findChild<QSlider *>();
    QTRY_VERIFY(slider->isVisible());
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Right);
    QVERIFY(session().hasPreview());
    QTest::keyClick(slider, Qt::Key_Escape);
    QVERIFY(!session().hasPreview());
    QCOMPARE(session().history()->index(), 0);
}

// Wrong: slits that stay square until something else changes, a tool that can be set to no end, or
// an end that is not one step.
void TestDocks::slitEndsFollowAtOnce()
{
    session().reset(cross());
    find<QAction>("fabricate.stocks")->trigger();
    auto *end = find<QComboBox>("stockSlitEnd");
    auto *tool = find<QWidget>("stockTool");
    QVERIFY(end && tool);
    QVERIFY(!tool->isEnabled());
    QVERIFY(tool->parentWidget()->toolTip().contains(QStringLiteral("square end has no tool")));
    const double before = session().currentAnalysis().cuts[0]->area();
    end->setCurrentIndex(static_cast<int>(SlitEnd::Dogbone));
    Q_EMIT end->activated(end->currentIndex());
    QVERIFY(tool->isEnabled());
    QCOMPARE(session().history()->count(), 1);
    QCOMPARE(session().committed().document.stocks.front()->slitEnd, SlitEnd::Dogbone);
    QVERIFY(session().currentAnalysis().cuts[0]->area() < before - 0.1);
    session().history()->undo();
    QVERIFY(!tool->isEnabled());
    QCOMPARE(end->currentIndex(), 0);
    QCOMPARE(session().currentAnalysis().cuts[0]->area(), before);
}

void TestDocks::slitNumbersAreTyped_data()
{
    QTest::addColumn<QString>("field");
    QTest::addColumn<double>("typed");
    QTest::addColumn<std::function<double(const Stock &)>>("kept");
    const auto row = [](const char *title, const char *field, double typed, double Stock::*kept) {
        QTest::newRow(title) << QString::fromLatin1(field) << typed
                             << std::function([kept](const Stock &stock) { return stock.*kept; });
    };
    row("the diameter of the tool", "stockTool", 2.5, &Stock::toolDiameter);
    row("the lead-in", "stockLeadIn", 1.5, &Stock::leadIn);
    row("the bumps", "stockBumps", 0.25, &Stock::bumps);
}

// Wrong: a field that changes nothing, the number of another field, or no slit.
void TestDocks::slitNumbersAreTyped()
{
    QFETCH(QString, field);
    QFETCH(double, typed);
    QFETCH(std::function<double(const Stock &)>, kept);
    Document document = cross();
    Stock milled = *document.stocks.front();
    milled.slitEnd = SlitEnd::Dogbone;
    session().reset(*setStock(std::move(document), milled));
    find<QAction>("fabricate.stocks")->trigger();
    auto *edit = m_window->findChild<QDoubleSpinBox *>(field);
    QVERIFY(edit && edit->isEnabled());
    QCOMPARE(edit->value(), kept(milled));
    const double before = session().currentAnalysis().cuts[0]->area();
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, QString::number(typed));
    QTest::keyClick(edit, Qt::Key_Return);
    QCOMPARE(kept(*session().committed().document.stocks.front()), typed);
    QCOMPARE(session().history()->count(), 1);
    QVERIFY(std::abs(session().currentAnalysis().cuts[0]->area() - before) > 1e-3);
    session().history()->undo();
    QCOMPARE(edit->value(), kept(milled));
}

// Wrong: the thickness of one stock given to another that is chosen before the slider has settled.
void TestDocks::aKeyOnTheSliderIsForTheStockThatIsShown()
{
    Document document = cross();
    Stock thick = *document.stocks.front();
    thick.name = "Thick";
    thick.thickness = 12.0;
    document = *addStock(std::move(document), thick);
    session().reset(document);
    find<QAction>("fabricate.stocks")->trigger();
    auto *list = find<QListWidget>("stockList");
    list->setCurrentRow(0);
    auto *slider = find<QWidget>("stockThickness")->findChild<QSlider *>();
    QTRY_VERIFY(slider->isVisible());
    const double before = session().committed().document.stocks.front()->thickness;
    QTest::keyClick(slider, Qt::Key_Right);
    list->setCurrentRow(1);
    QCOMPARE(session().history()->index(), 1);
    const auto &stocks = session().committed().document.stocks;
    QVERIFY(stocks.front()->thickness > before);
    QCOMPARE(stocks.back()->thickness, 12.0);
    QVERIFY(!session().hasPreview());
}

// Wrong: Undo takes back the step before, and what was set by a key comes after it as a new one.
void TestDocks::undoAfterAKeyOnTheSliderTakesItBack()
{
    session().reset(cross());
    session().commit(QStringLiteral("Rename"),
                     *renameSection(session().committed().document,
                                    session().committed().document.sections.front()->id, "Fin"));
    find<QAction>("fabricate.stocks")->trigger();
    auto *slider = find<QWidget>("stockThickness")->findChild<QSlider *>();
    QTRY_VERIFY(slider->isVisible());
    slider->window()->activateWindow();
    slider->setFocus();
    QTRY_COMPARE(QApplication::focusWidget(), slider);
    QTest::keyClick(slider, Qt::Key_Right);
    find<QAction>("edit.undo")->trigger();
    QCOMPARE(session().history()->index(), 1);
    QCOMPARE(session().history()->count(), 2);
    QCOMPARE(session().committed().document.sections.front()->name, std::string("Fin"));
    QVERIFY(!session().hasPreview());
}

// Wrong: what was typed for one section becomes the name of the one that is selected next.
void TestDocks::aNameIsForTheSectionItWasTypedAt()
{
    session().reset(cross());
    const Document document = session().committed().document;
    const SectionId first = document.sections[0]->id, second = document.sections[1]->id;
    const std::string kept = document.sections[1]->name;
    m_window->bench().select({SectionRef(first)});
    auto *name = find<QLineEdit>("propertiesName");
    name->setFocus();
    name->selectAll();
    QTest::keyClicks(name, QStringLiteral("Fin"));
    m_window->bench().select({SectionRef(second)});
    QTest::keyClick(name, Qt::Key_Return);
    QCOMPARE(session().committed().document.find(first)->name, std::string("Fin"));
    QCOMPARE(session().committed().document.find(second)->name, kept);
    QCOMPARE(name->text(), QString::fromStdString(kept));
    QCOMPARE(session().history()->index(), 1);
}

void TestDocks::aUsedStockIsReplaced()
{
    session().reset(cross());
    find<QAction>("fabricate.stocks")->trigger();
    auto *remove = find<QToolButton>("stockRemove");
    QVERIFY(!remove->isEnabled()); // the only one, and it says so
    QVERIFY(remove->toolTip().contains(QStringLiteral("another")));
    QTest::mouseClick(find<QToolButton>("stockCopy"), Qt::LeftButton);
    QCOMPARE(session().committed().document.stocks.size(), std::size_t(2));
    QVERIFY(remove->isEnabled());
    QVERIFY(!remove->menu()); // nothing is made of the copy
    QTest::mouseClick(remove, Qt::LeftButton);
    QCOMPARE(session().committed().document.stocks.size(), std::size_t(1));
    QCOMPARE(session().history()->index(), 2);
}

void TestDocks::lengthsFollowTheUnit()
{
    session().reset(cross());
    m_window->bench().select({session().model().ref(0)});
    auto *thickness = find<QDoubleSpinBox>("sectionThickness");
    QTRY_COMPARE(thickness->text(), QStringLiteral("3.00\u202fmm"));
    settings().setUnit(LengthUnit::Inch);
    QCOMPARE(thickness->text(), QStringLiteral("0.1181\u202fin"));
    QCOMPARE(find<QLabel>("statusSize")->text(), QStringLiteral("3.9 × 2.4 × 3.9\u202fin"));
    QCOMPARE(find<QToolButton>("statusUnits")->text(), QStringLiteral("in"));
    // A change of the unit is no change of the model; an eighth of an inch is.
    QCOMPARE(session().history()->index(), 0);
    thickness->setFocus();
    thickness->selectAll();
    QTest::keyClicks(thickness, QStringLiteral("1/8"));
    QTest::keyClick(thickness, Qt::Key_Return);
    QCOMPARE(session().committed().document.stocks.front()->thickness, 3.175);
}

// Wrong: "3*t" in the field that shows t, or a typing error that vanishes without a word.
void TestDocks::fieldsReckonWithTheThickness()
{
    session().reset(cross());
    m_window->bench().select({session().model().ref(0)});
    auto *x = find<QDoubleSpinBox>("positionX");
    QVERIFY(x);
    QTRY_VERIFY(x->isVisible());
    QSignalSpy refused(x, SIGNAL(refused(QString)));
    const auto type = [&](const char *text) {
        x->setFocus();
        x->selectAll();
        QTest::keyClicks(x, QString::fromUtf8(text));
        QTest::keyClick(x, Qt::Key_Return);
    };
    const auto position = [&] { return session().committed().section(0)->frame.origin.x(); };
    type("3*t");
    QVERIFY(std::abs(position() - 9.0) < 1e-9);
    type("1 in + 2 mm");
    QVERIFY(std::abs(position() - 27.4) < 1e-9);
    QCOMPARE(refused.count(), 0);
    const int steps = session().history()->index();
    type("3*kg");
    QCOMPARE(refused.count(), 1);
    QVERIFY(refused[0][0].toString().contains(QStringLiteral("kg")));
    QVERIFY(x->text().contains(QStringLiteral("kg"))); // to be mended
    type("99999999");
    QCOMPARE(refused.count(), 2);
    QVERIFY2(refused[1][0].toString().startsWith(QStringLiteral("At most")),
             qPrintable(refused[1][0].toString()));
    x->clearFocus();
    QCOMPARE(session().history()->index(), steps);
    QVERIFY2(x->text().startsWith(QStringLiteral("27.4")), qPrintable(x->text()));
}

// Wrong: a field that gives all sections the value of one when it is only passed by.
void TestDocks::fieldsOfSectionsThatDifferSayMixed()
{
    session().reset(twoSections(polygonShape(rectangle(-50, 0, 50, 60)), front(10),
                                polygonShape(rectangle(-50, 0, 50, 60)), side(20))
                        .document);
    m_window->bench().select({session().model().ref(0), session().model().ref(1)});
    auto *x = find<QDoubleSpinBox>("positionX");
    auto *edit = x->findChild<QLineEdit *>();
    QTRY_VERIFY(x->isVisible());
    QCOMPARE(edit->text(), QString());
    QCOMPARE(edit->placeholderText(), QStringLiteral("mixed"));
    settings().setUnit(LengthUnit::Inch);
    settings().setUnit(LengthUnit::Millimetre);
    QCOMPARE(edit->text(), QString());
    x->setFocus();
    QTest::keyClick(x, Qt::Key_Tab);
    QVERIFY(!x->hasFocus());
    QCOMPARE(session().history()->index(), 0);
    x->setFocus();
    QTest::keyClicks(x, QStringLiteral("7"));
    QTest::keyClick(x, Qt::Key_Return);
    QCOMPARE(session().history()->index(), 1);
    QCOMPARE(session().committed().section(0)->frame.origin.x(), 7.0);
    QCOMPARE(session().committed().section(1)->frame.origin.x(), 7.0);
}

void TestDocks::longSentencesAreCutShort()
{
    SentenceLabel label;
    label.setSentence(QStringLiteral("Drag out of <b>Body &amp; tail</b> to draw; <kbd>Esc</kbd>"));
    QCOMPARE(label.text(), QStringLiteral("Drag out of Body & tail to draw; Esc"));
    label.resize(600, 20);
    QVERIFY(!label.isCutShort());
    QVERIFY(label.toolTip().isEmpty());
    label.resize(60, 20);
    label.grab(); // resizes at once
    QVERIFY(label.isCutShort());
    QCOMPARE(label.toolTip(), label.text());
}

// Wrong: a tree of a thousand rows made anew for one name.
void TestDocks::anEditTouchesOneRowOfTheOutline()
{
    session().reset(plateComb(1000));
    auto *outline = m_window->findChild<OutlineDock *>();
    auto *tree = find<QTreeWidget>("outlineTree");
    QCOMPARE(tree->topLevelItem(0)->childCount(), 1000);
    const int before = outline->rowsTouched();
    const SectionId id = session().model().section(500)->id;
    session().commit(QStringLiteral("rename"),
                     *renameSection(session().committed().document, id, "Fin"));
    QCOMPARE(outline->rowsTouched(), before + 1);
    QCOMPARE(tree->topLevelItem(0)->child(499)->text(0), QStringLiteral("Fin"));
    session().commit(QStringLiteral("remove"),
                     *removeSections(session().committed().document, std::vector{id}));
    QCOMPARE(tree->topLevelItem(0)->childCount(), 999);
    session().history()->undo();
    QCOMPARE(outline->rowsTouched(), before + 2);
    QCOMPARE(tree->topLevelItem(0)->child(499)->text(0), QStringLiteral("Fin"));
}

void TestDocks::theFilterKeepsParents()
{
    Document document = plateComb(5);
    document = *renameSection(document, document.sections[3]->id, "Fin");
    session().reset(document);
    auto *tree = find<QTreeWidget>("outlineTree");
    QTest::keyClicks(find<QLineEdit>("outlineFilter"), QStringLiteral("fin"));
    QVERIFY(!tree->topLevelItem(0)->isHidden());
    QVERIFY(!tree->topLevelItem(0)->child(2)->isHidden());
    QVERIFY(tree->topLevelItem(0)->child(1)->isHidden());
}

void TestDocks::f6GoesRoundTheWindow()
{
    QStringList panes;
    const QStringList parts{QStringLiteral("mainToolBar"), QStringLiteral("outlineDock"),
                            QStringLiteral("checksDock"), QStringLiteral("propertiesDock")};
    session().reset(cross());
    QTRY_VERIFY(find<CheckRow>("checkRow0") && isSeen(find<CheckRow>("checkRow0")));
    for (int i = 0; i < 8; ++i) {
        QTest::keyClick(m_window.get(), Qt::Key_F6);
        for (QWidget *at = QApplication::focusWidget(); at; at = at->parentWidget()) {
            if (parts.contains(at->objectName()))
                panes += at->objectName();
        }
    }
    for (const QString &part : parts)
        QVERIFY2(panes.contains(part), qPrintable(panes.join(u' ')));
}

FFF_TEST_WITH(TestDocks, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setStyle(new FieldStyle);
    TestDocks test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_docks.moc"
