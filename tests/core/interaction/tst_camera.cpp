#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/units.h"
#include "core/interaction/camera.h"
#include "core/interaction/facing.h"
#include "core/interaction/view_fit.h"
#include "tests/test_program.h"

#include <numbers>
#include <random>

using namespace fff;

namespace {

const Vec2 kViewport(1280.0, 800.0);

class Random
{
public:
    explicit Random(unsigned seed) : m_engine(seed) {}
    double between(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(m_engine);
    }
    Vec2 pixel() { return {between(0.0, 1280.0), between(0.0, 800.0)}; }
    Vec3 point() { return {between(-300, 300), between(-300, 300), between(-300, 300)}; }
    Camera camera()
    {
        Camera camera;
        camera.target = point();
        camera.orientation =
            Eigen::Quaterniond(between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1))
                .normalized();
        camera.millimetresPerPixel = between(0.05, 2.0);
        return camera;
    }
    Camera camera(Projection projection)
    {
        Camera result = camera();
        result.projection = projection;
        if (projection == Projection::Perspective) // the points below stand before the eye
            result.millimetresPerPixel = between(0.8, 2.0);
        return result;
    }

private:
    std::mt19937 m_engine;
};

Camera named(const char *name)
{
    Camera camera;
    if (!orientationOfView(name, camera.orientation))
        qFatal("no such view");
    return camera;
}

} // namespace

class TestCamera : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void screenAndWorldAreInverse();
    void pinnedPointsStay();
    void orbitStopsAtStraightUpAndDown();
    void orbitTurnsTheWayOfTheDrag();
    void fittedShowsTheWholeBox();
    void emptyBoxShowsTheFirstPlane();
    void interpolationEndsWhereItShall();
    void namedViewsLookAsDefined_data();
    void namedViewsLookAsDefined();
    void facingLaws();
    void facingGoesToTheNearerSideWhateverTheLean();
    void facingExamples_data();
    void facingExamples();
    static void bothProjections_data();
    void screenAndWorldAreInverseInBoth_data() { bothProjections_data(); }
    void screenAndWorldAreInverseInBoth();
    void pinnedPointsStayInBoth_data() { bothProjections_data(); }
    void pinnedPointsStayInBoth();
    void zoomKeepsAllThatIsUnderTheCursor();
    void retargetingKeepsThePicture_data() { bothProjections_data(); }
    void retargetingKeepsThePicture();
    void orbitKeepsTheDistance();
    void fittedShowsTheWholeBoxInPerspective();
    void switchingKeepsTheSizeAtTheTarget();
    void fartherIsSmallerInPerspective();
};

void TestCamera::screenAndWorldAreInverse()
{
    Random random(1);
    for (int i = 0; i < 100; ++i) {
        const Camera camera = random.camera();
        const Vec2 pixel = random.pixel();
        QVERIFY((camera.toScreen(camera.pointAt(pixel, kViewport), kViewport) - pixel).norm() <
                1e-9);
        const Ray ray = camera.rayThrough(pixel, kViewport);
        const Vec3 further = ray.origin + random.between(0.0, 1e4) * ray.direction;
        QVERIFY((camera.toScreen(further, kViewport) - pixel).norm() < 1e-6);
        QVERIFY((ray.direction - camera.forward()).norm() < 1e-12);
    }
}

void TestCamera::pinnedPointsStay()
{
    Random random(2);
    for (int i = 0; i < 100; ++i) {
        const Camera camera = random.camera();
        const Vec3 point = random.point();
        const Vec2 pixel = random.pixel(), drag = random.pixel() - random.pixel();
        const auto offBy = [&](const Camera &c, const Vec3 &p, const Vec2 &at) {
            return (c.toScreen(p, kViewport) - at).norm();
        };
        QVERIFY(offBy(pinned(camera, point, pixel, kViewport), point, pixel) < 1e-9);
        const Vec3 under = camera.pointAt(pixel, kViewport);
        QVERIFY(offBy(zoomed(camera, random.between(0.2, 5.0), pixel, kViewport), under, pixel) <
                1e-9);
        QVERIFY(offBy(panned(camera, pixel, pixel + drag, kViewport), under, pixel + drag) < 1e-9);
        const Vec2 place = camera.toScreen(point, kViewport);
        QVERIFY(offBy(orbited(camera, drag, point, kViewport), point, place) < 1e-9);
    }
    const Camera untouched = zoomed(Camera(), 0.0, {1, 1}, kViewport);
    QCOMPARE(untouched.millimetresPerPixel, Camera().millimetresPerPixel);
}

