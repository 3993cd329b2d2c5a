// The slider that shows a model where it bends: what it says, and that it leaves nothing behind.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "core/session/scheduler.h"
#include "tests/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/field_style.h"

#include <QDockWidget>
#include <QLabel>
#include <QSlider>
#include <QToolButton>

#include <memory>

using namespace fff;
using namespace fff::ui;

class TestMovementRows : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { m_window.reset(); }
    void saysHowLargeItIs();
    void goneWithItsDock();
    void playsUnlessMotionIsReduced();

private:
    Workbench &bench() { return m_window->bench(); }
    QSlider *slider() { return m_window->findChild<QSlider *>(QStringLiteral("physicsMovement")); }
    QToolButton *play()
    {
        return m_window->findChild<QToolButton *>(QStringLiteral("physicsPlay"));
    }
    QString words()
    {
        return m_window->findChild<QLabel *>(QStringLiteral("physicsMovementWords"))->text();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

void TestMovementRows::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
    settings().setBendsSections(true);
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1400, 900);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    auto *dock = m_window->findChild<QDockWidget *>(QStringLiteral("physicsDock"));
    dock->show();
    dock->raise();
    bench().session().commit(
        QStringLiteral("Open"),
        io::readDocument(QStringLiteral(FFF_SOURCES "/resources/samples/acrylic_thick_three.fff"))
            .value()
            .document);
    bench().session().scheduler().finish();
    QTRY_VERIFY(slider()->isEnabled());
}

// Wrong: a picture that looks as if all of it were true.
void TestMovementRows::saysHowLargeItIs()
{
    const Document before = bench().session().committed().document;
    QVERIFY2(words().startsWith(QStringLiteral("Bends 3.6")), qPrintable(words()));
    QVERIFY(!words().contains(QStringLiteral("times")));
    slider()->setValue(slider()->maximum());
    QCOMPARE(bench().movement(), 1.0);
    QVERIFY2(words().contains(QStringLiteral("shown 5.3 times")), qPrintable(words()));
    slider()->setValue(slider()->maximum() / 2);
    QVERIFY2(words().contains(QStringLiteral("shown 2.6 times")), qPrintable(words()));
    QVERIFY(bench().session().committed().document.isSame(before));
}

// Wrong: a bent model, and nothing that says why.
void TestMovementRows::goneWithItsDock()
{
    slider()->setValue(40);
    QVERIFY(bench().movement() > 0.0);
    m_window->findChild<QDockWidget *>(QStringLiteral("physicsDock"))->hide();
    QCOMPARE(bench().movement(), 0.0);
}

void TestMovementRows::playsUnlessMotionIsReduced()
{
    settings().setMotion(Motion::Full);
    slider()->setValue(1);
    slider()->setValue(0);
    QVERIFY(play()->isEnabled());
    play()->click();
    QTRY_VERIFY(bench().movement() > 0.0);
    play()->click();
    settings().setMotion(Motion::Reduced);
    slider()->setValue(10);
    QVERIFY(!play()->isEnabled());
    slider()->setValue(0);
    QCOMPARE(bench().movement(), 0.0);
}

FFF_TEST_WITH(TestMovementRows, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setStyle(new FieldStyle);
    TestMovementRows test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_movement_rows.moc"
