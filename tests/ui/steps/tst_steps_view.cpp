// The steps of the assembly in a real window: the action, keys, bar, and the ways out.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/steps_tool.h"
#include "core/session/check_list.h"
#include "tests/core/assembly/known_models.h"
#include "tests/test_program.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_program.h"
#include "ui/base/sentence_label.h"
#include "ui/properties/stock_choice.h"
#include "ui/steps/steps_export.h"
#include "ui/steps/steps_view.h"
#include "ui/view/steps_scene.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QPointer>
#include <QSlider>
#include <QToolButton>
#include <QTreeView>
#include <QWheelEvent>

#include <functional>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

class TestStepsView : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { closeWindow(); }

    void theActionShowsThem();
    void keysGoThroughTheSteps();
    void arrowsGoThroughTheStepsFromTheBar();
    void theFocusStaysInTheBar();
    void theBarIsNotTheView();
    void theSliderGoesAnywhere();
    void theyArePlayed();
    void apartIsApart();
    void whatIsDrawnApartStaysInSight();
    void allOfItIsFitted();
    void whatIsDrawnApartFollowsTheWindow();
    void whatIsUnderTheBarComesIntoSight();
    void theViewIsTurnedAndNothingElse();
    void anEditLeavesThem();
    void anotherToolLeavesThem();
    void whatCannotBeAssembledSaysWhy();
    void nothingIsShownOfAnOlderPlan();
    void whoGoesOnIsNotDisturbed_data();
    void whoGoesOnIsNotDisturbed();
    void theViewMayBeTurnedMeanwhile();
    void theyAreExported();
    void paperHasTheUnitThatIsSet();
    void theNameAndTheFilterSayWhatIsWritten_data();
    void theNameAndTheFilterSayWhatIsWritten();

private:
    /// Asks for the steps of a model whose plan is not there yet.
    void waitForSteps();
    void finishPlan();
    void open(const Document &document);
    void showSteps();
    bool isAllInSight();
    StepsView &steps() { return *m_window->findChild<StepsView *>(); }
    QFrame *bar() { return m_window->findChild<QFrame *>(QStringLiteral("stepsBar")); }
    QString sentence()
    {
        return m_window->findChild<SentenceLabel *>(QStringLiteral("stepsSentence"))->text();
    }
    QString status()
    {
        return m_window->findChild<SentenceLabel *>(QStringLiteral("statusSentence"))->text();
    }
    QToolButton *button(const char *name)
    {
        return m_window->findChild<QToolButton *>(QLatin1String(name));
    }
    QSlider *slider(const char *name)
    {
        return m_window->findChild<QSlider *>(QLatin1String(name));
    }
    QPointer<QLineEdit> m_field;
    std::size_t shownParts() { return m_view->steps()->scene.sections.size(); }
};

void TestStepsView::init()
{
    openWindow();
    settings().setMotion(Motion::Reduced); // whole steps, at once
    open(combModel(3));
}

void TestStepsView::open(const Document &document)
{
    session().reset(document);
    finishPlan();
    bench().showAll("iso1");
    m_view->setFocus();
    QTRY_VERIFY(m_view->hasFocus());
}

void TestStepsView::finishPlan()
{
    session().currentAnalysis();
    m_window->findChild<CheckList *>()->finish();
}

void TestStepsView::waitForSteps()
{
    session().commit(QStringLiteral("Add"), combModel(5));
    actionOf(*m_window, "check.showAssembly")->trigger(); // before an event brings the plan
    QVERIFY(steps().isWaiting() && !steps().isOpen());
    QVERIFY(actionOf(*m_window, "check.showAssembly")->isChecked());
}

void TestStepsView::showSteps()
{
    key(Qt::Key_A);
    QVERIFY(steps().isOpen());
    QVERIFY(bar()->isVisible());
}

