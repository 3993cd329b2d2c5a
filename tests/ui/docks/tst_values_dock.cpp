// The Values dock as a person uses it, in a window without its view.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/test_program.h"
#include "tests/ui/docks/values_hand.h"
#include "ui/base/translations.h"
#include "ui/properties/choice_box.h"

#include <QCheckBox>
#include <QPushButton>
#include <QSlider>
#include <QUndoStack>

#include <cmath>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

class TestValuesDock : public QObject, private ValuesHand
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        begin();
        QVERIFY(dock().isHidden()); // until it is asked for
    }
    void cleanup() { end(); }

    void emptyItHasOneSentenceAndOneButton();
    void aNewOneIsNamedAndTyped();
    void leavingKeepsWhatWasTyped();
    void aDragIsSeenAndIsOneStep();
    void escapeTakesADragBack();
    void aRowSaysWhatIsWrongWithIt();
    void renamingFollowsEverywhere();
    void aNameOfTwoWords();
    void whatWasRefusedIsMended();
    void tabGoesFromTheNameToTheNumber();
    void removingSaysHowMany();
    void kindsHaveTheirEditors();
    void rangesMakeSliders();
    void aHoveredRowLightsWhatFollows();
    void theNoteIsItsTip();
    void undoBringsRowsBack();
};

void TestValuesDock::emptyItHasOneSentenceAndOneButton()
{
    open(newDocument());
    int sentences = 0, buttons = 0;
    for (const QLabel *label : dock().widget()->findChildren<QLabel *>())
        sentences += label->isVisible() ? 1 : 0;
    for (const QPushButton *button : dock().widget()->findChildren<QPushButton *>())
        buttons += button->isVisible() ? 1 : 0;
    QCOMPARE(sentences, 1);
    QCOMPARE(buttons, 1);
}

void TestValuesDock::aNewOneIsNamedAndTyped()
{
    open(newDocument());
    QTest::mouseClick(dock().findChild<QPushButton *>(QStringLiteral("valueAdd")), Qt::LeftButton);
    QCOMPARE(document().values.list.size(), std::size_t(1));
    auto *name = qobject_cast<QLineEdit *>(m_window->focusWidget());
    QVERIFY(name);
    QTest::keyClicks(name, QStringLiteral("gap"));
    QTest::keyClick(name, Qt::Key_Return);
    QVERIFY(row("gap"));
    type(in<NumberEdit>("gap"), QStringLiteral("1 in"));
    QCOMPARE(worth("gap"), 25.4);
}

// Wrong: an expression that was typed and left without Enter became its number.
void TestValuesDock::leavingKeepsWhatWasTyped()
{
    open(withValue(withValue(newDocument(), "a", "3 mm"), "b", "7 mm"));
    auto *edit = in<NumberEdit>("b");
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, QStringLiteral("= 2*a"));
    activate();
    in<NumberEdit>("a")->setFocus();
    QCOMPARE(document().values.find(std::string_view("b"))->typed, std::string("2*a"));
    QCOMPARE(worth("b"), 6.0);
    type(in<NumberEdit>("a"), QStringLiteral("4"));
    QCOMPARE(worth("b"), 8.0);
}

// Wrong: thickness, checks and sheets would follow only when the button is let go, or each pixel
// would be a step of the history.
void TestValuesDock::aDragIsSeenAndIsOneStep()
{
    open(adjustable());
    QCOMPARE(thickness(), 4.0);
    const int before = bench().session().history()->count();
    auto *slider = in<QSlider>("width");
    QVERIFY(slider);
    slider->setSliderDown(true);
    for (const int at : {45, 50, 60}) {
        slider->setSliderPosition(slider->minimum() +
                                  (slider->maximum() - slider->minimum()) * (at - 20) / 60);
        QVERIFY(bench().session().hasPreview());
        const double shown = bench().session().model().document.stocks.front()->thickness;
        QVERIFY2(std::abs(shown - at / 10.0) < 0.06, qPrintable(QString::number(shown)));
        QCOMPARE(thickness(), 4.0);
    }
    slider->setSliderDown(false);
    QVERIFY(!bench().session().hasPreview());
    QCOMPARE(bench().session().history()->count(), before + 1);
    QVERIFY(std::abs(thickness() - 6.0) < 1e-9);
    QVERIFY(std::abs(worth("half") - 30.0) < 1e-9);
    bench().session().history()->undo();
    QCOMPARE(thickness(), 4.0);
}

