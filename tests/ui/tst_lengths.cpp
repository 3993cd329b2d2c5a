// Lengths as people read and type them.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/test_program.h"
#include "ui/base/expression.h"
#include "ui/base/lengths.h"
#include "ui/bench/measures.h"

#include <QTemporaryDir>

#include <cmath>

using namespace fff::ui;

class TestLengths : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { Settings::setFile(m_folder.filePath(QStringLiteral("settings.ini"))); }
    void cleanup() { settings().setUnit(LengthUnit::Millimetre); }

    void whatIsTyped_data();
    void whatIsTyped();
    void whatIsRefusedSaysWhy_data();
    void whatIsRefusedSaysWhy();
    void numbersTakeSumsToo_data();
    void numbersTakeSumsToo();
    void whatIsShownIsReadBack_data();
    void whatIsShownIsReadBack();
    void sizesFollowTheUnit();

private:
    QTemporaryDir m_folder;
};

void TestLengths::whatIsTyped_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<LengthUnit>("unit");
    QTest::addColumn<QLocale::Language>("language");
    QTest::addColumn<double>("mm"); // nan: no length
    const auto mm = LengthUnit::Millimetre, cm = LengthUnit::Centimetre, in = LengthUnit::Inch;
    const auto english = QLocale::English, german = QLocale::German;
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

void TestLengths::whatIsTyped()
{
    QFETCH(QString, text);
    QFETCH(LengthUnit, unit);
    QFETCH(QLocale::Language, language);
    QFETCH(double, mm);
    const std::optional<double> length = readLength(text, unit, QLocale(language), 4.0).value;
    QCOMPARE(length.has_value(), !std::isnan(mm));
    if (length)
        QVERIFY2(std::abs(*length - mm) < 1e-9, qPrintable(QString::number(*length)));
}

void TestLengths::whatIsRefusedSaysWhy_data()
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
    row("an open sum", "3 +", Fault::Unfinished, "3 +");
    row("an open parenthesis", "(3 + 4", Fault::OpenParenthesis, "");
    row("a parenthesis too many", "3 + 4)", Fault::LooseParenthesis, ")");
    row("nothing to divide by", "3/(2 - 2)", Fault::DivisionByZero, "");
    row("an area", "2mm * 3mm", Fault::NotALength, "");
    row("the thickness of nothing", "3*t", Fault::NoThickness, "");
}

// Wrong: a field that jumps back without a word leaves one guessing what it did not like.
void TestLengths::whatIsRefusedSaysWhy()
{
    QFETCH(QString, text);
    QFETCH(int, fault);
    QFETCH(QString, piece);
    const Expression read = readLength(text, LengthUnit::Millimetre, QLocale::c());
    QVERIFY(!read.value);
    QCOMPARE(static_cast<int>(read.fault), fault);
    if (!piece.isEmpty())
        QCOMPARE(read.piece, piece);
    QVERIFY(!refusalText(read).isEmpty());
}

void TestLengths::numbersTakeSumsToo_data()
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
void TestLengths::numbersTakeSumsToo()
{
    QFETCH(QString, text);
    QFETCH(QString, sign);
    QFETCH(double, number);
    const std::optional<double> read = readNumber(text, sign, QLocale::c()).value;
    QCOMPARE(read.has_value(), !std::isnan(number));
    if (read)
        QCOMPARE(*read, number);
}

void TestLengths::whatIsShownIsReadBack_data()
{
    QTest::addColumn<LengthUnit>("unit");
    QTest::addColumn<QLocale::Language>("language");
    for (const auto unit : {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Inch}) {
        for (const auto language : {QLocale::English, QLocale::German, QLocale::French}) {
            QTest::addRow("%s in %s", qPrintable(unitName(unit)),
                          qPrintable(QLocale::languageToString(language)))
                << unit << language;
        }
    }
}

// A field that reads something else than it wrote changes models by itself.
void TestLengths::whatIsShownIsReadBack()
{
    QFETCH(LengthUnit, unit);
    QFETCH(QLocale::Language, language);
    settings().setUnit(unit);
    QLocale locale(language);
    locale.setNumberOptions(QLocale::OmitGroupSeparator); // as the fields do
    for (double mm : {0.0, 3.0, 3.175, -0.5, 12.7, 999.999, 1000.0, -123456.789}) {
        const QString text = lengthText(mm, 2, 3, locale);
        const std::optional<double> back = readLength(text, LengthUnit::Millimetre, locale).value;
        QVERIFY2(back, qPrintable(text));
        const double digit = unit == LengthUnit::Inch ? 0.0001 * 25.4 : 0.001;
        QVERIFY2(std::abs(*back - mm) < 0.51 * digit, qPrintable(text));
    }
}

void TestLengths::sizesFollowTheUnit()
{
    const QLocale english(QLocale::English);
    QCOMPARE(sizeText({327, 155, 96}, 0, english), QStringLiteral("327 × 155 × 96\u202fmm"));
    settings().setUnit(LengthUnit::Centimetre);
    QCOMPARE(sizeText({327, 155, 96}, 0, english), QStringLiteral("32.7 × 15.5 × 9.6\u202fcm"));
    settings().setUnit(LengthUnit::Inch);
    QCOMPARE(sizeText({327, 155, 96}, 0, english), QStringLiteral("12.9 × 6.1 × 3.8\u202fin"));
    QCOMPARE(lengthText(3.175, 2, 3, english), QStringLiteral("0.125\u202fin"));
}

FFF_TEST(TestLengths)
#include "tst_lengths.moc"
