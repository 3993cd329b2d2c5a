// Models whose slits have ends for a tool, lead-ins and bumps: their parts as cut, in place and on
// their way. If this fails, a stock's options make parts that do not go together, or checks that
// complain of parts that do.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/checks.h"
#include "core/analysis/plan_checks.h"
#include "core/assembly/overlap_depth.h"
#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/fabrication/kerf.h"
#include "core/fabrication/marks.h"
#include "core/io/cutting_file.h"
#include "core/session/finding_text.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/known_models.h"
#include "tests/core/session/all_findings.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

/// The document with its one stock changed.
Document like(Document document, const Stock &options)
{
    Stock stock = *document.stocks.front();
    stock.slitEnd = options.slitEnd;
    stock.toolDiameter = options.toolDiameter;
    stock.leadIn = options.leadIn;
    stock.bumps = options.bumps;
    stock.clearance = options.clearance;
    stock.kerf = options.kerf;
    return *setStock(std::move(document), stock);
}

std::vector<Document> models()
{
    const ShapePointer plate = polygonShape(rectangle(-30, 0, 30, 40));
    const ShapePointer slope = polygonShape({{-40, 0}, {40, 0}, {40, 60}, {-40, 30}});
    const ShapePointer slot = polygonShape(rectangle(-60, -60, 60, 60));
    return {
        eggCrate(3, 3),
        combModel(4),
        star(8),
        chain(5),
        withSection(withSection(newDocument(), plate, front()), plate, turned(radians(40.0))),
        withSection(withSection(newDocument(), slope, front()), slope, turned(radians(70.0))),
        withSection(withSection(newDocument(), slot, {Vec3::Zero(), Vec3::UnitX(), -Vec3::UnitZ()}),
                    polygonShape(rectangle(-10, -20, 10, 40)), front())};
}

std::vector<Stock> options()
{
    std::vector<Stock> all;
    for (const SlitEnd end : {SlitEnd::Square, SlitEnd::Round, SlitEnd::Dogbone, SlitEnd::TBone}) {
        for (const double leadIn : {0.0, 1.5}) {
            for (const double bumps : {0.0, 0.15}) {
                for (const double clearance : {0.0, 0.1, -0.05}) {
                    Stock stock;
                    stock.slitEnd = end;
                    stock.toolDiameter = 3.0;
                    stock.leadIn = leadIn;
                    stock.bumps = bumps;
                    stock.clearance = clearance;
                    all.push_back(stock);
                }
            }
        }
    }
    return all;
}

std::vector<Finding> narrowSlits(const Analysis &analysis)
{
    std::vector<Finding> found = checks(analysis);
    std::erase_if(found, [](const Finding &one) { return !one.is(kNarrowSlit); });
    return found;
}

} // namespace

class TestSlitEnds : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void partsGoTogether_data();
    void partsGoTogether();
    void bumpsPressAndNothingElse();
    void partsSeatAtTheSquareBottom();
    void slitNarrowerThanItsTool();
    void holesThatTheKerfSwallows();
    void slitThatTheKerfCloses();
    void reliefThatBreaksThroughIsAThinWeb();
    void reliefsThatMergeAreSaid();
    void undoneIsAsBefore();
    void numbersStandOnMaterial();
    void aToolAsWideAsTheKerfGoesRound();
};

void TestSlitEnds::partsGoTogether_data()
{
    QTest::addColumn<int>("model");
    const char *const names[] = {"a crate", "a comb",          "a star",   "a chain",
                                 "oblique", "oblique, slopes", "a mortise"};
    for (int i = 0; i < 7; ++i)
        QTest::newRow(names[i]) << i;
}

void TestSlitEnds::partsGoTogether()
{
    QFETCH(int, model);
    for (const Stock &stock : options()) {
        const Analysis analysis = analysed(like(models()[static_cast<std::size_t>(model)], stock));
        const QByteArray what = QStringLiteral("end %1, lead-in %2, bumps %3, clearance %4")
                                    .arg(static_cast<int>(stock.slitEnd))
                                    .arg(stock.leadIn)
                                    .arg(stock.bumps)
                                    .arg(stock.clearance)
                                    .toUtf8();
        const ModelPlan plan = planOf(analysis);
        QVERIFY2(plan.plan.verdict == AssemblyPlan::Verdict::Possible, what);
        QVERIFY2(plan.overlaps.empty(), what);
        for (const CutSectionPointer &cut : analysis.cuts)
            QCOMPARE(cut->parts().size(), std::size_t(1));
        for (const Finding &finding : planChecks(analysis, plan))
            QVERIFY2(finding.severity != Severity::Error, what);
    }
}

