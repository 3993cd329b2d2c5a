#include <QTest> // first: moc cannot read some of the standard library before it

#include "ui/files/progress.h"

#include <QApplication>
#include <QProgressDialog>
#include <QSemaphore>
#include <QTimer>
#include <QWidget>

#include <memory>

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

QTEST_MAIN(TestProgress)
#include "tst_progress.moc"
