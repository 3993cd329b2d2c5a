// Models of thousands of sections with something on them: whether they hold, and that whoever does
// not wait for it is not made to.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/analysed.h"
#include "core/analysis/check_rules.h"
#include "core/analysis/findings/strength_findings.h"
#include "core/analysis/holding.h"
#include "core/analysis/stages.h"
#include "core/io/document_file.h"
#include "core/model/load_edits.h"
#include "core/operations/evaluate.h"
#include "core/session/finding_text.h"
#include "tests/bench/generated_models.h"
#include "tests/test_program.h"

#include <QDir>

using namespace fff;

namespace {

constexpr int kSections = 5000;
constexpr int kCrates = 16, kReach = 10; // 16 × 16 crates of 20 strips
constexpr int kEveryNth = 10;            // section bears something

Document loaded(Document document)
{
    for (std::size_t i = 0; i < document.sections.size(); i += kEveryNth) {
        const Section &section = *document.sections[i];
        Load weight;
        weight.section = section.ref();
        weight.position = section.shape->centroid();
        weight.mass = 0.01;
        weight.id = LoadId{document.nextId++};
        document.loads.push_back(weight); // each by itself would copy all sections again
    }
    return document;
}

} // namespace

class TestManySections : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theyAreJudged_data();
    void theyAreJudged();
};

void TestManySections::theyAreJudged_data()
{
    QTest::addColumn<Document>("document");
    QTest::newRow("comb") << loaded(bench::comb(kSections));
    QTest::newRow("crate") << loaded(bench::crates(kCrates * kReach, kReach));
}

// Wrong: no answer, one without a sentence, or work that goes on when nobody wants it any more.
void TestManySections::theyAreJudged()
{
    QFETCH(Document, document);
    if (const QString folder = qEnvironmentVariable("FFF_KEEP_MODELS"); !folder.isEmpty())
        QVERIFY(io::writeDocument(
            QDir(folder).filePath(QString::fromLatin1(QTest::currentDataTag()) + u".fff"_qs),
            document));
    Snapshot::Results results{{kModel.name, std::make_shared<const Model>(evaluate(document))},
                              {kRules.name, std::make_shared<const CheckRules>()}};
    Progress progress;
    const auto known = analysed(Snapshot(0, results), nullptr, progress, {});
    QVERIFY(known);
    results[kAnalysed.name] = std::make_shared<const Analysed>(*known);
    std::stop_source gone;
    gone.request_stop();
    const auto stopped = holding(Snapshot(0, results), nullptr, progress, gone.get_token());
    QVERIFY(!stopped && stopped.error().code == ErrorCode::Cancelled);
    StrengthCaches caches;
    const Analysis &analysis = *known->analysis;
    const Strength strength = strengthOf(analysis, {}, caches);
    QCOMPARE(strength.made.structure.members.size(), analysis.bodies.size());
    QCOMPARE(strength.equilibrium().balance(), Balance::Stands);
    QVERIFY(strength.equilibrium().worstResidual <= kTrustedResidual);
    QVERIFY(std::isfinite(strength.cornerUse) && strength.cornerUse > 0.0);
    const std::vector<Finding> found = strengthFindings(analysis, strength, {}, {});
    QVERIFY(!found.empty());
    for (const Finding &finding : found)
        QVERIFY(!findingText(finding, analysis.model).isEmpty());
}

FFF_TEST(TestManySections)
#include "tst_many_sections.moc"
