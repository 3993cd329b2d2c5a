#include "core/assembly/assembly.h"
#include "core/geometry/symmetrised.h"
#include "core/operations/baking.h"
#include "tests/core/analysed.h"
#include "tests/core/operations/operation_models.h"
#include "tests/test_program.h"

#include <QTest>

#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

/// Across the plane x = 0 a body, askew; a leg and a shoe on it, to the right; a keel in the plane.
struct Beast
{
    Document document = newDocument();
    SectionId body, leg, shoe, keel;

    Beast()
    {
        body = add(document, "Body",
                   shapeOf(Contour::fromPoints({{-60, 60},
                                                {-30, 40},
                                                {30, 40},
                                                {80, 60},
                                                {90, 90},
                                                {60, 110},
                                                {20, 110},
                                                {-10, 108},
                                                {-50, 100}})
                               .value()),
                   frontFrame());
        leg = add(document, "Leg", shapeOf(polygonContour(rectangleAt(-10, 0, 20, 70))),
                  sideFrame({45, 0, 0}), Parent{SectionRef(body), {45, 70}, {45, 45}});
        shoe = add(document, "Shoe", shapeOf(polygonContour(rectangleAt(30, -15, 40, 30))),
                   {{0, 8, 0}, Vec3::UnitX(), -Vec3::UnitZ()},
                   Parent{SectionRef(leg), {-5, 8}, {5, 8}});
        keel = add(document, "Keel", shapeOf(polygonContour(rectangleAt(-20, 80, 40, 50))),
                   sideFrame({0, 0, 0}), Parent{SectionRef(body), {0, 80}, {0, 108}});
    }

    Model with(const char *kind, std::map<std::string, ParameterValue> values = {},
               std::map<std::string, std::vector<SectionRef>> inputs = {})
    {
        add(document, operation(kind, std::move(inputs), std::move(values)));
        return evaluate(document);
    }
};

double asymmetry(const Shape &shape, double x)
{
    const Moments m = shape.moments();
    return std::abs(m.centroid().x() - x);
}

} // namespace

class TestSymmetry : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oneSideStandsOnTheOther();
    void twiceIsTheIdentity();
    void whatIsDrawnOnBothSidesStays_data();
    void whatIsDrawnOnBothSidesStays();
    void symmetricShapesStayThemselves();
    void acrossASectionsPlane();
    void selectionOnly();
    void withoutJoining();
    void operationsAreMirroredToo();
    void turnedAllRound_data();
    void turnedAllRound();
    void turnedCentreBecomesRound();
    void uprightOnesThroughTheAxis();
    void aroundASlit();
    void bakedItStays();
    void halvesAndSectorsOfNastyShapes_data();
    void halvesAndSectorsOfNastyShapes();
    void sectorsMeetWithoutSplinters();
};

// Wrong: a leg on one side only, or two bodies in one place.
void TestSymmetry::oneSideStandsOnTheOther()
{
    Beast beast;
    const Model model = beast.with("mirror");
    QCOMPARE(model.sectionCount(), 4U + 2U);
    const OperationId id = model.document.operations[0]->id;
    const Section *leg = model.find({id, std::to_string(beast.leg.value)});
    const Section *shoe = model.find({id, std::to_string(beast.shoe.value)});
    QVERIFY(leg && shoe);
    QCOMPARE(leg->frame.origin, Vec3(-45, 0, 0));
    QCOMPARE(leg->shape, model.find(beast.leg)->shape);
    QCOMPARE(leg->parent->section, SectionRef(beast.body));
    QCOMPARE(leg->parent->slitTo, Vec2(-45, 45));
    QCOMPARE(shoe->parent->section, leg->ref());
    QCOMPARE(shoe->parent->slitTo, model.find(beast.shoe)->parent->slitTo);
    // The body is one and symmetric, the keel in the mirror is what it was.
    QVERIFY(asymmetry(*model.find(beast.body)->shape, 0.0) < 1e-6);
    QVERIFY(asymmetry(*model.document.find(beast.body)->shape, 0.0) > 1.0);
    QCOMPARE(model.find(beast.keel), model.document.find(beast.keel));
    QCOMPARE(heldGroups(analysed(model)).size(), 1U);
}

