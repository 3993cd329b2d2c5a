#include "core/interaction/pick.h"
#include "core/model/edits.h"
#include "core/operations/evaluate.h"
#include "tests/test_program.h"

#include <QTest>

#include <random>

using namespace fff;

namespace {

const Vec2 kViewport(1000.0, 1000.0);

Contour rectangle(double x0, double y0, double x1, double y1)
{
    return *Contour::fromPolygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

Document with(Document document, const Frame &frame, std::vector<Contour> holes = {})
{
    NewSection section;
    section.shape = *Shape::make(rectangle(-50, -40, 50, 40), std::move(holes));
    section.frame = frame;
    return *addSection(std::move(document), std::move(section));
}

Frame at(double z)
{
    Frame frame;
    frame.origin = {0, 0, z};
    return frame;
}

Ray rayFrom(const char *view, const Vec3 &through)
{
    Camera camera;
    orientationOfView(view, camera.orientation);
    return camera.rayThrough(camera.toScreen(through, kViewport), kViewport);
}

} // namespace

class TestPick : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hitsInsideTheContourOnly();
    void nearestFirst();
    void edgeOnViewsHitTheSideWall();
    void sideWallsOfHolesCount();
    void agreesWithASolid();
};

void TestPick::hitsInsideTheContourOnly()
{
    const Model model = evaluate(with(newDocument(), at(0), {rectangle(-10, -10, 10, 10)}));
    const auto countAt = [&](double x, double y) {
        return pick(model, rayFrom("front", {x, y, 0})).size();
    };
    QCOMPARE(countAt(30, 0), std::size_t(1));
    QCOMPARE(countAt(49.999, 39.999), std::size_t(1));
    QCOMPARE(countAt(50.001, 0), std::size_t(0));
    QCOMPARE(countAt(0, 0), std::size_t(0)); // in the hole
    QCOMPARE(countAt(9.999, 9.999), std::size_t(0));
    QCOMPARE(countAt(10.001, 0), std::size_t(1));
    const Hit hit = pick(model, rayFrom("front", {30, 12, 0})).front();
    QVERIFY((hit.local - Vec2(30, 12)).norm() < 1e-6);
    QVERIFY((hit.point - Vec3(30, 12, 0)).norm() < 1e-6);
}

void TestPick::nearestFirst()
{
    const Model model = evaluate(with(with(with(newDocument(), at(0)), at(30)), at(-30)));
    const auto order = [&](const char *view) {
        std::vector<int> sections;
        for (const Hit &hit : pick(model, rayFrom(view, {5, 5, 0})))
            sections.push_back(hit.section);
        return sections;
    };
    QCOMPARE(order("front"), (std::vector<int>{1, 0, 2}));
    QCOMPARE(order("back"), (std::vector<int>{2, 0, 1}));
}

/// A plate seen on edge is 3 mm wide there, not nothing.
void TestPick::edgeOnViewsHitTheSideWall()
{
    const Model model = evaluate(with(newDocument(), at(0)));
    const std::vector<Hit> hits = pick(model, rayFrom("right", {0, 5, 1.4}));
    QCOMPARE(hits.size(), std::size_t(1));
    QVERIFY((hits.front().local - Vec2(50, 5)).norm() < 1e-6);
    QVERIFY(pick(model, rayFrom("right", {0, 5, 1.6})).empty());
    QVERIFY(pick(model, rayFrom("right", {0, 41, 0})).empty());
    QVERIFY(!pick(model, rayFrom("top", {20, 0, -1.4})).empty());
}

void TestPick::sideWallsOfHolesCount()
{
    const Model model = evaluate(with(newDocument(), at(0), {rectangle(-10, -10, 10, 10)}));
    // Obliquely into the hole: it meets the hole's wall between the faces.
    const Vec3 into = Vec3(1.0, 0.0, -0.2).normalized();
    const Ray ray{Vec3(9.0, 0.0, 0.0) - 100.0 * into, into};
    const std::vector<Hit> hits = pick(model, ray);
    QCOMPARE(hits.size(), std::size_t(1));
    // The same way steeper passes through the hole.
    const Vec3 steep = Vec3(0.1, 0.0, -1.0).normalized();
    QVERIFY(pick(model, {Vec3(9.0, 0.0, 0.0) - 100.0 * steep, steep}).empty());
}

/// A hit exactly when some point of the ray lies in the solid, tried by walking along it.
void TestPick::agreesWithASolid()
{
    std::mt19937 random(6);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const Model model = evaluate(with(newDocument(), at(0), {rectangle(-30, -20, 10, 15)}));
    const Section &section = *model.section(0);
    int found = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3 through(70 * any(random), 60 * any(random), 2 * any(random));
        const Vec3 direction = Vec3(any(random), any(random), 0.3 * any(random)).normalized();
        const Ray ray{through - 300.0 * direction, direction};
        bool isSolid = false;
        double nearest =
            1e9; // how near the walk comes to a change of mind is not needed: skip near misses
        for (double s = 0.0; s < 600.0; s += 0.05) {
            const Vec3 p = ray.origin + s * direction;
            if (std::abs(p.z()) <= 1.5 &&
                locate(section.frame.toLocal(p), section.shape->region()) != Side::Outside) {
                isSolid = true;
                nearest = std::min(nearest, s);
            }
        }
        const std::vector<Hit> hits = pick(model, ray);
        if (isSolid) {
            QCOMPARE(hits.size(), std::size_t(1));
            QVERIFY(hits.front().distance <= nearest + 1e-6);
            QVERIFY(hits.front().distance >= nearest - 0.06);
            ++found;
        }
    }
    QVERIFY(found > 50);
}

FFF_TEST(TestPick)
#include "tst_pick.moc"
