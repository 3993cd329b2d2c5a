// Number fields that follow expressions, as a person types them.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/model/bindings.h"
#include "core/model/dimensions.h"
#include "core/operations/driven.h"
#include "tests/test_program.h"
#include "tests/ui/docks/values_hand.h"
#include "ui/base/translations.h"

#include <QAbstractItemView>
#include <QUndoStack>

#include <cmath>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

class TestFollowedFields : public QObject, private ValuesHand
{
    Q_OBJECT

private Q_SLOTS:
    void init() { begin(); }
    void cleanup() { end(); }

    void theFieldKeepsWhatWasTyped();
    void shiftIsNoLetter();
    void aPlainNumberEndsAnExpression();
    void namesComplete();
    void wrongOnesSayWhyAndChangeNothing();
    void fieldsOfTheModelFollow_data();
    void fieldsOfTheModelFollow();
    void aSectionsSizeFollows();
    void undoIsTheModelsBehindEnter();
    void aDoubleClickTakesAllOfTheNumber();
    void aDimensionStretchesItsSection();
    void whatIsLeftWithoutEnterFollows();
    void ofTwoThingsNoneFollows();
    void escapeTakesItBack();

private:
    static QString shown(const NumberEdit *field)
    {
        return field->isTypingFormula() ? field->formulaTyped() : field->text();
    }
    /// The field of the page of what is selected.
    NumberEdit *field(const char *name)
    {
        for (QWidget *found : m_window->findChildren<QWidget *>(QLatin1String(name))) {
            if (!found->isVisible())
                continue;
            if (auto *number = qobject_cast<NumberEdit *>(found))
                return number;
            if (auto *inside = found->findChild<NumberEdit *>())
                return inside;
        }
        return nullptr;
    }
    /// With the board selected.
    void openBoard()
    {
        open(withValue(shelf(), "gap", "12 mm"));
        dock().close();
        bench().select({SectionRef(document().sections.front()->id)});
        QTRY_VERIFY(field("sectionThickness"));
    }
};

void TestFollowedFields::theFieldKeepsWhatWasTyped()
{
    open(adjustable());
    auto *field = in<NumberEdit>("half");
    auto *mark = field->findChild<QLabel *>(QStringLiteral("followsMark"));
    QVERIFY(mark->isVisible());
    QVERIFY(field->text().startsWith(QStringLiteral("20")));
    activate();
    field->setFocus();
    QTRY_COMPARE(shown(field), QStringLiteral("= width/2"));
    type(field, QStringLiteral("= width/4"));
    QCOMPARE(worth("half"), 10.0);
    QCOMPARE(document().values.find(std::string_view("half"))->typed, std::string("width/4"));
    field = in<NumberEdit>("half");
    QVERIFY2(field->text().startsWith(QStringLiteral("10")), qPrintable(field->text()));
    QVERIFY(field->follows());
}

// Wrong: whoever pressed Shift for a "*" was out of the program.
void TestFollowedFields::shiftIsNoLetter()
{
    open(adjustable());
    auto *half = in<NumberEdit>("half");
    activate();
    half->setFocus();
    half->selectAll();
    const auto press = [this](Qt::Key key, const QString &text = {}) {
        QTest::sendKeyEvent(QTest::Click, m_window->focusWidget(), key, text, Qt::NoModifier);
    };
    press(Qt::Key_Shift);
    press(Qt::Key_Equal, QStringLiteral("="));
    press(Qt::Key_2, QStringLiteral("2"));
    press(Qt::Key_Shift);
    press(Qt::Key_Asterisk, QStringLiteral("*"));
    press(Qt::Key_Control);
    press(Qt::Key_Up);
    for (const QChar letter : QStringLiteral("width"))
        press(Qt::Key_W, QString(letter));
    press(Qt::Key_Shift);
    press(Qt::Key_Return, QStringLiteral("\r"));
    QCOMPARE(document().values.find(std::string_view("half"))->typed, std::string("2*width"));
}

