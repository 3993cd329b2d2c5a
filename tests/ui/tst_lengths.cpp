// Lengths as people read and type them.
#include <QTest> // first: moc stumbles over some standard headers

#include "ui/lengths.h"
#include "ui/measures.h"

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
    const std::optional<double> length = parseLength(text, unit, QLocale(language), 4.0);
    QCOMPARE(length.has_value(), !std::isnan(mm));
    if (length)
        QVERIFY2(std::abs(*length - mm) < 1e-9, qPrintable(QString::number(*length)));
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
        const std::optional<double> back = parseLength(text, LengthUnit::Millimetre, locale);
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

QTEST_GUILESS_MAIN(TestLengths)
#include "tst_lengths.moc"
