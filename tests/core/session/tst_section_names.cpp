// Names of sections in sentences: those that count up are said as one.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/finding.h"
#include "core/session/message_text.h"
#include "core/session/section_names.h"
#include "tests/test_program.h"

#include <QStringList>

using namespace fff;

class TestSectionNames : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void runsAreOne_data();
    void runsAreOne();
    void aSentenceHasRuns();
};

void TestSectionNames::runsAreOne_data()
{
    QTest::addColumn<QString>("names"); // between bars
    QTest::addColumn<QString>("said");
    const auto row = [](const char *what, const char *names, const char *said) {
        QTest::newRow(what) << QString::fromUtf8(names) << QString::fromUtf8(said);
    };
    row("none", "", "");
    row("one", "Section 70", "Section 70");
    row("two are read as such", "Section 70|Section 71", "Section 70|Section 71");
    row("four in a row", "Section 70|Section 71|Section 72|Section 73", "Sections 70–73");
    row("names of a person", "Rib 1|Rib 2|Rib 3", "Rib 1–3");
    row("a word of several", "Left rib 9|Left rib 10|Left rib 11", "Left rib 9–11");
    row("a gap", "Section 1|Section 2|Section 4", "Section 1|Section 2|Section 4");
    row("a gap between runs", "Section 70|Section 71|Section 72|Section 74|Section 75|Section 76",
        "Sections 70–72, 74–76");
    row("one beside a run", "Section 9|Section 2|Section 3|Section 4", "Sections 2–4, 9");
    row("too many pieces", "Rib 1|Rib 2|Rib 3|Rib 5|Rib 7|Rib 9|Rib 11",
        "Rib 1|Rib 2|Rib 3|Rib 5|Rib 7|Rib 9|Rib 11");
    row("in another order", "Rib 2|Body|Rib 3|Rib 1", "Rib 1–3|Body");
    row("one between two runs", "Rib 1|Rib 2|Rib 3|Body|Section 4|Section 5|Section 6",
        "Rib 1–3|Body|Sections 4–6");
    row("another word", "Rib 1|Fin 2|Rib 3", "Rib 1|Fin 2|Rib 3");
    row("downwards", "Rib 3|Rib 2|Rib 1", "Rib 1–3");
    row("the same again", "Rib 1|Rib 1|Rib 1", "Rib 1|Rib 1|Rib 1");
    row("numbers alone", "1|2|3", "1|2|3");
    row("noughts before", "Rib 01|Rib 02|Rib 03", "Rib 01|Rib 02|Rib 03");
    row("more than a number can be", "Rib 99999999999|Rib 99999999999|Rib 3",
        "Rib 99999999999|Rib 99999999999|Rib 3");
    row("a sign of a place", "%1 1|%1 2|%1 3", "%1 1–3");
}

void TestSectionNames::runsAreOne()
{
    QFETCH(QString, names);
    QFETCH(QString, said);
    const QStringList all = names.isEmpty() ? QStringList() : names.split(u'|');
    QCOMPARE(inRuns(all).join(u'|'), said);
}

// Wrong: a row of checks is four lines of names, or says of ten in a row only how many they are.
void TestSectionNames::aSentenceHasRuns()
{
    const auto said = [](std::vector<std::string> names, NameStyle style = NameStyle::Plain) {
        return argumentText(NamedSections{std::move(names)}, metricUnits(), style);
    };
    QCOMPARE(said({"Section 70", "Section 71", "Section 72", "Section 73"}),
             QStringLiteral("Sections 70–73"));
    QCOMPARE(said({"Rib 1", "Rib 2", "Rib 3", "Rib 4", "Rib 5", "Head & tail"}, NameStyle::Bold),
             QStringLiteral("<b>Rib 1–5</b> and <b>Head &amp; tail</b>"));
    QCOMPARE(said({"A", "B", "C", "D"}), QStringLiteral("A, B, C and D"));
    QCOMPARE(said({"A", "B", "C", "D", "E"}), QStringLiteral("5 sections"));
}

FFF_TEST(TestSectionNames)
#include "tst_section_names.moc"
