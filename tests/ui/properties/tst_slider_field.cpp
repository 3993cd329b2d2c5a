// A number as a slider and a field, wherever it stands: what is told of a drag, a key, the wheel
// and Esc.
#include <QTest>

#include "tests/test_program.h"
#include "ui/properties/slider_field.h"

#include <QApplication>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSlider>
#include <QWheelEvent>

using namespace fff::ui;

class TestSliderField : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { m_window.reset(); }

    void aDragIsToldAllAlongAndSettlesOnce();
    void keysSettleAfterTheLastOne();
    void whatIsTypedSettles();
    void whatIsSetIsNotTold();
    void whatIsSetDisturbsNoDrag();
    void escapeCancels();
    void escapeGivesUpTheDragOfTheMouse();
    void aFieldForSomethingElseSettlesFirst_data();
    void aFieldForSomethingElseSettlesFirst();
    void theWheelIsForTheOneWithTheFocus();
    void aNarrowOneHasALineOfItsOwn();

private:
    int middle() const { return m_slider->width() / 2; }
    void press(int x) { QTest::mousePress(m_slider, Qt::LeftButton, {}, at(x)); }
    void move(int x) { QTest::mouseMove(m_slider, at(x)); }
    void release(int x) { QTest::mouseRelease(m_slider, Qt::LeftButton, {}, at(x)); }
    QPoint at(int x) const { return {x, m_slider->height() / 2}; }
    double shown() const { return m_edit->value(); }

    std::unique_ptr<QWidget> m_window;
    SliderField *m_field = nullptr;
    QSlider *m_slider = nullptr;
    NumberEdit *m_edit = nullptr;
    std::unique_ptr<QSignalSpy> m_dragged, m_settled, m_cancelled;
};

/// From 0 to 10 in tenths; the field takes up to 100. It shows 5.
void TestSliderField::init()
{
    m_window = std::make_unique<QWidget>();
    m_window->resize(400, 60);
    m_edit = new NumberEdit({0.0, 100.0, 0.1, 1, 3}, QStringLiteral("mm"));
    m_field = new SliderField({0.0, 10.0, 0.1}, m_edit, m_window.get());
    m_field->resize(400, 40);
    auto *other = new QLineEdit(m_window.get());
    other->setObjectName(QStringLiteral("other"));
    m_field->setNumber(5.0);
    m_slider = m_field->findChild<QSlider *>();
    m_dragged = std::make_unique<QSignalSpy>(m_field, &SliderField::dragged);
    m_settled = std::make_unique<QSignalSpy>(m_field, &SliderField::settled);
    m_cancelled = std::make_unique<QSignalSpy>(m_field, &SliderField::cancelled);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    QApplication::setActiveWindow(m_window.get());
    m_slider->setFocus();
    QTRY_VERIFY(m_slider->hasFocus());
}

// Wrong: nothing follows on the way, or each pixel is a step of the history.
void TestSliderField::aDragIsToldAllAlongAndSettlesOnce()
{
    press(middle());
    for (int x = middle(); x <= middle() + 40; x += 4)
        move(x);
    QVERIFY(m_dragged->count() > 3);
    QCOMPARE(m_settled->count(), 0);
    QCOMPARE(m_dragged->last().at(0).toDouble(), shown());
    QVERIFY(shown() > 5.5);
    release(middle() + 40);
    QCOMPARE(m_settled->count(), 1);
    QCOMPARE(m_settled->first().at(0).toDouble(), shown());
    QTest::qWait(500); // nothing waits any more
    QCOMPARE(m_settled->count(), 1);
    QCOMPARE(m_cancelled->count(), 0);
}

void TestSliderField::keysSettleAfterTheLastOne()
{
    for (int i = 1; i <= 3; ++i)
        QTest::keyClick(m_slider, Qt::Key_Right);
    QCOMPARE(m_dragged->count(), 3);
    QCOMPARE(m_settled->count(), 0);
    QTRY_COMPARE(m_settled->count(), 1);
    QCOMPARE(m_settled->first().at(0).toDouble(), 5.3);
}

// Wrong: the field goes only as far as the slider, or what is typed is told as a drag.
void TestSliderField::whatIsTypedSettles()
{
    m_edit->setFocus();
    m_edit->selectAll();
    QTest::keyClicks(m_edit, QStringLiteral("42"));
    QTest::keyClick(m_edit, Qt::Key_Return);
    QCOMPARE(m_settled->count(), 1);
    QCOMPARE(m_settled->first().at(0).toDouble(), 42.0);
    QCOMPARE(m_dragged->count(), 0);
}

