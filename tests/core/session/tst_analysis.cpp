#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/checks.h"
#include "core/base/tolerances.h"
#include "core/session/finding_text.h"
#include "tests/bench/counted_memory.h"
#include "tests/bench/generated_models.h"
#include "tests/core/session/all_findings.h"
#include "tests/core/session/random_edits.h"
#include "tests/test_program.h"

#include <algorithm>
#include <set>

using namespace fff;
using namespace fff::test;

namespace {

/// To a micron, to which depths are measured: a cut that was made from another one is off by less.
bool holdTheSame(const JointGrips &a, const JointGrips &b)
{
    constexpr double kMicron = 1.001e-3; // mm
    const auto isSame = [](const Grip &x, const Grip &y) {
        return x.a == y.a && x.b == y.b && std::abs(x.inA - y.inA) < kMicron &&
               std::abs(x.inB - y.inB) < kMicron;
    };
    if (!std::equal(a.held.begin(), a.held.end(), b.held.begin(), b.held.end(), isSame) ||
        a.loose.has_value() != b.loose.has_value())
        return false;
    return !a.loose ||
           (a.loose->why == b.loose->why && a.loose->isInA == b.loose->isInA &&
            a.loose->slit == b.loose->slit && std::abs(a.loose->depth - b.loose->depth) < kMicron &&
            (a.loose->missing - b.loose->missing).norm() < kPracticallyParallel);
}

/// What differs between two analyses of one model, in words; nothing when every field is the same.
QString difference(const Analysis &a, const Analysis &b)
{
    if (!a.model.document.isSame(b.model.document))
        return QStringLiteral("the model");
    if (a.assembly.joints.size() != b.assembly.joints.size())
        return QStringLiteral("the number of joints");
    for (std::size_t i = 0; i < a.assembly.joints.size(); ++i) {
        const Joint &x = a.assembly.joints[i], &y = b.assembly.joints[i];
        if (x.id != y.id || x.a != y.a || x.b != y.b || x.kind != y.kind)
            return QStringLiteral("joint %1").arg(i + 1);
        const Crossing &c = *x.crossing, &d = *y.crossing;
        if (c.axis.point != d.axis.point || c.axis.direction != d.axis.direction ||
            c.angle != d.angle || c.overlaps.size() != d.overlaps.size())
            return QStringLiteral("the crossing of joint %1").arg(i + 1);
        for (std::size_t k = 0; k < c.overlaps.size(); ++k) {
            const Overlap &o = c.overlaps[k], &p = d.overlaps[k];
            const auto isSame = [](const AxisEnd &e, const AxisEnd &f) {
                return e.at == f.at && e.ring == f.ring && e.edge == f.edge;
            };
            if (o.from != p.from || o.to != p.to || o.meet != p.meet ||
                !isSame(o.a.from, p.a.from) || !isSame(o.a.to, p.a.to) ||
                !isSame(o.b.from, p.b.from) || !isSame(o.b.to, p.b.to))
                return QStringLiteral("overlap %1 of joint %2").arg(k).arg(i + 1);
        }
    }
    int number = 0;
    for (const Joint &joint : a.assembly.joints) {
        if (joint.id != ++number || &joint != &a.assembly.joints[joint.id - 1] ||
            &joint != a.assembly.joints.find(joint.a, joint.b))
            return QStringLiteral("the order of joint %1").arg(number);
    }
    if (!(a.assembly.slits == b.assembly.slits))
        return QStringLiteral("the slits");
    for (const Joint &joint : a.assembly.joints)
        if (!holdTheSame(a.grips.of(joint), b.grips.of(joint)))
            return QStringLiteral("what joint %1 holds").arg(joint.id);
    for (std::size_t i = 0; i < a.model.sectionCount(); ++i) {
        if (a.assembly.boxes[i].min != b.assembly.boxes[i].min ||
            a.assembly.boxes[i].max != b.assembly.boxes[i].max)
            return QStringLiteral("box %1").arg(i);
        const auto &p = a.cuts[i]->parts(), &q = b.cuts[i]->parts();
        if (p.size() != q.size())
            return QStringLiteral("the number of parts of section %1").arg(i);
        for (std::size_t k = 0; k < p.size(); ++k) {
            if (!(p[k].outer == q[k].outer) || !(p[k].holes == q[k].holes) ||
                p[k].region.outer != q[k].region.outer || p[k].region.holes != q[k].region.holes)
                return QStringLiteral("part %1 of section %2").arg(k).arg(i);
        }
    }
    return a.cuts.size() == b.cuts.size() ? QString() : QStringLiteral("the number of cuts");
}

/// What verdicts say, as text that differs when they do.
QString said(const std::vector<Finding> &checks, const Model &model)
{
    QString text;
    for (const Finding &finding : checks)
        text +=
            QString::number(static_cast<int>(finding.severity)) + exactly(finding, model) + u'\n';
    return text;
}

} // namespace