// Wrong: every look at the symmetry would double the model.
void TestSymmetry::twiceIsTheIdentity()
{
    Beast beast;
    const Model once = beast.with("mirror");
    const Model twice = beast.with("mirror");
    QCOMPARE(twice.sectionCount(), once.sectionCount());
    for (std::size_t i = 0; i < once.sectionCount(); ++i)
        QVERIFY(*twice.section(i)->shape == *once.section(i)->shape);
    QVERIFY(twice.evaluation.results[1]->sections.empty());
    QVERIFY(twice.evaluation.results[1]->changed.empty());
    // The image of an image is where it began, to the bit.
    Beast single;
    const OperationId first = [&] {
        single.with("mirror", {{"what", std::string("selection")}}, {{"sections", {single.leg}}});
        return single.document.operations[0]->id;
    }();
    single.document = removeSections(single.document, std::vector{single.shoe}).value();
    Operation again =
        operation("mirror", {{"sections", {SectionRef(first, std::to_string(single.leg.value))}}},
                  {{"what", std::string("selection")}});
    add(single.document, again);
    const Model model = evaluate(single.document);
    const Section &back = *model.evaluation.results[1]->sections.front();
    QVERIFY(back.frame == model.find(single.leg)->frame);
}

void TestSymmetry::whatIsDrawnOnBothSidesStays_data()
{
    QTest::addColumn<double>("off");
    QTest::addColumn<std::size_t>("copies"); // of the legs; the shoe has one
    QTest::newRow("exact") << 0.0 << 0UL;
    QTest::newRow("of a file with a few digits") << 0.003 << 0UL;
    QTest::newRow("by hand") << 0.05 << 0UL;
    QTest::newRow("elsewhere") << 0.5 << 2UL;
}

// Wrong: 14 doubles in a dinosaur whose legs were there on both sides, in the very places of
// others.
void TestSymmetry::whatIsDrawnOnBothSidesStays()
{
    QFETCH(double, off);
    QFETCH(std::size_t, copies);
    Beast beast;
    add(beast.document, "Other leg",
        shapeOf(polygonContour(rectangleAt(-10 + off, off, 20, 70 - off))),
        sideFrame({-45 - off, 0, 0}), Parent{SectionRef(beast.body), {-45, 70}, {-45, 45}});
    QCOMPARE(beast.with("mirror").sectionCount(), 5U + 1U + copies);
}

// Wrong: control points would be doubled each time a symmetric body is looked at.
void TestSymmetry::symmetricShapesStayThemselves()
{
    Document document = newDocument();
    add(document, "Body", shapeOf(circle({0, 50}, 40)), frontFrame());
    add(document, operation("mirror", {}));
    const Model model = evaluate(document);
    QVERIFY(!model.evaluation.listing);
    QCOMPARE(model.section(0), document.sections[0]);
}

// Wrong: only the world's planes would do.
void TestSymmetry::acrossASectionsPlane()
{
    Beast beast;
    const SectionId wall =
        add(beast.document, "Wall", shapeOf(circle({0, 50}, 30)), sideFrame({100, 0, 0}));
    const Model model = beast.with(
        "mirror", {{"plane", std::string("section")}, {"what", std::string("selection")}},
        {{"across", {wall}}, {"sections", {beast.leg, wall}}});
    const OperationId id = model.document.operations[0]->id;
    QVERIFY(
        (model.find({id, std::to_string(beast.leg.value)})->frame.origin - Vec3(155, 0, 0)).norm() <
        1e-9);
    QCOMPARE(model.evaluation.results[0]->sections.size(), 1U);
}

// Wrong: all of the model, where one leg was meant.
void TestSymmetry::selectionOnly()
{
    Beast beast;
    const Model model =
        beast.with("mirror", {{"what", std::string("selection")}}, {{"sections", {beast.leg}}});
    QCOMPARE(model.sectionCount(), 5U);
    QCOMPARE(model.find(beast.body), model.document.find(beast.body));
    Beast none;
    const Model nothing = none.with("mirror", {{"what", std::string("selection")}});
    QCOMPARE(nothing.sectionCount(), 4U);
    QCOMPARE(nothing.evaluation.results[0]->notices.front().kind,
             OperationNotice::Kind::InputMissing);
}

// Wrong: the switch would do nothing.
void TestSymmetry::withoutJoining()
{
    Beast beast;
    const Model model = beast.with("mirror", {{"join", false}});
    QCOMPARE(model.sectionCount(), 4U + 3U);
    QCOMPARE(model.find(beast.body), model.document.find(beast.body));
}

