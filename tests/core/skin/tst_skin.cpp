// The skin over sections: closed where their contours are, as round as they say, the same wherever
// the model stands.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/base/tolerances.h"
#include "core/io/document_file.h"
#include "core/operations/evaluate.h"
#include "core/skin/skin.h"
#include "core/skin/skin_outline.h"
#include "tests/core/skin/discs.h"
#include "tests/test_program.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

using Sections = std::vector<SectionPointer>;

constexpr double kRadius = 60.0;

Skin skinOver(const Sections &sections)
{
    return skinOf(sections).value();
}

/// How many edges have not one triangle on each side.
int openEdges(const TriangleMesh &mesh)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> count;
    for (const Triangle &t : mesh.triangles())
        for (std::size_t k = 0; k < 3; ++k)
            ++count[{t[k], t[(k + 1) % 3]}];
    int open = 0;
    for (const auto &[edge, times] : count) {
        const auto back = count.find({edge.second, edge.first});
        open += times != 1 || back == count.end() || back->second != 1;
    }
    return open;
}

double ballOf(double radius)
{
    return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

double distanceTo(const Vec3 &p, const Vec3 &a, const Vec3 &b, const Vec3 &c)
{
    const Vec3 n = (b - a).cross(c - a);
    const Vec3 foot = p - n.dot(p - a) / n.squaredNorm() * n;
    const auto isLeft = [&](const Vec3 &from, const Vec3 &to) {
        return n.dot((to - from).cross(foot - from)) >= 0.0;
    };
    if (isLeft(a, b) && isLeft(b, c) && isLeft(c, a))
        return (p - foot).norm();
    const auto toSegment = [&p](const Vec3 &from, const Vec3 &to) {
        const Vec3 way = to - from;
        const double share = std::clamp(way.dot(p - from) / way.squaredNorm(), 0.0, 1.0);
        return (p - from - share * way).norm();
    };
    return std::min({toSegment(a, b), toSegment(b, c), toSegment(c, a)});
}

double distanceTo(const Vec3 &p, const TriangleMesh &mesh)
{
    double least = 1e9;
    for (const auto &[a, b, c] : mesh.triangles())
        least = std::min(
            least, distanceTo(p, mesh.positions()[a], mesh.positions()[b], mesh.positions()[c]));
    return least;
}

/// Of a mesh's points, in whatever order: what differs when one is elsewhere.
Eigen::Matrix3d spreadOf(const TriangleMesh &mesh)
{
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const Vec3 &p : mesh.positions())
        sum += (p + Vec3(100, 200, 300)) * (p + Vec3(300, 100, 200)).transpose();
    return sum;
}

Sections spheres()
{
    return sphere(kRadius, {0.0});
}

/// Ribs on a spine that they reach round: no contour meets another.
Sections tube()
{
    Sections all = {sectionOf(polygonContour(rectangleAt(-50, -5, 100, 10)), Vec3::Zero(),
                              Vec3::UnitX(), Vec3::UnitY())};
    for (const double x : {-40.0, -20.0, 0.0, 20.0, 40.0})
        all.push_back(sectionOf(circle({0, 0}, 30.0), {x, 0, 0}, -Vec3::UnitZ(), Vec3::UnitY()));
    return all;
}

Sections plates(const Vec3 &normal, double apart)
{
    return {disc(50.0, Vec3::UnitZ(), 0.0), sectionOf(circle({0, 0}, 50.0), apart * Vec3::UnitZ(),
                                                      Vec3::UnitX(), normal.cross(Vec3::UnitX()))};
}

} // namespace

class TestSkin : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void closed_data();
    void closed();
    void turnedAndMoved();
    void anyOrder();
    void containsTheContours();
    void none_data();
    void none();
    void missedByMillimetres();
    void manySidesSeenWhole();
    void samples_data();
    void samples();
    void stopped();
};

void TestSkin::closed_data()
{
    QTest::addColumn<Sections>("sections");
    QTest::addColumn<double>("volume");
    QTest::addColumn<int>("patches");
    const double third = 1.0 / 3.0;
    QTest::newRow("three discs") << spheres() << ballOf(kRadius) << 8;
    QTest::newRow("two discs") << Sections{disc(kRadius, Vec3::UnitX(), 0.0),
                                           disc(kRadius, Vec3::UnitY(), 0.0)}
                               << ballOf(kRadius) << 4;
    QTest::newRow("three by three planes")
        << sphere(kRadius, {-third, 0.0, third}) << ballOf(kRadius) << 0;
    QTest::newRow("three on one axis")
        << Sections{disc(kRadius, {1, 0, 0}, 0.0), disc(kRadius, {1, 0, 1}, 0.0),
                    disc(kRadius, {-1, 0, 1}, 0.0)}
        << ballOf(kRadius) << 6;
    QTest::newRow("a meridian and parallels")
        << Sections{disc(kRadius, Vec3::UnitZ(), 0.0), disc(kRadius, Vec3::UnitY(), -20.0),
                    disc(kRadius, Vec3::UnitY(), 10.0), disc(kRadius, Vec3::UnitY(), 40.0)}
        << ballOf(kRadius) << 8;
    QTest::newRow("ribs round a spine") << tube() << std::numbers::pi * 900.0 * 80.0 << 6;
    const auto holed = [] {
        Sections all = spheres();
        auto copy = std::make_shared<Section>(*all[0]);
        copy->shape = Shape::make(circle({0, 0}, kRadius), {circle({20, 20}, 10.0)}).value();
        all[0] = copy;
        return all;
    };
    QTest::newRow("a hole in a disc") << holed() << ballOf(kRadius) << 8;
}