class TestAnalysis : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void incrementalEqualsFromScratch_data();
    void incrementalEqualsFromScratch();
    void whatAnEditDoesNotTouchIsShared();
    void editsOfAJointedSpineEqualFromScratch();
    void aMovedPointLeavesWhatIsFarAlone();
    void likeRibsShareTheirCuts();
    void ribsOfAMovedRowKeepTheirCuts();
    void aStepCostsSixteenBytesASection_data();
    void aStepCostsSixteenBytesASection();
};

void TestAnalysis::incrementalEqualsFromScratch_data()
{
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u})
        QTest::addRow("seed %u", seed) << seed;
}

// Wrong: after some sequence of edits, jumps through the history and changes of stock, the window
// would show and cut other slits than a fresh start with the same document.
void TestAnalysis::incrementalEqualsFromScratch()
{
    QFETCH(unsigned, seed);
    RandomEdits edits(seed);
    AnalysisCaches caches;
    CheckCaches verdicts;
    std::vector<Document> history{newDocument()};
    std::size_t joints = 0;
    for (int step = 0; step < 120; ++step) {
        // Now and then back, as undo does, or to anywhere.
        if (edits.below(8) == 0)
            history.push_back(
                history[static_cast<std::size_t>(edits.below(static_cast<int>(history.size())))]);
        else
            history.push_back(edits.next(history.back()));
        const Model model = evaluate(history.back());
        const AnalysisPointer kept = analyseNext(model, caches);
        AnalysisCaches none;
        const AnalysisPointer fresh = analyseNext(model, none);
        const QString wrong = difference(*kept, *fresh);
        QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("step %1: %2").arg(step).arg(wrong)));
        QCOMPARE(said(checks(*kept, verdicts), model), said(checks(*fresh), model));
        joints += kept->assembly.joints.size();
    }
    QVERIFY(joints > 120); // or nothing was tested
}

// Wrong: an edit would cost by the size of the model, and everything would be drawn anew.
void TestAnalysis::whatAnEditDoesNotTouchIsShared()
{
    Document document = newDocument();
    const ShapePointer strip = polygonShape(rectangle(0, 0, 200, 40));
    for (int i = 0; i < 8; ++i)
        document = withSection(std::move(document), strip, front(-20.0 * (i + 1)));
    document = withSection(std::move(document), polygonShape(rectangle(5, 0, 50, 40)), side(50));
    AnalysisCaches caches;
    const AnalysisPointer before = analyseNext(evaluate(document), caches);
    const SectionId id = document.sections.back()->id;
    const AnalysisPointer after =
        analyseNext(evaluate(*moveSection(document, id, side(51))), caches);
    QCOMPARE(before->assembly.joints.size(), std::size_t(2));
    // The moved section itself is cut where it was.
    for (std::size_t i = 0; i < 9; ++i) {
        QCOMPARE(before->cuts[i] != after->cuts[i], i < 2);
        QCOMPARE(before->assembly.slits.pointer(i) != after->assembly.slits.pointer(i), i < 2);
    }
    const AnalysisPointer undone = analyseNext(evaluate(document), caches);
    QVERIFY(std::ranges::equal(undone->cuts, before->cuts));
}

