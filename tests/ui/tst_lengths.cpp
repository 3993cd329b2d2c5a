// Lengths as people read and type them.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/test_program.h"
#include "ui/base/expression_text.h"
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

    void everyRefusalIsASentence();
    void whatIsShownIsReadBack_data();
    void whatIsShownIsReadBack();
    void sizesFollowTheUnit();

private:
    QTemporaryDir m_folder;
};

// Wrong: a field that jumps back without a word leaves one guessing what it did not like.
void TestLengths::everyRefusalIsASentence()
{
    for (const char *text :
         {"  ", "3 kg", "3 +", "(3 + 4", "3 + 4)", "3/(2 - 2)", "2mm * 3mm", "3*t", "3*gap"}) {
        const fff::Expression read = fff::readLength(text, 1.0, fff::Commas::Groups, {},
                                                     [](std::string_view) { return std::nullopt; });
        QVERIFY2(!read.value && refusalText(read).endsWith(u'.'), text);
        using Fault = fff::Expression::Fault;
        const bool isQuoted = read.fault == Fault::Unreadable || read.fault == Fault::Unfinished ||
                              read.fault == Fault::UnknownName;
        QVERIFY2(!isQuoted || refusalText(read).contains(QString::fromStdString(read.piece)), text);
    }
    QVERIFY(refusalText(fff::readNumber("3", {}, fff::Commas::Groups)).isEmpty());
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
        const std::optional<double> back =
            fff::readLength(text.toStdString(), 1.0, commasOf(locale)).value;
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
