// A model where it moves: solid all the same, as far as it is said, and nowhere else.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "core/model/edits.h"
#include "tests/core/analysed.h"
#include "tests/test_program.h"
#include "ui/view/bent_slab.h"
#include "ui/view/moved_scene.h"
#include "ui/view/offscreen_image.h"

#include <cmath>
#include <map>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

Holding heldOf(const char *sample, bool bends, double lifted = 0.0)
{
    Document document = io::readDocument(QStringLiteral(FFF_SAMPLES) + u'/' + QLatin1String(sample))
                            .value()
                            .document;
    if (lifted != 0.0)
        document = moveAll(std::move(document), Vec3(0.0, lifted, 0.0));
    StrengthRules rules;
    rules.isElastic = bends;
    return holdingOf(std::make_shared<const Analysis>(analysed(document)), rules,
                     std::make_shared<StrengthCaches>());
}

std::shared_ptr<const BentModel> bentOf(const Holding &held)
{
    return std::make_shared<const BentModel>(
        bentModel(held.analysis, held.strength, *held.caches).value());
}

Vec3 placeOf(const SlabVertex &vertex, double half)
{
    return {vertex.position[0], vertex.position[1], half * vertex.position[2]};
}

/// As it is drawn when it is bent as far as it really is.
SlabMesh bentMesh(const BentSlab &slab)
{
    SlabMesh mesh = slab.flat;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        mesh.vertices[i].position = slab.placeAt(i, 1.0);
    return mesh;
}

/// mm³ that the triangles enclose.
double volumeOf(const SlabMesh &mesh, double half)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
        sum += placeOf(mesh.vertices[mesh.triangles[i]], half)
                   .dot(placeOf(mesh.vertices[mesh.triangles[i + 1]], half)
                            .cross(placeOf(mesh.vertices[mesh.triangles[i + 2]], half))) /
               6.0;
    return sum;
}

/// Every side of a triangle is there once each way.
bool isClosed(const SlabMesh &mesh)
{
    std::map<std::array<float, 6>, int> sides;
    const auto key = [&](std::uint32_t a, std::uint32_t b) {
        const auto &p = mesh.vertices[a].position, &q = mesh.vertices[b].position;
        return std::array<float, 6>{p[0], p[1], p[2], q[0], q[1], q[2]};
    };
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.triangles[i + k], b = mesh.triangles[i + (k + 1) % 3];
            ++sides[key(a, b)];
            --sides[key(b, a)];
        }
    return std::all_of(sides.begin(), sides.end(), [](const auto &s) { return s.second == 0; });
}

} // namespace

class TestMovedScene : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void bentIsSolid();
    void asFarAsItIsSaid();
    void facesTurnAsTheyBend();
    void whatIsLooseGoesWhole();
    void nothingMoves();
};

// Wrong: holes, walls inside out, or another thickness.
void TestMovedScene::bentIsSolid()
{
    const Holding held = heldOf("acrylic_thick_three.fff", true);
    const auto bent = bentOf(held);
    for (std::size_t i = 0; i < bent->fields.size(); ++i) {
        const StressField &field = *bent->fields[i];
        const Body &body = held.analysis->bodies.at(static_cast<int>(i));
        const double half = 0.5 * body.thickness();
        const std::vector<Vec3> still(field.points.size(), Vec3::Zero());
        const SlabMesh flat = bentMesh(bentSlab(field, still, half));
        QVERIFY(isClosed(flat));
        double area = 0.0;
        for (const auto &t : field.triangles)
            area += 0.5 * cross(field.points[static_cast<std::size_t>(t[1])] -
                                    field.points[static_cast<std::size_t>(t[0])],
                                field.points[static_cast<std::size_t>(t[2])] -
                                    field.points[static_cast<std::size_t>(t[0])]);
        QVERIFY(std::abs(volumeOf(flat, half) / (2.0 * half * area) - 1.0) < 1e-4);
        std::vector<Vec3> waved;
        for (const Vec2 &p : field.points)
            waved.emplace_back(0.0, 0.0, 4.0 * std::sin(0.05 * p.x()));
        const SlabMesh wave = bentMesh(bentSlab(field, waved, half));
        QVERIFY(isClosed(wave));
        QVERIFY(std::abs(volumeOf(wave, half) / volumeOf(flat, half) - 1.0) < 1e-3);
    }
}