// Wrong: ribs of the right side would not stand on the left.
void TestSymmetry::operationsAreMirroredToo()
{
    Beast beast;
    const OperationId rows =
        add(beast.document, operation("linear", {{"section", {beast.leg}}, {"along", {beast.body}}},
                                      {{"repeatBy", std::string("spacing")},
                                       {"spacing", 15.0},
                                       {"side", std::string("back")}}));
    const Model model = beast.with("mirror");
    const auto made = model.resultOf(rows)->sections.size();
    QVERIFY(made >= 1);
    QCOMPARE(model.evaluation.results[1]->sections.size(), made + 2U);
    QVERIFY(
        model.find({model.document.operations[1]->id, "o" + std::to_string(rows.value) + "/-1"}));
}

void TestSymmetry::turnedAllRound_data()
{
    QTest::addColumn<int>("times");
    for (const int times : {2, 3, 4, 7, 60})
        QTest::addRow("%d times", times) << times;
}

// Wrong: legs of a table would not stand all round.
void TestSymmetry::turnedAllRound()
{
    QFETCH(int, times);
    Document document = newDocument();
    const SectionId leg =
        add(document, "Leg", shapeOf(polygonContour(rectangleAt(30, 0, 20, 70))), frontFrame());
    add(document, operation("rotational", {}, {{"times", double(times)}}));
    const Model model = evaluate(document);
    QCOMPARE(static_cast<int>(model.sectionCount()), times);
    for (int i = 1; i < times; ++i) {
        const Section *copy = model.find(
            {document.operations[0]->id, std::to_string(i) + "/" + std::to_string(leg.value)});
        QVERIFY(copy);
        const double angle = 2.0 * std::numbers::pi * i / times;
        QVERIFY((copy->frame.x - Vec3(std::cos(angle), 0, -std::sin(angle))).norm() < 1e-12);
        QCOMPARE(copy->shape, model.find(leg)->shape);
    }
}

// Wrong: a table's top would be there six times, or stay askew.
void TestSymmetry::turnedCentreBecomesRound()
{
    Document document = newDocument();
    const SectionId top =
        add(document, "Top", shapeOf(polygonContour({{-20, -40}, {60, -30}, {70, 20}, {-30, 50}})),
            {{0, 70, 0}, Vec3::UnitX(), -Vec3::UnitZ()});
    add(document, operation("rotational", {}, {{"times", 5.0}}));
    const Model model = evaluate(document);
    QCOMPARE(model.sectionCount(), 1U);
    const Shape &shape = *model.find(top)->shape;
    QVERIFY(shape.centroid().norm() < 1e-6);
    QVERIFY(shape.isPlain());
    // Again it stays what it is.
    add(document, operation("rotational", {}, {{"times", 5.0}}));
    const Model again = evaluate(document);
    QVERIFY(std::abs(again.find(top)->shape->area() - shape.area()) < 1e-3);
}

// Wrong: two plates in one place where the axis goes through an upright one.
void TestSymmetry::uprightOnesThroughTheAxis()
{
    Document document = newDocument();
    add(document, "Cross", shapeOf(polygonContour(rectangleAt(-20, 0, 60, 40))), frontFrame());
    add(document, operation("rotational", {}, {{"times", 4.0}}));
    const Model model = evaluate(document);
    QCOMPARE(model.sectionCount(), 2U);
    for (const SectionPointer &section : model.sections())
        QVERIFY(asymmetry(*section->shape, 0.0) < 1e-6);
}

// Wrong: flowers could stand upright only.
void TestSymmetry::aroundASlit()
{
    Document document = newDocument();
    const SectionId a = add(document, "A", shapeOf(circle({0, 0}, 30)), frontFrame());
    const SectionId b =
        add(document, "B", shapeOf(circle({0, 0}, 20)), {{0, 5, 0}, Vec3::UnitX(), -Vec3::UnitZ()});
    const SectionId petal =
        add(document, "Petal", shapeOf(circle({0, 60}, 10)), sideFrame({0, 0, 0}));
    add(document,
        operation(
            "rotational", {{"around", {a, b}}, {"sections", {petal}}},
            {{"axis", std::string("slit")}, {"times", 3.0}, {"what", std::string("selection")}}));
    const Model model = evaluate(document);
    // The axis lies along X at y = 5, and the petal is square to it beside it.
    QCOMPARE(model.sectionCount(), 3U + 2U);
    for (const SectionPointer &section : model.evaluation.results[0]->sections) {
        const Vec3 middle = section->frame.toWorld(section->shape->centroid());
        QVERIFY(std::abs((middle - Vec3(0, 5, 0)).norm() - 55.0) < 1e-6);
    }
}