// What would be wrong: interference where only a bump was meant to be, or a bump that does nothing.
void TestSlitEnds::bumpsPressAndNothingElse()
{
    for (const Document &document : models()) {
        for (const Stock &stock : options()) {
            if (stock.clearance < 0.0)
                continue;
            const Analysis analysis = analysed(like(document, stock));
            Collisions collisions;
            collisions.use(solidsOf(analysis.bodies));
            const std::vector<PartOverlap> overlaps = overlapsOf(collisions);
            const bool presses = stock.bumps > 0.5 * stock.clearance;
            QCOMPARE(!overlaps.empty(), presses);
            for (const PartOverlap &overlap : overlaps)
                QVERIFY(overlap.how.depth <= 2.0 * stock.bumps + kTouchingDepth);
        }
    }
}

// What would be wrong: a joint that closes farther than it is drawn, so that a model stands askew.
void TestSlitEnds::partsSeatAtTheSquareBottom()
{
    for (const SlitEnd end : {SlitEnd::Square, SlitEnd::Dogbone, SlitEnd::TBone, SlitEnd::Round}) {
        Stock stock;
        stock.slitEnd = end;
        stock.toolDiameter = 2.0;
        const ShapePointer plate = polygonShape(rectangle(-30, 0, 30, 40));
        const Analysis analysis = analysed(
            like(withSection(withSection(newDocument(), plate, front()), plate, side()), stock));
        const std::vector<SolidPointer> solids = solidsOf(analysis.bodies);
        const Slide slide = slidesOf(analysis).at(0);
        constexpr double kDeeper = 0.3; // mm: how far it is pushed on
        const Solid moved = movedBy(*solids[1], -kDeeper * slide.direction);
        const auto pushed = overlapOf(moved, *solids[0], kTouchingDepth);
        QVERIFY(pushed);
        if (end == SlitEnd::Square || end == SlitEnd::TBone) {
            QVERIFY(pushed->depth > kDeeper - 2.0 * kTouchingDepth);
        }
    }
}

// What would be wrong: a mill that is sent into a slit where it does not fit, without a word.
void TestSlitEnds::slitNarrowerThanItsTool()
{
    Stock stock;
    stock.clearance = -0.3;
    stock.toolDiameter = 3.0;
    QVERIFY(narrowSlits(analysed(like(eggCrate(2, 3), stock))).empty());
    for (const SlitEnd end : {SlitEnd::Round, SlitEnd::Dogbone, SlitEnd::TBone}) {
        stock.slitEnd = end;
        const Analysis analysis = analysed(like(eggCrate(2, 3), stock));
        const std::vector<Finding> found = narrowSlits(analysis);
        QCOMPARE(found.size(), std::size_t(1));
        QVERIFY(found[0].is(kNarrowSlit));
        QCOMPARE(found[0].severity, Severity::Error); // no such tool goes in
        QCOMPARE(found[0].sections.size(), std::size_t(5));
        QVERIFY(found[0].at);
        QCOMPARE(QByteArray(found[0].kind->name), QByteArray("narrowSlit"));
        const QString text = findingText(found[0], analysis.model);
        QVERIFY2(text.startsWith(QStringLiteral("Slit 2.70\u202Fmm is narrower than the "
                                                "3.00\u202Fmm tool. ")),
                 qPrintable(text));
    }
    stock.clearance = 0.0; // exactly as wide
    QVERIFY(narrowSlits(analysed(like(eggCrate(2, 3), stock))).empty());
    // Between its bumps it has less width than elsewhere.
    stock.clearance = 0.1;
    stock.bumps = 0.25;
    const std::vector<Finding> bumpy = narrowSlits(analysed(like(eggCrate(2, 3), stock)));
    QCOMPARE(bumpy.size(), std::size_t(1));
    QVERIFY(std::abs(bumpy[0].details<NarrowSlit>()->width - 2.6) < 1e-9);
    stock.bumps = 0.0;
    // An oblique slit is wider than the stock is thick.
    stock.clearance = -0.3;
    const ShapePointer plate = polygonShape(rectangle(-30, 0, 30, 40));
    QVERIFY(narrowSlits(analysed(like(withSection(withSection(newDocument(), plate, front()), plate,
                                                  turned(radians(40.0))),
                                      stock)))
                .empty());
}

