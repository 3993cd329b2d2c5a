// Control points in a real window: with mouse, keys and the fields of the Properties dock.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "tests/test_program.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_program.h"
#include "ui/properties/choice_box.h"

#include <QDoubleSpinBox>
#include <QLineEdit>

#include <cmath>

using namespace fff;
using namespace fff::ui;

class TestPointEditing : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { closeWindow(); }

    void aPointIsDraggedAndTakenBack();
    void aDoubleClickAddsAndDelTakesOut();
    void arrowKeysMoveAndMerge();
    void numbersAreTyped();
    void kindsAreChosen();
    void severalPointsShowWhatTheyShare();
    void aDragIsShownInTheNumbers();

private:
    /// Of a place in the frame of the plate, mm.
    QPoint at(double x, double y) const { return onScreen(first().frame.toWorld({x, y})); }
    void type(const char *field, const QString &text);
    template <class Widget>
    Widget *field(const char *name)
    {
        return m_window->findChild<Widget *>(QLatin1String(name));
    }
    Vec2 corner(int index) const { return position(*first().shape, {0, index}); }
};

/// A square of 100 mm that stands 20 mm above the ground, seen from the front and selected.
void TestPointEditing::init()
{
    openWindow();
    Document document = squareDocument(100.0);
    Frame frame;
    frame.origin = Vec3(-50, 20, 0);
    session().reset(*moveSection(document, document.sections.front()->id, frame));
    bench().showAll("front");
    bench().select({session().committed().ref(0)});
    m_view->setFocus();
    QTRY_VERIFY(m_view->hasFocus());
}

void TestPointEditing::type(const char *name, const QString &text)
{
    auto *edit = field<QAbstractSpinBox>(name);
    QVERIFY(edit && edit->isVisible());
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
}

// Wrong: what is dragged is not what is committed, or Ctrl+Z does not take it back.
void TestPointEditing::aPointIsDraggedAndTakenBack()
{
    const QPoint from = at(100, 100), to = from + QPoint(40, -30);
    move(from);
    press(from);
    for (int i = 1; i <= 8; ++i)
        move(from + (to - from) * i / 8);
    QTRY_VERIFY(session().hasPreview());
    release(to);
    QTRY_COMPARE(steps(), 1);
    const double scale = interaction().camera().millimetresPerPixel;
    QVERIFY((corner(2) - Vec2(100 + 40 * scale, 100 + 30 * scale)).norm() < 1e-6);
    QCOMPARE(session().history()->undoText(), QStringLiteral("Move point of Plate"));
    key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(corner(2) == Vec2(100, 100));
    key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(corner(2).x() > 105.0);
}

void TestPointEditing::aDoubleClickAddsAndDelTakesOut()
{
    const QPoint middle = at(50, 100);
    move(middle);
    press(middle);
    release(middle);
    QTest::mouseDClick(m_window->windowHandle(), Qt::LeftButton, {},
                       m_view->mapTo(m_window.get(), middle), 5);
    QTRY_COMPARE(first().shape->contour().segmentCount(), 5);
    QCOMPARE(steps(), 1);
    QCOMPARE(interaction().points().points().size(), std::size_t(1));
    key(Qt::Key_Delete);
    QCOMPARE(first().shape->contour().segmentCount(), 4);
    QCOMPARE(steps(), 2);
    QCOMPARE(interaction().selection().size(), std::size_t(1));
}

void TestPointEditing::arrowKeysMoveAndMerge()
{
    click(at(100, 100));
    for (int i = 0; i < 3; ++i)
        key(Qt::Key_Right);
    key(Qt::Key_Up, Qt::ShiftModifier);
    key(Qt::Key_Left, Qt::ControlModifier);
    QVERIFY((corner(2) - Vec2(102.9, 110)).norm() < 1e-9);
    QCOMPARE(steps(), 1);
    key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(corner(2) == Vec2(100, 100));
}

// Wrong: a number that is typed lands beside itself, or takes several steps.
void TestPointEditing::numbersAreTyped()
{
    click(at(100, 100));
    type("pointX", QStringLiteral("112.7"));
    QVERIFY(corner(2) == Vec2(112.7, 100));
    type("pointY", QStringLiteral("90+1.5"));
    QVERIFY(corner(2) == Vec2(112.7, 91.5));
    QCOMPARE(steps(), 2);
    type("handleOutLength", QStringLiteral("20"));
    type("handleOutAngle", QStringLiteral("135"));
    const Vec2 arm = handle(first().shape->contour(), 2, HandleSide::Out) - corner(2);
    QVERIFY((arm - 20.0 * Vec2(-std::sqrt(0.5), std::sqrt(0.5))).norm() < 1e-9);
    QCOMPARE(steps(), 4);
    m_view->setFocus();
    key(Qt::Key_Z, Qt::ControlModifier);
    key(Qt::Key_Z, Qt::ControlModifier);
    key(Qt::Key_Z, Qt::ControlModifier);
    key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(corner(2) == Vec2(100, 100));
}

void TestPointEditing::kindsAreChosen()
{
    click(at(100, 100));
    auto *kind = field<ChoiceBox>("pointKind");
    QVERIFY(kind && kind->isVisible());
    for (const PointKind wanted : {PointKind::Smooth, PointKind::Symmetric, PointKind::Corner}) {
        kind->setCurrentIndex(static_cast<int>(wanted));
        Q_EMIT kind->activated(static_cast<int>(wanted));
        QCOMPARE(kindOf(first().shape->contour(), 2), wanted);
        QCOMPARE(kind->currentIndex(), static_cast<int>(wanted));
    }
    m_view->setFocus();
    key(Qt::Key_1, Qt::ControlModifier);
    QCOMPARE(kindOf(first().shape->contour(), 2), PointKind::Smooth);
    key(Qt::Key_2, Qt::ControlModifier);
    QCOMPARE(kindOf(first().shape->contour(), 2), PointKind::Corner);
    QCOMPARE(steps(), 5);
}

void TestPointEditing::severalPointsShowWhatTheyShare()
{
    click(at(100, 0));
    click(at(100, 100), Qt::ControlModifier);
    auto *x = field<QAbstractSpinBox>("pointX"), *y = field<QAbstractSpinBox>("pointY");
    QVERIFY(x && x->isVisible());
    QVERIFY2(x->text().startsWith(QStringLiteral("100")), qPrintable(x->text()));
    QVERIFY(y->text().isEmpty());
    QCOMPARE(y->findChild<QLineEdit *>()->placeholderText(), QStringLiteral("mixed"));
    type("pointX", QStringLiteral("120"));
    QVERIFY(corner(1) == Vec2(120, 0) && corner(2) == Vec2(120, 100));
    QCOMPARE(steps(), 1);
    key(Qt::Key_Escape);
    m_view->setFocus();
    key(Qt::Key_Escape);
    QTRY_VERIFY(!x->isVisible());
}

void TestPointEditing::aDragIsShownInTheNumbers()
{
    const QPoint from = at(100, 100);
    move(from);
    press(from);
    for (int i = 1; i <= 8; ++i)
        move(from + QPoint(5 * i, 0));
    auto *x = field<QDoubleSpinBox>("pointX");
    QTRY_VERIFY(x && x->isVisible() && x->value() > 105.0);
    QCOMPARE(steps(), 0);
    release(from + QPoint(40, 0));
    QTRY_COMPARE(steps(), 1);
}

FFF_TEST_WITH(TestPointEditing, runInWindowProgram<TestPointEditing>)
#include "tst_point_editing.moc"
