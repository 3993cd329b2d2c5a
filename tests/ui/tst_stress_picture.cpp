// Which line of the stresses is asked about, over the view and from the list beside it.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "core/session/scheduler.h"
#include "tests/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/field_style.h"
#include "ui/bench/stress_picture.h"

#include <QDockWidget>
#include <QPushButton>

#include <memory>

using namespace fff;
using namespace fff::ui;

class TestStressPicture : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();
    void aClickKeepsTheCard();
    void aDragDoesNot();
    void anEditClosesIt();
    void theListRingsAndOpens();
    void noLessIsShownThanIsAskedFor();
    void thePhysicsPageShowsThem();

private:
    Workbench &bench() { return m_window->bench(); }
    const StressMarks &marks() { return *m_picture->marks(); }
    /// Where the worst line is seen, px.
    QPointF worst()
    {
        const StressLine &line = marks().lines.back();
        const Vec2 at = bench().interaction().camera().toScreen(
            0.5 * (line.from + line.to) + line.half * line.normal, kSize);
        return {at.x(), at.y()};
    }
    void hoverWorst()
    {
        m_picture->hover(worst(), kSize);
        QVERIFY(marks().lit >= 0);
    }

    const Vec2 kSize{900.0, 700.0};
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
    std::unique_ptr<StressPicture> m_picture;
};

void TestStressPicture::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1400, 900);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    bench().session().commit(
        QStringLiteral("Open"),
        io::readDocument(QStringLiteral(FFF_SOURCES "/resources/samples/acrylic_thin_three.fff"))
            .value()
            .document);
    bench().session().scheduler().finish();
    bench().run(QStringLiteral("check.stress"), {{"on", "true"}});
    m_picture = std::make_unique<StressPicture>(bench());
    QVERIFY(m_picture->marks() && !marks().lines.empty());
    bench().run(QStringLiteral("view.fit"));
}

void TestStressPicture::cleanup()
{
    m_picture.reset();
    m_window.reset();
}

void TestStressPicture::aClickKeepsTheCard()
{
    hoverWorst();
    const int line = marks().lit;
    const QPointF at = worst();
    m_picture->press(at);
    m_picture->release(at);
    QVERIFY(m_picture->isKept() && marks().hasCard);
    QCOMPARE(marks().lit, line);
    m_picture->hover({1.0, 1.0}, kSize); // elsewhere
    m_picture->leave();
    QVERIFY(marks().hasCard && marks().lit == line);
    m_picture->press({1.0, 1.0});
    m_picture->release({1.0, 1.0});
    QVERIFY(!m_picture->isKept() && !marks().hasCard);
    QCOMPARE(marks().lit, -1);
}

// Wrong: whoever turns the view by a drag that begins on a line has a card in the way.
void TestStressPicture::aDragDoesNot()
{
    hoverWorst();
    m_picture->press(worst());
    QCOMPARE(marks().lit, -1); // out of the way meanwhile
    m_picture->release(worst() + QPointF(60.0, 20.0));
    QVERIFY(!m_picture->isKept());
    hoverWorst();
    m_picture->press(worst());
    m_picture->release(worst());
    m_picture->press({10.0, 10.0});
    m_picture->release({80.0, 10.0}); // the card may be looked at from elsewhere
    QVERIFY(m_picture->isKept());
    m_picture->close();
    QVERIFY(!m_picture->isKept());
}

// Wrong: a card of a line that is no longer there.
void TestStressPicture::anEditClosesIt()
{
    hoverWorst();
    m_picture->press(worst());
    m_picture->release(worst());
    Document document = bench().session().committed().document;
    document.loads.front().mass *= 1.5;
    bench().session().commit(QStringLiteral("More"), document);
    bench().session().scheduler().finish();
    QVERIFY(m_picture->marks());
    QVERIFY(!m_picture->isKept());
    QCOMPARE(marks().lit, -1);
}

void TestStressPicture::theListRingsAndOpens()
{
    auto *dock = m_window->findChild<QDockWidget *>(QStringLiteral("physicsDock"));
    dock->show();
    dock->raise();
    auto *row = m_window->findChild<QPushButton *>(QStringLiteral("weakPlace0"));
    QTRY_VERIFY(row->isVisible());
    QEnterEvent enter({3, 3}, {3, 3}, {3, 3});
    QApplication::sendEvent(row, &enter);
    QVERIFY(marks().lit >= 0 && !marks().hasCard);
    QCOMPARE(marks().lines[static_cast<std::size_t>(marks().lit)].use, marks().lines.back().use);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(row, &leave);
    QCOMPARE(marks().lit, -1);
    QTest::keyClick(row, Qt::Key_Return);
    QVERIFY(m_picture->isKept() && marks().hasCard);
}

void TestStressPicture::noLessIsShownThanIsAskedFor()
{
    const std::size_t usual = marks().lines.size();
    for (const int percent : {90, 0}) {
        settings().setStressShown(percent);
        for (const StressLine &line : marks().lines)
            QVERIFY(line.use >= 0.01 * percent);
        QCOMPARE(marks().least, 0.01 * percent);
        QVERIFY(percent == 0 ? marks().lines.size() > usual : marks().lines.size() < usual);
    }
}

// Wrong: a page about what bears how much, beside a model that shows nothing of it; a weak place
// buried by the handles of its section; lines that come back though somebody turned them off.
void TestStressPicture::thePhysicsPageShowsThem()
{
    const auto isShown = [&] { return bench().interaction().view().showsStress; };
    const auto turnOff = [&] {
        bench().run(QStringLiteral("check.stress"), {{"on", "false"}});
        QVERIFY(!isShown());
    };
    turnOff();
    auto *dock = m_window->findChild<QDockWidget *>(QStringLiteral("physicsDock"));
    dock->show();
    dock->raise();
    bench().session().scheduler().finish();
    turnOff();
    dock->hide();
    dock->show();
    dock->raise();
    auto *row = m_window->findChild<QPushButton *>(QStringLiteral("weakPlace0"));
    QTRY_VERIFY(row->isVisible());
    QVERIFY(!isShown());
    bench().select({bench().session().model().ref(0)});
    QTest::mouseClick(row, Qt::LeftButton);
    QVERIFY(isShown());
    QVERIFY(m_picture->isKept() && marks().hasCard);
    QVERIFY(bench().interaction().selection().empty());

    MainWindow other;
    other.show();
    const Document loaded = bench().session().committed().document;
    other.bench().session().commit(QStringLiteral("Open"), loaded);
    auto *page = other.findChild<QDockWidget *>(QStringLiteral("physicsDock"));
    page->show();
    page->raise();
    QTRY_VERIFY(other.bench().interaction().view().showsStress);
}

FFF_TEST_WITH(TestStressPicture, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setStyle(new FieldStyle);
    TestStressPicture test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_stress_picture.moc"
