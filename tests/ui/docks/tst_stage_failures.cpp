#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/analysed.h"
#include "core/analysis/planned.h"
#include "core/analysis/verdicts.h"
#include "core/model/edits.h"
#include "core/session/scheduler.h"
#include "core/session/session.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"
#include "ui/base/field_style.h"
#include "ui/base/message_bar.h"
#include "ui/bench/workbench.h"
#include "ui/docks/check_row.h"
#include "ui/files/exporting.h"
#include "ui/settings/settings.h"
#include "ui/steps/steps_view.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QDir>
#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>

#include <atomic>
#include <memory>
#include <thread>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

/// A stage fails, throws, takes for ever or is stopped in a running window: always a sentence,
/// once, and never a wheel that turns on.
class TestStageFailures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void eachWayIsSaid_data();
    void eachWayIsSaid();
    void whatTakesForEverCanBeStopped();
    void theModelIsSetAside();
    void whatStandsOnAFailureIsOlder();
    void whoWaitsForItIsTold();
    void whatIsNotThereYetIsNoOlder();

private:
    using Compute = decltype(Stage::compute);

    Session &session() { return m_window->bench().session(); }
    Scheduler &scheduler() { return session().scheduler(); }
    void edit()
    {
        session().commit(QStringLiteral("Edit"), moveAll(session().model().document, {0, 0, 1}));
    }
    static Document moveAll(Document document, const Vec3 &by)
    {
        for (const SectionPointer &section : std::vector(document.sections)) {
            Frame frame = section->frame;
            frame.origin += by;
            document = *moveSection(document, section->id, frame);
        }
        return document;
    }
    /// Rows that say that something could not be worked out, or was stopped.
    std::vector<CheckRow *> failures()
    {
        std::vector<CheckRow *> rows;
        for (CheckRow *row : m_window->findChildren<CheckRow *>()) {
            const QString said = row->accessibleName();
            if (!row->isHidden() && (said.contains(QStringLiteral("Could not be worked out")) ||
                                     said.contains(QStringLiteral("Stopped"))))
                rows.push_back(row);
        }
        return rows;
    }
    bool isQuiet()
    {
        return m_window->findChild<QLabel *>(QStringLiteral("checksFooter"))
            ->parentWidget()
            ->isHidden();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

void TestStageFailures::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
    qputenv("XDG_DATA_HOME", QFile::encodeName(m_folder->path()));
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1280, 800);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    session().reset(
        withSection(withSection(newDocument(), polygonShape(rectangle(-50, 0, 50, 60)), front()),
                    polygonShape(rectangle(-50, 0, 50, 60)), side()));
    scheduler().finish();
    QTRY_VERIFY(isQuiet());
}

void TestStageFailures::cleanup()
{
    session().setClean();
    m_window.reset();
    m_folder.reset();
}

void TestStageFailures::eachWayIsSaid_data()
{
    QTest::addColumn<QString>("stage");
    QTest::addColumn<int>("way");
    for (const std::string_view stage :
         {kAnalysed.name, kVerdicts.name, kPlanned.name, kFlips.name})
        for (int way = 0; way < 4; ++way)
            QTest::addRow("%s, way %d", stage.data(), way)
                << QString::fromLatin1(stage.data()) << way;
}

void TestStageFailures::eachWayIsSaid()
{
    QFETCH(QString, stage);
    QFETCH(int, way);
    const std::string name = stage.toStdString();
    Compute proper;
    for (const Stage &known : scheduler().stages())
        if (name == known.name)
            proper = known.compute;
    scheduler().setCompute(name,
                           [way](const Snapshot &, const void *, Progress &,
                                 std::stop_token stop) -> Result<std::shared_ptr<const void>> {
                               switch (way) {
                               case 0:
                                   return failure(ErrorCode::NotSolid, {}, {"Rib 3"});
                               case 1:
                                   throw std::runtime_error("out of luck");
                               case 2:
                                   throw 7;
                               default:
                                   while (!stop.stop_requested())
                                       std::this_thread::yield();
                                   return failure(ErrorCode::Cancelled);
                               }
                           });
    edit();
    if (way == 3) {
        QTRY_VERIFY(scheduler().isRunning(name));
        scheduler().cancel(name);
    }
    QTRY_COMPARE(failures().size(), std::size_t(1));
    const QString said =
        failures().front()->accessibleName() + failures().front()->accessibleDescription();
    QVERIFY2(!said.contains(QLatin1Char('%')), qPrintable(said));
    scheduler().finish();
    QVERIFY(m_window->findChild<QToolButton *>(QStringLiteral("checksStop"))->isHidden());
    QCOMPARE(failures().size(), std::size_t(1));

    scheduler().setCompute(name, proper);
    QTRY_VERIFY(failures().front()->height() > 0);
    auto *again = failures().front()->findChild<QAbstractButton *>();
    QVERIFY(again);
    QCOMPARE(again->text(), QStringLiteral("Try again"));
    QTest::mouseClick(again, Qt::LeftButton);
    QTRY_VERIFY(failures().empty());
    QTRY_VERIFY(isQuiet());
}

