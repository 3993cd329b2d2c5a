// The tour by real events: it waits for what a person does, in any hurry, and is gone when it is
// not wanted. If this fails, the first three minutes end in a card that does not go on.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/model/edits.h"
#include "core/session/check_list.h"
#include "tests/test_program.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_program.h"
#include "tests/ui/work_folder.h"
#include "ui/bench/first_sections.h"
#include "ui/files/document_files.h"
#include "ui/start/start_page.h"
#include "ui/tour/tour_card.h"
#include "ui/tour/tour_hint.h"
#include "ui/window/windows.h"

#include <QAction>
#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QToolBar>
#include <QToolButton>
#include <QUndoStack>

using namespace fff;
using namespace fff::ui;

class TestTour : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init() { openWindow(); }
    void cleanup()
    {
        settings().setSimpleWindow(false);
        closeWindow();
    }

    void aWholeModel();
    void everyStepCanBeSkipped();
    void undoneIsAskedForAgain();
    void aSlipIsNoBody();
    void oneSectionAloneIsNotWrong();
    void whatTurnsByItselfIsNobodysHand();
    void theStartPageOffersIt();
    void itEndsWithTheModel();
    void theSimpleWindowHasNoOperations();
    void theHintLeavesTheBodyUpwards();
    void theHintKeepsOffTheCard();
    void theHintTakesNoClickAndRests();

private:
    TourCard *card() const { return m_view->findChild<TourCard *>(); }
    TourHint *hint() const { return m_window->findChild<TourHint *>(); }
    QString said() const
    {
        return card()->findChild<QLabel *>(QStringLiteral("tourWords"))->text();
    }
    bool asks(const char *words) const
    {
        return card()->isVisible() && said().contains(QLatin1String(words));
    }
    template <class Button>
    void clickOn(const char *name)
    {
        auto *button = card()->findChild<Button *>(QLatin1String(name));
        QVERIFY(button && button->isVisible());
        QTest::mouseClick(button, Qt::LeftButton);
    }
    void begin() { m_window->findChild<QAction *>(QStringLiteral("help.tour"))->trigger(); }
    void skipTo(const char *words)
    {
        for (int i = 0; i < 7 && !asks(words); ++i)
            clickOn<QPushButton>("tourSkip");
        QVERIFY(asks(words));
    }
    void setThickness(double mm)
    {
        Stock stock = *session().committed().document.stocks.front();
        stock.thickness = mm;
        bench().commit(QStringLiteral("thickness"),
                       setStock(session().committed().document, stock));
    }
    QPoint middleOf(std::size_t section) const
    {
        const Section &it = *session().committed().section(section);
        return onScreen(worldBounds(*it.shape, it.frame).center());
    }
};

// Wrong: in the least window the pointer draws over the words that say what it does.
void TestTour::theHintKeepsOffTheCard()
{
    closeWindow();
    openWindow({1024, 640});
    begin();
    QTRY_VERIFY(hint()->isVisible());
    constexpr int kAround = 26; // px of the hint that are only room for the pointer
    const int way = hint()->geometry().top() + kAround;
    const int words = card()->mapTo(m_window.get(), card()->rect().bottomLeft()).y();
    QVERIFY2(way > words, qPrintable(QStringLiteral("%1, %2").arg(way).arg(words)));
}

