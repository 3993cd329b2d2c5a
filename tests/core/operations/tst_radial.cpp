#include "core/geometry/boolean.h"
#include "core/geometry/radial_contour.h"
#include "core/operations/baking.h"
#include "tests/core/operations/operation_models.h"
#include "tests/test_program.h"

#include <QTest>

#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kPi = std::numbers::pi;

/// A disc of 60 mm with a window beside its middle.
Model shaped(std::map<std::string, ParameterValue> values, const ShapePointer &shape = {})
{
    Document document = newDocument();
    const SectionId disc =
        add(document, "Disc", shape ? shape : shapeOf(circle({5, 7}, 60)), frontFrame());
    add(document, operation("radial", {{"section", {disc}}}, std::move(values)));
    return evaluate(document);
}

double radiusAt(const Shape &shape, const Vec2 &centre, double angle)
{
    // Where a ray from the middle leaves the contour last.
    double far = 0.0;
    const Vec2 u(std::cos(angle), std::sin(angle));
    const Polygon chords = shape.contour().flatten(1e-4).points;
    for (std::size_t i = 0; i < chords.size(); ++i) {
        const Vec2 p = chords[i] - centre, q = chords[(i + 1) % chords.size()] - centre;
        const double a = cross(u, p), b = cross(u, q);
        if ((a <= 0.0) == (b <= 0.0))
            continue;
        far = std::max(far, u.dot(p + a / (a - b) * (q - p)));
    }
    return far;
}

} // namespace

class TestRadial : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void contoursAreWhatTheyAreCalled();
    void teethRepeat_data();
    void teethRepeat();
    void ringsOfHoles();
    void holesThatFitStay();
    void drawnSectorRepeats();
    void theSectionStaysItself();
    void nothingThatFits();
};

// Wrong: other areas than those of the figures.
void TestRadial::contoursAreWhatTheyAreCalled()
{
    const ShapePointer discShape =
        shaped({{"kind", std::string("circle")}, {"outerRadius", 30.0}}).section(0)->shape;
    const Shape &disc = *discShape;
    QVERIFY(std::abs(disc.area() - kPi * 900.0) < 3.0);
    QVERIFY((disc.centroid() - Vec2(5, 7)).norm() < 1e-6);
    const ShapePointer starShape =
        shaped({{"kind", std::string("star")}, {"sectors", 5.0}}).section(0)->shape;
    const Shape &star = *starShape;
    QVERIFY(std::abs(star.area() - 5.0 * 40.0 * 28.0 * std::sin(kPi / 5.0)) < 1e-6);
    const double inner = kPi * 28.0 * 28.0, outer = kPi * 40.0 * 40.0;
    const ShapePointer squareShape =
        shaped({{"tooth", std::string("square")}, {"sectors", 12.0}}).section(0)->shape;
    const Shape &square = *squareShape;
    QVERIFY(std::abs(square.area() - 0.5 * (inner + outer)) < 60.0); // flanks are straight
    const ShapePointer taperedShape =
        shaped({{"tooth", std::string("trapezium")}, {"sectors", 12.0}}).section(0)->shape;
    const Shape &tapered = *taperedShape;
    QVERIFY(tapered.area() > inner && tapered.area() < outer);
    QVERIFY(square.isPlain() && tapered.isPlain());
}

void TestRadial::teethRepeat_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("tooth");
    QTest::addColumn<int>("count");
    for (const int count : {3, 8, 31, 200})
        for (const char *tooth : {"round", "square", "trapezium"})
            QTest::addRow("%d %s teeth", count, tooth) << "gear" << tooth << count;
    QTest::newRow("a star of 7") << "star"
                                 << "round" << 7;
}

// Wrong: one tooth would be another than the rest, or they would not be where they were turned to.
void TestRadial::teethRepeat()
{
    QFETCH(QString, kind);
    QFETCH(QString, tooth);
    QFETCH(int, count);
    const double phase = 0.3;
    const Model model = shaped({{"kind", kind.toStdString()},
                                {"tooth", tooth.toStdString()},
                                {"sectors", double(count)},
                                {"phase", phase}});
    const Shape &gear = *model.section(0)->shape;
    QVERIFY(gear.isPlain());
    for (const int i : {0, 1, count / 2, count - 1}) {
        const double angle = phase + 2.0 * kPi * i / count;
        QVERIFY(std::abs(radiusAt(gear, {5, 7}, angle) - 40.0) < 0.02);
        QVERIFY(std::abs(radiusAt(gear, {5, 7}, angle + kPi / count) - 28.0) < 0.02);
    }
}