void TestValuesDock::escapeTakesADragBack()
{
    open(adjustable());
    auto *slider = in<QSlider>("width");
    slider->setFocus();
    slider->setSliderDown(true);
    slider->setSliderPosition(slider->maximum());
    QVERIFY(bench().session().hasPreview());
    QTest::keyClick(slider, Qt::Key_Escape);
    QVERIFY(!bench().session().hasPreview());
    QCOMPARE(worth("width"), 40.0);
}

// Wrong: a file with a circle would show a row without a number and without a reason.
void TestValuesDock::aRowSaysWhatIsWrongWithIt()
{
    open(withValue(withValue(newDocument(), "a", "b + 1 mm"), "b", "a"));
    QVERIFY2(problem("a").contains(u'→'), qPrintable(problem("a")));
    type(in<NumberEdit>("b"), QStringLiteral("3"));
    QCOMPARE(worth("a"), 4.0);
    QCOMPARE(problem("a"), QString());
}

void TestValuesDock::renamingFollowsEverywhere()
{
    open(adjustable());
    ValueRow *of = row("width");
    auto *name = of->findChild<QLineEdit *>(QStringLiteral("valueName"));
    type(name, QStringLiteral("span"));
    QCOMPARE(document().values.find(std::string_view("half"))->typed, std::string("span/2"));
    QCOMPARE(thickness(), 4.0);
    type(name, QStringLiteral("half")); // taken
    auto *problem = of->findChild<QLabel *>(QStringLiteral("valueProblem"));
    QVERIFY(problem->isVisible() && problem->text().endsWith(u'.'));
    QVERIFY(document().values.find(std::string_view("span")));
}

// Wrong: who wrote "my gap" lost both words.
void TestValuesDock::aNameOfTwoWords()
{
    open(adjustable());
    type(row("width")->findChild<QLineEdit *>(QStringLiteral("valueName")),
         QStringLiteral(" my  span "));
    QVERIFY(document().values.find(std::string_view("my_span")));
    QCOMPARE(document().values.find(std::string_view("half"))->typed, std::string("my_span/2"));
}

// Wrong: what was typed was gone, and the reason stayed for good.
void TestValuesDock::whatWasRefusedIsMended()
{
    open(adjustable());
    ValueRow *of = row("width");
    auto *name = of->findChild<QLineEdit *>(QStringLiteral("valueName"));
    auto *problem = of->findChild<QLabel *>(QStringLiteral("valueProblem"));
    type(name, QStringLiteral("2gether"));
    QCOMPARE(name->text(), QStringLiteral("2gether"));
    QVERIFY(problem->isVisible());
    QTest::keyClick(name, Qt::Key_Home);
    QTest::keyClick(name, Qt::Key_Delete);
    QVERIFY(!problem->isVisible());
    QTest::keyClick(name, Qt::Key_Return);
    QVERIFY(document().values.find(std::string_view("gether")));
    auto *number = in<NumberEdit>("gether");
    type(name, QStringLiteral("half")); // taken
    QVERIFY(problem->isVisible());
    number->setFocus(); // given up
    QTRY_COMPARE(name->text(), QStringLiteral("gether"));
    type(in<NumberEdit>("gether"), QStringLiteral("44"));
    QVERIFY(!problem->isVisible());
}

void TestValuesDock::tabGoesFromTheNameToTheNumber()
{
    open(newDocument());
    activate();
    QTest::mouseClick(dock().findChild<QPushButton *>(QStringLiteral("valueAdd")), Qt::LeftButton);
    auto *name = qobject_cast<QLineEdit *>(m_window->focusWidget());
    QVERIFY(name);
    QTest::keyClicks(name, QStringLiteral("gap"));
    QTest::keyClick(name, Qt::Key_Tab);
    QVERIFY(row("gap"));
    QCOMPARE(m_window->focusWidget(), in<NumberEdit>("gap"));
    QTest::keyClicks(m_window->focusWidget(), QStringLiteral("12"));
    QTest::keyClick(m_window->focusWidget(), Qt::Key_Tab);
    QCOMPARE(worth("gap"), 12.0);
}