void TestSliderField::whatIsSetIsNotTold()
{
    m_field->setNumber(7.0);
    QCOMPARE(m_slider->value(), 70);
    m_field->setNumber(42.0);
    QCOMPARE(m_slider->value(), 100); // as far as it goes
    QCOMPARE(shown(), 42.0);
    m_field->setNumber({});
    QTest::qWait(500);
    QCOMPARE(m_dragged->count() + m_settled->count() + m_cancelled->count(), 0);
}

// Wrong: the slider jumps back under the hand, since what is shown is read again on the way.
void TestSliderField::whatIsSetDisturbsNoDrag()
{
    press(middle());
    move(middle() + 40);
    const int notch = m_slider->value();
    m_field->setNumber(5.0);
    QCOMPARE(m_slider->value(), notch);
    release(middle() + 40);
    QCOMPARE(m_settled->first().at(0).toDouble(), notch * 0.1);
}

void TestSliderField::escapeCancels()
{
    QTest::keyClick(m_slider, Qt::Key_Right);
    QTest::keyClick(m_slider, Qt::Key_Escape);
    QCOMPARE(m_cancelled->count(), 1);
    QTest::qWait(500);
    QCOMPARE(m_settled->count(), 0);
    // Without a drag it is for whoever else has a use for it.
    QTest::keyClick(m_slider, Qt::Key_Escape);
    QCOMPARE(m_cancelled->count(), 1);
}

// Wrong: the mouse, still down after Esc, goes on to drag and settles what was given up.
void TestSliderField::escapeGivesUpTheDragOfTheMouse()
{
    press(middle());
    move(middle() + 12);
    QTest::keyClick(m_slider, Qt::Key_Escape);
    QCOMPARE(m_cancelled->count(), 1);
    const qsizetype told = m_dragged->count();
    move(middle() + 24);
    release(middle() + 24);
    QCOMPARE(m_dragged->count(), told);
    QCOMPARE(m_settled->count(), 0);
    m_field->setNumber(5.0); // as who shows it does
    // The next drag is one again.
    press(middle());
    move(middle() + 30);
    move(middle() + 50);
    release(middle() + 50);
    QVERIFY(m_dragged->count() > told);
    QCOMPARE(m_settled->count(), 1);
}

void TestSliderField::aFieldForSomethingElseSettlesFirst_data()
{
    QTest::addColumn<bool>("byFocus");
    QTest::newRow("it is asked to settle") << false;
    QTest::newRow("the focus goes elsewhere") << true;
}

// Wrong: the number of one thing is given to the next one that is shown.
void TestSliderField::aFieldForSomethingElseSettlesFirst()
{
    QFETCH(bool, byFocus);
    QTest::keyClick(m_slider, Qt::Key_Right);
    QCOMPARE(m_settled->count(), 0);
    if (byFocus)
        m_window->findChild<QLineEdit *>(QStringLiteral("other"))->setFocus();
    else
        m_field->settle();
    QCOMPARE(m_settled->count(), 1);
    QCOMPARE(m_settled->first().at(0).toDouble(), 5.1);
    QTest::qWait(500);
    QCOMPARE(m_settled->count(), 1);
}

// Wrong: whoever scrolls past it changes it.
void TestSliderField::theWheelIsForTheOneWithTheFocus()
{
    const auto scroll = [this] {
        const QPointF on = m_slider->rect().center();
        QWheelEvent event(on, m_slider->mapToGlobal(on), {}, {0, 120}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(m_slider, &event);
    };
    m_window->findChild<QLineEdit *>(QStringLiteral("other"))->setFocus();
    scroll();
    QCOMPARE(m_dragged->count(), 0);
    m_slider->setFocus();
    scroll();
    QCOMPARE(m_dragged->count(), 1);
}

// Wrong: a slider of 36 px, on which each pixel is three of a hundred.
void TestSliderField::aNarrowOneHasALineOfItsOwn()
{
    const int field = m_edit->width();
    for (const int width : {400, 110, 200, 120, 400}) {
        m_field->resize(width, m_field->sizeHint().height());
        const auto isBeside = [this] {
            return m_slider->geometry().right() < m_edit->geometry().left();
        };
        QTRY_COMPARE(isBeside(), width >= 80 + 8 + field);
        QTRY_VERIFY2(m_slider->width() >= 80, qPrintable(QString::number(m_slider->width())));
        QCOMPARE(m_edit->width(), field);
        QVERIFY(!m_slider->geometry().intersects(m_edit->geometry()));
        m_slider->setFocus();
        QTest::keyClick(m_slider, Qt::Key_Right);
        QVERIFY(m_slider->hasFocus());
    }
}

FFF_TEST_WITH(TestSliderField, fff::testing::runWithin<TestSliderField, QApplication>)
#include "tst_slider_field.moc"