// Wrong: a joint that an edit seems not to come near would be the one before, though it does.
void TestAnalysis::editsOfAJointedSpineEqualFromScratch()
{
    Document document = bench::jointedComb(60);
    const SectionId spine = document.sections.front()->id;
    // Beside it some that are neither square to it nor across its middle, and one with two
    // overlaps.
    const ShapePointer plate = polygonShape(rectangle(-30, 0, 30, 40));
    for (const double angle : {0.6, 1.1, 2.2}) {
        Frame frame = turned(angle);
        frame.origin = Vec3(95.0 + 130.0 * angle, 11.0, 0.0);
        document = withSection(std::move(document), plate, frame);
    }
    document = withSection(std::move(document),
                           polygonShape(rectangle(-20, -20, 20, 60), {rectangle(-12, 10, 12, 25)}),
                           side(333.3));
    std::mt19937 random(5);
    const auto below = [&](int limit) {
        return std::uniform_int_distribution<int>(0, limit - 1)(random);
    };
    AnalysisCaches caches;
    CheckCaches verdicts;
    int kept = 0;
    for (int step = 0; step < 80; ++step) {
        const Shape &shape = *document.find(spine)->shape;
        const PointAddress point{0, below(shape.contour().segmentCount())};
        const Vec2 by(0.4 * (below(9) - 4), 0.9 * (below(9) - 4));
        Result<ShapePointer> next = failure(ErrorCode::EmptyContour);
        switch (below(4)) {
        case 0:
            next = insertedPoint(shape, 0, {point.index, 0.4});
            break;
        case 1:
            next = withoutPoints(shape, std::vector{point});
            break;
        case 2:
            next = movedHandle(shape, point, HandleSide::Out, position(shape, point) + 3.0 * by,
                               false);
            break;
        default:
            next = movedPoint(shape, point, position(shape, point) + by);
        }
        if (next)
            document = *setShape(document, spine, *next);
        if (step % 16 == 15) {
            Stock stock = *document.stocks.front();
            stock.leadIn = step % 32 == 15 ? 1.0 : 0.0;
            document = *setStock(document, stock);
        }
        const AnalysisPointer last = caches.last;
        const Model model = evaluate(document);
        const AnalysisPointer followed = analyseNext(model, caches);
        AnalysisCaches none;
        const AnalysisPointer fresh = analyseNext(model, none);
        const QString wrong = difference(*followed, *fresh);
        QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("step %1: %2").arg(step).arg(wrong)));
        QCOMPARE(said(checks(*followed, verdicts), model), said(checks(*fresh), model));
        for (std::size_t i = 1; last && i < followed->cuts.size(); ++i)
            kept += followed->cuts[i] == last->cuts[i] ? 1 : 0;
    }
    QVERIFY2(kept > 80 * 40, qPrintable(QString::number(kept)));
}

// Wrong: one point of a spine that is dragged would cut and draw thousands of ribs anew.
void TestAnalysis::aMovedPointLeavesWhatIsFarAlone()
{
    constexpr int kRibs = 400;
    const Document document = bench::jointedComb(kRibs);
    AnalysisCaches caches;
    const AnalysisPointer before = analyseNext(evaluate(document), caches);
    const SectionPointer &spine = document.sections.front();
    const PointAddress point{0, 51}; // of the upper edge, which the ribs stand on
    const auto shape =
        movedPoint(*spine->shape, point, position(*spine->shape, point) + Vec2(1, 2));
    const AnalysisPointer after =
        analyseNext(evaluate(*setShape(document, spine->id, *shape)), caches);
    int cutAnew = 0;
    for (std::size_t i = 0; i < before->cuts.size(); ++i) {
        const bool isKept = before->cuts[i] == after->cuts[i];
        cutAnew += isKept ? 0 : 1;
        if (!isKept)
            continue;
        QCOMPARE(after->assembly.slits.pointer(i), before->assembly.slits.pointer(i));
        QCOMPARE(&after->cuts[i]->triangulations(), &before->cuts[i]->triangulations());
    }
    // The spine, and the ribs on the two edges that end in the point.
    QVERIFY2(cutAnew > 10 && cutAnew <= 25, qPrintable(QString::number(cutAnew)));
    const AnalysisPointer undone = analyseNext(evaluate(document), caches);
    QVERIFY(std::ranges::equal(undone->cuts, before->cuts));
    int crossings = 0; // that are not those they were
    for (std::size_t i = 0; i < before->assembly.joints.size(); ++i)
        crossings +=
            before->assembly.joints[i].crossing != after->assembly.joints[i].crossing ? 1 : 0;
    QVERIFY2(crossings <= 25, qPrintable(QString::number(crossings)));
    int grips = 0; // that were looked at again: those of these ribs, and beside them
    for (const Joint &joint : after->assembly.joints)
        grips += &before->grips.of(joint) != &after->grips.of(joint) ? 1 : 0;
    QVERIFY2(grips > 0 && grips <= 30, qPrintable(QString::number(grips)));
}