// Wrong: a printer refuses the file, or what comes out is no ball.
void TestSkin::closed()
{
    QFETCH(Sections, sections);
    QFETCH(double, volume);
    QFETCH(int, patches);
    const Skin skin = skinOver(sections);
    QVERIFY(skin.mesh);
    QCOMPARE(skin.open, 0);
    if (patches > 0)
        QCOMPARE(skin.patches, patches);
    QCOMPARE(openEdges(*skin.mesh), 0);
    qInfo("%d patches, %zu triangles, volume %.4f of what it should be", skin.patches,
          skin.mesh->triangles().size(), skin.mesh->volume() / volume);
    QVERIFY(std::abs(skin.mesh->volume() / volume - 1.0) < 0.02);
}

// Wrong: the same model has another skin where it stands elsewhere.
void TestSkin::turnedAndMoved()
{
    const Sections all = sphere(kRadius, {-0.3, 0.25});
    const Skin before = skinOver(all);
    const Eigen::Isometry3d motion = Eigen::Translation3d(120.0, -35.0, 71.0) *
                                     Eigen::AngleAxisd(0.83, Vec3(0.3, -0.7, 0.5).normalized());
    const Skin after = skinOver(moved(all, motion));
    QCOMPARE(after.patches, before.patches);
    QCOMPARE(after.mesh->triangles(), before.mesh->triangles());
    double most = 0.0;
    for (std::size_t i = 0; i < before.mesh->positions().size(); ++i)
        most = std::max(most,
                        (motion * before.mesh->positions()[i] - after.mesh->positions()[i]).norm());
    QVERIFY2(most < 1e-9 * before.mesh->size(), qPrintable(QString::number(most)));
}

// Wrong: what is drawn first decides what is seen.
void TestSkin::anyOrder()
{
    Sections all = sphere(kRadius, {-0.3, 0.25});
    const Skin first = skinOver(all);
    std::mt19937 random(7);
    for (int i = 0; i < 5; ++i) {
        std::shuffle(all.begin(), all.end(), random);
        const Skin other = skinOver(all);
        QCOMPARE(other.patches, first.patches);
        QCOMPARE(other.open, first.open);
        QCOMPARE(other.mesh->triangles().size(), first.mesh->triangles().size());
        // The same points; a quad of them may be parted the other way.
        QCOMPARE(other.mesh->positions().size(), first.mesh->positions().size());
        QVERIFY((spreadOf(*other.mesh) - spreadOf(*first.mesh)).norm() <
                1e-9 * spreadOf(*first.mesh).norm());
        QVERIFY(std::abs(other.mesh->volume() - first.mesh->volume()) <
                1e-3 * first.mesh->volume());
    }
}

// Wrong: sections stick out of their skin.
void TestSkin::containsTheContours()
{
    const Sections all = sphere(kRadius, {-0.3, 0.25});
    const Skin skin = skinOver(all);
    for (const SectionPointer &section : all) {
        const SkinOutline outline(*section->shape, section->frame);
        for (int i = 0; i < 40; ++i) {
            const Vec3 point = outline.worldAt(outline.length() * i / 40.0);
            const double distance = distanceTo(point, *skin.mesh);
            QVERIFY2(distance < 2.0 * kDrawChord, qPrintable(QString::number(distance)));
        }
    }
}

void TestSkin::none_data()
{
    QTest::addColumn<Sections>("sections");
    QTest::newRow("no section") << Sections();
    QTest::newRow("one") << Sections{disc(50.0, Vec3::UnitZ(), 0.0)};
    QTest::newRow("two beside each other") << plates(Vec3::UnitZ(), 20.0);
    QTest::newRow("one twice") << plates(Vec3::UnitZ(), 0.0);
    QTest::newRow("one turned over") << plates(-Vec3::UnitZ(), 0.0);
    QTest::newRow("far from each other") << plates(Vec3::UnitX() + Vec3::UnitY(), 500.0);
    // The one ends where the other begins.
    QTest::newRow("edge to edge") << Sections{
        sectionOf(polygonContour(rectangleAt(-40, 0, 80, 50)), Vec3::Zero(), Vec3::UnitX(),
                  Vec3::UnitY()),
        sectionOf(polygonContour(rectangleAt(-40, -50, 80, 50)), Vec3::Zero(), Vec3::UnitZ(),
                  Vec3::UnitY())};
    // One stands on the other, which lies.
    QTest::newRow("a plate on a plate")
        << Sections{sectionOf(polygonContour(rectangleAt(-40, 0, 80, 50)), Vec3::Zero(),
                              Vec3::UnitX(), Vec3::UnitY()),
                    sectionOf(polygonContour(rectangleAt(-60, -60, 120, 120)), Vec3::Zero(),
                              Vec3::UnitX(), Vec3::UnitZ())};
    // A small one within a large one: neither ends where the other does.
    QTest::newRow("one inside of another")
        << Sections{disc(80.0, Vec3::UnitZ(), 0.0), disc(30.0, Vec3::UnitX(), 0.0)};
}

