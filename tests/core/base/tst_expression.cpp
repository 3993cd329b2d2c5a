// What people type into number fields.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/base/expression.h"
#include "tests/test_program.h"

#include <cmath>

using namespace fff;

class TestExpression : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsTyped_data();
    void whatIsTyped();
    void whatIsRefusedSaysWhy_data();
    void whatIsRefusedSaysWhy();
    void numbersTakeSumsToo_data();
    void numbersTakeSumsToo();
    void namesStandForLengthsAndNumbers();
    void massesHaveUnitsOfTheirOwn();
    void blanksOfPrintAreBlanks();
    void aThousandParenthesesAreRefused_data();
    void aThousandParenthesesAreRefused();
};

void TestExpression::whatIsTyped_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("unit"); // mm
    QTest::addColumn<Commas>("commas");
    QTest::addColumn<double>("mm"); // nan: no length
    const double mm = 1.0, cm = 10.0, in = 25.4;
    const Commas english = Commas::Groups, german = Commas::Decimals;
    const double none = std::nan("");
    QTest::newRow("a number has the unit that is set") << "3" << mm << english << 3.0;
    QTest::newRow("also centimetres") << "3" << cm << english << 30.0;
    QTest::newRow("also inches") << "0.5" << in << english << 12.7;
    QTest::newRow("a unit behind it counts") << "2.5cm" << mm << english << 25.0;
    QTest::newRow("a fraction of an inch") << "1/2 in" << mm << english << 12.7;
    QTest::newRow("a fraction in the unit that is set") << "1/8" << in << english << 3.175;
    QTest::newRow("a mixed number") << "1 1/2 in" << mm << english << 38.1;
    QTest::newRow("an inch mark") << "3\"" << mm << english << 76.2;
    QTest::newRow("a product") << "3*25.4" << mm << english << 76.2;
    QTest::newRow("a product with a length") << "3*2cm" << mm << english << 60.0;
    QTest::newRow("units mixed in a sum") << "1in + 5" << mm << english << 30.4;
    QTest::newRow("a fraction of a length") << "2.5cm/2" << mm << english << 12.5;
    QTest::newRow("parentheses") << "(10 + 2.5) / 2" << mm << english << 6.25;
    QTest::newRow("products before sums") << "2 + 3 * 4" << mm << english << 14.0;
    QTest::newRow("from left to right") << "8 / 4 / 2" << mm << english << 1.0;
    QTest::newRow("the real minus sign") << QStringLiteral("\u22124.5") << mm << english << -4.5;
    QTest::newRow("the thickness") << "3*t" << mm << english << 12.0;
    QTest::newRow("a German comma") << "2,5" << mm << german << 2.5;
    QTest::newRow("a point typed by a German") << "3.175" << mm << german << 3.175;
    QTest::newRow("an English thousand") << "1,000" << mm << english << 1000.0;
    QTest::newRow("a German thousand") << "1.234,5" << mm << german << 1234.5;
    QTest::newRow("nothing") << "" << mm << english << none;
    QTest::newRow("an open sum") << "3 +" << mm << english << none;
    QTest::newRow("an area") << "2mm * 3mm" << mm << english << none;
    QTest::newRow("nothing divided by nothing") << "1/0" << mm << english << none;
    QTest::newRow("another unit") << "3 kg" << mm << english << none;
    QTest::newRow("two units") << "3 mm cm" << mm << english << none;
    QTest::newRow("two numbers") << "3 4" << mm << english << none;
    QTest::newRow("an open parenthesis") << "(3" << mm << english << none;
}

void TestExpression::whatIsTyped()
{
    QFETCH(QString, text);
    QFETCH(double, unit);
    QFETCH(Commas, commas);
    QFETCH(double, mm);
    const std::optional<double> length = readLength(text.toStdString(), unit, commas, 4.0).value;
    QCOMPARE(length.has_value(), !std::isnan(mm));
    if (length)
        QVERIFY2(std::abs(*length - mm) < 1e-9, qPrintable(QString::number(*length)));
}

void TestExpression::whatIsRefusedSaysWhy_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("fault");
    QTest::addColumn<QString>("piece");
    const auto row = [](const char *says, const char *text, Expression::Fault fault,
                        const char *piece) {
        QTest::newRow(says) << QString::fromUtf8(text) << static_cast<int>(fault)
                            << QString::fromUtf8(piece);
    };
    using Fault = Expression::Fault;
    row("blanks", "  ", Fault::Empty, "");
    row("another unit", "3 kg", Fault::Unreadable, "kg");
    row("a word", "three", Fault::Unreadable, "three");
    row("a word that begins with t", "3*thick", Fault::Unreadable, "thick");
    row("a sign that is none", "3 # 4", Fault::Unreadable, "#");
    row("a word of another language", "3 Stück", Fault::Unreadable, "Stück");
    row("a word of another script", "3*長さ + 1", Fault::Unreadable, "長さ");
    row("half a number", "3.4.5", Fault::Unreadable, "3");
    row("more than any number", qPrintable(QString(400, u'9')), Fault::Unreadable,
        qPrintable(QString(400, u'9')));
    row("an open sum", "3 +", Fault::Unfinished, "3 +");
    row("an open parenthesis", "(3 + 4", Fault::OpenParenthesis, "");
    row("a parenthesis too many", "3 + 4)", Fault::LooseParenthesis, ")");
    row("nothing to divide by", "3/(2 - 2)", Fault::DivisionByZero, "");
    row("an area", "2mm * 3mm", Fault::NotALength, "");
    row("the thickness of nothing", "3*t", Fault::NoThickness, "");
}

