// Sections that are cut back to others.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/assembly_plan.h"
#include "core/assembly/joint_editing.h"
#include "core/assembly/joint_words.h"
#include "core/assembly/trim.h"
#include "core/geometry/boolean.h"
#include "tests/core/assembly/line_oracle.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

Result<ShapePointer> firstTrimmed(const Model &model)
{
    return trimmed({*model.section(0), model.stockOf(0)}, {*model.section(1), model.stockOf(1)});
}

bool areInEachOther(const Model &model)
{
    AnalysisCaches caches;
    const Analysis analysis = analyse(model, caches);
    const std::vector<CutPlate> plates = platesOf(analysis.bodies);
    return plates.size() != 2 || fff::test::areInEachOther(plates[0], plates[1]);
}

} // namespace

class TestTrim : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingStaysInTheOther();
    void theLargerSideStays();
    void curvesStayCurves();
    void whatIsNotInTheOtherIsNotTrimmed();
    void theEasierOneLosesLess();
    void aTrimmedSectionCanHaveTabs();
};

// Wrong: who trims is told of a collision all the same, or loses more than was in the other.
void TestTrim::nothingStaysInTheOther()
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int k = 0; k < 100; ++k) {
        const double angle = (20.0 + 140.0 * uniform(random)) * std::numbers::pi / 180.0;
        std::vector<Polygon> holes;
        if (k % 2)
            holes.push_back(rectangle(-8 + 10 * uniform(random), -5, 8, 5 + 8 * uniform(random)));
        const double end = 30.0 * (uniform(random) - 0.5);
        const Polygon plate{{end, -25 * uniform(random) - 5}, {60, -20}, {60, 20}, {end + 4, 12}};
        const Polygon host{
            {-50, -40 * uniform(random) - 2}, {50, -20}, {40, 40 * uniform(random)}, {-40, 25}};
        const Model model =
            twoSections(polygonShape(plate), turned(angle), polygonShape(host, holes), front());
        const auto shape = firstTrimmed(model);
        if (!shape) {
            QVERIFY(shape.error().code == ErrorCode::BadValue ||
                    shape.error().code == ErrorCode::EmptyContour);
            continue;
        }
        const double before = model.section(0)->shape->area();
        QVERIFY((*shape)->area() < before);
        const Document next = *setShape(model.document, model.section(0)->id, *shape);
        Document none = next; // without a joint, if one of their axis is left
        JointOverride wanted;
        wanted.a = model.ref(0);
        wanted.b = model.ref(1);
        wanted.kind = JointKind::None;
        QVERIFY2(!areInEachOther(evaluate(*setJointOverride(none, wanted))),
                 qPrintable(QString::number(k)));
        // What was cut off was in the slab, or fell off with it.
        const auto again = firstTrimmed(evaluate(next));
        QVERIFY2(!again && again.error().code == ErrorCode::BadValue,
                 qPrintable(QString::number(k)));
    }
}

// Wrong: of a leg that goes through a plate the stump is what stays.
void TestTrim::theLargerSideStays()
{
    const Model model = twoSections(polygonShape(rectangle(-60, -10, 20, 10)), side(),
                                    polygonShape(rectangle(-50, -50, 50, 50)), front());
    const auto shape = firstTrimmed(model);
    QVERIFY(shape.has_value());
    QVERIFY(std::abs((*shape)->area() - 20 * 58.5) < 1e-3); // 3 mm of stock
    QVERIFY(std::abs((*shape)->bounds().min.x() + 60.0) < 1e-9);
    QVERIFY(std::abs((*shape)->bounds().max.x() + 1.5) < 1e-5);
}

// Wrong: a trimmed circle is a polygon from then on.
void TestTrim::curvesStayCurves()
{
    const double k = 0.5522847498 * 30;
    const auto disc = Shape::make(*Contour::fromPoints({{30, 0},
                                                        {30, k},
                                                        {k, 30},
                                                        {0, 30},
                                                        {-k, 30},
                                                        {-30, k},
                                                        {-30, 0},
                                                        {-30, -k},
                                                        {-k, -30},
                                                        {0, -30},
                                                        {k, -30},
                                                        {30, -k}}));
    QVERIFY(disc.has_value());
    const Model model =
        twoSections(*disc, side(20), polygonShape(rectangle(-50, -50, 50, 50)), front(10));
    const auto shape = firstTrimmed(model);
    QVERIFY(shape.has_value());
    QVERIFY((*shape)->controlPointCount() <= (*disc)->controlPointCount() + 6);
}

void TestTrim::whatIsNotInTheOtherIsNotTrimmed()
{
    const Model apart = twoSections(polygonShape(rectangle(-60, -10, -1.5, 10)), side(),
                                    polygonShape(rectangle(-50, -50, 50, 50)), front());
    const auto touching = firstTrimmed(apart);
    QVERIFY(!touching && touching.error().code == ErrorCode::BadValue);
    const Model parallel = twoSections(polygonShape(rectangle(0, 0, 10, 10)), front(),
                                       polygonShape(rectangle(0, 0, 10, 10)), front(1));
    QCOMPARE(firstTrimmed(parallel).error().code, ErrorCode::NearlyParallel);
    const Model within = twoSections(polygonShape(rectangle(-1, -1, 1, 1)), side(),
                                     polygonShape(rectangle(-50, -50, 50, 50)), front());
    QCOMPARE(firstTrimmed(within).error().code, ErrorCode::EmptyContour);
}

void TestTrim::theEasierOneLosesLess()
{
    const Model model = twoSections(polygonShape(rectangle(-60, -10, 20, 10)), side(),
                                    polygonShape(rectangle(-50, -50, 50, 50)), front());
    const JointRef joint(model.ref(0), model.ref(1));
    QCOMPARE(easierTrimmed(model, joint), std::optional(model.ref(0)));
    const JointEdit edit = trimTo(model, model.ref(0), model.ref(1));
    QVERIFY(edit.has_value());
    QVERIFY(edit->document.sections[1] == model.document.sections[1]); // the other one is as it was
    QCOMPARE(edit->step.words.text, steps::kTrimSection);
}

// Wrong: who trims to join with tabs is told that the section ends nowhere.
void TestTrim::aTrimmedSectionCanHaveTabs()
{
    const Model model = twoSections(polygonShape(rectangle(-60, -10, 20, 10)), side(),
                                    polygonShape(rectangle(-50, -50, 50, 50)), front());
    const JointRef joint(model.ref(0), model.ref(1));
    QVERIFY(!joinWithTabs(model, joint)); // it goes through
    const Model trimmed = evaluate(trimTo(model, model.ref(0), model.ref(1))->document);
    const JointEdit edit = joinWithTabs(trimmed, joint);
    QVERIFY(edit.has_value());
    const Model joined = evaluate(edit->document);
    AnalysisCaches caches;
    const Analysis analysis = analyse(joined, caches);
    QCOMPARE(analysis.assembly.joints.size(), std::size_t(1));
    QCOMPARE(analysis.assembly.joints.front().kind, JointKind::Tabs);
}

FFF_TEST(TestTrim)
#include "tests/told.h"
#include "tst_trim.moc"