void TestCamera::orbitStopsAtStraightUpAndDown()
{
    for (const double way : {1.0, -1.0}) {
        Camera camera;
        for (int i = 0; i < 100; ++i) {
            camera = orbited(camera, {3.0, 37.0 * way}, Vec3::Zero(), kViewport);
            QVERIFY(camera.up().y() > -1e-9); // never upside down
            QVERIFY(std::abs(camera.right().y()) < 1e-9);
        }
        QVERIFY(std::abs(camera.backward().y() - way) < 1e-9);
    }
}

void TestCamera::orbitTurnsTheWayOfTheDrag()
{
    const Vec3 near(0.0, 0.0, 100.0);
    const Camera camera = orbited(Camera(), {40.0, 30.0}, Vec3::Zero(), kViewport);
    const Vec2 moved = camera.toScreen(near, kViewport) - 0.5 * kViewport;
    QVERIFY(moved.x() > 0.0);
    QVERIFY(moved.y() > 0.0);
}

void TestCamera::fittedShowsTheWholeBox()
{
    Random random(3);
    for (int i = 0; i < 50; ++i) {
        Box3 box;
        box.extend(random.point());
        if (i % 5)
            box.extend(random.point());
        const Camera camera = fitted(random.camera(), box, kViewport);
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 p(corner & 1 ? box.min.x() : box.max.x(),
                         corner & 2 ? box.min.y() : box.max.y(),
                         corner & 4 ? box.min.z() : box.max.z());
            const Vec2 pixel = camera.toScreen(p, kViewport);
            QVERIFY((pixel.array() > 0.0).all() && (pixel.array() < kViewport.array()).all());
        }
    }
}

void TestCamera::emptyBoxShowsTheFirstPlane()
{
    const Camera camera = fitted(Camera(), Box3(), kViewport);
    QVERIFY((camera.toScreen({0, kFirstPlaneHeight, 0}, kViewport) - 0.5 * kViewport).norm() <
            1e-9);
    const Vec2 ground = camera.toScreen(Vec3::Zero(), kViewport);
    QVERIFY(ground.y() > 400.0 && ground.y() < 800.0);
}

void TestCamera::interpolationEndsWhereItShall()
{
    Random random(4);
    const Camera from = random.camera(), to = random.camera();
    QCOMPARE(interpolated(from, to, 0.0).target, from.target);
    QCOMPARE(interpolated(from, to, 1.0).target, to.target);
    const Camera middle = interpolated(from, to, 0.5);
    QVERIFY(std::abs(middle.millimetresPerPixel * middle.millimetresPerPixel -
                     from.millimetresPerPixel * to.millimetresPerPixel) < 1e-9);
    QVERIFY(std::abs(middle.orientation.angularDistance(from.orientation) -
                     middle.orientation.angularDistance(to.orientation)) < 1e-9);
}

void TestCamera::namedViewsLookAsDefined_data()
{
    QTest::addColumn<Vec3>("backward");
    QTest::addColumn<Vec3>("up");
    QTest::newRow("front") << Vec3(0, 0, 1) << Vec3(0, 1, 0);
    QTest::newRow("back") << Vec3(0, 0, -1) << Vec3(0, 1, 0);
    QTest::newRow("right") << Vec3(1, 0, 0) << Vec3(0, 1, 0);
    QTest::newRow("left") << Vec3(-1, 0, 0) << Vec3(0, 1, 0);
    QTest::newRow("top") << Vec3(0, 1, 0) << Vec3(0, 0, -1);
    QTest::newRow("bottom") << Vec3(0, -1, 0) << Vec3(0, 0, 1);
    const auto iso = [](const char *name, double x, double z) {
        const Vec3 backward = Vec3(x, 0.8, z).normalized();
        const Vec3 up = (Vec3::UnitY() - backward.y() * backward).normalized();
        QTest::newRow(name) << backward << up;
    };
    iso("iso1", 1, 1);
    iso("iso2", 1, -1);
    iso("iso3", -1, -1);
    iso("iso4", -1, 1);
}