// What would be wrong: a hole that was drawn is not in the file, and nobody says so.
void TestSlitEnds::holesThatTheKerfSwallows()
{
    const Contour plate = Contour::ofPolygon(rectangle(0, 0, 80, 60));
    const auto uncutOf = [&](const Contour &outer, const std::vector<Contour> &holes, double kerf) {
        Stock stock;
        stock.kerf = kerf;
        const ShapePointer shape = *Shape::make(outer, holes);
        const auto file =
            io::makeCuttingFile(analysed(like(withSection(newDocument(), shape, front()), stock)));
        return file ? static_cast<int>(file->uncut.size()) : -1;
    };
    const auto hole = [](double width, double height) {
        return Contour::ofPolygon(rectangle(20, 20, 20 + width, 20 + height)).reversed();
    };
    const Contour notched = Contour::ofPolygon(
        {{0, 0}, {80, 0}, {80, 60}, {40.4, 60}, {40.4, 40}, {40, 40}, {40, 60}, {0, 60}});
    QCOMPARE(uncutOf(plate, {hole(20, 10)}, 0.5), 0);
    QCOMPARE(uncutOf(plate, {hole(0.3, 0.3)}, 0.5), 1);
    QCOMPARE(uncutOf(plate, {hole(0.3, 0.3)}, 0.2), 0);
    QCOMPARE(uncutOf(plate, {hole(10, 0.4)}, 0.5), 1);
    QCOMPARE(uncutOf(notched, {}, 0.5), 1);
    QCOMPARE(uncutOf(notched, {}, 0.2), 0);
    QCOMPARE(uncutOf(notched, {hole(0.3, 0.3)}, 0.0), 0);
}

// What would be wrong: a cutting file without the slits that hold the model together.
void TestSlitEnds::slitThatTheKerfCloses()
{
    Stock stock;
    stock.kerf = 3.0 + stock.clearance; // as wide as they are
    const Analysis closed = analysed(like(eggCrate(2, 3), stock));
    const std::vector<Finding> found = narrowSlits(closed);
    QCOMPARE(found.size(), std::size_t(1));
    QCOMPARE(found[0].severity, Severity::Error);
    QCOMPARE(found[0].sections.size(), std::size_t(5));
    QVERIFY(findingText(found[0], closed.model).contains(QStringLiteral("closed by the kerf")));
    const auto file = io::makeCuttingFile(closed);
    QVERIFY(!file);
    QCOMPARE(file.error().code, ErrorCode::ClosedSlit);
    QCOMPARE(file.error().args.front(), closed.model.section(0)->name);
    // As designed there is nothing to close.
    io::CuttingFileOptions asDesigned;
    asDesigned.compensatesKerf = false;
    QVERIFY(io::makeCuttingFile(closed, asDesigned));
    stock.kerf -= 0.05;
    const Analysis open = analysed(like(eggCrate(2, 3), stock));
    QVERIFY(narrowSlits(open).empty());
    QVERIFY(io::makeCuttingFile(open));
}

// What would be wrong: a corner that falls off, since only the square slit was looked at.
void TestSlitEnds::reliefThatBreaksThroughIsAThinWeb()
{
    Stock stock;
    stock.toolDiameter = 3.0;
    const auto webs = [&](SlitEnd end, double below) {
        stock.slitEnd = end;
        // A rib on a spine, its slit down to `below` above the spine's lower edge.
        Document document =
            withSection(newDocument(), polygonShape(rectangle(0, 0, 60, 20 + below)), front());
        document =
            withSection(std::move(document),
                        polygonShape(rectangle(-20, below - 20, 20, 20 + below + 10)), side(30));
        JointOverride wanted;
        wanted.a = document.sections[0]->id;
        wanted.b = document.sections[1]->id;
        wanted.opens = Vec2::UnitY();
        wanted.shares = {{{30, 10}, 0.95}};
        document = *setJointOverride(std::move(document), wanted);
        const Analysis analysis = analysed(like(std::move(document), stock));
        return thinWebs(analysis.model.section(0)->shape->region(), analysis.assembly.slits[0],
                        3.0);
    };
    const double square = webs(SlitEnd::Square, 1.0).at(0).width;
    QVERIFY(square > 0.5 && square < 3.0);
    const double dogbone = webs(SlitEnd::Dogbone, 1.0).at(0).width;
    QVERIFY(dogbone < square - 0.3);
    const Web round = webs(SlitEnd::Round, 0.2).at(0);
    QCOMPARE(round.between, Web::Between::SlitAndContour);
    QVERIFY(round.width == 0.0 || round.width < square);
}

