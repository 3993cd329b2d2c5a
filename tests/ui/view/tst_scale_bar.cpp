#include <QTest>

#include "tests/test_program.h"
#include "ui/view/scale_bar.h"

using namespace fff::ui;

class TestScaleBar : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void stepsAreRound_data()
    {
        QTest::addColumn<int>("unit");
        QTest::addColumn<double>("longest");
        QTest::addColumn<double>("length");
        QTest::addColumn<QString>("text");
        const auto row = [](const char *says, LengthUnit unit, double longest, double length,
                            const char *text) {
            QTest::newRow(says) << static_cast<int>(unit) << longest << length
                                << QString::fromUtf8(text).replace(u' ', QChar(0x202f));
        };
        const auto mm = LengthUnit::Millimetre, cm = LengthUnit::Centimetre, in = LengthUnit::Inch;
        row("just below the next step", mm, 99.0, 50.0, "50 mm");
        row("just the step", mm, 20.0, 20.0, "20 mm");
        row("parts of a millimetre", mm, 0.7, 0.5, "0.5 mm");
        row("metres", mm, 60000.0, 50000.0, "50 m");
        row("centimetres are the same lengths", cm, 99.0, 50.0, "5 cm");
        row("parts of a centimetre", cm, 3.0, 2.0, "0.2 cm");
        row("metres beside centimetres", cm, 25000.0, 20000.0, "20 m");
        row("an eighth", in, 5.0, 25.4 / 8, "1/8 in");
        row("a quarter", in, 7.0, 25.4 / 4, "1/4 in");
        row("a half", in, 25.0, 25.4 / 2, "1/2 in");
        row("one inch, just reached", in, 25.4, 25.4, "1 in");
        row("two inches", in, 100.0, 50.8, "2 in");
        row("five inches", in, 200.0, 127.0, "5 in");
        row("a hundred inches", in, 119.0 * 25.4, 2540.0, "100 in");
        row("feet", in, 121.0 * 25.4, 10.0 * 304.8, "10 ft");
        row("the finest fraction", in, 0.5, 25.4 / 64, "1/64 in");
        row("thousandths", in, 0.3, 0.254, "0.01 in");
        row("a few thousandths", in, 0.06, 0.0508, "0.002 in");
    }

    /// A bar of 17.3 mm, or of decimals that no inch ruler has, measures nothing.
    void stepsAreRound()
    {
        QFETCH(int, unit);
        QFETCH(double, longest);
        QFETCH(double, length);
        QFETCH(QString, text);
        const ScaleBar bar = scaleBar(longest, static_cast<LengthUnit>(unit), QLocale::c());
        QVERIFY2(std::abs(bar.length - length) < 1e-9 * length, qPrintable(bar.text));
        QCOMPARE(bar.text, text);
    }

    /// Zooming in would make the bar jump back, leave its place or vanish.
    void theBarFillsItsPlaceAtEveryZoom()
    {
        for (const LengthUnit unit :
             {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Inch}) {
            double before = 0.0;
            for (double longest = 1e-3; longest < 1e6; longest *= 1.03) {
                const double length = scaleBar(longest, unit, QLocale::c()).length;
                QVERIFY2(length <= longest * (1.0 + 1e-6) && length > 0.3 * longest,
                         qPrintable(QString::number(longest)));
                QVERIFY(length >= before);
                before = length;
            }
        }
    }

    /// German reads "0.5" as a typing error.
    void numbersAreOfTheLocale()
    {
        QCOMPARE(scaleBar(0.7, LengthUnit::Millimetre, QLocale(QLocale::German)).text,
                 QStringLiteral("0,5\u202fmm"));
    }
};

FFF_TEST(TestScaleBar)
#include "tst_scale_bar.moc"
