#include <QTest> // first: moc cannot read some of the standard library before it

#include "tests/test_program.h"
#include "ui/files/progress.h"

#include <QApplication>
#include <QProgressBar>
#include <QProgressDialog>
#include <QSemaphore>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <vector>

using namespace fff::ui;

namespace {

QProgressDialog *dialogOf(QWidget &window)
{
    return window.findChild<QProgressDialog *>(QStringLiteral("progress"));
}

/// Calls `act` as soon as the dialog is there, however long that takes.
template <class Act>
void whenShown(QWidget &window, QTimer &timer, Act act)
{
    QObject::connect(&timer, &QTimer::timeout, &window, [&window, &timer, act] {
        QProgressDialog *dialog = dialogOf(window);
        if (!dialog || !dialog->isVisible())
            return;
        timer.stop();
        act(*dialog);
    });
    timer.start(5);
}

} // namespace

class TestProgress : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatMustEndIsNotClosedAway_data();
    void whatMustEndIsNotClosedAway();
    void whatMayBeGivenUpIs();
    void howFarItIsIsSeen();
    void piecesAreDoneInTheirOrder();
    void piecesMayBeGivenUp();
    void aPieceThatFailsIsTheLast();
};

void TestProgress::whatMustEndIsNotClosedAway_data()
{
    QTest::addColumn<bool>("byKey");
    QTest::newRow("Esc") << true;
    QTest::newRow("the frame's close button") << false;
}

/// The dialog keeps input from all windows. Without it, a document is edited, saved a second time
/// or closed while its file is being written.
void TestProgress::whatMustEndIsNotClosedAway()
{
    QFETCH(bool, byKey);
    QWidget window;
    window.show();
    QSemaphore mayEnd;
    QTimer timer;
    bool isShown = false, isModal = false;
    whenShown(window, timer, [&](QProgressDialog &dialog) {
        if (byKey)
            QTest::keyClick(&dialog, Qt::Key_Escape);
        else
            dialog.close();
        isShown = dialog.isVisible();
        isModal = QApplication::activeModalWidget() == &dialog;
        mayEnd.release();
    });
    const std::optional<int> result =
        inBackground<int>(window, QStringLiteral("Saving"), MayCancel::No, [&mayEnd] {
            mayEnd.acquire();
            return 7;
        });
    QCOMPARE(result, std::optional(7));
    QVERIFY(isShown);
    QVERIFY(isModal);
    QVERIFY(!dialogOf(window));
}

/// What may be given up is, at once; the work runs on and nobody waits for it.
void TestProgress::whatMayBeGivenUpIs()
{
    QWidget window;
    window.show();
    const auto mayEnd = std::make_shared<QSemaphore>();
    QTimer timer;
    whenShown(window, timer,
              [](QProgressDialog &dialog) { QTest::keyClick(&dialog, Qt::Key_Escape); });
    const std::optional<int> result =
        inBackground<int>(window, QStringLiteral("Opening"), MayCancel::Yes, [mayEnd] {
            mayEnd->acquire();
            return 7;
        });
    mayEnd->release();
    QVERIFY(!result);
}

/// Wrong: a bar that only runs to and fro for as long as a large file takes.
void TestProgress::howFarItIsIsSeen()
{
    QWidget window;
    window.show();
    const auto share = std::make_shared<std::atomic<double>>(-1.0);
    const auto mayEnd = std::make_shared<QSemaphore>();
    QTimer timer, look;
    bool wasUnknown = false;
    double seen = -1.0;
    whenShown(window, timer, [&](QProgressDialog &dialog) {
        const auto *bar = dialog.findChild<QProgressBar *>();
        wasUnknown = bar && bar->maximum() == 0;
        share->store(0.25);
        QObject::connect(&look, &QTimer::timeout, &window, [&, bar] {
            if (!bar || bar->maximum() == 0)
                return;
            seen = static_cast<double>(bar->value()) / bar->maximum();
            mayEnd->release();
        });
        look.start(5);
    });
    inBackground<int>(
        window, QStringLiteral("Reading"), MayCancel::Yes,
        [mayEnd] {
            mayEnd->acquire();
            return 7;
        },
        share);
    QVERIFY(wasUnknown);
    QCOMPARE(seen, 0.25);
}

/// Each once, with time in between for all else that waits: else the window would hang.
void TestProgress::piecesAreDoneInTheirOrder()
{
    QWidget window;
    std::vector<int> done;
    int between = 0;
    QTimer other;
    connect(&other, &QTimer::timeout, &window, [&] { ++between; });
    other.start(0);
    const Pieces how = doInPieces(window, QStringLiteral("Exporting"), 5, [&](int piece) {
        done.push_back(piece);
        return true;
    });
    QCOMPARE(how, Pieces::Done);
    QCOMPARE(done, (std::vector<int>{0, 1, 2, 3, 4}));
    QVERIFY(between >= 4);
    QVERIFY(!dialogOf(window));
}

/// Whoever does not want to wait need not.
void TestProgress::piecesMayBeGivenUp()
{
    QWidget window;
    window.show();
    int done = 0;
    QTimer timer;
    int shown = -1, most = 0;
    whenShown(window, timer, [&](QProgressDialog &dialog) {
        shown = dialog.value();
        most = dialog.maximum();
        QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    const Pieces how = doInPieces(window, QStringLiteral("Exporting"), 400, [&](int) {
        ++done;
        QTest::qSleep(5);
        return true;
    });
    QCOMPARE(how, Pieces::GivenUp);
    QVERIFY(done < 400);
    QVERIFY(shown > 0); // how far it is
    QCOMPARE(most, 400);
}

void TestProgress::aPieceThatFailsIsTheLast()
{
    QWidget window;
    int done = 0;
    const Pieces how = doInPieces(window, QStringLiteral("Exporting"), 5, [&](int piece) {
        ++done;
        return piece < 2;
    });
    QCOMPARE(how, Pieces::Failed);
    QCOMPARE(done, 3);
}

FFF_TEST_WITH(TestProgress, fff::testing::runWithin<TestProgress, QApplication>)
#include "tst_progress.moc"