// Wrong: a picture of another movement than the words tell, or one that runs out of the view.
void TestMovedScene::asFarAsItIsSaid()
{
    const Holding held = heldOf("acrylic_thick_three.fff", true);
    const auto movement = movementOf(held, bentOf(held));
    QVERIFY(movement && !movement->isLoose && movement->most > 1.0);
    const double times = movement->mostTimes();
    QVERIFY(std::abs(times * movement->most / movement->size - 0.05) < 1e-9);
    const Scene scene = ui::sceneOf(*held.analysis);
    MovedScene moved;
    const Scene &shown = moved.at(scene, held.analysis->model, *movement, times);
    QCOMPARE(shown.sections.size(), held.analysis->bodies.size());
    double farthest = 0.0;
    for (std::size_t i = 0; i < shown.sections.size(); ++i) {
        const SceneSection &section = shown.sections[i];
        const StressField &field = *movement->bent->drawn[i];
        QVERIFY(section.bent && section.bentTimes == times &&
                section.frame == scene.sections[i].frame);
        for (std::size_t k = 0; k < field.points.size(); ++k) {
            const Vec3 at = placeOf({section.bent->placeAt(k, times), {}}, 1.0) -
                            Vec3(field.points[k].x(), field.points[k].y(), 1.0);
            farthest =
                std::max(farthest, Vec3(at.x(), at.y(), 0.5 * section.thickness * at.z()).norm());
        }
    }
    QVERIFY2(std::abs(farthest / (0.05 * movement->size) - 1.0) < 1e-2,
             qPrintable(QString::number(farthest)));
    // Another share of it makes nothing anew.
    const auto before = shown.sections.front().bent;
    const SceneSection &less =
        moved.at(scene, held.analysis->model, *movement, 0.5 * times).sections.front();
    QVERIFY(less.bent == before && less.bentTimes == 0.5 * times);
}

// Wrong: light and shade, or lines, of a sheet that is not bent like this one.
void TestMovedScene::facesTurnAsTheyBend()
{
    const Holding held = heldOf("acrylic_thick_three.fff", true);
    const auto model = bentOf(held);
    const StressField &field = *model->fields.front();
    std::vector<Vec3> moved;
    for (const Vec2 &p : field.points)
        moved.emplace_back(0.3 * p.y(), 0.1 * p.x() * p.x() / 50.0, 4.0 * std::sin(0.05 * p.x()));
    constexpr double kTimes = 1.7;
    const BentSlab slab = bentSlab(field, moved, 1.0);
    std::vector<Vec3> wanted(field.points.size(), Vec3::Zero());
    for (const auto &t : field.triangles) {
        const auto at = [&](int i) {
            const auto k = static_cast<std::size_t>(i);
            return Vec3(Vec3(field.points[k].x(), field.points[k].y(), 0.0) + kTimes * moved[k]);
        };
        const Vec3 across = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
        for (const int i : t)
            wanted[static_cast<std::size_t>(i)] += across;
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const VertexMotion &motion = slab.motions[i];
        Vec3 normal = Vec3::UnitZ();
        for (int k = 0; k < 3; ++k)
            normal[k] += kTimes * (motion.turn[static_cast<std::size_t>(k)] +
                                   kTimes * motion.turnMore[static_cast<std::size_t>(k)]);
        QVERIFY(normal.normalized().dot(wanted[i].normalized()) > 1.0 - 1e-6);
    }
}

// Wrong: pieces that come loose grow, bend, or stay.
void TestMovedScene::whatIsLooseGoesWhole()
{
    Holding held = heldOf("glass_three_legs.fff", false);
    Equilibrium &equilibrium = held.strength.envelope.front();
    ComponentState &state = equilibrium.components.front();
    state.balance = Balance::Mechanism;
    state.motion.assign(state.parts.members.size(), {});
    state.motion.front() = {Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1e-3, 0.0)};
    const auto loose = static_cast<std::size_t>(state.parts.members.front());
    const auto movement = movementOf(held, nullptr);
    QVERIFY(movement && movement->isLoose);
    const Scene scene = ui::sceneOf(*held.analysis);
    MovedScene moved;
    const Scene &shown = moved.at(scene, held.analysis->model, *movement, movement->mostTimes());
    for (std::size_t i = 0; i < shown.sections.size(); ++i) {
        const Frame &frame = shown.sections[i].frame;
        QVERIFY(std::abs(frame.x.norm() - 1.0) < 1e-12 && std::abs(frame.x.dot(frame.y)) < 1e-12);
        QCOMPARE(frame == scene.sections[i].frame, i != loose);
    }
    const double way = (shown.sections[loose].frame.toWorld(Vec2(0, 0)) -
                        scene.sections[loose].frame.toWorld(Vec2(0, 0)))
                           .norm();
    QVERIFY(way > 0.01 * movement->size && way < 0.1 * movement->size);
}

void TestMovedScene::nothingMoves()
{
    const Holding held = heldOf("chair.fff", false);
    QVERIFY(!movementOf(held, nullptr)); // it stands, and nobody knows how it bends
    const Holding lifted = heldOf("chair.fff", true, 50.0);
    QVERIFY(!movementOf(lifted, nullptr));
    // Of another model nothing is moved.
    const Holding other = heldOf("acrylic_thick_three.fff", true);
    const auto movement = movementOf(other, bentOf(other));
    const Scene scene = ui::sceneOf(*held.analysis);
    MovedScene moved;
    QCOMPARE(&moved.at(scene, held.analysis->model, *movement, 1.0), &scene);
}

FFF_TEST(TestMovedScene)
#include "tst_moved_scene.moc"