void TestSkin::none()
{
    QFETCH(Sections, sections);
    const Skin skin = skinOver(sections);
    QVERIFY(!skin.mesh);
    QCOMPARE(skin.patches, 0);
}

// Wrong: a hand that trembles makes a skin with cracks, or none.
void TestSkin::missedByMillimetres()
{
    Sections all = {disc(kRadius, Vec3::UnitX(), 0.0), disc(kRadius + 3.0, Vec3::UnitY(), 0.0),
                    disc(kRadius - 2.0, Vec3::UnitZ(), 0.0)};
    const Skin skin = skinOver(all);
    QCOMPARE(skin.patches, 8);
    QCOMPARE(openEdges(*skin.mesh), 0);
    QVERIFY(std::abs(skin.mesh->volume() / ballOf(kRadius) - 1.0) < 0.05);
}

/// Twelve discs of a sphere in a ring, tilted upwards, of which those beside each other cross.
Sections crown()
{
    constexpr int kDiscs = 12;
    const double tilt = std::numbers::pi / 6.0;
    Sections all;
    for (int i = 0; i < kDiscs; ++i) {
        const double around = 2.0 * std::numbers::pi * i / kDiscs;
        const Vec3 normal(std::cos(tilt) * std::cos(around), std::sin(tilt),
                          std::cos(tilt) * std::sin(around));
        all.push_back(disc(kRadius, normal, 0.91 * kRadius));
    }
    return all;
}

// Wrong: the top of a form is left open since many sections end round it; or the mouth below, which
// is more than half of a sphere, is closed with a balloon.
void TestSkin::manySidesSeenWhole()
{
    const Sections all = crown();
    const Skin skin = skinOver(all);
    QVERIFY(skin.mesh);
    QVERIFY(skin.mesh->bounds().max.y() > 0.95 * kRadius);
    QVERIFY(skin.mesh->bounds().max.y() < 1.05 * kRadius);
    QCOMPARE(static_cast<std::size_t>(skin.open), skin.places.size());
    QVERIFY(std::any_of(skin.places.begin(), skin.places.end(), [&](const OpenPlace &place) {
        return place.why == OpenPlace::Why::NoForm && place.sections.size() == all.size();
    }));
}

void TestSkin::samples_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<bool>("isThere");
    QTest::newRow("one whole animal") << QStringLiteral("dinosaur.fff") << true;
    QTest::newRow("154 sections") << QStringLiteral("bridge.fff") << true;
    QTest::newRow("cells") << QStringLiteral("whale.fff") << true;
    QTest::newRow("boughs that cross with too many sides") << QStringLiteral("tree.fff") << false;
}

// Wrong: what a person draws has spikes in its skin, or edges on which three patches meet.
void TestSkin::samples()
{
    QFETCH(QString, file);
    QFETCH(bool, isThere);
    const auto loaded = io::readDocument(QStringLiteral(FFF_SAMPLES "/") + file);
    QVERIFY(loaded);
    const Model model = evaluate(loaded->document);
    const Skin skin = skinOver(model.sections());
    QCOMPARE(skin.mesh != nullptr, isThere);
    QCOMPARE(skin.places.size(), static_cast<std::size_t>(skin.open));
    for (const OpenPlace &place : skin.places) {
        QVERIFY(!place.sections.empty());
        QVERIFY(std::is_sorted(place.sections.begin(), place.sections.end()));
        QVERIFY(place.sections.back() < static_cast<int>(model.sectionCount()));
    }
    if (!isThere)
        return;
    qInfo("%d patches, %d open, %zu triangles", skin.patches, skin.open,
          skin.mesh->triangles().size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> count;
    for (const Triangle &t : skin.mesh->triangles())
        for (std::size_t k = 0; k < 3; ++k)
            ++count[{t[k], t[(k + 1) % 3]}];
    for (const auto &[edge, times] : count)
        QCOMPARE(times, 1); // consistently oriented: no edge twice the same way
    Box3 room = model.bounds();
    const double slack = 0.1 * room.size().maxCoeff();
    QVERIFY((skin.mesh->bounds().min.array() > room.min.array() - slack).all());
    QVERIFY((skin.mesh->bounds().max.array() < room.max.array() + slack).all());
}

void TestSkin::stopped()
{
    std::stop_source stop;
    stop.request_stop();
    const Result<Skin> skin = skinOf(sphere(kRadius, {0.0}), {stop.get_token(), {}});
    QVERIFY(!skin);
    QCOMPARE(skin.error().code, ErrorCode::Cancelled);
}

FFF_TEST(TestSkin)
#include "tst_skin.moc"