// Wrong: what was symmetric would fall back to one side.
void TestSymmetry::bakedItStays()
{
    Beast beast;
    const Model model = beast.with("mirror");
    const Model after = evaluate(baked(model, model.document.operations[0]->id).value(), model);
    QCOMPARE(after.sectionCount(), model.sectionCount());
    QVERIFY(after.document.operations.empty());
    QVERIFY(asymmetry(*after.find(beast.body)->shape, 0.0) < 1e-6);
}

void TestSymmetry::halvesAndSectorsOfNastyShapes_data()
{
    QTest::addColumn<int>("index");
    const auto all = simpleContours();
    for (std::size_t i = 0; i < all.size(); ++i)
        QTest::newRow(all[i].name) << static_cast<int>(i);
}

// Wrong: a half and its image would overlap, leave a crack, or lose their curves.
void TestSymmetry::halvesAndSectorsOfNastyShapes()
{
    QFETCH(int, index);
    const Contour contour = simpleContours()[static_cast<std::size_t>(index)].contour;
    const Vec2 middle = contour.bounds().center();
    for (const double angle : {0.0, 0.4, 1.9}) {
        const Vec2 inward(std::cos(angle), std::sin(angle));
        const Halfplane half{middle, inward};
        double area = 0.0, sum = 0.0;
        const auto halves = *clip(contour, {}, half);
        for (const ClippedPiece &piece : halves) {
            area += std::abs(piece.outer.signedArea());
            for (const Contour &hole : piece.holes)
                area -= std::abs(hole.signedArea());
        }
        const auto mirrored = *mirroredHalf(contour, {}, half);
        for (const ClippedPiece &piece : mirrored) {
            sum += std::abs(piece.outer.signedArea());
            for (const Contour &hole : piece.holes)
                sum -= std::abs(hole.signedArea());
        }
        const double rounding = 0.01 + 1e-4 * contour.bounds().size().norm();
        QVERIFY2(std::abs(sum - 2.0 * area) < rounding,
                 qPrintable(QString::number(sum - 2.0 * area)));
    }
    // One sector more or less round is the same, and a whole turn is all of it.
    const auto areaOf = [](const std::vector<ClippedPiece> &pieces) {
        double sum = 0.0;
        for (const ClippedPiece &piece : pieces) {
            sum += std::abs(piece.outer.signedArea());
            for (const Contour &hole : piece.holes)
                sum -= std::abs(hole.signedArea());
        }
        return sum;
    };
    const double rounding = 0.01 + 1e-4 * contour.bounds().size().norm();
    QVERIFY(std::abs(areaOf(*repeatedSector(contour, {}, middle, 1, 0.7)) -
                     std::abs(contour.signedArea())) < rounding);
    for (const int count : {2, 3, 12}) {
        const double turn = 2.0 * std::numbers::pi / count;
        double all = 0.0; // of each sector in its turn, repeated, the mean is the contour
        for (int i = 0; i < count; ++i)
            all += areaOf(*repeatedSector(contour, {}, middle, count, 0.7 + i * turn));
        QVERIFY(std::abs(all / count - std::abs(contour.signedArea())) < rounding);
    }
}

// Wrong: where sectors meet, the edge goes a hair's breadth back and on again; a crease is drawn.
void TestSymmetry::sectorsMeetWithoutSplinters()
{
    for (const int count : {2, 3, 4, 5, 6, 7, 12}) {
        for (const double radius : {38.0, 47.0, 60.0}) {
            const auto pieces = *repeatedSector(circle({0, 0}, radius), {}, {0, 0}, count, 0.0);
            QCOMPARE(pieces.size(), 1U);
            const Contour &outer = pieces.front().outer;
            for (int i = 0; i < outer.segmentCount(); ++i) {
                const CubicBezier segment = outer.segment(i);
                QVERIFY2((segment.p3 - segment.p0).norm() > 1e-6,
                         qPrintable(QString::number(count)));
            }
        }
    }
}

FFF_TEST(TestSymmetry)
#include "tst_global_symmetry.moc"
