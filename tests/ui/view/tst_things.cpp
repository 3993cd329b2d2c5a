// What weights stand for in the view: closed solids, where the weights are, filled as said.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "core/operations/evaluate.h"
#include "tests/core/analysed.h"
#include "tests/test_program.h"
#include "ui/view/offscreen_image.h"
#include "ui/view/scene.h"

#include <QFile>
#include <QGuiApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <map>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

Vec3 toVec3(const std::array<float, 3> &p)
{
    return {p[0], p[1], p[2]};
}

std::vector<ThingVertex> verticesOf(const SceneThing &thing)
{
    std::vector<ThingVertex> vertices;
    addTriangles(thing, vertices);
    return vertices;
}

/// mm³, by what its triangles enclose with the origin.
double volumeOf(const std::vector<ThingVertex> &vertices, std::size_t from, std::size_t to)
{
    double volume = 0.0;
    for (std::size_t i = from; i < to; i += 3)
        volume +=
            toVec3(vertices[i].position)
                .dot(toVec3(vertices[i + 1].position).cross(toVec3(vertices[i + 2].position))) /
            6.0;
    return volume;
}

/// Each edge of a triangle is that of another one, the other way round.
bool isClosed(const std::vector<ThingVertex> &vertices)
{
    std::map<std::pair<std::array<float, 3>, std::array<float, 3>>, int> edges;
    for (std::size_t i = 0; i < vertices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto &p = vertices[i + k].position, &q = vertices[i + (k + 1) % 3].position;
            ++edges[{p, q}];
            --edges[{q, p}];
        }
    return std::all_of(edges.begin(), edges.end(), [](const auto &e) { return e.second == 0; });
}

Model sample(const char *name)
{
    const auto file = io::readDocument(QStringLiteral(FFF_SAMPLES) + u'/' + QLatin1String(name));
    return evaluate(file ? file->document : Document());
}

} // namespace

class TestThings : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void closed_data();
    void closed();
    void filled_data();
    void filled();
    void standsOnWhatLies();
    void isHiddenWithItsSection();
    void tooManyAreNone();
    void isSeen();
};

void TestThings::closed_data()
{
    QTest::addColumn<QString>("preset");
    QTest::newRow("a plain block") << QString();
    QTest::newRow("one of another version") << QStringLiteral("teapot");
    QFile file(QStringLiteral(":/loads/presets.json"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    for (const QJsonValue &row : QJsonDocument::fromJson(file.readAll()).array()) {
        const QString key = row.toObject()[QLatin1String("key")].toString();
        QTest::newRow(qPrintable(key)) << key;
    }
}

void TestThings::closed()
{
    QFETCH(QString, preset);
    SceneThing thing;
    thing.preset = preset.toStdString();
    thing.mass = 0.35;
    const std::vector<ThingVertex> vertices = verticesOf(thing);
    QVERIFY(!vertices.empty());
    QVERIFY(isClosed(vertices));
    QVERIFY(volumeOf(vertices, 0, vertices.size()) > 0.0);
    for (const ThingVertex &vertex : vertices)
        QVERIFY(std::abs(toVec3(vertex.normal).norm() - 1.0) < 1e-5);
}

void TestThings::filled_data()
{
    QTest::addColumn<double>("share");
    for (const double share : {0.01, 0.25, 0.5, 0.99, 1.0, 7.0})
        QTest::addRow("%g", share) << share;
}

// Water fills the share of the vessel that its mass is of what that holds, however it widens.
void TestThings::filled()
{
    QFETCH(double, share);
    for (const char *preset : {"glass", "pot"}) {
        SceneThing thing;
        thing.preset = preset;
        const std::vector<ThingVertex> empty = verticesOf(thing);
        thing.filled = share * (thing.preset == "glass" ? 0.35 : 0.3);
        const std::vector<ThingVertex> full = verticesOf(thing);
        QVERIFY(full.size() > empty.size() && isClosed(full));
        const std::size_t water = full.size() - empty.size();
        constexpr double kInside = 0.94 * 0.94; // of its outside
        const double whole = kInside * volumeOf(full, water, full.size());
        QVERIFY(std::abs(volumeOf(full, 0, water) / whole - std::min(share, 1.0)) < 1e-3);
    }
}

void TestThings::standsOnWhatLies()
{
    const Model model = sample("glass_four_legs.fff");
    const std::vector<SceneThing> things = thingsOf(model);
    QCOMPARE(things.size(), std::size_t(1));
    const Section &shelf = *model.section(static_cast<std::size_t>(things[0].section));
    const double half = 0.5 * model.stockOf(static_cast<std::size_t>(things[0].section)).thickness;
    QVERIFY(std::abs(things[0].at.y() - shelf.frame.origin.y() - half) < 1e-6);
    double lowest = 1e9;
    for (const ThingVertex &vertex : verticesOf(things[0]))
        lowest = std::min(lowest, static_cast<double>(vertex.position[1]));
    QVERIFY(std::abs(lowest - things[0].at.y()) < 1e-4);
}

void TestThings::isHiddenWithItsSection()
{
    const Analysis analysis = analysed(sample("glass_four_legs.fff").document);
    Scene scene = sceneOf(analysis);
    ViewState view;
    applyView(scene, analysis.model, view);
    QVERIFY(!scene.things.front().isHidden);
    view.hidden.insert(analysis.model.ref(static_cast<std::size_t>(scene.things[0].section)));
    applyView(scene, analysis.model, view);
    QVERIFY(scene.things.front().isHidden);
}

void TestThings::tooManyAreNone()
{
    Document document = sample("glass_four_legs.fff").document;
    while (document.loads.size() < kMostThings)
        document.loads.push_back(document.loads.front());
    QCOMPARE(thingsOf(evaluate(document)).size(), kMostThings);
    document.loads.push_back(document.loads.front());
    QVERIFY(thingsOf(evaluate(document)).empty());
}

// The picture differs where the glass is, and nowhere else.
void TestThings::isSeen()
{
    OffscreenPainter painter;
    QVERIFY(painter.isUsable());
    const Vec2 size(400.0, 300.0);
    const Analysis analysis = analysed(sample("glass_four_legs.fff").document);
    Scene scene = sceneOf(analysis);
    const Camera camera = cameraFor(scene, "iso1", size);
    const QImage with = painter.paint(scene, camera, size);
    Box2 seen;
    for (const ThingVertex &vertex : verticesOf(scene.things.front()))
        seen.extend(camera.toScreen(toVec3(vertex.position), size));
    scene.things.clear();
    const QImage without = painter.paint(scene, camera, size);
    int within = 0, beyond = 0;
    for (int y = 0; y < with.height(); ++y)
        for (int x = 0; x < with.width(); ++x) {
            if (with.pixel(x, y) == without.pixel(x, y))
                continue;
            const bool isIn = x >= seen.min.x() - 2 && x <= seen.max.x() + 2 &&
                              y >= seen.min.y() - 2 && y <= seen.max.y() + 2;
            ++(isIn ? within : beyond);
        }
    QVERIFY(within > 1000);
    QCOMPARE(beyond, 0);
}

FFF_TEST_WITH(TestThings, fff::testing::runWithin<TestThings, QGuiApplication>)
#include "tst_things.moc"
