#include <QGuiApplication>
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/tolerances.h"
#include "core/interaction/interaction.h"
#include "core/session/session_commands.h"
#include "core/session/session_host.h"
#include "core/templates/template_mesh.h"
#include "tests/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QUndoStack>

using namespace fff;

namespace {

/// A corner of this size: an .obj knows no unit, a .gltf is in metres.
void writeObj(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        qFatal("no file %s", qPrintable(path));
    file.write("v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
}

void writeGltf(const QString &path, float metres)
{
    const float positions[] = {0, 0, 0, metres, 0, 0, 0, metres, 0, 0, 0, metres};
    const quint16 corners[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    QByteArray bytes(reinterpret_cast<const char *>(positions), sizeof positions);
    bytes.append(reinterpret_cast<const char *>(corners), sizeof corners);
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        qFatal("no file %s", qPrintable(path));
    file.write(
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"buffers":[{"byteLength":72,
"uri":"data:application/octet-stream;base64,)" +
        bytes.toBase64() + R"("}],"bufferViews":[{"buffer":0,"byteLength":48},
{"buffer":0,"byteOffset":48,"byteLength":24}],"accessors":[{"bufferView":0,"componentType":5126,
"count":4,"type":"VEC3"},{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}]})");
}

struct Bench
{
    QTemporaryDir folder;
    Session session;
    SessionHost host{session};
    Interaction interaction{host};
    CommandRegistry commands;
    const QString corner = folder.filePath(QStringLiteral("corner.obj"));

    Bench()
    {
        registerSessionCommands(commands, session, interaction);
        host.attach(interaction);
        writeObj(corner);
    }
    Result<void> run(const char *id, const CommandParameters &parameters = {})
    {
        return commands.run(id, parameters);
    }
    Result<void> add(const QString &path)
    {
        return run("template.add", {{"file", path.toStdString()}});
    }
    const std::vector<TemplatePointer> &templates() const
    {
        return session.committed().document.templates;
    }
    Box3 bounds() const { return worldBounds(*templates().back(), *templates().back()->mesh); }
};

} // namespace

class TestTemplateCommands : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itStandsAsLargeAsToldTo();
    void whatIsLargerThanTheRoomIsMadeSmaller();
    void itStaysOnTheGroundAsItIsSized();
    void itTurnsAboutWhereItStands();
    void suggestedSectionsAreOneStep();
    void facetsStandWhereTheMeshIs();
    void wrongUseChangesNothing_data();
    void wrongUseChangesNothing();
};

void TestTemplateCommands::itStandsAsLargeAsToldTo()
{
    Bench bench;
    QVERIFY(bench.run("template.add", {{"file", bench.corner.toStdString()}, {"size", "80"}}));
    QCOMPARE(bench.templates().size(), std::size_t(1));
    QCOMPARE(bench.bounds().size().maxCoeff(), 80.0);
    QCOMPARE(bench.bounds().min.y(), 0.0);
    bench.session.history()->undo();
    QVERIFY(bench.templates().empty());
}

