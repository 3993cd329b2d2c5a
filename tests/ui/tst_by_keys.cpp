// A first model by keys alone, from the empty window to the file for the laser: no pointer comes
// near it.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "tests/test_program.h"
#include "tests/ui/dialogs/export_hand.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_program.h"

#include <QDir>

using namespace fff;
using namespace fff::ui;

class TestByKeys : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void aFirstModel();

private:
    static void type(const QString &text, QWindow *window)
    {
        for (const QChar c : text)
            QTest::keyClick(window, c.toLatin1(), Qt::NoModifier, 5);
    }
    void type(const QString &text) { type(text, m_window->windowHandle()); }
    /// With the pen, by its numbers.
    void draw(const std::vector<Vec2> &corners);
    /// The first that the search has for these words.
    void runByWords(const QString &words);
    /// In the next dialog of this kind.
    template <class Dialog>
    void inDialog(const std::function<void(Dialog *)> &act)
    {
        auto *timer = new QTimer(qApp);
        QObject::connect(timer, &QTimer::timeout, timer, [timer, act] {
            auto *dialog = qobject_cast<Dialog *>(QApplication::activeModalWidget());
            if (!dialog || !dialog->isVisible())
                return;
            timer->deleteLater();
            act(dialog);
        });
        timer->start(20);
    }
};

void TestByKeys::draw(const std::vector<Vec2> &corners)
{
    QTRY_VERIFY_WITH_TIMEOUT(!interaction().isAnimating(), 5000);
    for (const Vec2 &corner : corners) {
        QVERIFY(m_view->hasFocus());
        type(QString::number(corner.x()));
        key(Qt::Key_Tab);
        type(QString::number(corner.y()));
        key(Qt::Key_Return);
    }
    key(Qt::Key_Return); // closes it
}

void TestByKeys::runByWords(const QString &words)
{
    key(Qt::Key_K, Qt::ControlModifier);
    QTRY_VERIFY(QApplication::activePopupWidget());
    QWindow *search = QApplication::activePopupWidget()->windowHandle();
    type(words, search);
    QTest::keyClick(search, Qt::Key_Return);
    QTRY_VERIFY(!QApplication::activePopupWidget());
}

void TestByKeys::aFirstModel()
{
    key(Qt::Key_P);
    draw({{-50, 0}, {50, 0}, {50, 60}, {-50, 60}});
    QCOMPARE(count(), std::size_t(1));

    // One across it, on the plane at its side.
    runByWords(QStringLiteral("side plane"));
    QVERIFY(interaction().tool());
    draw({{-40, 0}, {40, 0}, {40, 60}, {-40, 60}});
    QCOMPARE(count(), std::size_t(2));
    QTRY_COMPARE(session().analysis().assembly.joints.size(), std::size_t(1));
    key(Qt::Key_Escape);
    QVERIFY(!interaction().tool());

    // It is looked at, undone and done again.
    key(Qt::Key_1);
    key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(count(), std::size_t(1));
    key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(count(), std::size_t(2));

    // Kept, and written for the laser beside it.
    inDialog<QFileDialog>([this](QFileDialog *dialog) {
        auto *name = dialog->findChild<QLineEdit *>(QStringLiteral("fileNameEdit"));
        QTRY_VERIFY(name->hasFocus());
        name->selectAll();
        type(m_folder->filePath(QStringLiteral("keys.fff")), dialog->windowHandle());
        QTest::keyClick(dialog->windowHandle(), Qt::Key_Return);
    });
    key(Qt::Key_S, Qt::ControlModifier);
    QTRY_VERIFY(QFile::exists(m_folder->filePath(QStringLiteral("keys.fff"))));
    QVERIFY(!m_window->isWindowModified());
    // The display may have no window manager to give it the keys back.
    QApplication::setActiveWindow(m_window.get());
    QTRY_VERIFY(m_view->hasFocus());
    bool isAsked = false;
    inDialog<QDialog>([&isAsked](QDialog *dialog) {
        isAsked = true;
        awaitSheets(dialog);
        QTest::keyClick(dialog->windowHandle(), Qt::Key_Return);
    });
    key(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(isAsked);
    QTRY_COMPARE(QDir(m_folder->path(), QStringLiteral("*.svg")).entryList().size(), 1);
}

FFF_TEST_WITH(TestByKeys, runInWindowProgram<TestByKeys>)
#include "tst_by_keys.moc"
