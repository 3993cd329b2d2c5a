#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/camera.h"
#include "core/interaction/snapping.h"
#include "core/model/edits.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <cmath>
#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;
using Kind = Snap::Kind;

namespace {

constexpr double kScale = 0.5; // mm per pixel: the grid has 5 mm, the reach is 4 mm

bool isNear(double a, double b)
{
    return std::abs(a - b) < 1e-9;
}
bool isNear(const Vec2 &a, const Vec2 &b)
{
    return (a - b).norm() < 1e-9;
}

/// The plane Z = 0 seen from the front, with its own origin and axes askew in it.
Frame uprightCanvas()
{
    const double angle = 0.3;
    return {Vec3(12.34, 56.78, 0.0), Vec3(std::cos(angle), std::sin(angle), 0.0),
            Vec3(-std::sin(angle), std::cos(angle), 0.0)};
}

SnapTargets upright()
{
    return {uprightCanvas(), Eigen::Quaterniond::Identity()};
}

/// Given where the grid counts it.
Vec2 at(const SnapTargets &targets, double x, double y)
{
    return targets.fromGrid({x, y});
}

bool hasPoint(const SnapTargets &targets, const Vec3 &world)
{
    for (const Vec2 &point : targets.points()) {
        if ((targets.canvas().toWorld(point) - world).norm() < 1e-9)
            return true;
    }
    return false;
}

Model modelWith(const std::vector<NewSection> &sections)
{
    Document document = newDocument();
    for (const NewSection &section : sections)
        document = *addSection(std::move(document), section);
    return {std::move(document), {}};
}

NewSection plate(const Frame &frame)
{
    NewSection section;
    section.shape = polygonShape(rectangle(-100, -60, 100, 60), {rectangle(-15, -15, 15, 15)});
    section.frame = frame;
    return section;
}

} // namespace

class TestSnapping : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void gridsAreLevelAndCountFromTheGround();
    void levelCanvasesCountFromTheOrigin();
    void stepsAreRoundAndWideEnough();
    void theStrongestCatches_data();
    void theStrongestCatches();
    void gridPointsAreRound();
    void whatCaughtHoldsALittleLonger();
    void snappingTwiceChangesNothing();
    void heldDirectionsAreExact();
    void whereTheModelMeetsTheCanvas();
    void curvesAreMetOnTheCurve();
    void hiddenAndExceptedSectionsDoNotCatch();
    void endsOfSlitsCatch();
    void whereAPlaneCrossesAGuide();
};

/// Heights must be round whatever way a canvas lies: its own origin is where somebody pressed.
void TestSnapping::gridsAreLevelAndCountFromTheGround()
{
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 500; ++i) {
        const Vec3 x = Vec3(normal(random), normal(random), normal(random)).normalized();
        const Vec3 other = Vec3(normal(random), normal(random), normal(random));
        const Frame canvas{100.0 * other, x, x.cross(other).normalized()};
        if (std::hypot(canvas.normal().x(), canvas.normal().z()) < 0.05)
            continue;
        const Eigen::Quaterniond eye =
            Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
                .normalized();
        const Frame grid = canvasGrid(canvas, eye);
        QVERIFY(isNear(grid.x.norm(), 1.0) && isNear(grid.y.norm(), 1.0));
        QVERIFY(isNear(grid.x.dot(grid.y), 0.0));
        QVERIFY(isNear(grid.x.y(), 0.0) && grid.y.y() > 0.0);
        QVERIFY(std::abs(grid.origin.y()) < 1e-7);
        QVERIFY(std::abs(canvas.height(grid.toWorld({30.0, 40.0}))) < 1e-7);
        // As seen by the eye: x to the right when y is up.
        QVERIFY(grid.x.cross(grid.y).dot(eye * Vec3::UnitZ()) >= 0.0);
    }
}

void TestSnapping::levelCanvasesCountFromTheOrigin()
{
    const Frame ground{Vec3(7, 1.5, 3), Vec3::UnitZ(), Vec3::UnitX()};
    Eigen::Quaterniond top;
    QVERIFY(orientationOfView("top", top));
    const SnapTargets targets(ground, top);
    QVERIFY(!targets.meetsGround());
    QVERIFY((targets.grid().origin - Vec3(0, 1.5, 0)).norm() < 1e-12);
    QVERIFY((targets.grid().x - Vec3::UnitX()).norm() < 1e-12);
    QVERIFY((targets.grid().y + Vec3::UnitZ()).norm() < 1e-12);
}

