// Links of checks in a real window: where keys go after one was clicked.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/session/check_list.h"
#include "tests/core/assembly/known_models.h"
#include "tests/test_program.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_program.h"
#include "ui/base/sentence_label.h"
#include "ui/docks/check_row.h"
#include "ui/properties/link_row.h"

#include <QAbstractButton>
#include <QLabel>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

class TestCheckLinks : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { closeWindow(); }

    void theHandGoesOnInTheView();
    void whoWorksWithKeysStaysThere();
    void itSaysWhatWasDone();
    void theSecondPressDoesNothing();
    void aClickShowsWhereInTheModelItIs();
    void linksStandBelowTheWords();

private:
    CheckRow *row() const { return m_window->findChild<CheckRow *>(QStringLiteral("checkRow0")); }
    QAbstractButton *link() const
    {
        return row() ? row()->findChild<QAbstractButton *>(QStringLiteral("checkLink0")) : nullptr;
    }
    /// Twice: what a cursor comes to rest on was not pointed at (ui/properties/link_row.h).
    void pointAt(const QWidget *widget)
    {
        m_at = widget->mapTo(m_window.get(), widget->rect().center());
        for (const QPoint &place : {m_at - QPoint(1, 0), m_at})
            QTest::mouseMove(m_window->windowHandle(), place, 5);
    }
    const CheckRow *rowUnder(const QPoint &inWindow) const
    {
        const QWidget *under = m_window->childAt(inWindow);
        while (under && !qobject_cast<const CheckRow *>(under))
            under = under->parentWidget();
        return qobject_cast<const CheckRow *>(under);
    }
    void pressAndRelease()
    {
        QTest::mousePress(m_window->windowHandle(), Qt::LeftButton, {}, m_at, 5);
        QTest::mouseRelease(m_window->windowHandle(), Qt::LeftButton, {}, m_at, 5);
    }

    QPoint m_at; // in the window
};

/// A crate that hangs above the ground.
void TestCheckLinks::init()
{
    openWindow();
    session().reset(moveAll(eggCrate(2, 2), {0, 12, 0}));
    QTRY_VERIFY(link() && link()->isVisible());
    QCOMPARE(link()->text(), QStringLiteral("Drop it to the ground"));
}

// Wrong: one has to click into the view before its keys do anything.
void TestCheckLinks::theHandGoesOnInTheView()
{
    QTest::mouseClick(row(), Qt::LeftButton); // to read it
    QVERIFY(!m_view->hasFocus());
    QTest::mouseClick(link(), Qt::LeftButton);
    QCOMPARE(steps(), 1);
    QTRY_VERIFY(m_view->hasFocus());
    QTRY_VERIFY(row()->accessibleName().startsWith(QStringLiteral("Good")));
    QVERIFY(m_view->hasFocus()); // also once it is checked anew
    const auto press = [](Qt::Key key, Qt::KeyboardModifiers with = {}) {
        QTest::keyClick(QApplication::focusWidget(), key, with);
    };
    press(Qt::Key_W);
    QVERIFY(interaction().tool() && interaction().tool()->command() == "physics.addWeight");
    press(Qt::Key_Escape);
    QVERIFY(!interaction().tool());
    press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(session().history()->index(), 0);
}

// Wrong: with keys alone one would have to come all the way back for the next check.
void TestCheckLinks::whoWorksWithKeysStaysThere()
{
    row()->setFocus();
    QTest::keyClick(row(), Qt::Key_Tab);
    QVERIFY(link()->hasFocus());
    QTest::keyClick(link(), Qt::Key_Return);
    QCOMPARE(steps(), 1);
    QTRY_VERIFY(row()->accessibleName().startsWith(QStringLiteral("Good")));
    QVERIFY(!m_view->hasFocus());
}

// Wrong: what was promised and what was done are two different sentences, or the latter is gone as
// soon as another row comes to be under the cursor.
void TestCheckLinks::itSaysWhatWasDone()
{
    const auto *status = m_window->findChild<SentenceLabel *>(QStringLiteral("statusSentence"));
    pointAt(link());
    const QString before = QStringLiteral("If you click: "), after = QStringLiteral("Done: ");
    QTRY_VERIFY(status->text().startsWith(before));
    const QString promised = status->text().mid(before.size());
    pressAndRelease();
    QCOMPARE(steps(), 1);
    QCOMPARE(status->text(), after + promised);
    QTRY_VERIFY(row()->accessibleName().startsWith(QStringLiteral("Good")));
    QCOMPARE(status->text(), after + promised);
}

// Wrong: the row that comes under the cursor when the one above it is mended is clicked.
void TestCheckLinks::theSecondPressDoesNothing()
{
    pointAt(link());
    pressAndRelease();
    QCOMPARE(steps(), 1);
    QTRY_VERIFY(row()->accessibleName().startsWith(QStringLiteral("Good")));
    m_window->findChild<CheckList *>()->finish(); // what comes later moves no row
    const CheckRow *now = rowUnder(m_at);
    QVERIFY(now); // or it could not be clicked anyway
    const Camera before = interaction().targetCamera();
    QTest::lastMouseTimestamp -= QTest::mouseDoubleClickInterval - 50; // it is a double click
    pressAndRelease();
    QVERIFY(!now->isChecked());
    QVERIFY(interaction().targetCamera() == before);
    QCOMPARE(steps(), 1);
    pressAndRelease(); // by itself, and what is there now is meant
    QCOMPARE(rowUnder(m_at), now);
    QVERIFY(now->isChecked());
}

// Wrong: the view is full of one section, and nobody knows where it is.
void TestCheckLinks::aClickShowsWhereInTheModelItIs()
{
    Document crate = eggCrate(4, 4);
    crate = withSection(std::move(crate), polygonShape(rectangle(0, 0, 8, 8)), front(20));
    session().reset(crate);
    QTRY_VERIFY(row() && row()->accessibleName().startsWith(QStringLiteral("Problem 1")));
    m_window->findChild<CheckList *>()->finish(); // what comes later moves no row
    bench().run(QStringLiteral("view.fitAll"));
    const double all = interaction().targetCamera().millimetresPerPixel;
    pointAt(row()->findChild<QLabel *>(QStringLiteral("checkTitle")));
    pressAndRelease();
    QVERIFY(row()->isChecked());
    QCOMPARE(interaction().selection().size(), std::size_t(1));
    const double now = interaction().targetCamera().millimetresPerPixel;
    QVERIFY(now < 0.9 * all && now > all / 6.0);
}

// Wrong: links stand beside the edge that heading and text have.
void TestCheckLinks::linksStandBelowTheWords()
{
    const auto edge = [this](const char *label) {
        const auto *words = row()->findChild<QLabel *>(QLatin1String(label));
        return words->mapTo(row(), words->contentsRect().topLeft()).x();
    };
    QCOMPARE(edge("checkText"), edge("checkTitle"));
    QCOMPARE(link()->mapTo(row(), QPoint(LinkRow::kAround, 0)).x(), edge("checkTitle"));
}

FFF_TEST_WITH(TestCheckLinks, runInWindowProgram<TestCheckLinks>)
#include "tst_check_links.moc"
