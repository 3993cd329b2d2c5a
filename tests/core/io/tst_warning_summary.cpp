// What a reader mended, said in few words. If this fails, a person who opens an old model reads a
// page of lines, or is not told that something is missing.
#include "core/io/warning_summary.h"
#include "tests/test_program.h"

#include <QtTest/QtTest>

using namespace fff;
using io::warningSummary;

namespace {

constexpr int kCodes = static_cast<int>(WarningCode::LostBinding) + 1;

Warning mended(int code, const char *name, int line)
{
    return {static_cast<WarningCode>(code), "a.txt:" + std::to_string(line), {name}};
}

} // namespace

class TestWarningSummary : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingIsSaidOfNothing();
    void manyOfAKindAreOneSentence();
    void oneIsCalledByItsName();
    void aNameKeepsItsSmallLetter();
    void kindsComeInTheOrderOfTheFile();
    void eachLineIsThere();
};

void TestWarningSummary::nothingIsSaidOfNothing()
{
    QVERIFY(warningSummary({}).isEmpty());
    QVERIFY(io::warningLines({}).isEmpty());
}

/// Of every kind: the count stands in it, and it is a sentence.
void TestWarningSummary::manyOfAKindAreOneSentence()
{
    for (int code = 0; code < kCodes; ++code) {
        std::vector<Warning> warnings;
        for (int i = 0; i < 37; ++i)
            warnings.push_back(mended(code, "Rib", i));
        const QStringList said = warningSummary(warnings);
        QCOMPARE(said.size(), 1);
        QVERIFY2(said.front().contains(QStringLiteral("37 ")), qPrintable(said.front()));
        QVERIFY2(said.front().endsWith(u'.') &&
                     said.front().front().isUpper() == said.front().front().isLetter(),
                 qPrintable(said.front()));
    }
    QCOMPARE(
        warningSummary(std::vector{mended(0, "Rib", 3), mended(0, "Fin", 9)}),
        QStringList(QStringLiteral("2 sections were slightly skewed and have been straightened.")));
}

void TestWarningSummary::oneIsCalledByItsName()
{
    QCOMPARE(warningSummary(std::vector{mended(0, "Rib", 3)}),
             QStringList(QStringLiteral("Rib was slightly skewed and has been straightened.")));
    QCOMPARE(
        warningSummary(std::vector{Warning{WarningCode::SkewFrame, "a.txt:3", {}}}),
        QStringList(QStringLiteral("A section was slightly skewed and has been straightened.")));
}

void TestWarningSummary::aNameKeepsItsSmallLetter()
{
    QCOMPARE(io::wholeSentence(mended(0, "rib %1", 3)),
             QStringLiteral("rib %1 was slightly skewed and has been straightened."));
}

/// Each kind once, where it is met first.
void TestWarningSummary::kindsComeInTheOrderOfTheFile()
{
    const int hole = static_cast<int>(WarningCode::HoleOutside);
    const QStringList said = warningSummary(
        std::vector{mended(hole, "Fin", 1), mended(0, "Rib", 3), mended(hole, "Rib", 5)});
    QCOMPARE(said.size(), 2);
    QVERIFY2(said[0].startsWith(QStringLiteral("2 holes ")), qPrintable(said[0]));
    QVERIFY2(said[1].startsWith(QStringLiteral("Rib ")), qPrintable(said[1]));
}

void TestWarningSummary::eachLineIsThere()
{
    std::vector<Warning> warnings;
    for (int i = 1; i <= 50; ++i)
        warnings.push_back(mended(i % kCodes, "Rib", i));
    const QStringList lines = io::warningLines(warnings);
    QCOMPARE(lines.size(), 50);
    for (int i = 1; i <= 50; ++i)
        QVERIFY2(lines[i - 1].startsWith(QStringLiteral("a.txt:%1: ").arg(i)),
                 qPrintable(lines[i - 1]));
}

FFF_TEST(TestWarningSummary)
#include "tst_warning_summary.moc"