// Wrong: nobody sees that it is on, or the action does not say so.
void TestStepsView::theActionShowsThem()
{
    QVERIFY(!bar()->isVisible());
    showSteps();
    QVERIFY(actionOf(*m_window, "check.showAssembly")->isChecked());
    QCOMPARE(
        sentence(),
        QStringLiteral("Step 1 of 4: start with %1").arg(QString::fromStdString(first().name)));
    QCOMPARE(shownParts(), std::size_t(1));
    QVERIFY(m_view->rect().contains(bar()->geometry()));
    key(Qt::Key_Escape);
    QVERIFY(!steps().isOpen() && !bar()->isVisible() && !m_view->steps());
    QVERIFY(!actionOf(*m_window, "check.showAssembly")->isChecked());
    showSteps();
    key(Qt::Key_A);
    QVERIFY(!steps().isOpen());
    showSteps();
    QTest::mouseClick(m_window->findChild<QToolButton *>(QStringLiteral("stepsClose")),
                      Qt::LeftButton);
    QVERIFY(!steps().isOpen());
}

// Wrong: a key does what it does elsewhere (Home fits the view, End drops the model).
void TestStepsView::keysGoThroughTheSteps()
{
    showSteps();
    const Camera seen = interaction().camera();
    key(Qt::Key_Right);
    QCOMPARE(steps().time(), 2.0);
    QVERIFY(sentence().startsWith(QStringLiteral("Step 2 of 4: slide")));
    key(Qt::Key_Right);
    key(Qt::Key_Left);
    QCOMPARE(steps().time(), 2.0);
    key(Qt::Key_End);
    QCOMPARE(steps().time(), 4.0);
    QCOMPARE(shownParts(), std::size_t(4));
    key(Qt::Key_Right);
    QCOMPARE(steps().time(), 4.0);
    key(Qt::Key_Home);
    QCOMPARE(steps().time(), 0.0);
    QCOMPARE(shownParts(), std::size_t(0));
    QVERIFY(interaction().camera() == seen);
    QCOMPARE(this->ViewHand::steps(), 0); // of the history
}

// Wrong: Left and Right, which the tips name, go from button to button.
void TestStepsView::arrowsGoThroughTheStepsFromTheBar()
{
    showSteps();
    for (const char *name : {"stepsNext", "stepsPlay", "stepsExport"}) {
        QToolButton *focused = button(name);
        focused->setFocus();
        key(Qt::Key_Right);
        QCOMPARE(steps().time(), 2.0);
        QVERIFY(focused->hasFocus());
        key(Qt::Key_Left);
        QCOMPARE(steps().time(), 1.0);
        QVERIFY(focused->hasFocus());
    }
}

// Wrong: whoever goes to the last step with Space plays them all with the next one.
void TestStepsView::theFocusStaysInTheBar()
{
    showSteps();
    button("stepsNext")->setFocus();
    for (int step = 2; step <= 4; ++step)
        key(Qt::Key_Space);
    QCOMPARE(steps().time(), 4.0);
    QVERIFY(!button("stepsNext")->isEnabled());
    QVERIFY(button("stepsPrevious")->hasFocus());
    for (int step = 3; step >= 0; --step)
        key(Qt::Key_Space);
    QCOMPARE(steps().time(), 0.0);
    QVERIFY(button("stepsNext")->hasFocus());
}