void TestTour::aWholeModel()
{
    QVERIFY(card()->isHidden());
    begin();
    QVERIFY(asks("Draw a body"));
    QTRY_VERIFY(hint()->isVisible());
    drawFirst(); // through the hint that lies there
    QTRY_VERIFY(asks("across it"));
    drawSecond();
    QTRY_VERIFY(asks("Look around"));
    QTRY_VERIFY(!interaction().isAnimating());
    QVERIFY(asks("Look around")); // the view has turned back by itself
    const QPoint beside(40, m_view->height() - 60);
    drag({beside, beside + QPoint(60, 0), beside + QPoint(140, -10), beside + QPoint(220, -20)});
    QTRY_VERIFY(asks("Measure your sheet"));
    QTRY_VERIFY(hint()->isVisible());
    const auto *stock = m_window->findChild<QWidget *>(QStringLiteral("toolStock"));
    QVERIFY(
        hint()->geometry().contains(QRect(stock->mapTo(m_window.get(), QPoint()), stock->size())));
    setThickness(2.7);
    QTRY_VERIFY(asks("Will it work"));
    auto *badge = m_window->findChild<QAbstractButton *>(QStringLiteral("badge0"));
    QTRY_VERIFY(badge->isVisible());
    QTest::mouseClick(badge, Qt::LeftButton);
    QTRY_VERIFY(asks("Repeat it"));
    m_window->findChild<QAction *>(QStringLiteral("operation.linear"))->trigger();
    QVERIFY(interaction().tool());
    QTRY_VERIFY(hint()->isHidden()); // the tool has words of its own
    click(middleOf(1) + QPoint(0, -20));
    click(middleOf(0) + QPoint(120, 0));
    QTRY_VERIFY(count() > 2);
    QTRY_VERIFY(asks("Export")); // of a row that comes too far, what is to be done first
    workIn(m_folder->path());
    auto *enter = new QTimer(qApp);
    connect(enter, &QTimer::timeout, enter, [enter] {
        QWidget *dialog = QApplication::activeModalWidget();
        if (!dialog || dialog->objectName() != QStringLiteral("exportDialog"))
            return;
        auto *now = dialog->findChild<QPushButton *>(QStringLiteral("exportNow"));
        if (!now->isEnabled())
            return;
        enter->deleteLater();
        QTest::keyClick(now, Qt::Key_Return);
    });
    enter->start(20);
    m_window->findChild<QAction *>(QStringLiteral("file.export"))->trigger();
    QTRY_VERIFY(asks("all of the way"));
    QVERIFY(!card()->findChild<QPushButton *>(QStringLiteral("tourSkip"))->isVisible());
    QTRY_VERIFY(hint()->isHidden());
    setThickness(3.0); // goes on: nothing is in the way
    QTRY_VERIFY(card()->isHidden());
}

void TestTour::everyStepCanBeSkipped()
{
    begin();
    drawFirst();
    QStringList steps;
    for (int i = 0; i < 6; ++i) {
        steps += said();
        clickOn<QPushButton>("tourSkip");
    }
    QVERIFY(asks("ends here")); // and not what nobody did
    QVERIFY(!asks("all of the way"));
    QCOMPARE(steps.removeDuplicates(), 0);
    clickOn<QToolButton>("tourEnd");
    QVERIFY(card()->isHidden());
    begin(); // and it can be had again: in another window, as here is a model
    QCOMPARE(mainWindows().size(), 2);
    for (MainWindow *window : mainWindows())
        if (window != m_window.get()) {
            QVERIFY(window->findChild<TourCard *>()->isVisible());
            window->closeUnasked();
        }
}

// Wrong: "draw a section across it" beside an empty view.
void TestTour::undoneIsAskedForAgain()
{
    begin();
    drawFirst();
    QTRY_VERIFY(asks("across it"));
    session().history()->undo();
    QTRY_VERIFY(asks("Draw a body"));
    session().history()->redo();
    QTRY_VERIFY(asks("across it"));
    // Who only reads goes on all the same.
    session().history()->undo();
    QTRY_VERIFY(asks("Draw a body"));
    clickOn<QPushButton>("tourSkip");
    QVERIFY(asks("Look around"));
}

// Wrong: a slip of 12 mm is a body, and nothing can be drawn across it.
void TestTour::aSlipIsNoBody()
{
    const auto draw = [this](double side, std::optional<Parent> parent = {}) {
        NewSection section;
        section.shape = *Shape::make(
            *Contour::fromPolygon({{0, 0}, {side, 0}, {side, 0.5 * side}, {0, 0.5 * side}}));
        section.parent = parent;
        bench().commit(QStringLiteral("draw"), addSection(session().committed().document, section));
    };
    begin();
    draw(12.0);
    QTRY_VERIFY(asks("very small"));
    session().history()->undo();
    QTRY_VERIFY(asks("Draw a body"));
    draw(12.0); // whoever leaves it there has his body beside it
    draw(80.0);
    QTRY_VERIFY(asks("across it"));
    session().history()->undo();
    session().history()->undo();
    draw(80.0);
    QTRY_VERIFY(asks("across it"));
    draw(80.0); // beside it is not across it
    QVERIFY(asks("across it"));
    const Parent body{session().committed().ref(0), {20, 20}, {20, 50}};
    draw(12.0, body);
    QTRY_VERIFY(asks("very small"));
    draw(60.0, body);
    QTRY_VERIFY(asks("Look around"));
}

