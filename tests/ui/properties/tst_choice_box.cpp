// A box to choose from, by itself.
#include <QTest> // first: moc stumbles over some standard headers

#include <QApplication>

#include "tests/test_program.h"
#include "tests/ui/tip.h"
#include "ui/properties/choice_box.h"

#include <QStyleOptionComboBox>

using namespace fff::test;
using namespace fff::ui;

class TestChoiceBox : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aLongNameEndsInDots();
};

namespace {

/// Columns of pixels, from the right end of the text's field on, that are all of one colour.
int emptyColumns(ChoiceBox &box)
{
    const QImage picture = box.grab().toImage();
    QStyleOptionComboBox option;
    option.initFrom(&box);
    const QRect field = box.style()->subControlRect(QStyle::CC_ComboBox, &option,
                                                    QStyle::SC_ComboBoxEditField, &box);
    const double scale = picture.devicePixelRatio();
    const int top = static_cast<int>(scale * (field.top() + 4)),
              bottom = static_cast<int>(scale * (field.bottom() - 4));
    const auto isEmpty = [&](int x) {
        for (int y = top; y < bottom; ++y)
            if (std::abs(qGray(picture.pixel(x, y)) - qGray(picture.pixel(x, y + 1))) > 24)
                return false;
        return true;
    };
    int count = 0;
    for (int x = static_cast<int>(scale * field.right()); x > 0 && isEmpty(x); --x)
        ++count;
    return count;
}

} // namespace

// Wrong: "Birkensperrh", cut off in the middle of a letter, with nothing that says the rest.
void TestChoiceBox::aLongNameEndsInDots()
{
    const QString name = QStringLiteral("WWWWWWWWWWWWWWWW");
    ChoiceBox box;
    box.setChoices({{{name, Qt::darkYellow}, {QStringLiteral("Card"), Qt::gray}}, 0});
    box.resize(120, 26);
    box.show();
    QVERIFY(QTest::qWaitForWindowExposed(&box));
    QCOMPARE(tipOf(box), name);
    // Letters cut off reach the end of their field; dots are low and leave what is above them.
    QVERIFY2(emptyColumns(box) > 0, QByteArray::number(emptyColumns(box)));
    box.setChoices({{{name, Qt::darkYellow}, {QStringLiteral("Card"), Qt::gray}}, 1});
    QCOMPARE(tipOf(box), QString());
    box.setChoices({{{name, Qt::darkYellow}, {QStringLiteral("Card"), Qt::gray}}, 0});
    box.resize(600, 26);
    QCOMPARE(tipOf(box), QString());
    box.setSizeAdjustPolicy(QComboBox::AdjustToContents);
    box.resize(box.sizeHint()); // which it says is enough
    QCOMPARE(tipOf(box), QString());
}

FFF_TEST_WITH(TestChoiceBox, fff::testing::runWithin<TestChoiceBox, QApplication>)
#include "tst_choice_box.moc"