void TestSnapping::stepsAreRoundAndWideEnough()
{
    for (double scale = 1e-4; scale < 1e3; scale *= 1.07) {
        const double step = gridStep(scale), pixels = step / scale;
        QVERIFY2(pixels > kGridPixels * (1.0 - 1e-12) && pixels < 2.5001 * kGridPixels,
                 qPrintable(QString::number(pixels)));
        const double lead = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
        QVERIFY(isNear(lead, 1.0) || isNear(lead, 2.0) || isNear(lead, 5.0));
    }
    QCOMPARE(gridStep(1.25), 10.0);
    QCOMPARE(gridStep(0.5), 5.0);
}

void TestSnapping::theStrongestCatches_data()
{
    QTest::addColumn<Vec2>("free");
    QTest::addColumn<int>("kind");
    QTest::addColumn<Vec2>("point");
    QTest::addColumn<int>("anchors");
    QTest::addColumn<bool>("ground");
    // All in the grid. A point at (31, 41); lines through (20.3, 40.7) and (60.1, 85.2).
    const auto row = [](const char *name, const Vec2 &free, Kind kind, const Vec2 &point,
                        int anchors = 0, bool ground = false) {
        QTest::newRow(name) << free << int(kind) << point << anchors << ground;
    };
    row("far from everything: the grid", {101.2, 133.4}, Kind::Grid, {100, 135});
    row("a point", {32, 42}, Kind::Point, {31, 41});
    row("a point before the lines through another", {29, 40.7}, Kind::Point, {31, 41});
    row("a level line, and the grid on it", {131.1, 43}, Kind::Line, {130, 40.7}, 1);
    row("an upright line, and the grid on it", {58, 131.1}, Kind::Line, {60.1, 130}, 1);
    row("where two lines cross", {62, 38}, Kind::Crossing, {60.1, 40.7}, 2);
    row("the ground", {131.1, 2.9}, Kind::Line, {130, 0}, 0, true);
    row("below the ground", {131.1, -2.9}, Kind::Line, {130, 0}, 0, true);
    row("where a line meets the ground", {21, 3}, Kind::Crossing, {20.3, 0}, 1, true);
    row("just out of reach of a line", {131.1, 44.8}, Kind::Grid, {130, 45});
}

void TestSnapping::theStrongestCatches()
{
    QFETCH(Vec2, free);
    QFETCH(int, kind);
    QFETCH(Vec2, point);
    SnapTargets targets = upright();
    targets.addPoint(at(targets, 31, 41));
    targets.alignWith(at(targets, 20.3, 40.7));
    targets.alignWith(at(targets, 60.1, 85.2));
    const Snap snap = snapped(targets.fromGrid(free), targets, kScale, {});
    QCOMPARE(int(snap.kind), kind);
    QVERIFY(isNear(targets.toGrid(snap.point), point));
    QTEST(int(snap.anchors.size()), "anchors");
    QTEST(snap.isOnGround, "ground");
}

void TestSnapping::gridPointsAreRound()
{
    const SnapTargets targets = upright();
    std::mt19937 random(9);
    std::uniform_real_distribution<double> place(5.0, 400.0);
    for (int i = 0; i < 500; ++i) {
        const double scale = 0.01 * place(random), step = gridStep(scale);
        const Vec2 free(place(random), place(random) + 50.0 * scale);
        const Snap snap = snapped(targets.fromGrid(free), targets, scale, {});
        const Vec2 counted = targets.toGrid(snap.point) / step;
        QVERIFY(std::abs(counted.x() - std::round(counted.x())) * step < 1e-9);
        QVERIFY(std::abs(counted.y() - std::round(counted.y())) * step < 1e-9);
        QVERIFY((targets.toGrid(snap.point) - free).cwiseAbs().maxCoeff() <= 0.5 * step + 1e-9);
    }
}

/// At the border of the reach a trembling hand must not make the point jump to and fro.
void TestSnapping::whatCaughtHoldsALittleLonger()
{
    SnapTargets targets = upright();
    targets.addPoint(at(targets, 131, 141));
    targets.alignWith(at(targets, 20.3, 40.7));
    const Vec2 near = at(targets, 131 + 3.9, 141), far = at(targets, 131 + 5.1, 141),
               gone = at(targets, 131 + 5.3, 141);
    const Snap caught = snapped(near, targets, kScale, {});
    QCOMPARE(int(caught.kind), int(Kind::Point));
    QCOMPARE(int(snapped(far, targets, kScale, {}).kind), int(Kind::Grid));
    QCOMPARE(int(snapped(far, targets, kScale, caught).kind), int(Kind::Point));
    QCOMPARE(int(snapped(gone, targets, kScale, caught).kind), int(Kind::Grid));

    const Snap onLine = snapped(at(targets, 80, 40.7 + 3.9), targets, kScale, {});
    QCOMPARE(int(onLine.kind), int(Kind::Line));
    QCOMPARE(int(snapped(at(targets, 80, 45.8), targets, kScale, {}).kind), int(Kind::Grid));
    QCOMPARE(int(snapped(at(targets, 80, 45.8), targets, kScale, onLine).kind), int(Kind::Line));
}

