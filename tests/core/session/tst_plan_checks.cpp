#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/findings/order.h"
#include "core/analysis/plan_checks.h"
#include "core/session/finding_text.h"
#include "tests/core/assembly/known_models.h"
#include "tests/core/session/all_findings.h"
#include "tests/test_program.h"

#include <QLocale>

#include <algorithm>

using namespace fff;
using namespace fff::test;

namespace {

struct Said
{
    std::vector<Finding> checks;
    QStringList sentences;
};

Said saidOf(const Document &document, const std::function<bool()> &isOutOfTime = {})
{
    AnalysisCaches caches;
    const Analysis analysis = analyse(evaluate(document), caches);
    Said said{planChecks(analysis, planOf(analysis, isOutOfTime)), {}};
    for (const Finding &finding : said.checks)
        said.sentences += findingText(finding, analysis.model).replace(QChar(0x202f), u' ');
    return said;
}

} // namespace

class TestPlanChecks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void sentences_data();
    void sentences();
    void anUnknownOrderIsNoProblem();
    void whatIsInEachOtherSaysHowDeep();
    void whatOtherJointsArePressedByHidesNothing();
    void anAngleThatNoSlitTakesIsAnError();
    void websAreMeasured();
    void whatIsKnownFromBeforeChangesNothing();
    void ringsAreNamed();
    void blockingPairsAreLinked();
    void whatIsSaidOfAJointNamesIt();
    void aModelWithoutPartsHasNoVerdict();
    void whatNothingHoldsIsNotGreen();
};

void TestPlanChecks::sentences_data()
{
    QTest::addColumn<Document>("document");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("one part") << withSection(newDocument(), polygonShape(rectangle(0, 0, 40, 40)),
                                             front())
                              << QStringLiteral("Can be assembled. Only one part so far.");
    QTest::newRow("a crate") << eggCrate(2, 2) << QStringLiteral("Can be assembled. 4 steps.");
    QTest::newRow("locked by directions")
        << triangle()
        << QStringLiteral("Sections block each other. Sections 1–3 meet in 3 joints that slide in "
                          "3 different directions.");
    QTest::newRow("locked by an arm")
        << underAnArm(60)
        << QStringLiteral("Sections block each other. Section 2 comes only 5 mm out of its slit "
                          "before it hits Section 1.");
}

/// What would be wrong: a person who is told "no" and not why.
void TestPlanChecks::sentences()
{
    QFETCH(Document, document);
    QFETCH(QString, sentence);
    QCOMPARE(saidOf(document).sentences, QStringList(sentence));
}

/// What would be wrong: a search that was cut short says that the model is good, or that it is bad.
void TestPlanChecks::anUnknownOrderIsNoProblem()
{
    const Said said = saidOf(eggCrate(2, 2), [] { return true; });
    QCOMPARE(said.checks.size(), std::size_t(1));
    QVERIFY(said.checks.front().is(kOrderUnknown));
    QCOMPARE(said.checks.front().severity, Severity::Unknown);
}

/// What would be wrong: plates that are in each other where no axis runs go to the cutter.
void TestPlanChecks::whatIsInEachOtherSaysHowDeep()
{
    const ShapePointer plate = polygonShape(rectangle(0, 0, 40, 40));
    const Said said =
        saidOf(withSection(withSection(newDocument(), plate, front()), plate, front(2.0)));
    QCOMPARE(said.checks.size(), std::size_t(2));
    const Finding &finding = said.checks.back();
    QVERIFY(finding.is(kInterference));
    QCOMPARE(finding.severity, Severity::Warning);
    QCOMPARE(finding.sections.size(), std::size_t(2));
    QVERIFY(finding.at);
    QCOMPARE(said.sentences.back(),
             QStringLiteral("Section 1 and Section 2 overlap by 1 mm, but are not joined."));
}

/// What would be wrong: bumps of one joint, or the clearance of another stock, hide that two plates
/// elsewhere are in each other.
void TestPlanChecks::whatOtherJointsArePressedByHidesNothing()
{
    Document document = *addStock(eggCrate(2, 2), [] {
        Stock tight = birchPlywood();
        tight.clearance = -0.4;
        tight.bumps = 0.3;
        return tight;
    }());
    const StockId usual = document.stocks[0]->id, tight = document.stocks[1]->id;
    for (const SectionPointer &section : std::vector(document.sections))
        document = *setSectionStock(std::move(document), section->id, tight);
    document = *setCurrentStock(std::move(document), usual);
    const auto isInterference = [](const Finding &c) { return c.is(kInterference); };
    const Said before = saidOf(document);
    QVERIFY(std::none_of(before.checks.begin(), before.checks.end(), isInterference));
    const ShapePointer plate = polygonShape(rectangle(200, 0, 240, 40));
    document = withSection(withSection(document, plate, front()), plate, front(2.6));
    const Said said = saidOf(document);
    const auto found = std::find_if(said.checks.begin(), said.checks.end(), isInterference);
    QVERIFY(found != said.checks.end());
    QVERIFY(std::abs(found->details<Interference>()->depth - 0.4) < 1e-6);
}