// Wrong: ribs whose slits differ by a thousandth of a hair would each be cut by themselves.
void TestAnalysis::likeRibsShareTheirCuts()
{
    constexpr int kRibs = 300;
    const Document document = bench::comb(kRibs);
    AnalysisCaches caches;
    const auto differentCuts = [](const Analysis &analysis) {
        return std::set<CutSectionPointer>(std::next(analysis.cuts.begin()), analysis.cuts.end())
            .size();
    };
    QCOMPARE(differentCuts(*analyseNext(evaluate(document), caches)), std::size_t(1));
    // All of the lower edge is oblique then, by a hundredth of a mm in all.
    const SectionPointer &spine = document.sections.front();
    const auto shape = movedPoint(*spine->shape, {0, 0}, Vec2(0, 0.01));
    const AnalysisPointer moved =
        analyseNext(evaluate(*setShape(document, spine->id, *shape)), caches);
    QCOMPARE(differentCuts(*moved), std::size_t(6));
}

// Wrong: a row that goes somewhere else as it is would be cut anew, for rounding's sake.
void TestAnalysis::ribsOfAMovedRowKeepTheirCuts()
{
    Document document = bench::comb(40);
    AnalysisCaches caches;
    const AnalysisPointer before = analyseNext(evaluate(document), caches);
    for (const SectionPointer &section : std::vector(document.sections)) {
        Frame frame = section->frame;
        const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
        frame = {turn * frame.origin + Vec3(17.3, 5.1, 2.9), turn * frame.x, turn * frame.y};
        document = *moveSection(document, section->id, frame);
    }
    const AnalysisPointer after = analyseNext(evaluate(document), caches);
    int kept = 0;
    for (std::size_t i = 1; i < before->cuts.size(); ++i)
        kept += before->cuts[i] == after->cuts[i] ? 1 : 0;
    QVERIFY2(kept == 39, qPrintable(QString::number(kept)));
}

void TestAnalysis::aStepCostsSixteenBytesASection_data()
{
    QTest::addColumn<int>("sections");
    QTest::addColumn<QString>("edit");
    for (int sections : {10, 1000}) {
        for (const char *edit : {"move", "add", "remove", "shape", "stock"})
            QTest::addRow("%s one of %d", edit, sections) << sections << QString::fromLatin1(edit);
    }
}

// Wrong: a day's undo steps would fill the memory, as steps that copy what they do not change do.
void TestAnalysis::aStepCostsSixteenBytesASection()
{
    QFETCH(int, sections);
    QFETCH(QString, edit);
    Document document = newDocument();
    const ShapePointer strip = polygonShape(rectangle(0, 0, 200, 40));
    for (int i = 0; i < sections; ++i)
        document = withSection(std::move(document), strip, front(-20.0 * i));
    const auto model = std::make_shared<const Model>(evaluate(document));
    const ShapePointer other = polygonShape(rectangle(0, 0, 100, 40));
    const SectionId id = document.sections[4]->id;
    const auto edited = [&]() -> Document {
        if (edit == QStringLiteral("move"))
            return *moveSection(model->document, id, side());
        if (edit == QStringLiteral("add"))
            return withSection(model->document, other, side());
        if (edit == QStringLiteral("remove"))
            return *removeSections(model->document, std::vector{id});
        if (edit == QStringLiteral("shape"))
            return *setShape(model->document, id, other);
        Stock stock = *model->document.stocks.front();
        stock.thickness = 4.0;
        return *setStock(model->document, stock);
    };
    // What the history keeps of the step is the model after it.
    const std::int64_t before = bench::liveBytes();
    const auto after = std::make_shared<const Model>(evaluate(edited()));
    const std::int64_t counted = bench::liveBytes() - before;
    const auto lists = static_cast<std::int64_t>(sizeof(std::shared_ptr<void>) *
                                                 (static_cast<std::size_t>(sections) + 1 + 1));
    // The changed object with its text, and the model that holds the lists.
    const auto changed = static_cast<std::int64_t>(std::max(sizeof(Section), sizeof(Stock)) +
                                                   sizeof(Model) + 2 * 16 + 64);
    QVERIFY2(counted <= lists + changed, qPrintable(QString::number(counted)));
    QVERIFY2(counted >= 16 * sections - 16, qPrintable(QString::number(counted)));
    int kept = 0;
    for (const SectionPointer &s : after->document.sections)
        kept += std::count(model->document.sections.begin(), model->document.sections.end(), s);
    QVERIFY(kept >= sections - 1);
}

FFF_TEST(TestAnalysis)
#include "tst_analysis.moc"