void TestFollowedFields::aPlainNumberEndsAnExpression()
{
    open(adjustable());
    type(in<NumberEdit>("half"), QStringLiteral("20")); // what it is anyway
    QVERIFY(!in<NumberEdit>("half")->follows());
    QCOMPARE(worth("half"), 20.0);
    type(in<NumberEdit>("half"), QStringLiteral("width/5")); // "=" is not needed with a name
    QVERIFY(in<NumberEdit>("half")->follows());
    type(in<NumberEdit>("half"), QStringLiteral("33"));
    QVERIFY(!in<NumberEdit>("half")->follows());
    QCOMPARE(worth("half"), 33.0);
}

void TestFollowedFields::namesComplete()
{
    open(adjustable());
    auto *field = in<NumberEdit>("half");
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("= 2*wi"));
    auto *list = [this]() -> QAbstractItemView * {
        for (QWidget *widget : QApplication::topLevelWidgets())
            if (widget->objectName() == QStringLiteral("nameList") && widget->isVisible())
                return qobject_cast<QAbstractItemView *>(widget);
        return nullptr;
    }();
    QVERIFY(list);
    QCOMPARE(list->currentIndex().data().toString(), QStringLiteral("width"));
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(shown(field), QStringLiteral("= 2*width"));
    QVERIFY(!list->isVisible());
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(worth("half"), 80.0);
}

void TestFollowedFields::wrongOnesSayWhyAndChangeNothing()
{
    open(adjustable());
    const Document before = document();
    for (const char *text :
         {"= width*width", "= nothing", "= 2*(width", "= half", "= half + width"}) {
        auto *field = in<NumberEdit>("half");
        QString why;
        const auto told = QObject::connect(field, &NumberEdit::refused,
                                           [&why](const QString &reason) { why = reason; });
        type(field, QLatin1String(text));
        QObject::disconnect(told);
        QVERIFY2(why.endsWith(u'.'), text);
        QVERIFY2(document().isSame(before), text);
        QCOMPARE(shown(field), QLatin1String(text)); // to be mended
        QTest::keyClick(field, Qt::Key_Escape);
    }
}

void TestFollowedFields::fieldsOfTheModelFollow_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("key");
    QTest::addColumn<double>("is");      // mm, radians
    QTest::addColumn<double>("becomes"); // with gap = 20 mm
    QTest::newRow("stock") << QByteArray("sectionThickness") << QStringLiteral("= gap/3")
                           << QStringLiteral("stock/%1/thickness") << 4.0 << 20.0 / 3.0;
    QTest::newRow("place") << QByteArray("positionX") << QStringLiteral("= 2*gap")
                           << QStringLiteral("section/%1/x") << 24.0 << 40.0;
    QTest::newRow("hole") << QByteArray("figure1.diameter") << QStringLiteral("gap")
                          << QStringLiteral("figure/%1/1/diameter") << 12.0 << 20.0;
    QTest::newRow("its place") << QByteArray("figure1.x") << QStringLiteral("= 3*gap")
                               << QStringLiteral("figure/%1/1/centreX") << 36.0 << 60.0;
    QTest::newRow("letters") << QByteArray("mark0.height") << QStringLiteral("= gap/2")
                             << QStringLiteral("lettering/%1/0/height") << 6.0 << 10.0;
}