void TestCamera::namedViewsLookAsDefined()
{
    QFETCH(Vec3, backward);
    QFETCH(Vec3, up);
    const Camera camera = named(QTest::currentDataTag());
    QVERIFY((camera.backward() - backward).norm() < 1e-12);
    QVERIFY((camera.up() - up).norm() < 1e-12);
    Eigen::Quaterniond untouched = Eigen::Quaterniond::Identity();
    QVERIFY(!orientationOfView("sideways", untouched));
    QVERIFY(untouched.coeffs() == Eigen::Quaterniond::Identity().coeffs());
}

/// Frontoparallel, from the nearer side, world up never downwards on the screen.
void TestCamera::facingLaws()
{
    Random random(5);
    for (int i = 0; i < 300; ++i) {
        const Vec3 normal = random.point().normalized();
        const Camera current = random.camera();
        Camera camera;
        camera.orientation = facingOrientation(current.orientation, normal);
        QVERIFY(camera.backward().cross(normal).norm() < 1e-9);
        QVERIFY(camera.backward().dot(current.backward()) > -0.0088);
        QVERIFY(camera.up().y() >= -1e-9);
        // Facing again turns no further.
        const Eigen::Quaterniond again = facingOrientation(camera.orientation, normal);
        QVERIFY(again.angularDistance(camera.orientation) < 1e-6);
    }
}

// Wrong: a plane that leans a degree away from the eye is looked at from behind, past the model.
void TestCamera::facingGoesToTheNearerSideWhateverTheLean()
{
    for (const char *name : {"front", "right", "iso1", "iso2", "iso3", "iso4"})
        for (int turn = 0; turn < 360; turn += 5)
            for (int lean = -5; lean <= 5; ++lean) {
                const Camera current = named(name);
                const double about = radians(turn), up = radians(lean);
                const Vec3 normal(std::cos(up) * std::cos(about), std::sin(up),
                                  std::cos(up) * std::sin(about));
                Camera camera;
                camera.orientation = facingOrientation(current.orientation, normal);
                const double faced = normal.dot(current.backward());
                if (std::abs(faced) > 0.0088)
                    QVERIFY(camera.backward().dot(faced > 0.0 ? normal : Vec3(-normal)) > 0.999);
                // From level views no farther than to the plane's side and upright on it.
                const double angle =
                    std::acos(std::clamp(camera.backward().dot(current.backward()), -1.0, 1.0));
                QVERIFY(angle < radians(90.6));
            }
    // Seen on edge from the front, the same side for every lean.
    for (int lean = -5; lean <= 5; ++lean) {
        Camera camera = named("front");
        camera.orientation = facingOrientation(
            camera.orientation, Vec3(std::cos(radians(lean)), std::sin(radians(lean)), 0.0));
        QVERIFY(camera.backward().x() > 0.99);
    }
}

