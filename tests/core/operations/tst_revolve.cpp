#include "core/assembly/crossing.h"
#include "core/geometry/arc_length.h"
#include "core/geometry/contour_points.h"
#include "tests/core/operations/operation_models.h"
#include "tests/test_program.h"

#include <QTest>

#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

/// A body, and a plate across its upper edge, turned by `skew` out of the right angle to it.
struct Plates
{
    Document document = newDocument();
    SectionId body, plate;

    explicit Plates(const Contour &contour, double skew = 0.0)
    {
        body = add(document, "Body", shapeOf(contour), frontFrame());
        const Vec3 across(std::sin(skew), 0.0, std::cos(skew));
        plate = add(document, "Plate", shapeOf(polygonContour(rectangleAt(-15, 40, 30, 40))),
                    {Vec3::Zero(), across, Vec3::UnitY()});
    }

    Model revolved(std::map<std::string, ParameterValue> values)
    {
        add(document,
            operation("revolve", {{"section", {plate}}, {"along", {body}}}, std::move(values)));
        return evaluate(document);
    }
};

double angleTo(const Section &section, const Vec2 &tangent)
{
    const Vec3 n = section.frame.normal();
    return std::acos(std::clamp(n.dot(Vec3(tangent.x(), tangent.y(), 0.0)), -1.0, 1.0));
}

} // namespace

class TestRevolve : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void angleToTheTangentIsKept_data();
    void angleToTheTangentIsKept();
    void stepsAreEqualAlongTheEdge();
    void insideIsMirrored();
    void holesAreFollowed();
    void askedAngle();
    void scaleFollowsTheGirth();
    void rangeAcrossTheSource();
    void apartMakesNothing();
};

void TestRevolve::angleToTheTangentIsKept_data()
{
    QTest::addColumn<int>("seed");
    QTest::addColumn<double>("skew");
    for (int seed = 1; seed <= 8; ++seed)
        QTest::addRow("blob %d", seed) << seed << 0.13 * (seed - 4);
}

// Wrong: plates would lean differently all along the back.
void TestRevolve::angleToTheTangentIsKept()
{
    QFETCH(int, seed);
    QFETCH(double, skew);
    std::mt19937 random(static_cast<unsigned>(seed));
    const Contour contour = blob(random, 9, 75);
    Plates plates(contour, skew);
    const Model model = plates.revolved({{"count", 17.0}, {"closed", true}});
    QCOMPARE(model.sectionCount(), 2U + 16U);
    const Section &plate = *model.section(1);
    const auto crossing =
        findCrossing(*model.section(0)->shape, model.section(0)->frame, *plate.shape, plate.frame);
    const Vec3 edge =
        crossing.axis.at(crossing.axis.direction.y() > 0 ? crossing.overlaps.back().to
                                                         : crossing.overlaps.front().from);
    const NearestPlace place = nearestPlace(contour, edge.head<2>());
    const double wanted = angleTo(plate, directionAt(contour, place.at));
    for (std::size_t i = 2; i < model.sectionCount(); ++i) {
        QCOMPARE(model.section(i)->shape, plate.shape);
    }
    const ArcLength length(model.section(0)->shape->contour());
    const double start = length.of(nearestPlace(length.contour(), edge.head<2>()).at);
    const OperationId id = model.document.operations[0]->id;
    for (int k = 1; k <= 16; ++k) {
        const Section *replica = model.find({id, std::to_string(k)});
        QVERIFY(replica);
        const CurvePoint at = length.at(start + k * length.total() / 17.0);
        const double got = angleTo(*replica, directionAt(length.contour(), at));
        QVERIFY2(std::abs(got - wanted) < 1e-9, qPrintable(QString::number(got - wanted)));
    }
}

// Wrong: spacing along a curve would be that of its chords, or of its parameters.
void TestRevolve::stepsAreEqualAlongTheEdge()
{
    Plates plates(circle({0, 0}, 50));
    const Model model =
        plates.revolved({{"repeatBy", std::string("spacing")}, {"spacing", 20.0}, {"to", 0.5}});
    // Four arcs for a circle, so the length is that of the circle to 0.03 %.
    const double length = ArcLength(circle({0, 0}, 50)).total();
    QCOMPARE(static_cast<double>(model.sectionCount() - 2), std::floor(0.5 * length / 20.0));
    double last = 0.0;
    for (std::size_t i = 2; i < model.sectionCount(); ++i) {
        const Vec3 y = model.section(i)->frame.y;
        const double angle = std::atan2(-y.x(), y.y());       // counter-clockwise
        QVERIFY(std::abs(angle - last - 20.0 / 50.0) < 5e-3); // arcs are not quite circles
        last = angle;
    }
}

// Wrong: spokes could not be put on the inside of a rim.
void TestRevolve::insideIsMirrored()
{
    Plates plates(circle({0, 0}, 50));
    const Model outside = plates.revolved({{"count", 8.0}, {"closed", true}});
    Plates others(circle({0, 0}, 50));
    const Model inside =
        others.revolved({{"count", 8.0}, {"closed", true}, {"side", std::string("inside")}});
    Plates both(circle({0, 0}, 50));
    const Model all =
        both.revolved({{"count", 8.0}, {"closed", true}, {"side", std::string("both")}});
    QCOMPARE(outside.sectionCount(), 2U + 7U);
    QCOMPARE(inside.sectionCount(), 2U + 7U);
    QCOMPARE(all.sectionCount(), 2U + 7U + 8U); // the source's own place, too
    for (std::size_t i = 2; i < 9; ++i) {
        const Section &out = *outside.section(i), &in = *inside.section(i);
        // The plate reaches from 10 inside to 30 outside.
        const auto reach = [](const Section &s) {
            double far = 0.0;
            for (const Vec2 &p : s.shape->region().outer)
                far = std::max(far, s.frame.toWorld(p).head<2>().norm());
            return far;
        };
        QVERIFY(std::abs(reach(in) - 60.0) < 0.3);
        QVERIFY(std::abs(reach(out) - 80.0) < 0.3);
    }
}