// Wrong: a name is understood once and forgotten.
void TestFollowedFields::fieldsOfTheModelFollow()
{
    QFETCH(QByteArray, name);
    QFETCH(QString, typed);
    QFETCH(QString, key);
    QFETCH(double, is);
    QFETCH(double, becomes);
    openBoard();
    const auto of = key.startsWith(QStringLiteral("stock")) ? document().stocks.front()->id.value
                                                            : document().sections.front()->id.value;
    const std::string place = key.arg(of).toStdString();
    QTRY_VERIFY2(field(name.constData()), name.constData()); // rows are shown when laid out
    type(field(name.constData()), typed);
    QVERIFY(bindingOf(document(), at(document(), place)));
    QVERIFY(std::abs(numberAt(document(), place) - is) < 1e-9);
    auto *mark = field(name.constData())->findChild<QLabel *>(QStringLiteral("followsMark"));
    QVERIFY(field(name.constData())->follows());
    QTRY_VERIFY(mark->isVisible());
    const int steps = bench().session().history()->count();
    bench().run(QStringLiteral("value.set"), {{"name", "gap"}, {"expression", "20 mm"}});
    QCOMPARE(bench().session().history()->count(), steps + 1);
    QVERIFY(std::abs(numberAt(document(), place) - becomes) < 1e-9);
    type(field(name.constData()), QStringLiteral("7"));
    QVERIFY(!bindingOf(document(), at(document(), place)));
    QVERIFY(std::abs(numberAt(document(), place) - 7.0) < 1e-9);
    QTRY_VERIFY(!mark->isVisible());
    bench().session().history()->undo();
    QVERIFY(bindingOf(document(), at(document(), place)));
    QVERIFY(field(name.constData())->follows());
    QTRY_VERIFY(mark->isVisible());
}

// Drawn contours follow, too, and are stretched by plain numbers.
void TestFollowedFields::aSectionsSizeFollows()
{
    openBoard();
    QTRY_VERIFY(field("sectionWidth") && field("sectionHeight"));
    const auto size = [this] { return document().sections.front()->shape->bounds().size(); };
    const Vec2 before = size();
    const Document was = document();
    type(field("sectionWidth"), QStringLiteral("150"));
    QVERIFY((size() - Vec2(150, before.y())).norm() < 1e-9);
    bench().session().history()->undo();
    QVERIFY(document() == was);
    type(field("sectionHeight"), QStringLiteral("= 5*gap"));
    QVERIFY((size() - Vec2(before.x(), 60)).norm() < 1e-9);
    QVERIFY(field("sectionHeight")->follows());
    bench().run(QStringLiteral("value.set"), {{"name", "gap"}, {"expression", "10 mm"}});
    QVERIFY((size() - Vec2(before.x(), 50)).norm() < 1e-9);
    QTRY_VERIFY(field("sectionHeight")->text().startsWith(QStringLiteral("50")));
    // Of two there is none to be typed, and what they do not have in common is not shown.
    bench().select(
        {SectionRef(document().sections[0]->id), SectionRef(document().sections[1]->id)});
    QTRY_VERIFY(!field("sectionWidth")->isEnabled());
}