/// What would be wrong: sections that meet at 8° are in each other, and nobody says why.
void TestPlanChecks::anAngleThatNoSlitTakesIsAnError()
{
    const ShapePointer plate = polygonShape(rectangle(-30, 0, 30, 40));
    const Said said = saidOf(
        withSection(withSection(newDocument(), plate, front()), plate, turned(radians(8.0))));
    QCOMPARE(said.checks.size(), std::size_t(2));
    QVERIFY(said.checks.back().is(kShallowAngle));
    QCOMPARE(said.checks.back().severity, Severity::Error);
    QCOMPARE(said.sentences.back(),
             QStringLiteral("Section 1 and Section 2 almost lie in one plane: they meet at 8°, and "
                            "below 10° no slit can hold them."));
}

/// What would be wrong: a web that breaks in the hand is cut without a word, or every short slit is
/// called a problem.
void TestPlanChecks::websAreMeasured()
{
    // A bar with two slits from above, 3 mm wide.
    const ShapePointer bar = polygonShape(rectangle(0, 0, 100, 30));
    const ShapePointer rib = polygonShape(rectangle(-20, 15, 20, 45));
    const auto twoRibs = [&](double away) {
        Document document = withSection(newDocument(), bar, front());
        document = withSection(std::move(document), rib, side(40));
        return saidOf(withSection(std::move(document), rib, side(40 + away)));
    };
    const auto last = [&](double away) { return twoRibs(away).checks.back(); };
    QCOMPARE(twoRibs(4).sentences.back(),
             QStringLiteral(
                 "Section 1: only 1 mm of material is left between its slits for Section 2 and "
                 "Section 3."));
    QCOMPARE(last(4).severity, Severity::Warning);
    QVERIFY(last(5).is(kThinWeb));
    QCOMPARE(last(5).severity, Severity::Note);
    QCOMPARE(twoRibs(6.5).checks.size(), std::size_t(1)); // the verdict alone
    QCOMPARE(twoRibs(2).sentences.back(),
             QStringLiteral("Section 1: its slits for Section 2 and Section 3 run into each "
                            "other."));
    // The place is in the web.
    QVERIFY(last(4).at && std::abs(last(4).at->x() - 42.0) < 0.01);
    QCOMPARE(last(4).sections.size(), std::size_t(1));
}

/// What would be wrong: a web that was, or one that nobody sees until the model is opened again.
void TestPlanChecks::whatIsKnownFromBeforeChangesNothing()
{
    const ShapePointer bar = polygonShape(rectangle(0, 0, 100, 30));
    const ShapePointer rib = polygonShape(rectangle(-20, 15, 20, 45));
    Document document = withSection(newDocument(), bar, front());
    document = withSection(std::move(document), rib, side(40));
    document = withSection(std::move(document), rib, side(60));
    AnalysisCaches analyses;
    PlanCheckCaches caches;
    for (const double at : {60.0, 44.0, 42.0, 80.0, 45.0}) {
        document = *moveSection(document, document.sections[2]->id, side(at));
        const AnalysisPointer analysis = analyseNext(evaluate(document), analyses);
        const ModelPlan plan = planOf(*analysis);
        const std::vector<Finding> kept = planChecks(*analysis, plan, caches);
        const std::vector<Finding> anew = planChecks(*analysis, plan);
        QCOMPARE(kept.size(), anew.size());
        for (std::size_t i = 0; i < kept.size(); ++i)
            QCOMPARE(exactly(kept[i], analysis->model), exactly(anew[i], analysis->model));
    }
}