// Wrong: spokes of a window would be put round the outside.
void TestRevolve::holesAreFollowed()
{
    Document document = newDocument();
    const SectionId body =
        add(document, "Ring", shapeOf(circle({0, 0}, 80), {circle({0, 0}, 40)}), frontFrame());
    const SectionId plate =
        add(document, "Spoke", shapeOf(polygonContour(rectangleAt(-15, 10, 30, 40))),
            sideFrame({0, 0, 0}));
    add(document, operation("revolve", {{"section", {plate}}, {"along", {body}}},
                            {{"count", 4.0}, {"closed", true}}));
    const Model model = evaluate(document);
    QCOMPARE(model.sectionCount(), 5U);
    for (std::size_t i = 2; i < 5; ++i) {
        const Vec3 y = model.section(i)->frame.y;
        QVERIFY(std::abs(std::abs(y.x()) + std::abs(y.y()) - 1.0) < 1e-9); // quarter turns
        QVERIFY(model.section(i)->frame.origin.norm() < 1e-9);
    }
}

// Wrong: the angle that a person types would be another one in the view, or change with the side.
void TestRevolve::askedAngle()
{
    constexpr double kAsked = 60.0 * std::numbers::pi / 180.0;
    for (const char *side : {"outside", "inside"}) {
        Plates plates(circle({0, 0}, 50), 0.0);
        const Model model = plates.revolved(
            {{"count", 6.0}, {"closed", true}, {"angle", kAsked}, {"side", std::string(side)}});
        QCOMPARE(model.evaluation.results[0]->found.at("angle"), kAsked);
        const ArcLength length(model.section(0)->shape->contour());
        const double start = length.of(nearestPlace(length.contour(), {0, 50}).at);
        for (int k = 1; k <= 5; ++k) {
            const Section *replica =
                model.find({model.document.operations[0]->id,
                            (std::string(side) == "inside" ? "in/" : "") + std::to_string(k)});
            QVERIFY(replica);
            const CurvePoint at = length.at(start + k * length.total() / 6.0);
            const Vec2 tangent = directionAt(length.contour(), at);
            const Vec3 n = replica->frame.normal();
            // Of the plane, whose trace is at a right angle to its normal.
            const double sine = std::abs(n.dot(Vec3(tangent.x(), tangent.y(), 0.0)));
            QVERIFY(std::abs(sine - std::sin(kAsked)) < 1e-9);
        }
    }
    Plates plates(circle({0, 0}, 50), 0.0);
    const Model model = plates.revolved({{"count", 6.0}});
    QVERIFY(std::abs(model.evaluation.results[0]->found.at("angle") - std::numbers::pi / 2) < 1e-4);
}

// Wrong: plates on a thin tail would be as large as those on the back.
void TestRevolve::scaleFollowsTheGirth()
{
    Plates plates(polygonContour({{-100, 0}, {100, 15}, {100, 25}, {0, 50}, {-100, 60}}));
    const Model model =
        plates.revolved({{"count", 20.0}, {"closed", true}, {"scale", std::string("thickness")}});
    const double width = 30.0;
    double least = 10.0, most = 0.0;
    for (std::size_t i = 2; i < model.sectionCount(); ++i) {
        const double ratio = model.section(i)->shape->bounds().size().x() / width;
        least = std::min(least, ratio);
        most = std::max(most, ratio);
    }
    QVERIFY(least >= 0.1 && least < 0.6);
    QVERIFY(most > 1.2);
}

// Wrong: a row to both sides of the source could not be had.
void TestRevolve::rangeAcrossTheSource()
{
    Plates plates(circle({0, 0}, 50));
    const Model model = plates.revolved({{"count", 9.0}, {"from", 0.9}, {"to", 0.2}});
    const OperationId id = model.document.operations[0]->id;
    QCOMPARE(model.sectionCount(), 2U + 8U);
    QVERIFY(model.find({id, "1"}) && model.find({id, "-1"}) && !model.find({id, "8"}));
    for (std::size_t i = 2; i < model.sectionCount(); ++i) {
        const Vec3 y = model.section(i)->frame.y;
        const double turns = std::atan2(-y.x(), y.y()) / (2.0 * std::numbers::pi);
        QVERIFY(turns > -0.101 && turns < 0.201);
    }
}

// Wrong: a plate that floats beside the body would be turned about nothing.
void TestRevolve::apartMakesNothing()
{
    Plates plates(circle({0, 0}, 10));
    const Model model = plates.revolved({});
    QCOMPARE(model.sectionCount(), 2U);
    QCOMPARE(model.evaluation.results[0]->notices.front().kind, OperationNotice::Kind::InputsApart);
}

FFF_TEST(TestRevolve)
#include "tst_revolve.moc"