// Wrong: a field that jumps back without a word leaves one guessing what it did not like.
void TestExpression::whatIsRefusedSaysWhy()
{
    QFETCH(QString, text);
    QFETCH(int, fault);
    QFETCH(QString, piece);
    const Expression read = readLength(text.toStdString(), 1.0, Commas::Groups);
    QVERIFY(!read.value);
    QCOMPARE(static_cast<int>(read.fault), fault);
    QCOMPARE(QString::fromStdString(read.piece), piece);
}

void TestExpression::numbersTakeSumsToo_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("sign");
    QTest::addColumn<double>("number"); // nan: none
    const double none = std::nan("");
    QTest::newRow("a part of a turn") << "360/8"
                                      << "°" << 45.0;
    QTest::newRow("with its sign") << "2*(3+4) °"
                                   << "°" << 14.0;
    QTest::newRow("a sign inside") << "90° - 15°"
                                   << "°" << 75.0;
    QTest::newRow("without any sign") << "1.5*2"
                                      << "" << 3.0;
    QTest::newRow("a length is none") << "3 mm"
                                      << "°" << none;
    QTest::newRow("no thickness in degrees") << "2*t"
                                             << "°" << none;
}

// Wrong: sums that work in one field and not in the one beside it.
void TestExpression::numbersTakeSumsToo()
{
    QFETCH(QString, text);
    QFETCH(QString, sign);
    QFETCH(double, number);
    const std::optional<double> read =
        readNumber(text.toStdString(), sign.toStdString(), Commas::Groups).value;
    QCOMPARE(read.has_value(), !std::isnan(number));
    if (read)
        QCOMPARE(*read, number);
}

void TestExpression::namesStandForLengthsAndNumbers()
{
    const NumberNames names = [](std::string_view name) -> std::optional<NamedValue> {
        if (name == "gap")
            return NamedValue{12.0, true};
        return name == "n" ? std::optional(NamedValue{5.0, false}) : std::nullopt;
    };
    const Expression length = readAny("n*gap + 1", Commas::Groups, names);
    QCOMPARE(length.value.value_or(0.0), 61.0);
    QVERIFY(length.isLength);
    const Expression number = readAny("n + 1", Commas::Groups, names);
    QCOMPARE(number.value.value_or(0.0), 6.0);
    QVERIFY(!number.isLength);
    QVERIFY(readNumber("2*gap", {}, Commas::Groups, names).fault == Expression::Fault::NotALength);
    const Expression unknown = readAny("2*Größe_1", Commas::Groups, names);
    QVERIFY(unknown.fault == Expression::Fault::UnknownName);
    QCOMPARE(unknown.piece, std::string("Größe_1"));
}

// Wrong: what a field itself writes between a number and its unit cannot be read.
void TestExpression::blanksOfPrintAreBlanks()
{
    QCOMPARE(readLength("\u202f2\u00a0cm\t+\u20091", 1.0, Commas::Groups).value.value_or(0.0),
             21.0);
}

void TestExpression::aThousandParenthesesAreRefused_data()
{
    QTest::addColumn<QString>("sign");
    for (const char *sign : {"(", "-", "+", "-("})
        QTest::newRow(sign) << QString::fromUtf8(sign);
}

// Wrong: the expression of a number in a file takes the stack, and the program with it.
void TestExpression::aThousandParenthesesAreRefused()
{
    QFETCH(QString, sign);
    const std::string text = sign.repeated(1'000'000).toStdString() + "1";
    QVERIFY(readAny(text, Commas::Groups).fault == Expression::Fault::Unreadable);
    const std::string few = "1" + std::string(50, '+') + "1 + ((((((((((2))))))))))";
    QCOMPARE(readAny(few, Commas::Groups).value.value_or(0.0), 4.0);
}

void TestExpression::massesHaveUnitsOfTheirOwn()
{
    const auto read = [](const char *text) { return readMass(text, 1e-3, Commas::Groups); };
    for (const auto &[text, kilograms] :
         {std::pair("350", 0.35), std::pair("1.5 kg", 1.5), std::pair("2lb", 0.90718474),
          std::pair("1/2 oz", 0.0141747615625), std::pair("3*45 g", 0.135),
          std::pair("1 kg + 50", 1.05), std::pair("(1 lb - 3 oz) / 2", 0.1842719003125)}) {
        const Expression mass = read(text);
        QVERIFY2(mass.value, text);
        QVERIFY2(std::abs(*mass.value - kilograms) < 1e-9, text);
        QVERIFY(!mass.isLength);
    }
    QVERIFY(read("2 kg * 3 g").fault == Expression::Fault::NotAMass);
    QVERIFY(read("1 kg / 2 kg").value == 0.0005); // a plain number, of grams
    QVERIFY(read("5 mm").fault == Expression::Fault::Unreadable);
    QVERIFY(read("t").fault == Expression::Fault::Unreadable);
    QVERIFY(read("").fault == Expression::Fault::Empty);
    const NumberNames names = [](std::string_view name) {
        return name == "gap" ? std::optional(NamedValue{12.0, true})
                             : std::optional(NamedValue{3.0, false});
    };
    QVERIFY(readMass("gap", 1e-3, Commas::Groups, names).fault == Expression::Fault::NotAMass);
    QCOMPARE(*readMass("n * 2 kg", 1e-3, Commas::Groups, names).value, 6.0);
}

FFF_TEST(TestExpression)
#include "tst_expression.moc"
