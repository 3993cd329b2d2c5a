// The skin in the window: asked for, said how far it is, shown, and gone again.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/asked_skin.h"
#include "core/session/scheduler.h"
#include "tests/core/skin/discs.h"
#include "tests/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/bench/skin_picture.h"

#include <memory>

using namespace fff;
using namespace fff::ui;

class TestSkinPicture : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();
    void shownAndHidden();
    void theChipSaysIt();
    void followsEdits();
    void whereThereIsNone();
    void offStopsIt();
    void ofTheViewOnly();

private:
    Workbench &bench() { return m_window->bench(); }
    Scheduler &scheduler() { return bench().session().scheduler(); }
    QAbstractButton *chip()
    {
        return m_window->findChild<QAbstractButton *>(QStringLiteral("skinChip"));
    }
    bool isShown() { return SkinPicture(bench()).shown().has_value(); }
    void press()
    {
        bench().run(QStringLiteral("view.skin"));
        scheduler().finish();
    }
    void draw(const std::vector<SectionPointer> &sections)
    {
        Document document = newDocument();
        for (const SectionPointer &section : sections) {
            NewSection one;
            one.shape = section->shape;
            one.frame = section->frame;
            document = addSection(document, one).value();
        }
        bench().session().commit(QStringLiteral("draw"), document);
        scheduler().finish();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

void TestSkinPicture::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1400, 900);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    draw(test::sphere(40.0, {0.0}));
}

void TestSkinPicture::cleanup()
{
    m_window.reset();
}

void TestSkinPicture::shownAndHidden()
{
    auto *action = m_window->findChild<QAction *>(QStringLiteral("view.skin"));
    QVERIFY(action->isCheckable() && !action->isChecked());
    QVERIFY(!isShown()); // nobody asks
    press();
    QTRY_VERIFY(action->isChecked());
    QVERIFY(isShown());
    const SceneTemplate shown = *SkinPicture(bench()).shown();
    QVERIFY((shown.bounds.size() - Vec3(80.0, 80.0, 80.0)).cwiseAbs().maxCoeff() < 2.0);
    press();
    QTRY_VERIFY(!action->isChecked());
    QVERIFY(!isShown());
}

// Wrong: nobody knows why the view looks so, or how far it is.
void TestSkinPicture::theChipSaysIt()
{
    QVERIFY(chip());
    QVERIFY(chip()->isHidden());
    press();
    QTRY_COMPARE(chip()->text(), QStringLiteral("Skin"));
    QVERIFY(!chip()->isHidden());
    QVERIFY2(chip()->toolTip().startsWith(QStringLiteral("8 patches.")),
             qPrintable(chip()->toolTip()));
    chip()->click();
    QVERIFY(chip()->isHidden());
    QVERIFY(!scheduler().questions().skin);
}

void TestSkinPicture::followsEdits()
{
    press();
    draw(test::sphere(30.0, {0.0}));
    QVERIFY(SkinPicture(bench()).shown()->bounds.size().x() < 62.0);
}

void TestSkinPicture::whereThereIsNone()
{
    draw({test::disc(40.0, Vec3::UnitZ(), 0.0)});
    press();
    QVERIFY(!isShown());
    QTRY_COMPARE(chip()->text(), QStringLiteral("Skin: no contours cross"));
}

// Wrong: what nobody wants to see any more keeps the machine busy.
void TestSkinPicture::offStopsIt()
{
    std::atomic<bool> hasStopped{false};
    scheduler().setCompute(
        kSkin.name,
        [&hasStopped](const Snapshot &snapshot, const void *, Progress &progress,
                      std::stop_token stop) -> Result<std::shared_ptr<const void>> {
            if (!snapshot.get(kQuestions).skin)
                return std::make_shared<const AskedSkin>();
            progress.set(0.42);
            while (!stop.stop_requested())
                QThread::msleep(1);
            hasStopped = true;
            return failure(ErrorCode::Cancelled);
        });
    bench().run(QStringLiteral("view.skin"));
    QTRY_COMPARE(chip()->text(), QStringLiteral("Skin: working… 42\u202f%"));
    chip()->click();
    QTRY_VERIFY(hasStopped);
    scheduler().finish();
    QVERIFY(!scheduler().failureOf(kSkin.name));
    QVERIFY(chip()->isHidden());
}

// Wrong: a model is changed by looking at it.
void TestSkinPicture::ofTheViewOnly()
{
    const std::uint64_t revision = bench().session().revision();
    press();
    QCOMPARE(bench().session().revision(), revision);
}

FFF_TEST_WITH(TestSkinPicture, fff::testing::runWithin<TestSkinPicture, QApplication>)
#include "tst_skin_picture.moc"