// Wrong: holes would run into each other, or out of the disc.
void TestRadial::ringsOfHoles()
{
    for (const double count : {1.0, 6.0, 40.0, 200.0}) {
        const Model model = shaped({{"kind", std::string("holes")}, {"sectors", count}});
        const Shape &disc = *model.section(0)->shape;
        QCOMPARE(static_cast<double>(disc.holes().size()), count);
        QVERIFY(disc.isPlain());
        QVERIFY(disc.contour() == circle({5, 7}, 60));
    }
}

// Wrong: a bore would be lost when a disc becomes a gear.
void TestRadial::holesThatFitStay()
{
    const auto shape = shapeOf(circle({0, 0}, 60), {circle({0, 0}, 8), circle({0, 50}, 4)});
    const ShapePointer gearShape = shaped({}, shape).section(0)->shape;
    const Shape &gear = *gearShape;
    QCOMPARE(gear.holes().size(), 1U); // the other lies beside the gear
    const ShapePointer both = shaped({{"kind", std::string("star")},
                                      {"sectors", 5.0},
                                      {"outerRadius", 30.0},
                                      {"innerRadius", 15.0},
                                      {"applyTo", std::string("holes")}},
                                     shapeOf(circle({0, 0}, 60), {circle({0, 50}, 4)}))
                                  .section(0)
                                  ->shape;
    QCOMPARE(both->holes().size(), 2U);
}

// Wrong: what a person drew would not be what is repeated.
void TestRadial::drawnSectorRepeats()
{
    // A disc with one bump: five times the bump.
    Polygon polygon;
    for (int i = 0; i < 360; ++i) {
        const double angle = i * kPi / 180.0;
        const double bump = std::abs(angle - 0.2) < 0.3 ? 12.0 : 0.0;
        polygon.push_back((40.0 + bump) * Vec2(std::cos(angle), std::sin(angle)));
    }
    const auto shape = shapeOf(polygonContour(polygon), {circle({30, 6}, 4)});
    const Vec2 centre = shape->centroid();
    const Model model =
        shaped({{"kind", std::string("sector")}, {"sectors", 5.0}, {"phase", 0.2}}, shape);
    const Shape &flower = *model.section(0)->shape;
    QCOMPARE(flower.holes().size(), 5U);
    QVERIFY(flower.isPlain());
    for (int i = 0; i < 5; ++i) {
        const double angle = 0.2 + 2.0 * kPi * i / 5.0;
        QVERIFY(radiusAt(flower, centre, angle) > 48.0);
        QVERIFY(radiusAt(flower, centre, angle + kPi / 5.0) < 43.0);
    }
    // A circle about its middle comes out as it was, as far as four arcs are a circle.
    const Model same = shaped({{"kind", std::string("sector")}, {"sectors", 7.0}});
    QVERIFY(std::abs(same.section(0)->shape->area() - same.document.sections[0]->shape->area()) <
            5.0);
}

// Wrong: joints, weights and children of the section would be lost.
void TestRadial::theSectionStaysItself()
{
    const Model model = shaped({});
    QCOMPARE(model.sectionCount(), 1U);
    QVERIFY(model.section(0)->id.isValid());
    QCOMPARE(model.section(0)->id, model.document.sections[0]->id);
    QVERIFY(model.section(0) != model.document.sections[0]);
    const Document next = baked(model, model.document.operations[0]->id).value();
    QCOMPARE(next.sections[0]->shape, model.section(0)->shape);
    QVERIFY(next.operations.empty());
    // An edit elsewhere keeps the very object.
    Document more = model.document;
    add(more, "Other", shapeOf(circle({0, 0}, 5)), frontFrame({0, 0, 20}));
    QCOMPARE(evaluate(more, model).section(0), model.section(0));
}

// Wrong: holes beside the section would take it apart, or it would be lost.
void TestRadial::nothingThatFits()
{
    const Model model =
        shaped({{"kind", std::string("holes")}, {"outerRadius", 500.0}, {"innerRadius", 490.0}});
    QCOMPARE(model.sectionCount(), 1U);
    QVERIFY(model.section(0)->shape->holes().empty());
}

FFF_TEST(TestRadial)
#include "tst_radial.moc"
