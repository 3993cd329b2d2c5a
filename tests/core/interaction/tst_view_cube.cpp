#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/camera.h"
#include "core/interaction/view_cube.h"
#include "tests/test_program.h"

#include <map>
#include <random>
#include <set>
#include <tuple>

using namespace fff;

namespace {

const Vec2 kViewport(800.0, 600.0);

std::tuple<int, int, int> key(const CubePart &part)
{
    return {part.x, part.y, part.z};
}

Vec3 direction(const CubePart &part)
{
    return Vec3(part.x, part.y, part.z).normalized();
}

} // namespace

class TestViewCube : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void thereAre26Parts();
    void everyPartCanBeHit();
    void partsAreHitWhereTheyAreDrawn();
    void besideIsNothing();
    void turnsLookAtThePart();
    void facesAreTheNamedViews();
    void sideLettersStandUpright();
    void staysInItsRoom();
};

void TestViewCube::thereAre26Parts()
{
    std::set<std::tuple<int, int, int>> all;
    std::map<int, int> ranks;
    for (const CubePart &part : cubeParts()) {
        all.insert(key(part));
        ++ranks[part.rank()];
    }
    QCOMPARE(all.size(), std::size_t(26));
    QCOMPARE(ranks[1], 6);
    QCOMPARE(ranks[2], 12);
    QCOMPARE(ranks[3], 8);
}

/// A part that cannot be clicked from any side would be a view that cannot be had.
void TestViewCube::everyPartCanBeHit()
{
    std::set<std::tuple<int, int, int>> hit;
    for (const CubePart &part : cubeParts()) {
        const Eigen::Quaterniond orientation = orientationOfPart(part);
        const std::optional<CubePart> found =
            cubePartAt(*cubeCentre(kViewport), orientation, kViewport);
        QVERIFY(found);
        QVERIFY(*found == part); // looked at straight, it is in the middle
        hit.insert(key(*found));
    }
    QCOMPARE(hit.size(), std::size_t(26));
}

void TestViewCube::partsAreHitWhereTheyAreDrawn()
{
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> between(-1.0, 1.0);
    for (int i = 0; i < 60; ++i) {
        const Eigen::Quaterniond orientation =
            Eigen::Quaterniond(between(engine), between(engine), between(engine), between(engine))
                .normalized();
        int tested = 0;
        for (const CubeFace &face : visibleFaces(orientation, kViewport)) {
            double covered = 0.0;
            for (const CubePart &part : cubeParts()) {
                const auto corners = partOnFace(face, part);
                if (!corners)
                    continue;
                Vec2 middle = Vec2::Zero();
                for (const Vec2 &p : *corners)
                    middle += 0.25 * p;
                const auto found = cubePartAt(middle, orientation, kViewport);
                QVERIFY(found && *found == part);
                covered +=
                    std::abs(cross((*corners)[1] - (*corners)[0], (*corners)[3] - (*corners)[0]));
                ++tested;
            }
            // They fill the face.
            QVERIFY(std::abs(covered - 4.0 * std::abs(cross(face.right, face.up))) < 1e-6);
        }
        QVERIFY(tested >= 9 && tested <= 27);
    }
}

void TestViewCube::besideIsNothing()
{
    const Eigen::Quaterniond front = Eigen::Quaterniond::Identity();
    const Vec2 centre = *cubeCentre(kViewport);
    QVERIFY(!cubePartAt(centre + Vec2(0.5 * kCubeEdge + 1.0, 0.0), front, kViewport));
    QVERIFY(cubePartAt(centre + Vec2(0.5 * kCubeEdge - 1.0, 0.0), front, kViewport));
    QVERIFY(!cubePartAt({10.0, 10.0}, front, kViewport));
    // A view that is too small for it has none.
    QVERIFY(!cubeCentre({200.0, 200.0}));
    QVERIFY(!cubePartAt({100.0, 100.0}, front, {200.0, 200.0}));
}

void TestViewCube::turnsLookAtThePart()
{
    for (const CubePart &part : cubeParts()) {
        Camera camera;
        camera.orientation = orientationOfPart(part);
        QVERIFY(camera.backward().dot(direction(part)) > 0.99);
        QVERIFY(camera.up().y() > -1e-12);             // never upside down
        QVERIFY(std::abs(camera.right().y()) < 1e-12); // never rolled
    }
    Eigen::Quaterniond iso;
    QVERIFY(orientationOfView("iso2", iso));
    QVERIFY(orientationOfPart({1, 1, -1}).angularDistance(iso) < 1e-9);
}

void TestViewCube::facesAreTheNamedViews()
{
    int faces = 0;
    for (const CubePart &part : cubeParts()) {
        Eigen::Quaterniond named;
        if (!orientationOfView(nameOfPart(part), named)) {
            QVERIFY(part.rank() > 1);
            continue;
        }
        ++faces;
        QVERIFY(orientationOfPart(part).angularDistance(named) < 1e-12);
    }
    QCOMPARE(faces, 6);
}

void TestViewCube::sideLettersStandUpright()
{
    for (const CubePart &part : cubeParts()) {
        for (const CubeFace &face : visibleFaces(orientationOfPart(part), kViewport)) {
            QVERIFY(cross(face.right, face.up) < 0.0); // not mirrored (y runs down)
            if (face.part.y == 0)
                QVERIFY(face.up.y() < 0.0);
        }
    }
}

void TestViewCube::staysInItsRoom()
{
    const Vec2 centre = *cubeCentre(kViewport);
    QVERIFY(centre.x() + 0.5 * kCubeRoom <= kViewport.x());
    QVERIFY(centre.y() - 0.5 * kCubeRoom >= 0.0);
    for (const CubePart &part : cubeParts()) {
        for (const CubeFace &face : visibleFaces(orientationOfPart(part), kViewport)) {
            for (const double u : {-1.0, 1.0}) {
                for (const double v : {-1.0, 1.0}) {
                    const Vec2 corner = face.centre + u * face.right + v * face.up - centre;
                    QVERIFY(corner.cwiseAbs().maxCoeff() <= 0.5 * kCubeRoom);
                }
            }
        }
    }
}

FFF_TEST(TestViewCube)
#include "tst_view_cube.moc"