// Wrong: a town in metres, or a size of kilometres, was the end of the program.
void TestTemplateCommands::whatIsLargerThanTheRoomIsMadeSmaller()
{
    Bench bench;
    const QString town = bench.folder.filePath(QStringLiteral("town.gltf"));
    const QString house = bench.folder.filePath(QStringLiteral("house.gltf"));
    writeGltf(town, 5000.0F);
    writeGltf(house, 10.0F);
    QVERIFY(bench.add(town));
    QVERIFY(std::abs(bench.bounds().size().maxCoeff() - kTemplateSize) < 1e-6);
    QVERIFY(bench.add(house));
    QVERIFY(std::abs(bench.bounds().size().maxCoeff() - 10'000.0) < 1e-6);
}

/// A mesh that comes 254 mm large and is made 80 mm would hover 87 mm above the ground, were it
/// sized about its middle.
void TestTemplateCommands::itStaysOnTheGroundAsItIsSized()
{
    Bench bench;
    QVERIFY(bench.add(bench.corner));
    QVERIFY(bench.run("template.set", {{"x", "120"}, {"z", "-40"}}));
    const Box3 before = bench.bounds();
    for (const char *size : {"80", "600"}) {
        QVERIFY(bench.run("template.set", {{"size", size}}));
        const Box3 box = bench.bounds();
        QVERIFY(std::abs(box.size().maxCoeff() - std::stod(size)) < 1e-6);
        QVERIFY(std::abs(box.min.y()) < 1e-9);
        const Vec3 moved = box.center() - before.center();
        QVERIFY(std::hypot(moved.x(), moved.z()) < 1e-9);
    }
    // What does not stand there keeps its middle.
    QVERIFY(bench.run("template.set", {{"y", "900"}}));
    QVERIFY(bench.run("template.set", {{"size", "80"}}));
    QVERIFY(std::abs(bench.bounds().center().y() - 900.0) < 1e-6);
}

void TestTemplateCommands::itTurnsAboutWhereItStands()
{
    Bench bench;
    QVERIFY(bench.add(bench.corner));
    QVERIFY(bench.run("template.set", {{"x", "120"}, {"z", "-40"}, {"size", "100"}}));
    const Box3 before = bench.bounds();
    QVERIFY(bench.run("template.turnUp"));
    const Box3 after = bench.bounds();
    const Vec3 moved = after.center() - before.center();
    QVERIFY(std::hypot(moved.x(), moved.z()) < 1e-9);
    QCOMPARE(after.min.y(), 0.0);
    QCOMPARE(after.size().z(), before.size().y());
    QVERIFY(bench.run("template.turnUp"));
    QVERIFY((bench.bounds().size() - before.size()).norm() < 1e-9);
}

// What was found is chosen, so that it can be moved, or be deleted, at once.
void TestTemplateCommands::suggestedSectionsAreOneStep()
{
    Bench bench;
    QVERIFY(bench.add(bench.corner));
    const Document before = bench.session.committed().document;
    QVERIFY(bench.run("template.suggest", {{"count", "3"}}));
    const Model &suggested = bench.session.committed();
    QVERIFY(suggested.sectionCount() >= 2);
    QCOMPARE(bench.interaction.selection().size(), suggested.sectionCount());
    QCOMPARE(bench.session.history()->count(), 2);
    bench.session.history()->undo();
    QVERIFY(bench.session.committed().document.isSame(before));
}

void TestTemplateCommands::facetsStandWhereTheMeshIs()
{
    Bench bench;
    QVERIFY(bench.add(bench.corner));
    QVERIFY(bench.run("template.set", {{"x", "120"}, {"z", "-40"}}));
    const Box3 mesh = bench.bounds();
    QVERIFY(bench.run("template.facets"));
    const Model &made = bench.session.committed();
    QCOMPARE(made.sectionCount(), std::size_t(4));
    QVERIFY(made.document.templates.front()->isHidden);
    Box3 box;
    for (const Body &body : bench.session.currentAnalysis().bodies)
        box.extend(body.box());
    QVERIFY(std::abs(box.min.y() - mesh.min.y()) < 1e-6);
    QVERIFY((box.center() - mesh.center()).norm() < 0.2 * mesh.size().maxCoeff());
    bench.session.history()->undo();
    QCOMPARE(bench.session.committed().sectionCount(), std::size_t(0));
    QVERIFY(bench.run("template.net"));
    const Model &net = bench.session.committed();
    QCOMPARE(net.sectionCount(), std::size_t(1));
    QVERIFY(!net.section(0)->marks.empty());
    QVERIFY(!net.document.templates.front()->isHidden);
    bench.session.history()->undo();
    QCOMPARE(bench.session.committed().sectionCount(), std::size_t(0));
}

void TestTemplateCommands::wrongUseChangesNothing_data()
{
    QTest::addColumn<QString>("command");
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("value");
    QTest::newRow("no such file") << "template.add"
                                  << "file"
                                  << "/nowhere/at-all.stl";
    QTest::newRow("larger than the room") << "template.add"
                                          << "size"
                                          << "1e8";
    QTest::newRow("less than nothing") << "template.add"
                                       << "size"
                                       << "-5";
    QTest::newRow("nothing") << "template.add"
                             << "size"
                             << "0";
    QTest::newRow("no size") << "template.add"
                             << "size"
                             << "large";
    QTest::newRow("no axis") << "template.add"
                             << "up"
                             << "w";
    QTest::newRow("neither") << "template.add"
                             << "reference"
                             << "perhaps";
    QTest::newRow("no template") << "template.set"
                                 << "template"
                                 << "another";
    QTest::newRow("out of the room") << "template.set"
                                     << "x"
                                     << "1e9";
    QTest::newRow("more than opaque") << "template.set"
                                      << "opacity"
                                      << "200";
    QTest::newRow("flat") << "template.set"
                          << "size"
                          << "0";
    QTest::newRow("inside out") << "template.set"
                                << "size"
                                << "-3";
    QTest::newRow("no section") << "template.suggest"
                                << "count"
                                << "0";
    QTest::newRow("half a section") << "template.suggest"
                                    << "count"
                                    << "2.5";
    QTest::newRow("more than anyone asks for") << "template.suggest"
                                               << "count"
                                               << "1000";
    QTest::newRow("encloses nothing") << "template.facets"
                                      << "faces"
                                      << "3";
    QTest::newRow("lays nothing flat") << "template.net"
                                       << "faces"
                                       << "3";
    QTest::newRow("no seed") << "template.suggest"
                             << "seed"
                             << "-1";
    QTest::newRow("not hidden or shown") << "template.set"
                                         << "hidden"
                                         << "half";
}

void TestTemplateCommands::wrongUseChangesNothing()
{
    QFETCH(const QString, command);
    QFETCH(const QString, key);
    QFETCH(const QString, value);
    Bench bench;
    QVERIFY(bench.add(bench.corner));
    const Template before = *bench.templates().front();
    CommandParameters parameters;
    if (command == QStringLiteral("template.add"))
        parameters["file"] = bench.corner.toStdString();
    parameters[key.toStdString()] = value.toStdString();
    const Result<void> refused = bench.run(qPrintable(command), parameters);
    QVERIFY(!refused);
    QVERIFY(!refused.error().place.empty());
    QCOMPARE(bench.templates().size(), std::size_t(1));
    QVERIFY(*bench.templates().front() == before);
}

FFF_TEST_WITH(TestTemplateCommands, fff::testing::runWithin<TestTemplateCommands, QGuiApplication>)
#include "tst_template_commands.moc"