void TestCamera::facingExamples_data()
{
    QTest::addColumn<QString>("from");
    QTest::addColumn<Vec3>("normal");
    QTest::addColumn<Vec3>("backward");
    QTest::addColumn<Vec3>("up");
    QTest::newRow("a standing slit, from the front: the eye moves to its right")
        << "front" << Vec3(-1, 0, 0) << Vec3(1, 0, 0) << Vec3(0, 1, 0);
    QTest::newRow("a level slit, from the front: down from the top")
        << "front" << Vec3(0, -1, 0) << Vec3(0, 1, 0) << Vec3(0, 0, -1);
    QTest::newRow("a level slit, from the back: the top, not turned round")
        << "back" << Vec3(0, 1, 0) << Vec3(0, 1, 0) << Vec3(0, 0, 1);
    QTest::newRow("a slit askew, from the top: upright, from the nearer side")
        << "top" << Vec3(1, 0, -1).normalized() << Vec3(-1, 0, 1).normalized() << Vec3(0, 1, 0);
    QTest::newRow("from a corner: the nearer side")
        << "iso1" << Vec3(0, 0, -1) << Vec3(0, 0, 1) << Vec3(0, 1, 0);
    const double tilt = radians(5.0);
    QTest::newRow("a slit that rises a little: seen level, not standing")
        << "front" << Vec3(-std::sin(tilt), std::cos(tilt), 0)
        << Vec3(-std::sin(tilt), std::cos(tilt), 0) << Vec3(0, 0, -1);
}

void TestCamera::facingExamples()
{
    QFETCH(QString, from);
    QFETCH(Vec3, normal);
    QFETCH(Vec3, backward);
    QFETCH(Vec3, up);
    Camera camera = named(from.toUtf8().constData());
    camera.orientation = facingOrientation(camera.orientation, normal);
    QVERIFY((camera.backward() - backward).norm() < 1e-9);
    QVERIFY((camera.up() - up).norm() < 1e-9);
}

void TestCamera::bothProjections_data()
{
    QTest::addColumn<Projection>("projection");
    QTest::newRow("orthographic") << Projection::Orthographic;
    QTest::newRow("perspective") << Projection::Perspective;
}

void TestCamera::screenAndWorldAreInverseInBoth()
{
    QFETCH(Projection, projection);
    Random random(11);
    for (int i = 0; i < 200; ++i) {
        const Camera camera = random.camera(projection);
        const Vec2 pixel = random.pixel();
        const Ray ray = camera.rayThrough(pixel, kViewport);
        QVERIFY(std::abs(ray.direction.norm() - 1.0) < 1e-12);
        const double depth = camera.eyeDistance(kViewport) * random.between(0.1, 1.5);
        QVERIFY((camera.toScreen(ray.origin + depth * ray.direction, kViewport) - pixel).norm() <
                1e-5);
        // And the ray through where a point is seen goes through the point.
        const Vec3 point = camera.target + 0.3 * (random.point() - camera.target);
        if (camera.scaleAt(point, kViewport) < 0.01)
            continue; // beside or behind the eye
        const Ray back = camera.rayThrough(camera.toScreen(point, kViewport), kViewport);
        QVERIFY((point - back.origin).cross(back.direction).norm() < 1e-6);
    }
}

void TestCamera::pinnedPointsStayInBoth()
{
    QFETCH(Projection, projection);
    Random random(12);
    for (int i = 0; i < 100; ++i) {
        const Camera camera = random.camera(projection);
        const Vec3 point = camera.target + 0.3 * random.point();
        const Vec2 pixel = random.pixel(), drag = 0.3 * (random.pixel() - random.pixel());
        const auto offBy = [&](const Camera &c, const Vec3 &p, const Vec2 &at) {
            return (c.toScreen(p, kViewport) - at).norm();
        };
        QVERIFY(offBy(pinned(camera, point, pixel, kViewport), point, pixel) < 1e-6);
        const Vec3 under = camera.pointAt(pixel, kViewport);
        QVERIFY(offBy(panned(camera, pixel, pixel + drag, kViewport), under, pixel + drag) < 1e-6);
        const Vec2 place = camera.toScreen(point, kViewport);
        QVERIFY(offBy(orbited(camera, drag, point, kViewport), point, place) < 1e-6);
        const Camera facing = turned(camera, random.camera().orientation, point, kViewport);
        QVERIFY(offBy(facing, point, place) < 1e-6);
        QVERIFY(std::abs(facing.scaleAt(point, kViewport) - camera.scaleAt(point, kViewport)) <
                1e-9);
    }
}