void TestSnapping::snappingTwiceChangesNothing()
{
    SnapTargets targets = upright();
    targets.addPoint(at(targets, 31, 41));
    targets.alignWith(at(targets, 20.3, 40.7));
    for (double x = -20.0; x < 80.0; x += 1.7) {
        for (double y = -20.0; y < 80.0; y += 1.9) {
            const Snap once = snapped(at(targets, x, y), targets, kScale, {});
            const Snap twice = snapped(once.point, targets, kScale, once);
            QVERIFY(twice.kind >= once.kind);
            if (twice.kind == once.kind)
                QVERIFY(isNear(once.point, twice.point));
        }
    }
}

/// What is held level must be level to the last bits: a rectangle of such points has right angles.
void TestSnapping::heldDirectionsAreExact()
{
    SnapTargets targets = upright();
    targets.alignWith(at(targets, 60.1, 85.2));
    const Vec2 from = at(targets, 20, 30);
    for (int degrees = 0; degrees < 360; degrees += 7) {
        const double angle = degrees * std::numbers::pi / 180.0;
        const Vec2 free = at(targets, 20 + 57.3 * std::cos(angle), 30 + 57.3 * std::sin(angle));
        for (const bool snaps : {false, true}) {
            const Snap snap = held(free, from, targets, kScale, snaps);
            const Vec2 way = targets.toGrid(snap.point) - Vec2(20, 30);
            const double eighth = std::atan2(way.y(), way.x()) / (std::numbers::pi / 4.0);
            QVERIFY(std::abs(eighth - std::round(eighth)) < 1e-9);
            QVERIFY(std::abs(std::remainder(std::atan2(way.y(), way.x()) - angle,
                                            2.0 * std::numbers::pi)) < 0.4);
            if (!snaps)
                QVERIFY(isNear(snap.point, held(snap.point, from, targets, kScale, false).point));
        }
    }
    const Snap level = held(at(targets, 58.5, 33), from, targets, kScale, true);
    QVERIFY(isNear(targets.toGrid(level.point), {60.1, 30}));
    QCOMPARE(int(level.kind), int(Kind::Crossing));
    QVERIFY(isNear(targets.toGrid(held(at(targets, 43, 33), from, targets, kScale, true).point),
                   {45, 30}));
    // Downwards to the ground.
    const Snap down = held(at(targets, 21, 2), from, targets, kScale, true);
    QVERIFY(isNear(targets.toGrid(down.point), {20, 0}) && down.isOnGround);
}

void TestSnapping::whereTheModelMeetsTheCanvas()
{
    // An upright plate in X = 10, and one in the canvas itself.
    const Frame across{Vec3(10, 80, 0), -Vec3::UnitZ(), Vec3::UnitY()};
    const Frame along{Vec3(300, 80, 0), Vec3::UnitX(), Vec3::UnitY()};
    SnapTargets targets = upright();
    targets.addModel(modelWith({plate(across), plate(along)}), {}, {});
    for (const double y : {20.0, 65.0, 95.0, 140.0})
        QVERIFY(hasPoint(targets, {10, y, 0}));
    for (const Vec3 &corner : {Vec3(200, 20, 0), Vec3(400, 140, 0), Vec3(315, 95, 0)})
        QVERIFY(hasPoint(targets, corner));
    QCOMPARE(targets.points().size(), std::size_t(4 + 8));
}