// Wrong: "Falls at a touch" beside "Now draw a section across it".
void TestTour::oneSectionAloneIsNotWrong()
{
    begin();
    drawFirst();
    QTRY_VERIFY(asks("across it"));
    m_window->findChild<QAction *>(QStringLiteral("section.dropToGround"))->trigger();
    setThickness(0.5); // of card it falls at a touch
    auto *first = m_window->findChild<FirstSections *>();
    auto *list = m_window->findChild<CheckList *>();
    const auto hasError = [&] {
        list->finish();
        return std::any_of(list->all().begin(), list->all().end(), [](const Finding &finding) {
            return finding.severity == Severity::Error;
        });
    };
    first->leaveAlone();
    QVERIFY(!hasError());
    clickOn<QToolButton>("tourEnd");
    first->leaveAlone();
    QVERIFY(hasError());
}

void TestTour::whatTurnsByItselfIsNobodysHand()
{
    begin();
    drawFirst();
    skipTo("Look around");
    bench().run(QStringLiteral("view.top"));
    QTRY_VERIFY(!interaction().isAnimating());
    QTest::qWait(50);
    QVERIFY(asks("Look around"));
}

void TestTour::theStartPageOffersIt()
{
    m_window->showStartPage();
    auto *offer = m_window->findChild<QPushButton *>(QStringLiteral("startTour"));
    QVERIFY(offer && offer->isVisible());
    QTest::mouseClick(offer, Qt::LeftButton);
    QTRY_VERIFY(m_view->isVisible());
    QVERIFY(asks("Draw a body"));
    QVERIFY(m_view->hasFocus());
    QCOMPARE(mainWindows().size(), 1); // it was empty
}

void TestTour::itEndsWithTheModel()
{
    begin();
    drawFirst();
    QVERIFY(m_window->files().saveFile(m_folder->filePath(QStringLiteral("a.fff"))));
    QVERIFY(card()->isVisible());
    session().reset(Document());
    QVERIFY(card()->isHidden());
    QTRY_VERIFY(hint()->isHidden());
}

void TestTour::theSimpleWindowHasNoOperations()
{
    settings().setSimpleWindow(true);
    QTRY_VERIFY(!m_window->findChild<QAction *>(QStringLiteral("operation.linear"))->isVisible());
    QTest::qWait(50); // other panels, another view
    begin();
    drawFirst();
    QStringList steps;
    while (!asks("ends here") && steps.size() < 8) {
        steps += said();
        clickOn<QPushButton>("tourSkip");
    }
    QCOMPARE(steps.size(), 5); // the first is done
    QVERIFY(steps.filter(QStringLiteral("Linear")).isEmpty());
}

// Wrong: of a body with long straight edges it goes down, into the ground.
void TestTour::theHintLeavesTheBodyUpwards()
{
    begin();
    NewSection body;
    body.name = "Body";
    body.shape = *Shape::make(*Contour::fromPolygon({{-60, 0}, {60, 0}, {60, 40}, {-60, 40}}));
    bench().commit(QStringLiteral("draw"), addSection(session().committed().document, body));
    QTRY_VERIFY(asks("across it"));
    QTRY_VERIFY(hint()->isVisible());
    const int top = m_view->mapTo(m_window.get(), onScreen({0, 40, 0})).y();
    const int bottom = m_view->mapTo(m_window.get(), onScreen({0, 0, 0})).y();
    QTRY_VERIFY(hint()->geometry().top() < top && hint()->geometry().bottom() < bottom);
}

void TestTour::theHintTakesNoClickAndRests()
{
    settings().setMotion(Motion::Reduced);
    begin();
    QTRY_VERIFY(hint()->isVisible());
    const QImage one = hint()->grab().toImage();
    QTest::qWait(120);
    QCOMPARE(hint()->grab().toImage(), one); // little motion: none
    const QPoint at = hint()->mapTo(m_window.get(), hint()->rect().center());
    QVERIFY(m_window->childAt(at) != hint());
    press(middle());
    for (int i = 0; i < 5; ++i)
        move(middle() + QPoint(20 * i, 10 * i));
    QTRY_VERIFY(hint()->isHidden()); // somebody is at it
    release(middle() + QPoint(80, 40));
    settings().setMotion(Motion::System);
}

FFF_TEST_WITH(TestTour, runInWindowProgram<TestTour>)
#include "tst_tour.moc"
