// Weights in a real window: what a click and keys do in the view.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/model/load_edits.h"
#include "tests/test_program.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_program.h"

using namespace fff;
using namespace fff::ui;

class TestWeightKeys : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { closeWindow(); }

    void keysChangeTheOneThatIsClicked();
    void withoutOneTheyAreForSections();

private:
    const std::vector<Load> &weights() const { return session().committed().document.loads; }
    QPoint place() const { return onScreen(first().frame.toWorld(weights().front().position)); }

    Document m_before;
};

/// A square of 100 mm that stands on the ground, seen from the front, and 350 g that hang on it.
void TestWeightKeys::init()
{
    openWindow();
    const Document square = squareDocument(100.0);
    m_before = *addLoad(square, Load{{}, square.sections.front()->ref(), Vec2(60, 40), 0.35, {}});
    session().reset(m_before);
    bench().showAll("front");
    m_view->setFocus();
    QTRY_VERIFY(m_view->hasFocus());
}

// Wrong: a key of points, or of sections, takes what is meant for the weight.
void TestWeightKeys::keysChangeTheOneThatIsClicked()
{
    move(place());
    click(place());
    QVERIFY(interaction().selectedLoad().isValid());
    QVERIFY(interaction().selection().empty());
    key(Qt::Key_Plus, Qt::ShiftModifier); // as on many keyboards
    key(Qt::Key_Plus);
    key(Qt::Key_Minus);
    key(Qt::Key_Plus);
    QCOMPARE(weights().front().mass, 0.37);
    key(Qt::Key_Right);
    key(Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY((weights().front().position - Vec2(61, 50)).norm() < 1e-9);
    QCOMPARE(steps(), 2); // of its mass, and of its place
    key(Qt::Key_Delete);
    QVERIFY(weights().empty());
    QCOMPARE(count(), std::size_t(1));
    for (int i = 0; i < 3; ++i)
        key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(session().committed().document.isSame(m_before));
}

// Wrong: + and − do something to a weight that nobody chose.
void TestWeightKeys::withoutOneTheyAreForSections()
{
    bench().select({session().committed().ref(0)});
    key(Qt::Key_Plus);
    key(Qt::Key_Minus);
    QCOMPARE(weights().front().mass, 0.35);
    QVERIFY(interaction().selection().size() == 1);
}

FFF_TEST_WITH(TestWeightKeys, runInWindowProgram<TestWeightKeys>)
#include "tst_weight_keys.moc"