void TestValuesDock::removingSaysHowMany()
{
    open(adjustable());
    auto *remove = detail<QPushButton>("width", "valueDelete");
    QVERIFY(remove);
    QTest::mouseClick(remove, Qt::LeftButton);
    QVERIFY(!row("width"));
    QCOMPARE(worth("half"), 20.0);
    QCOMPARE(thickness(), 4.0);
    QCOMPARE(bench().interaction().hint().words.count.value_or(0), 2);
}

void TestValuesDock::kindsHaveTheirEditors()
{
    Document document = withValue(newDocument(), "boards", "3", ValueKind::Count);
    document = withValue(std::move(document), "curved", "yes", ValueKind::Switch);
    document = withValue(std::move(document), "words", "Hello", ValueKind::Text);
    Value wood;
    wood.name = "wood";
    wood.kind = ValueKind::Choice;
    wood.choices = {"oak", "a very long name of a wood", "beech"};
    wood.typed = "oak";
    document = addValue(std::move(document), wood).value();
    open(document);
    QTest::keyClick(in<NumberEdit>("boards"), Qt::Key_Up);
    QTRY_COMPARE(worth("boards"), 4.0);
    in<QCheckBox>("curved")->click();
    QCOMPARE(worth("curved"), 0.0);
    type(in<QLineEdit>("words"), QStringLiteral("{boards} boards"));
    const auto text = [this](const char *name) {
        const Model &model = bench().session().committed();
        return model.evaluation.values.worth(idOf(model.document, name))->text;
    };
    QCOMPARE(text("words"), std::string("4 boards"));
    auto *box = in<ChoiceBox>("wood");
    QVERIFY(box);
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Down);
    box->activated(2);
    QCOMPARE(text("wood"), std::string("beech"));
}

void TestValuesDock::rangesMakeSliders()
{
    open(withValue(newDocument(), "gap", "12 mm"));
    QVERIFY(!in<QSlider>("gap"));
    type(detail<QLineEdit>("gap", "valueLeast"), QStringLiteral("1 cm"));
    QVERIFY(!in<QSlider>("gap"));
    type(detail<QLineEdit>("gap", "valueMost"), QStringLiteral("20"));
    QVERIFY(in<QSlider>("gap"));
    QCOMPARE(*document().values.list[0]->value.range.least, 10.0);
    QCOMPARE(*document().values.list[0]->value.range.most, 20.0);
    type(detail<QLineEdit>("gap", "valueMost"), QStringLiteral("11 mm")); // it is 12
    QVERIFY2(problem("gap").endsWith(u'.'), qPrintable(problem("gap")));
    QCOMPARE(*document().values.list[0]->value.range.most, 20.0);
    type(detail<QLineEdit>("gap", "valueMost"), QStringLiteral("2 kg"));
    QVERIFY(!problem("gap").isEmpty());
    type(detail<QLineEdit>("gap", "valueStep"), QStringLiteral("-5 mm"));
    QVERIFY(!problem("gap").isEmpty());
    QVERIFY(!document().values.list[0]->value.range.step);
}

void TestValuesDock::aHoveredRowLightsWhatFollows()
{
    open(adjustable());
    QEnterEvent enter({5, 5}, {5, 5}, {5, 5});
    QApplication::sendEvent(row("width"), &enter);
    QCOMPARE(bench().outlined().size(), document().sections.size());
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(row("width"), &leave);
    QVERIFY(bench().outlined().empty());
    QApplication::sendEvent(row("half"), &enter);
    QVERIFY(bench().outlined().empty());
}

void TestValuesDock::theNoteIsItsTip()
{
    open(withValue(newDocument(), "gap", "12 mm"));
    type(detail<QLineEdit>("gap", "valueNote"), QStringLiteral("between two boards"));
    QCOMPARE(row("gap")->toolTip(), QStringLiteral("between two boards"));
}

void TestValuesDock::undoBringsRowsBack()
{
    open(adjustable());
    QTest::mouseClick(detail<QPushButton>("half", "valueDelete"), Qt::LeftButton);
    QVERIFY(!row("half"));
    bench().session().history()->undo();
    QVERIFY(row("half"));
    QVERIFY(in<NumberEdit>("half")->follows());
}

FFF_TEST_WITH(TestValuesDock, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    installTranslations(application);
    TestValuesDock test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_values_dock.moc"