// Wrong: the field kept the focus and took Ctrl+Z for its own text.
void TestFollowedFields::undoIsTheModelsBehindEnter()
{
    openBoard();
    QTRY_VERIFY(field("sectionWidth"));
    const Document was = document();
    type(field("sectionWidth"), QStringLiteral("150"));
    QVERIFY(!(document() == was));
    activate();
    QKeyEvent key(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
    key.ignore();
    QCoreApplication::sendEvent(field("sectionWidth"), &key);
    QVERIFY(!key.isAccepted());
    QTest::keyClicks(field("sectionWidth"), QStringLiteral("9"));
    QCoreApplication::sendEvent(field("sectionWidth"), &key);
    QVERIFY(key.isAccepted()); // of what is being typed
}

// Wrong: in 340.0 the digit behind the point was taken for a word, and 400 became 340.4.
void TestFollowedFields::aDoubleClickTakesAllOfTheNumber()
{
    openBoard();
    QTRY_VERIFY(field("sectionWidth"));
    activate();
    auto *line =
        field("sectionWidth")->findChild<QLineEdit *>(QStringLiteral("qt_spinbox_lineedit"));
    QTest::mouseDClick(line, Qt::LeftButton, {}, QPoint(20, line->height() / 2));
    QVERIFY(line->selectedText().startsWith(QStringLiteral("200.0")));
    QTest::keyClicks(field("sectionWidth"), QStringLiteral("170"));
    QTest::keyClick(field("sectionWidth"), Qt::Key_Return);
    QVERIFY(std::abs(document().sections.front()->shape->bounds().size().x() - 170.0) < 1e-9);
}

// And what stands on the section can be told how to follow, once there is something to follow.
void TestFollowedFields::aDimensionStretchesItsSection()
{
    Document measured = withValue(shelf(), "gap", "12 mm");
    const SectionRef board = measured.sections[0]->ref(), rib = measured.sections[1]->ref();
    measured = addDimension(measured, {board, {0, 0, 0}}, {board, {90, 0, 0}}).value();
    measured = addDimension(measured, {board, {0, 0, 0}}, {rib, {0, 0, 0}}).value();
    open(measured);
    dock().close();
    const auto holding = [this] {
        return m_window->findChild<QWidget *>(QStringLiteral("sectionHoldsTo"))->isVisible();
    };
    bench().select({rib});
    QVERIFY(!holding());
    bench().select({});
    QTRY_VERIFY(field("dimension0"));
    type(field("dimension0"), QStringLiteral("= 10*gap"));
    const auto width = [this](std::size_t section) {
        return document().sections[section]->shape->bounds().size().x();
    };
    QVERIFY(std::abs(width(0) - 230.0) < 1e-9);
    QCOMPARE(width(1), 60.0);
    QVERIFY(field("dimension0")->follows());
    bench().select({rib});
    QTRY_VERIFY(holding());
    bench().run(QStringLiteral("section.holdTo"), {{"end", "right"}});
    QVERIFY(document().sections[1]->parent->holdsTo == HoldsTo::Right);
    // From one section to another one it is the size of the model, as ever.
    bench().select({});
    QTRY_VERIFY(field("dimension1"));
    type(field("dimension1"), QString::number(2 * field("dimension1")->value()));
    QVERIFY(std::abs(width(1) - 120.0) < 1e-6);
}

void TestFollowedFields::whatIsLeftWithoutEnterFollows()
{
    openBoard();
    auto *thickness = field("sectionThickness");
    thickness->setFocus();
    thickness->selectAll();
    QTest::keyClicks(thickness, QStringLiteral("= gap/5"));
    activate();
    field("positionX")->setFocus();
    QVERIFY(std::abs(document().stocks.front()->thickness - 2.4) < 1e-9);
    QTRY_VERIFY(thickness->follows());
    QVERIFY2(thickness->text().endsWith(QStringLiteral("mm")), qPrintable(thickness->text()));
}

void TestFollowedFields::ofTwoThingsNoneFollows()
{
    openBoard();
    bench().select(
        {SectionRef(document().sections[0]->id), SectionRef(document().sections[1]->id)});
    auto *place = field("positionX");
    QString why;
    QObject::connect(place, &NumberEdit::refused, [&why](const QString &reason) { why = reason; });
    const Document before = document();
    type(place, QStringLiteral("= gap"));
    QVERIFY(why.endsWith(u'.'));
    QVERIFY(document().isSame(before));
}

void TestFollowedFields::escapeTakesItBack()
{
    openBoard();
    auto *thickness = field("sectionThickness");
    type(thickness, QStringLiteral("= gap/4"));
    activate();
    QTest::mouseClick(thickness->findChild<QLineEdit *>(), Qt::LeftButton);
    QCOMPARE(shown(thickness), QStringLiteral("= gap/4"));
    QTest::keyClicks(thickness, QStringLiteral("00"));
    QTest::keyClick(thickness, Qt::Key_Escape);
    QVERIFY(thickness->follows());
    QVERIFY2(thickness->text().startsWith(QStringLiteral("3")), qPrintable(thickness->text()));
    QVERIFY(std::abs(document().stocks.front()->thickness - 3.0) < 1e-9);
}

FFF_TEST_WITH(TestFollowedFields, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    installTranslations(application);
    TestFollowedFields test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_followed_fields.moc"
