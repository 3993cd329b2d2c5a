#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/checks.h"
#include "core/analysis/mends.h"
#include "core/analysis/planned.h"
#include "core/analysis/stages.h"
#include "core/model/edits.h"
#include "core/session/check_list.h"
#include "core/session/finding_text.h"
#include "core/session/session.h"
#include "tests/core/assembly/known_models.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

// A kind of finding that the product does not have, and a stage that has such: all that there is of
// them is here, and nothing else knows of them.
namespace {

struct Crowd
{
    int sections = 0;
};

Message crowdSentence(const Finding &finding, const Model &model)
{
    return {FFF_TEXT("Checks", "Too many: %1 sections, the last is %2."),
            {finding.details<Crowd>()->sections, nameAt(finding, model, 0)}};
}

constexpr Text kThinOut = FFF_TEXT("Checks", "Thin out");

std::optional<FindingEdit> thinnedOut(const FindingAction &, const Finding &finding,
                                      const Analysis &analysis, const Flips *)
{
    Result<Document> next =
        removeSections(analysis.model.document, std::vector{finding.sections.front().drawn});
    if (!next)
        return {};
    return FindingEdit{FFF_TEXT("Step", "Thin out"),
                       *std::move(next),
                       {FFF_TEXT("Checks", "It is less crowded."), {}}};
}

const ActionKind kThinning{plainWords<kThinOut>, thinnedOut};

std::vector<FindingAction> thinning(const Finding &, const Analysis &)
{
    return {{&kThinning}};
}

const FindingKind kCrowded{"crowded", Subject::Size, FFF_TEXT("Checks", "Crowded"), crowdSentence,
                           thinning};

std::optional<Finding> crowdIn(const Model &model)
{
    if (model.sectionCount() < 4)
        return {};
    Finding finding =
        makeFinding(kCrowded, Severity::Warning, Crowd{static_cast<int>(model.sectionCount())});
    finding.sections = {model.ref(model.sectionCount() - 1)};
    return finding;
}

void findCrowd(const Looked &at, std::vector<Finding> &found)
{
    if (auto crowd = crowdIn(at.analysis.model))
        found.push_back(*std::move(crowd));
}

struct Crowding
{
    std::vector<Finding> findings;
};
constexpr StageOf<Crowding> kCrowding{"crowding"};

Result<Crowding> crowding(const Snapshot &snapshot, const Crowding *, Progress &, std::stop_token)
{
    Crowding out;
    if (auto crowd = crowdIn(snapshot.get(kModel)))
        out.findings.push_back(*std::move(crowd));
    return out;
}

/// Those of the product, with one more line.
std::vector<Stage> withCrowding()
{
    std::vector<Stage> all = stages();
    std::erase_if(all, [](const Stage &stage) { return stage.name == kMends.name; });
    all.push_back(makeStage(kCrowding, FFF_TEXT("Stage", "how crowded it is"), {kModel.name},
                            Stage::Runs::WhenSettled, crowding));
    all.push_back(mendsOf(all));
    return all;
}

} // namespace

class TestOwnFinding : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aFinderIsOneLine();
    void aStageIsOneLine();
};

void TestOwnFinding::aFinderIsOneLine()
{
    AnalysisCaches analyses;
    CheckCaches caches;
    const AnalysisPointer analysis = analyseNext(evaluate(eggCrate(2, 2)), analyses);
    std::vector<Finder> all(finders().begin(), finders().end());
    all.push_back(findCrowd);
    const std::vector<Finding> found = checks(*analysis, caches, {}, {}, all);
    QCOMPARE(found.size(), checks(*analysis).size() + 1);
    const Finding &crowd = found.back();
    QVERIFY(crowd.is(kCrowded));
    QCOMPARE(findingText(crowd, analysis->model),
             QStringLiteral("Too many: 4 sections, the last is Section 4."));
    QCOMPARE(worst(found, Subject::Size), Severity::Warning);
    const std::vector<FindingAction> actions = actionsOf(crowd, *analysis);
    QCOMPARE(actions.size(), std::size_t(1));
    const auto edit = carriedOut(actions.front(), crowd, *analysis);
    QVERIFY(edit);
    QCOMPARE(edit->document.sections.size(), std::size_t(3));
}

void TestOwnFinding::aStageIsOneLine()
{
    Session session(withCrowding());
    CheckList list(session);
    const auto crowd = [&list]() -> const Finding * {
        list.finish();
        for (const Finding &finding : list.all())
            if (finding.is(kCrowded))
                return &finding;
        return nullptr;
    };
    session.commit(QStringLiteral("Draw"), eggCrate(2, 2));
    QVERIFY(crowd());
    const std::vector<Mend> &mends = list.mendsOf(*crowd());
    QCOMPARE(mends.size(), std::size_t(1));
    const FindingAction action = mends.front().action;
    QCOMPARE(messageText(action.kind->words(action, *crowd(), list.model())),
             QStringLiteral("Thin out"));
    session.commit(QStringLiteral("Thin out"), list.mendFor(action, *crowd())->edit->document);
    QVERIFY(!crowd());
    // Its failure is said in its place.
    session.scheduler().setCompute(kCrowding.name,
                                   [](const Snapshot &, const void *, Progress &,
                                      std::stop_token) -> Result<std::shared_ptr<const void>> {
                                       throw std::runtime_error("no room");
                                   });
    session.commit(QStringLiteral("Draw"), eggCrate(3, 3));
    list.finish();
    QVERIFY(std::any_of(list.all().begin(), list.all().end(), [&list](const Finding &finding) {
        return findingText(finding, list.model()).contains(QStringLiteral("how crowded it is"));
    }));
    QVERIFY(!crowd());
}

FFF_TEST(TestOwnFinding)
#include "tst_own_finding.moc"