// Wrong: what is done on the bar, beside its buttons, turns or zooms the view behind it.
void TestStepsView::theBarIsNotTheView()
{
    showSteps();
    key(Qt::Key_End);
    const Camera seen = interaction().camera();
    const QPoint sentence = bar()->pos() + QPoint(80, 20);
    const QPoint disabled = m_view->mapFromGlobal(button("stepsNext")->mapToGlobal(QPoint(14, 14)));
    for (const QPoint &on : {sentence, disabled})
        drag({on, on + QPoint(20, 0), on + QPoint(60, 0)});
    QVERIFY(interaction().camera() == seen);
    const double time = steps().time();
    const auto scroll = [this](QWidget *on) {
        const QPointF at = QRectF(on->rect()).center();
        QWheelEvent event(at, on->mapToGlobal(at), {}, {0, 240}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(on, &event);
    };
    m_view->setFocus();
    scroll(bar());
    scroll(slider("stepsTime"));
    scroll(slider("stepsApart"));
    QCoreApplication::processEvents();
    QVERIFY(interaction().camera() == seen);
    QCOMPARE(steps().time(), time);
    QCOMPARE(slider("stepsApart")->value(), 0);
    slider("stepsApart")->setFocus();
    scroll(slider("stepsApart"));
    QVERIFY(slider("stepsApart")->value() > 0);
}

// Wrong: a place on the slider is no place in the steps.
void TestStepsView::theSliderGoesAnywhere()
{
    showSteps();
    QSlider *time = slider("stepsTime");
    time->setValue((time->maximum() * 5) / 8);
    QCOMPARE(steps().time(), 2.5);
    QVERIFY(sentence().startsWith(QStringLiteral("Step 3 of 4")));
    const std::vector<SceneSection> &shown = m_view->steps()->scene.sections;
    QCOMPARE(std::count_if(shown.begin(), shown.end(),
                           [](const SceneSection &s) { return s.isSelected; }),
             1);
    QVERIFY(m_view->steps()->marks.way.size() >= 2);
    // The same place backwards shows the same.
    const std::vector<SceneSection> before = shown;
    time->setValue(time->maximum());
    time->setValue((time->maximum() * 5) / 8);
    QVERIFY(std::equal(before.begin(), before.end(), m_view->steps()->scene.sections.begin(),
                       [](const SceneSection &a, const SceneSection &b) {
                           return a.frame == b.frame && a.isSelected == b.isSelected;
                       }));
    time->setFocus();
    QTest::keyClick(time, Qt::Key_Escape);
    QVERIFY(!steps().isOpen());
}

// Wrong: it does not begin, does not stop, or frames go on for ever.
void TestStepsView::theyArePlayed()
{
    settings().setMotion(Motion::Full);
    open(chain(9));
    showSteps();
    QTRY_VERIFY_WITH_TIMEOUT(steps().time() > 0.1, 10000);
    // The first event of a window sets its clock; no step is left out for that.
    const double before = steps().time();
    bench().clock().observe(quint64(1) << 40);
    bench().advance();
    QVERIFY2(steps().time() < before + 1.0, qPrintable(QString::number(steps().time())));
    key(Qt::Key_Space);
    const double paused = steps().time();
    QVERIFY(paused < 9.0);
    QVERIFY2(!interaction().isAnimating(), qPrintable(QString::number(paused)));
    key(Qt::Key_Right);
    QTRY_COMPARE_WITH_TIMEOUT(steps().time(), std::floor(paused) + 1.0, 10000);
    QTRY_VERIFY(!interaction().isAnimating());
    // The picture at rest is drawn in full some time later, and then no more.
    const auto rests = [this] {
        const int painted = m_view->paintCount();
        QTest::qWait(300);
        return m_view->paintCount() == painted;
    };
    QTRY_VERIFY_WITH_TIMEOUT(rests(), 10000);
}

// Wrong: parts still cover each other.
void TestStepsView::apartIsApart()
{
    showSteps();
    key(Qt::Key_End);
    const auto framesNow = [this] {
        std::vector<Frame> frames;
        for (const SceneSection &section : m_view->steps()->scene.sections)
            frames.push_back(section.frame);
        return frames;
    };
    const std::vector<Frame> together = framesNow();
    slider("stepsApart")->setValue(100);
    QVERIFY(framesNow() != together);
    slider("stepsApart")->setValue(0);
    QVERIFY(framesNow() == together);
    slider("stepsApart")->setValue(60);
    key(Qt::Key_Escape);
    showSteps();
    QCOMPARE(slider("stepsApart")->value(), 0);
}

// Wrong: "Fit" cuts off what is drawn apart.
void TestStepsView::allOfItIsFitted()
{
    showSteps();
    key(Qt::Key_End);
    slider("stepsApart")->setValue(100);
    actionOf(*m_window, "view.fitAll")->trigger();
    for (const SceneSection &section : m_view->steps()->scene.sections) {
        for (const Vec2 &p : section.shape->region().outer) {
            const QPoint at = onScreen(section.frame.toWorld(p));
            QVERIFY(m_view->rect().contains(at));
            QVERIFY(at.y() < bar()->y());
        }
    }
}

bool TestStepsView::isAllInSight()
{
    bool all = true;
    for (const SceneSection &section : m_view->steps()->scene.sections)
        for (const Vec2 &p : section.shape->region().outer) {
            const QPoint at = onScreen(section.frame.toWorld(p));
            all = all && m_view->rect().contains(at) && at.y() < bar()->y();
        }
    return all;
}

// Wrong: half of what is drawn apart is beside the view; or who only looks at it has lost the view
// that was there before.
void TestStepsView::whatIsDrawnApartStaysInSight()
{
    showSteps();
    key(Qt::Key_End);
    QTRY_VERIFY(!interaction().isAnimating());
    const Camera before = interaction().targetCamera();
    slider("stepsApart")->setValue(100);
    QVERIFY(isAllInSight());
    QVERIFY(!(interaction().targetCamera() == before));
    slider("stepsApart")->setValue(40);
    QVERIFY(isAllInSight());
    slider("stepsApart")->setValue(0);
    QVERIFY(interaction().targetCamera() == before);
    // The hand's own view stays, as long as all is seen there.
    slider("stepsApart")->setValue(100);
    const Vec2 size = interaction().viewport();
    const Camera moved = panned(interaction().targetCamera(), Vec2(3.0, 2.0), Vec2::Zero(), size);
    bench().setCamera(moved);
    slider("stepsApart")->setValue(0);
    QVERIFY(interaction().targetCamera() == moved);
    bench().setCamera(before);
    slider("stepsApart")->setValue(100);
    QVERIFY(!(interaction().targetCamera() == before));
    key(Qt::Key_Escape);
    QVERIFY(interaction().targetCamera() == before);
}

// Wrong: a smaller window cut off what was drawn apart.
void TestStepsView::whatIsDrawnApartFollowsTheWindow()
{
    showSteps();
    key(Qt::Key_End);
    QTRY_VERIFY(!interaction().isAnimating());
    slider("stepsApart")->setValue(100);
    const QSize size = m_window->size();
    m_window->resize(size * 0.75);
    QTRY_VERIFY(!interaction().isAnimating() && isAllInSight());
    // Who looked closer goes on doing so.
    Camera closer = interaction().targetCamera();
    closer.millimetresPerPixel *= 0.25;
    bench().setCamera(closer);
    QTRY_VERIFY(!interaction().isAnimating());
    m_window->resize(size);
    QTest::qWait(50);
    QCOMPARE(interaction().targetCamera().millimetresPerPixel, closer.millimetresPerPixel);
}

// Wrong: the feet were under the bar, and it was to be guessed that F brings them above it.
void TestStepsView::whatIsUnderTheBarComesIntoSight()
{
    const Vec2 size = interaction().viewport();
    const Camera under =
        panned(interaction().camera(), Vec2(0.0, 0.4 * size.y()), Vec2::Zero(), size);
    bench().setCamera(under);
    showSteps();
    key(Qt::Key_End);
    QTRY_VERIFY(!interaction().isAnimating());
    QVERIFY(isAllInSight());
    const Camera seen = interaction().targetCamera();
    key(Qt::Key_Escape);
    QVERIFY(interaction().targetCamera() == under);
    // Where all is seen, nothing moves.
    bench().setCamera(seen);
    showSteps();
    QVERIFY(interaction().targetCamera() == seen);
}

void TestStepsView::theViewIsTurnedAndNothingElse()
{
    showSteps();
    key(Qt::Key_End);
    const Camera seen = interaction().camera();
    const QPoint on = onScreen(first().frame.toWorld(first().shape->centroid()));
    click(on);
    QVERIFY(interaction().selection().empty());
    drag({on, on + QPoint(40, 10), on + QPoint(90, 30)});
    QVERIFY(!(interaction().camera() == seen));
    QVERIFY(steps().isOpen());
    QCOMPARE(count(), std::size_t(4));
    QCOMPARE(this->ViewHand::steps(), 0);
}

// Wrong: steps are shown of a model that is another one by now.
void TestStepsView::anEditLeavesThem()
{
    showSteps();
    session().commit(QStringLiteral("Add"), combModel(4));
    QVERIFY(!steps().isOpen() && !m_view->steps());
    QCOMPARE(status(),
             QStringLiteral("The model has changed, so the view of its steps was closed."));
    finishPlan();
    showSteps();
    key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(!steps().isOpen());
    QCOMPARE(count(), std::size_t(4));
}

void TestStepsView::anotherToolLeavesThem()
{
    showSteps();
    key(Qt::Key_P);
    QVERIFY(!steps().isOpen() && !bar()->isVisible());
    QVERIFY(interaction().tool());
    showSteps();
    QVERIFY(interaction().tool()->command() == StepsTool::kCommand);
}

// Wrong: nothing happens, and nobody knows why.
void TestStepsView::whatCannotBeAssembledSaysWhy()
{
    open(triangle());
    key(Qt::Key_A);
    QVERIFY(!steps().isOpen());
    QVERIFY2(status().contains(QStringLiteral("cannot be assembled")), qPrintable(status()));
}

// Wrong: the steps are those of a model before.
void TestStepsView::nothingIsShownOfAnOlderPlan()
{
    waitForSteps();
    QVERIFY(status().startsWith(QStringLiteral("Working out the order")));
    finishPlan();
    QVERIFY(steps().isOpen());
    QCOMPARE(steps().steps()->playback.partCount(), 6);
    QVERIFY(actionOf(*m_window, "check.showAssembly")->isChecked());
    key(Qt::Key_Escape);
    QVERIFY(!actionOf(*m_window, "check.showAssembly")->isChecked());
}

void TestStepsView::whoGoesOnIsNotDisturbed_data()
{
    QTest::addColumn<std::function<void()>>("goOn");
    QTest::addColumn<QString>("said"); // begins so
    const auto row = [](const char *name, std::function<void()> goOn, const char *said) {
        QTest::newRow(name) << std::move(goOn) << QString::fromLatin1(said);
    };
    const char *const notShown = "The steps will not be shown.";
    row(
        "asking again", [this] { actionOf(*m_window, "check.showAssembly")->trigger(); }, notShown);
    row(
        "Esc", [this] { QTest::keyClick(m_view, Qt::Key_Escape); }, notShown);
    row(
        "Esc in a dock",
        [this] {
            auto *list = m_window->findChild<QTreeView *>(QStringLiteral("outlineTree"));
            QVERIFY(list);
            list->setFocus();
            QTest::keyClick(list, Qt::Key_Escape);
        },
        notShown);
    row(
        "an edit", [this] { session().commit(QStringLiteral("Add"), combModel(6)); },
        "The model has changed, so its steps are not shown.");
    row(
        "undo", [this] { session().history()->undo(); }, "The model has changed");
    row(
        "a tool", [this] { bench().run(QStringLiteral("section.pen")); }, notShown);
    row(
        "a stroke", [this] { press(onScreen(first().frame.toWorld(first().shape->centroid()))); },
        "");
    row(
        "typing",
        [this] {
            m_field = new QLineEdit(m_window.get());
            m_field->show();
            m_field->setFocus();
            QVERIFY(m_field->hasFocus());
        },
        "The order of assembly is known now");
}

// Wrong: points of the pen, a stroke, or the place in a field are lost to steps that nobody waits
// for any more.
void TestStepsView::whoGoesOnIsNotDisturbed()
{
    QFETCH(std::function<void()>, goOn);
    QFETCH(QString, said);
    waitForSteps();
    goOn();
    const Tool *held = interaction().tool();
    const bool hadGesture = interaction().hasGesture();
    finishPlan();
    QVERIFY(!steps().isOpen() && !steps().isWaiting());
    QVERIFY(!actionOf(*m_window, "check.showAssembly")->isChecked());
    QCOMPARE(interaction().tool(), held);
    QCOMPARE(interaction().hasGesture(), hadGesture);
    QVERIFY(!m_field || m_field->hasFocus());
    QVERIFY2(status().startsWith(said), qPrintable(status()));
}

// Wrong: the view jumps back under the hand that turns it, or the steps are forgotten over it.
void TestStepsView::theViewMayBeTurnedMeanwhile()
{
    waitForSteps();
    const QPoint beside(40, m_view->height() / 2);
    const Camera before = interaction().camera();
    press(beside);
    move(beside + QPoint(30, 0));
    move(beside + QPoint(60, 0));
    finishPlan();
    QVERIFY(!steps().isOpen() && steps().isWaiting());
    release(beside + QPoint(60, 0));
    QVERIFY(steps().isOpen());
    QVERIFY(!(interaction().camera() == before));
}

void TestStepsView::theyAreExported()
{
    showSteps();
    const QString folder = m_folder->path();
    auto *exporting = m_window->findChild<StepsExport *>();
    const StepsExport::Subject subject{steps().steps(), interaction().camera(),
                                       QStringLiteral("Comb of three")};
    QVERIFY(exporting->write(subject, folder + QStringLiteral("/comb.pdf")));
    QFile pdf(folder + QStringLiteral("/comb.pdf"));
    QVERIFY(pdf.open(QIODevice::ReadOnly));
    const QByteArray bytes = pdf.readAll();
    QVERIFY(bytes.startsWith("%PDF-"));
    // Its title is the model's, whatever the file is called; PDF has it in UTF-16.
    const QString title = QStringLiteral("Comb of three");
    QByteArray inPdf;
    for (const QChar c : title)
        inPdf += QByteArray(1, '\0') + c.toLatin1();
    QVERIFY(bytes.contains(inPdf));
    QCOMPARE(status(), QStringLiteral("Exported 4 steps to comb.pdf."));
    QVERIFY(exporting->write(subject, folder + QStringLiteral("/comb.html")));
    QFile page(folder + QStringLiteral("/comb.html"));
    QVERIFY(page.open(QIODevice::ReadOnly));
    const QByteArray html = page.readAll();
    QVERIFY(html.contains("<title>Comb of three</title>"));
    QCOMPARE(html.count("<img "), 4);
    QCOMPARE(status(), QStringLiteral("Exported 4 steps to comb.html."));
    const QString pictures = folder + QStringLiteral("/comb.png");
    QVERIFY(exporting->write(subject, pictures));
    QVERIFY(QFile::exists(folder + QStringLiteral("/comb-04.png")));
    int asked = 0;
    answer(QStringLiteral("Cancel"), &asked);
    QVERIFY(!exporting->write(subject, pictures));
    QCOMPARE(asked, 1);
    QVERIFY(!exporting->write(subject, folder + QStringLiteral("/none/comb.pdf")));
    QVERIFY(messagesOf(*m_window)->isVisible());
    QVERIFY(steps().isOpen());
    // The button asks for a file, named as the model.
    QString suggested;
    whenShown<QFileDialog>("stepsExportDialog", [&suggested](QFileDialog *dialog) {
        suggested = QFileInfo(dialog->selectedFiles().value(0)).suffix();
    });
    QTest::mouseClick(m_window->findChild<QToolButton *>(QStringLiteral("stepsExport")),
                      Qt::LeftButton);
    QCOMPARE(suggested, QStringLiteral("pdf"));
}

// Wrong: the window says inches and names stocks in its language, and the paper does neither.
void TestStepsView::paperHasTheUnitThatIsSet()
{
    showSteps();
    settings().setUnit(LengthUnit::Inch);
    Stock stock = *session().committed().document.stocks.front();
    stock.name = "MDF 2"; // of a preset, which has a name in each language
    const StepsExport::Subject subject{steps().steps(), interaction().camera(), {}};
    const StepsPaper::Options paper =
        m_window->findChild<StepsExport *>()->optionsFor(subject, QStringLiteral("a.pdf")).paper;
    QCOMPARE(StepsPaper::stockText(stock, paper),
             QStringLiteral("%1, 0.1181\u202fin").arg(stockName(stock)));
    QVERIFY(paper.stockName);
}

void TestStepsView::theNameAndTheFilterSayWhatIsWritten_data()
{
    QTest::addColumn<QString>("filter"); // how it ends
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("there"); // before
    QTest::addColumn<int>("questions"); // of the dialog or our own
    QTest::addColumn<QStringList>("written");
    const QStringList pictures{QStringLiteral("a-01.png"), QStringLiteral("a-02.png"),
                               QStringLiteral("a-03.png"), QStringLiteral("a-04.png")};
    const QStringList second{QStringLiteral("a.v2-01.png"), QStringLiteral("a.v2-02.png"),
                             QStringLiteral("a.v2-03.png"), QStringLiteral("a.v2-04.png")};
    const auto row = [](const char *name, const char *filter, const char *typed, const char *there,
                        int questions, const QStringList &written) {
        QTest::newRow(name) << QString::fromLatin1(filter) << QString::fromLatin1(typed)
                            << QString::fromLatin1(there) << questions << written;
    };
    row("a name gets the suffix of the paper", "pdf", "a", "", 0, {QStringLiteral("a.pdf")});
    row("a name gets the suffix of the pictures", "png", "a", "", 0, pictures);
    row("a dot in a name is no suffix on paper", "pdf", "a.v2", "", 0,
        {QStringLiteral("a.v2.pdf")});
    row("a dot in a name is no suffix of pictures", "png", "a.v2", "", 0, second);
    row("a name gets the suffix of the page", "html", "a", "", 0, {QStringLiteral("a.html")});
    row("a page that is there is asked about", "html", "a", "a.html", 1, {});
    row("a page is written whatever the filter", "png", "a.html", "", 0,
        {QStringLiteral("a.html")});
    row("a suffix that is typed is meant", "pdf", "a.png", "", 0, pictures);
    row("a PDF that is there is asked about", "pdf", "a.pdf", "a.pdf", 1, {});
    row("a PDF that is there is asked about with the other filter", "png", "a.pdf", "a.pdf", 1, {});
    row("a PDF that gets its suffix later is asked about", "pdf", "a.v2", "a.v2.pdf", 1, {});
    row("a picture that is there is asked about", "png", "a.png", "a-02.png", 1, {});
    row("a picture that none is called like is not asked about", "png", "a.png", "a.png", 0,
        pictures);
}

// Wrong: what lies there is lost without a question, or one kind of file has the other one's name.
void TestStepsView::theNameAndTheFilterSayWhatIsWritten()
{
    QFETCH(QString, filter);
    QFETCH(QString, typed);
    QFETCH(QString, there);
    QFETCH(int, questions);
    QFETCH(QStringList, written);
    showSteps();
    const QString folder = m_folder->filePath(QStringLiteral("out"));
    QVERIFY(QDir().mkpath(folder));
    if (!there.isEmpty())
        QVERIFY(io::writeFile(folder + u'/' + there, "mine"));
    int asked = 0;
    whenShown<QFileDialog>("stepsExportDialog", [&](QFileDialog *dialog) {
        auto *kinds = dialog->findChild<QComboBox *>(QStringLiteral("fileTypeCombo"));
        kinds->setFocus();
        QTest::keyClick(kinds, Qt::Key_Home);
        while (!kinds->currentText().contains(filter) && kinds->currentIndex() + 1 < kinds->count())
            QTest::keyClick(kinds, Qt::Key_Down);
        dialog->findChild<QLineEdit *>(QStringLiteral("fileNameEdit"))->setText(typed);
        dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Save)->click();
    });
    QTimer no;
    connect(&no, &QTimer::timeout, this, [&asked] {
        if (auto *question = qobject_cast<QMessageBox *>(QApplication::activeModalWidget())) {
            ++asked;
            question->reject();
        }
    });
    no.start(20);
    const bool wasWritten = m_window->findChild<StepsExport *>()->ask(
        {steps().steps(), interaction().camera(), QStringLiteral("Comb")},
        folder + QStringLiteral("/comb"));
    no.stop();
    QCOMPARE(asked, questions);
    QCOMPARE(wasWritten, !written.isEmpty());
    QStringList now = QDir(folder).entryList(QDir::Files, QDir::Name);
    if (!there.isEmpty()) {
        QCOMPARE(io::readFile(folder + u'/' + there).value(), std::string("mine"));
        now.removeOne(there);
    }
    QCOMPARE(now, written);
}

FFF_TEST_WITH(TestStepsView, runInWindowProgram<TestStepsView>)
#include "tst_steps_view.moc"