void TestStageFailures::whatTakesForEverCanBeStopped()
{
    std::atomic<bool> wasStopped = false;
    scheduler().setCompute(kPlanned.name,
                           [&](const Snapshot &, const void *, Progress &progress,
                               std::stop_token stop) -> Result<std::shared_ptr<const void>> {
                               progress.set(0.42);
                               while (!stop.stop_requested())
                                   std::this_thread::yield();
                               wasStopped = true;
                               return failure(ErrorCode::Cancelled);
                           });
    auto *stop = m_window->findChild<QToolButton *>(QStringLiteral("checksStop"));
    auto *rows = m_window->findChild<QWidget *>(QStringLiteral("checksArea"));
    const int width = rows->width();
    edit();
    QTRY_VERIFY(!stop->isHidden());
    auto *footer = m_window->findChild<QLabel *>(QStringLiteral("checksFooter"));
    QTRY_VERIFY(footer->text().contains(QStringLiteral("the order of assembly")));
    QVERIFY(footer->text().contains(QStringLiteral("42")));
    QCOMPARE(rows->width(), width); // what is worked out widens no dock
    QTest::mouseClick(stop, Qt::LeftButton);
    QTRY_VERIFY(wasStopped);
    QTRY_COMPARE(failures().size(), std::size_t(1));
    QVERIFY(stop->isHidden());
    // The other verdicts are those of what is there.
    QTRY_VERIFY(isQuiet());
}

void TestStageFailures::theModelIsSetAside()
{
    scheduler().setCompute(kVerdicts.name,
                           [](const Snapshot &, const void *, Progress &,
                              std::stop_token) -> Result<std::shared_ptr<const void>> {
                               throw std::runtime_error("out of luck");
                           });
    edit();
    QTRY_COMPARE(failures().size(), std::size_t(1));
    const QDir reports(Settings::dataFolder() + QStringLiteral("/reports"));
    QCOMPARE(reports.entryList({QStringLiteral("*.fff")}).size(), 1);
    QCOMPARE(reports.entryList({QStringLiteral("*.txt")}).size(), 1);
    QCOMPARE(failures().front()->findChildren<QAbstractButton *>().size(), 2);
}

/// Joints that could not be worked out leave the checks with those of the model before.
void TestStageFailures::whatStandsOnAFailureIsOlder()
{
    scheduler().setCompute(kAnalysed.name,
                           [](const Snapshot &, const void *, Progress &,
                              std::stop_token) -> Result<std::shared_ptr<const void>> {
                               return failure(ErrorCode::NotWorkedOut);
                           });
    edit();
    QTRY_COMPARE(failures().size(), std::size_t(1));
    QTRY_VERIFY(!isQuiet());
    QCOMPARE(m_window->findChild<QLabel *>(QStringLiteral("checksFooter"))->text(),
             QStringLiteral("Older than the drawing"));
    QVERIFY(m_window->findChildren<CheckRow *>().size() > 1);
}

/// Wrong: a window that says "Exporting…" until somebody gives up, or steps that never come.
void TestStageFailures::whoWaitsForItIsTold()
{
    scheduler().setCompute(kAnalysed.name,
                           [](const Snapshot &, const void *, Progress &,
                              std::stop_token) -> Result<std::shared_ptr<const void>> {
                               return failure(ErrorCode::NotWorkedOut);
                           });
    edit();
    const QString file = m_folder->filePath(QStringLiteral("out.svg"));
    QVERIFY(!m_window->findChild<Exporting *>()->write(file));
    QVERIFY(!QFile::exists(file));
    auto *bar = m_window->findChild<MessageBar *>();
    QVERIFY(bar && !bar->isHidden());
    scheduler().finish();
    QSignalSpy said(m_window->findChild<StepsView *>(), &StepsView::said);
    m_window->findChild<StepsView *>()->toggle();
    QTRY_VERIFY(!said.empty());
}

/// Wrong: a list without rows, of a model that has just come, is called older than the drawing.
void TestStageFailures::whatIsNotThereYetIsNoOlder()
{
    const Document document = session().committed().document;
    session().setClean();
    m_window = std::make_unique<MainWindow>();
    m_window->show();
    scheduler().setCompute(kAnalysed.name,
                           [](const Snapshot &, const void *, Progress &,
                              std::stop_token stop) -> Result<std::shared_ptr<const void>> {
                               while (!stop.stop_requested())
                                   std::this_thread::yield();
                               return failure(ErrorCode::Cancelled);
                           });
    session().reset(document);
    auto *footer = m_window->findChild<QLabel *>(QStringLiteral("checksFooter"));
    QTRY_VERIFY(!isQuiet());
    QVERIFY(footer->text() != QStringLiteral("Older than the drawing"));
    QVERIFY(!footer->text().isEmpty());
}

FFF_TEST_WITH(TestStageFailures, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setStyle(new FieldStyle);
    TestStageFailures test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_stage_failures.moc"
