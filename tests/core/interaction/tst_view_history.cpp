#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/view_history.h"
#include "tests/test_program.h"

using namespace fff;
using Change = ViewHistory::Change;

namespace {

Camera at(double x)
{
    Camera camera;
    camera.target.x() = x;
    return camera;
}

} // namespace

class TestViewHistory : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void goesBackInOrder();
    void stepsOfAWheelAreOne();
    void aWheelAfterSomethingElseIsAnother();
    void viewsThatLookTheSameAreSkipped();
    void depthIsNotSeenWithoutPerspective();
    void isBounded();
};

void TestViewHistory::goesBackInOrder()
{
    ViewHistory history;
    QVERIFY(!history.canGoBack(at(0)));
    history.leave(at(0), Change::Turn);
    history.leave(at(10), Change::Drag);
    QCOMPARE(history.takeBack(at(20))->target.x(), 10.0);
    QCOMPARE(history.takeBack(at(10))->target.x(), 0.0);
    QVERIFY(!history.takeBack(at(0)));
}

void TestViewHistory::stepsOfAWheelAreOne()
{
    ViewHistory history;
    for (int i = 0; i < 5; ++i)
        history.leave(at(10.0 * i), Change::Wheel);
    QCOMPARE(history.takeBack(at(50))->target.x(), 0.0);
    QVERIFY(!history.canGoBack(at(0)));
}

void TestViewHistory::aWheelAfterSomethingElseIsAnother()
{
    ViewHistory history;
    history.leave(at(0), Change::Wheel);
    history.leave(at(10), Change::Wheel);
    history.interrupt();
    history.leave(at(20), Change::Wheel);
    history.leave(at(30), Change::Drag);
    history.leave(at(40), Change::Wheel);
    QCOMPARE(history.takeBack(at(50))->target.x(), 40.0);
    QCOMPARE(history.takeBack(at(40))->target.x(), 30.0);
    QCOMPARE(history.takeBack(at(30))->target.x(), 20.0);
    QCOMPARE(history.takeBack(at(20))->target.x(), 0.0);
}

void TestViewHistory::viewsThatLookTheSameAreSkipped()
{
    ViewHistory history;
    history.leave(at(0), Change::Turn);
    history.leave(at(10), Change::Turn);
    QCOMPARE(history.takeBack(at(10))->target.x(), 0.0);
    Camera deep = at(0);
    deep.projection = Projection::Perspective;
    history.leave(deep, Change::Turn);
    QVERIFY(history.canGoBack(at(0)));
}

void TestViewHistory::depthIsNotSeenWithoutPerspective()
{
    ViewHistory history;
    history.leave(at(0), Change::Turn);
    Camera deeper = at(0);
    deeper.target.z() = 500.0; // the front view looks along z
    QVERIFY(!history.canGoBack(deeper));
}

void TestViewHistory::isBounded()
{
    ViewHistory history;
    for (int i = 0; i < 1000; ++i)
        history.leave(at(10.0 * i), Change::Turn);
    Camera current = at(-1);
    std::size_t count = 0;
    while (const auto before = history.takeBack(current)) {
        current = *before;
        ++count;
    }
    QCOMPARE(count, ViewHistory::kCapacity);
}

FFF_TEST(TestViewHistory)
#include "tst_view_history.moc"