/// What would be wrong: rings that nobody sees, or a crate, which slides one way, full of them.
void TestPlanChecks::ringsAreNamed()
{
    const auto cyclesSaid = [](const Document &document) {
        const Said said = saidOf(document);
        QStringList found;
        for (std::size_t i = 0; i < said.checks.size(); ++i)
            if (said.checks[i].is(kRings))
                found += said.sentences[static_cast<qsizetype>(i)];
        return found;
    };
    QVERIFY(cyclesSaid(triangle()).isEmpty()); // the verdict is about the same sections
    QVERIFY(cyclesSaid(eggCrate(3, 3)).isEmpty());
    QVERIFY(cyclesSaid(chain(5)).isEmpty());
    // A lid on two pairs of neighbouring strips closes rings with them.
    Document lid = eggCrate(2, 1);
    lid = withSection(std::move(lid), polygonShape(rectangle(0, 0, 70, 70)),
                      {{-10, 20, 10}, Vec3::UnitX(), -Vec3::UnitZ()});
    QCOMPARE(cyclesSaid(lid).size(), 1);
    QVERIFY(cyclesSaid(lid).front().contains(QStringLiteral("joined in")));
    Finding ring = makeFinding(kRings, Severity::Note, Rings{1, true, {}});
    const Model model = evaluate(triangle());
    ring.sections = {model.ref(0), model.ref(1), model.ref(2)};
    QCOMPARE(findingText(ring, model),
             QStringLiteral("Sections 1–3 are joined in a ring: put them together in the order of "
                            "the steps."));
}

/// What would be wrong: "Can be assembled" over an empty view.
void TestPlanChecks::aModelWithoutPartsHasNoVerdict()
{
    QVERIFY(saidOf(newDocument()).checks.empty());
}

// Wrong: lines between sections that do not block each other, or beside where they do.
void TestPlanChecks::blockingPairsAreLinked()
{
    for (const Document &document : {triangle(), roundabout(eggCrate(2, 2), 0), underAnArm(60)}) {
        const Model model = evaluate(document);
        const std::vector<Finding> checks = saidOf(document).checks;
        QVERIFY(checks.front().is(kCannotAssemble));
        const Blocked &blocked = *checks.front().details<Blocked>();
        QVERIFY(!blocked.links.empty());
        QCOMPARE(static_cast<int>(blocked.links.size()), blocked.joints);
        for (const ProblemLink &link : blocked.links) {
            const auto isIn = [&](std::size_t section, const Vec3 &at) {
                const Frame &frame = model.section(section)->frame;
                return std::abs(frame.normal().dot(at - frame.origin)) < 1e-6;
            };
            // The place is in both planes, and so is the way; the ends are in one each.
            const auto isOf = [&](std::size_t a, std::size_t b) {
                return isIn(a, link.at) && isIn(b, link.at) && isIn(a, link.at + link.way) &&
                       isIn(b, link.at + link.way) && isIn(a, link.fromA) && isIn(b, link.fromB);
            };
            int pairs = 0;
            for (std::size_t a = 0; a < model.sectionCount(); ++a)
                for (std::size_t b = 0; b < model.sectionCount(); ++b)
                    pairs += a != b && isOf(a, b);
            QVERIFY(pairs > 0);
            QVERIFY(std::abs(link.way.norm() - 1.0) < 1e-9);
        }
    }
    QVERIFY(!saidOf(eggCrate(2, 2)).checks.front().kind->look);
}

// Wrong: the page of another joint, or of none, beside what is said of one.
void TestPlanChecks::whatIsSaidOfAJointNamesIt()
{
    // Two places of the same rib: one too near to the edge of the plate that holds it.
    const Document document = twoSections(polygonShape(rectangle(-50, 0, 50, 60)), front(),
                                          polygonShape(rectangle(-30, 0, 30, 60)), side(47))
                                  .document;
    int named = 0;
    for (const Finding &finding : saidOf(document).checks) {
        if (!finding.is(kThinWeb))
            continue;
        QVERIFY(finding.joint == JointRef(finding.sections.front(), finding.others.front()));
        ++named;
    }
    QVERIFY(named > 0);
}

// Wrong: a green tick for pieces that are put in the air.
void TestPlanChecks::whatNothingHoldsIsNotGreen()
{
    const ShapePointer plate = polygonShape(rectangle(-30, 0, 30, 40));
    const Document held = withSection(withSection(newDocument(), plate, front()), plate, side());
    const Document apart = withSection(held, plate, front(-200));
    for (const auto &[document, severity] :
         {std::pair(&held, Severity::Good), std::pair(&apart, Severity::Note)}) {
        const Said said = saidOf(*document);
        const auto order = std::find_if(said.checks.begin(), said.checks.end(),
                                        [](const Finding &f) { return f.is(kCanAssemble); });
        QVERIFY(order != said.checks.end());
        QCOMPARE(order->severity, severity);
    }
    QVERIFY(saidOf(apart).sentences.join(u' ').contains(
        QStringLiteral("But nothing holds one of the parts")));
}

FFF_TEST(TestPlanChecks)
#include "tst_plan_checks.moc"
