// Links of checks in a real window: where keys go after one was clicked.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "tests/core/assembly/known_models.h"
#include "tests/test_program.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_program.h"
#include "ui/docks/check_row.h"

#include <QAbstractButton>

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

private:
    CheckRow *row() const { return m_window->findChild<CheckRow *>(QStringLiteral("checkRow0")); }
    QAbstractButton *link() const
    {
        return row() ? row()->findChild<QAbstractButton *>(QStringLiteral("checkLink0")) : nullptr;
    }
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

FFF_TEST_WITH(TestCheckLinks, runInWindowProgram<TestCheckLinks>)
#include "tst_check_links.moc"