void TestSlitEnds::reliefsThatMergeAreSaid()
{
    Stock stock;
    stock.toolDiameter = 3.0;
    const auto worst = [&](SlitEnd end) {
        stock.slitEnd = end;
        Document document =
            withSection(newDocument(), polygonShape(rectangle(0, 0, 80, 30)), front());
        for (const double x : {30.0, 35.5})
            document =
                withSection(std::move(document), polygonShape(rectangle(-20, 10, 20, 50)), side(x));
        const Analysis analysis = analysed(like(std::move(document), stock));
        double least = 3.0;
        for (const Finding &finding : planChecks(analysis, planOf(analysis)))
            if (finding.is(kThinWeb) || finding.is(kSlitsMeet))
                least = std::min(least, finding.details<ThinWeb>()->width);
        return least;
    };
    QVERIFY(std::abs(worst(SlitEnd::Square) - 2.5) < 1e-6);
    QVERIFY(std::abs(worst(SlitEnd::Round) - 2.5) < 1e-3);
    QVERIFY(worst(SlitEnd::Dogbone) < 2.0);
    QCOMPARE(worst(SlitEnd::TBone), 0.0);
}

// What would be wrong: relief that stays in the parts when the stock is plain again.
void TestSlitEnds::undoneIsAsBefore()
{
    AnalysisCaches caches;
    const Document plain = eggCrate(2, 2);
    const Analysis before = analyse(evaluate(plain), caches);
    Stock stock;
    stock.slitEnd = SlitEnd::Dogbone;
    const Analysis milled = analyse(evaluate(like(plain, stock)), caches);
    for (std::size_t i = 0; i < 4; ++i)
        QVERIFY(milled.cuts[i]->area() < before.cuts[i]->area() - 0.1);
    const Analysis after = analyse(evaluate(plain), caches);
    for (std::size_t i = 0; i < 4; ++i)
        QVERIFY(after.cuts[i] == before.cuts[i]);
}

// What would be wrong: a joint's number engraved where its slit is milled away.
void TestSlitEnds::numbersStandOnMaterial()
{
    for (const Document &document : models()) {
        for (const Stock &stock : options()) {
            const Analysis analysis = analysed(like(document, stock));
            for (const Part &part : makeParts(analysis.model, analysis.assembly, analysis.bodies)) {
                const Engraving engraving = engrave(part, {});
                QVERIFY(engraving.hasNumber);
                QVERIFY(engraving.jointsLeftOut.empty());
                const Region &region = part.outline.region;
                for (const Box2 &box : engraving.boxes) {
                    QCOMPARE(locate(box.center(), region), Side::Inside);
                    for (const Vec2 &p : region.outer)
                        QVERIFY(!box.contains(p));
                }
            }
        }
    }
}

// What would be wrong: a path inside of the arcs that a mill cannot follow, or that leaves a corner
// standing.
void TestSlitEnds::aToolAsWideAsTheKerfGoesRound()
{
    for (const SlitEnd end : {SlitEnd::Round, SlitEnd::Dogbone, SlitEnd::TBone}) {
        Stock stock;
        stock.slitEnd = end;
        stock.toolDiameter = 2.5;
        const Analysis analysis = analysed(like(eggCrate(2, 2), stock));
        const CurvedRegion &part = analysis.cuts[0]->parts()[0];
        const CurvedRegion path = *compensateKerf(part, stock.toolDiameter);
        // The tool's middle comes to its radius from each corner of the guest.
        for (const Slit &slit : analysis.assembly.slits[0]) {
            const Polygon corners = slit.outline();
            for (const Vec2 &corner : {corners[0], corners[3]}) {
                double nearest = 1e9;
                for (const Vec2 &p : path.outer.flatten(0.001).points)
                    nearest = std::min(nearest, (p - corner).norm());
                QVERIFY2(nearest < 0.5 * stock.toolDiameter + 0.01,
                         qPrintable(QString::number(nearest)));
            }
        }
    }
}

FFF_TEST(TestSlitEnds)
#include "tst_slit_ends.moc"