void TestSnapping::curvesAreMetOnTheCurve()
{
    // A disc of radius 50 in X = 0, met 17 mm beside its middle.
    NewSection disc;
    disc.shape = *Shape::make(circle({0, 0}, 50));
    disc.frame = {Vec3(0, 100, 17), -Vec3::UnitZ(), Vec3::UnitY()};
    SnapTargets targets = upright();
    targets.addModel(modelWith({disc}), {}, {});
    QCOMPARE(targets.points().size(), std::size_t(2));
    const Contour &contour = disc.shape->contour();
    for (const Vec2 &point : targets.points()) {
        const Vec2 local = disc.frame.toLocal(targets.canvas().toWorld(point));
        QVERIFY(isNear(local.x(), 17.0));
        double nearest = 1e9;
        for (int i = 0; i < 4; ++i) {
            const CubicBezier segment = contour.segment(i);
            double low = 0.0, high = 1.0; // x is monotone on each quarter
            const bool rises = segment.p3.x() > segment.p0.x();
            for (int step = 0; step < 60; ++step) {
                const double middle = 0.5 * (low + high);
                ((segment.at(middle).x() < 17.0) == rises ? low : high) = middle;
            }
            nearest = std::min(nearest, (segment.at(low) - local).norm());
        }
        QVERIFY(nearest < 1e-9);
    }
}

/// Nobody can see why a point jumps to what is hidden.
void TestSnapping::hiddenAndExceptedSectionsDoNotCatch()
{
    const Frame across{Vec3(10, 80, 0), -Vec3::UnitZ(), Vec3::UnitY()};
    const Model model = modelWith({plate(across)});
    SnapTargets targets = upright();
    targets.addModel(model, {}, model.ref(0));
    QVERIFY(targets.points().empty());
    ViewState view;
    view.hidden.insert(model.ref(0));
    targets.addModel(model, view, {});
    QVERIFY(targets.points().empty());
    targets.addModel(model, {}, {});
    QCOMPARE(targets.points().size(), std::size_t(4));
}

void TestSnapping::endsOfSlitsCatch()
{
    // A child stands on the plate in the canvas; its slit lies in the canvas.
    Document document =
        *addSection(newDocument(), plate({Vec3(0, 80, 0), Vec3::UnitX(), Vec3::UnitY()}));
    NewSection child = plate({Vec3(500, 80, 0), Vec3::UnitZ(), Vec3::UnitY()});
    child.parent = Parent{document.sections.front()->id, {40, 10}, {40, 60}};
    document = *addSection(std::move(document), child);
    SnapTargets targets = upright();
    targets.addModel({document, {}}, {}, {});
    QVERIFY(hasPoint(targets, {40, 90, 0}));
    QVERIFY(hasPoint(targets, {40, 140, 0}));
}

// Wrong: a contour that follows the template misses by a millimetre the one that it is to meet.
void TestSnapping::whereAPlaneCrossesAGuide()
{
    const double turn = 0.6;
    const Vec3 across(std::cos(turn), 0.0, std::sin(turn)); // its normal
    const Model model =
        modelWith({plate({Vec3(40, 900, 0), Vec3::UnitY(), across.cross(Vec3::UnitY())}),
                   plate({Vec3(0, 900, 30), Vec3::UnitX(), Vec3::UnitY()})}); // parallel
    SnapTargets targets = upright();
    const auto onCanvas = [&](double x, double y) {
        return targets.canvas().toLocal(Vec3(x, y, 0.0));
    };
    const GuideLine square{{onCanvas(0, 0), onCanvas(100, 0), onCanvas(100, 100), onCanvas(0, 100)},
                           false};
    GuideLine open = square; // without its left side
    open.isOpen = true;
    // The plane meets the canvas in x = 40, where neither section reaches.
    for (const GuideLine &guide : {square, open}) {
        SnapTargets caught = targets;
        caught.setGuides(std::make_shared<const std::vector<GuideLine>>(1, guide), 10.0);
        caught.addGuideCrossings(model, {}, {});
        QCOMPARE(caught.points().size(), std::size_t(2));
        QVERIFY(hasPoint(caught, {40, 0, 0}));
        QVERIFY(hasPoint(caught, {40, 100, 0}));
        const Snap snap = snapped(onCanvas(41, 98), caught, kScale, {});
        QCOMPARE(snap.kind, Kind::Point);
        QVERIFY(isNear(snap.point, onCanvas(40, 100)));
        QCOMPARE(snapped(onCanvas(60, 98), caught, kScale, {}).kind, Kind::Guide);
        caught.addGuideCrossings(model, {}, model.ref(0));
        QCOMPARE(caught.points().size(), std::size_t(2));
    }
    ViewState view;
    view.hidden.insert(model.ref(0));
    targets.setGuides(std::make_shared<const std::vector<GuideLine>>(1, square), 10.0);
    targets.addGuideCrossings(model, view, {});
    QVERIFY(targets.points().empty());
}

FFF_TEST(TestSnapping)
#include "tst_snapping.moc"