/// In perspective the eye moves along the cursor's ray, so that depth does not matter.
void TestCamera::zoomKeepsAllThatIsUnderTheCursor()
{
    Random random(13);
    for (int i = 0; i < 100; ++i) {
        const Camera camera = random.camera(Projection::Perspective);
        const Vec2 pixel = random.pixel();
        const Camera near = zoomed(camera, random.between(0.5, 2.0), pixel, kViewport);
        const Ray ray = camera.rayThrough(pixel, kViewport);
        for (const double depth : {0.6, 1.0, 1.7}) {
            const Vec3 point = ray.origin + depth * camera.eyeDistance(kViewport) * ray.direction;
            if (near.scaleAt(point, kViewport) > 0.01)
                QVERIFY((near.toScreen(point, kViewport) - pixel).norm() < 1e-6);
        }
    }
}

void TestCamera::retargetingKeepsThePicture()
{
    QFETCH(Projection, projection);
    Random random(14);
    for (int i = 0; i < 100; ++i) {
        const Camera camera = random.camera(projection);
        const Vec3 depth = camera.target + 0.3 * random.point();
        const Camera other = retargeted(camera, depth, kViewport);
        for (int k = 0; k < 5; ++k) {
            const Vec3 point = camera.target + 0.3 * random.point();
            QVERIFY((camera.toScreen(point, kViewport) - other.toScreen(point, kViewport)).norm() <
                    1e-6);
        }
        QVERIFY(std::abs(other.backward().dot(other.target - depth)) < 1e-6);
    }
    // Nothing behind the eye is a target.
    Camera camera = random.camera(Projection::Perspective);
    const Vec3 behind = camera.eye(kViewport) + 10.0 * camera.backward();
    QCOMPARE(retargeted(camera, behind, kViewport).millimetresPerPixel, camera.millimetresPerPixel);
}

void TestCamera::orbitKeepsTheDistance()
{
    Random random(15);
    Camera camera = random.camera(Projection::Perspective);
    const Vec3 pivot = camera.target + Vec3(20.0, -10.0, 40.0);
    const double before = (camera.eye(kViewport) - pivot).norm();
    for (int i = 0; i < 20; ++i)
        camera = orbited(camera, {7.0, i % 2 ? 5.0 : -3.0}, pivot, kViewport);
    QVERIFY(std::abs((camera.eye(kViewport) - pivot).norm() - before) < 1e-6);
}

void TestCamera::fittedShowsTheWholeBoxInPerspective()
{
    Random random(16);
    for (int i = 0; i < 100; ++i) {
        Box3 box;
        box.extend(random.point());
        if (i % 5)
            box.extend(random.point());
        const Vec2 viewport = i % 2 ? kViewport : Vec2(500.0, 900.0);
        const Camera camera = fitted(random.camera(Projection::Perspective), box, viewport);
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 p(corner & 1 ? box.min.x() : box.max.x(),
                         corner & 2 ? box.min.y() : box.max.y(),
                         corner & 4 ? box.min.z() : box.max.z());
            QVERIFY(camera.backward().dot(camera.eye(viewport) - p) > 0.0); // before the eye
            const Vec2 pixel = camera.toScreen(p, viewport);
            QVERIFY((pixel.array() > 0.0).all() && (pixel.array() < viewport.array()).all());
        }
    }
}

void TestCamera::switchingKeepsTheSizeAtTheTarget()
{
    Random random(17);
    Camera flat = random.camera(), deep = flat;
    deep.projection = Projection::Perspective;
    const Vec3 beside = flat.target + 30.0 * flat.right() + 12.0 * flat.up();
    QVERIFY((flat.toScreen(beside, kViewport) - deep.toScreen(beside, kViewport)).norm() < 1e-9);
}

void TestCamera::fartherIsSmallerInPerspective()
{
    Camera camera;
    camera.projection = Projection::Perspective;
    const Vec3 near(50.0, 0.0, 40.0), far(50.0, 0.0, -40.0);
    QVERIFY(camera.toScreen(near, kViewport).x() > camera.toScreen(far, kViewport).x() + 1.0);
}

FFF_TEST(TestCamera)
#include "tst_camera.moc"
