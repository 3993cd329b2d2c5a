#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/findings/in_each_other.h"
#include "core/analysis/findings/thin_webs.h"
#include "core/analysis/mends.h"
#include "core/analysis/outlined_sections.h"
#include "core/session/check_list.h"
#include "core/session/session.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

Finding overlapOf(int a, int b, Severity severity = Severity::Error)
{
    Finding finding = makeFinding(kInterference, severity);
    finding.sections = {SectionRef(SectionId{a}), SectionRef(SectionId{b})};
    finding.at = Vec3(a, b, 0);
    return finding;
}

} // namespace

class TestFindingRows : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Twelve rows that say the same hide the one that says something else.
    void equalOnesAreOneRow()
    {
        std::vector<Finding> findings;
        for (int i = 1; i <= 4; ++i)
            findings.push_back(overlapOf(i, i + 1));
        findings.insert(findings.begin() + 2, makeFinding(kThinWeb, Severity::Warning));
        const std::vector<FindingRow> rows = inRows(findings);
        QCOMPARE(rows.size(), std::size_t(2));
        QCOMPARE(rows[0].count(), 4);
        QCOMPARE(rows[0].finding.sections.size(), std::size_t(5)); // each once
        QVERIFY(!rows[0].finding.at);                              // it has no one place
        for (int i = 0; i < 4; ++i)
            QCOMPARE(rows[0].all[static_cast<std::size_t>(i)].at->x(), i + 1.0);
        QCOMPARE(rows[1].count(), 1);
    }

    /// Of two each is read at once, and has its own links.
    void twoStayTwo()
    {
        const std::vector<FindingRow> rows = inRows({overlapOf(1, 2), overlapOf(3, 4)});
        QCOMPARE(rows.size(), std::size_t(2));
        QVERIFY(rows[1].finding.at == rows[1].all.front().at);
    }

    /// A warning among errors would be read as one.
    void whatIsLessGraveIsAnotherRow()
    {
        std::vector<Finding> findings;
        for (int i = 1; i <= 3; ++i) {
            findings.push_back(overlapOf(i, 9));
            findings.push_back(overlapOf(i, 8, Severity::Warning));
        }
        const std::vector<FindingRow> rows = inRows(findings);
        QCOMPARE(rows.size(), std::size_t(2));
        for (const FindingRow &row : rows)
            for (const Finding &one : row.all)
                QCOMPARE(one.severity, row.finding.severity);
    }

    /// None is lost, whatever the findings are.
    void eachFindingIsInOneRow()
    {
        std::vector<Finding> findings;
        for (int i = 0; i < 40; ++i)
            findings.push_back(
                overlapOf(i + 1, i + 2, i % 3 == 0 ? Severity::Error : Severity::Note));
        std::size_t all = 0;
        for (const FindingRow &row : inRows(findings))
            all += row.all.size();
        QCOMPARE(all, findings.size());
        QVERIFY(inRows({}).empty());
    }

    /// Six sections in red say nothing about where it falls.
    void whatFallsIsOutlinedAtItsFeet()
    {
        // A narrow foot, and a beam on it that reaches far out, with plates across that.
        Document document = withSection(newDocument(), plateOf(0, 0, 20, 60), front());
        document = withSection(document, plateOf(-30, 40, 30, 90), side(10));
        document = withSection(document, plateOf(0, 70, 200, 90), front(20));
        const Model model = evaluate(document);
        Session session;
        session.reset(document);
        CheckList list(session);
        list.finish();
        bool isMet = false;
        for (const Finding &finding : list.all()) {
            if (finding.subject() != Subject::Stability)
                continue;
            isMet = true;
            const std::vector<SectionRef> outlined = outlinedSections(finding, model);
            QCOMPARE(outlined, std::vector{model.ref(0)});
        }
        QVERIFY(isMet);
        Finding other = overlapOf(1, 2);
        QCOMPARE(outlinedSections(other, model), other.sections);
    }

    /// What hangs in the air has no feet: its lowest sections are where to look.
    void whatHangsIsOutlinedAtItsLowest()
    {
        Document document = withSection(newDocument(), plateOf(-50, 20, 50, 60), front());
        document = withSection(document, plateOf(-50, 40, 50, 90), side());
        const Model model = evaluate(document);
        const Finding hangs = [] {
            Finding finding = makeFinding(kInterference, Severity::Error);
            static FindingKind kind = kInterference;
            kind.subject = Subject::Stability;
            finding.kind = &kind;
            return finding;
        }();
        QCOMPARE(outlinedSections(hangs, model), std::vector{model.ref(0)});
    }
};

FFF_TEST(TestFindingRows)
#include "tst_finding_rows.moc"
