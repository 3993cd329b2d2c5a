// `facets`, as scripts use it.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "core/operations/evaluate.h"
#include "tests/app/cli_run.h"
#include "tests/app/mesh_files.h"
#include "tests/core/templates/made_polyhedra.h"
#include "tests/test_program.h"

#include <QFile>
#include <QTemporaryDir>

using namespace fff;
using namespace fff::test;
using namespace Qt::Literals::StringLiterals;

class TestCliFacets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aCube();
    void insideOut();
    void simplified();
    void unfolded();
    void tooThickToFold();
    void edgesWithoutFingersAreNamed();
    void wrongUse_data();
    void wrongUse();
    void whatCannotBeBuilt_data();
    void whatCannotBeBuilt();

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }
    Run facets(const QString &mesh, const QStringList &options)
    {
        return run(QStringList{u"facets"_s, mesh, u"-o"_s, path(u"out.fff"_s)} + options, false);
    }
    Model made() const
    {
        auto read = io::readDocument(path(u"out.fff"_s));
        return read ? evaluate(std::move(read->document)) : Model();
    }

    QTemporaryDir m_folder;
};

void TestCliFacets::aCube()
{
    const QString mesh = putMesh(path(u"dice.obj"_s), cube(2.0));
    const Run told = facets(mesh, {u"--size"_s, u"100"_s, u"--stock"_s, u"acrylic"_s});
    QVERIFY2(told.status == 0, told.err);
    QCOMPARE(told.err, QByteArray("Sections: 6, joints: 12\n"));
    const Model model = made();
    QCOMPARE(model.sectionCount(), std::size_t(6));
    QCOMPARE(model.section(0)->name, std::string("dice 1"));
    QVERIFY(model.document.templates.empty() && model.document.blobs.empty());
    QCOMPARE(model.document.jointOverrides.size(), std::size_t(12));
    QVERIFY(QString::fromStdString(model.stockOf(0).name).startsWith(u"Acrylic"));
    const QByteArray info = run({u"info"_s, path(u"out.fff"_s)}).out;
    QVERIFY2(info.contains("All sections hold together") && info.contains("Can be assembled"),
             info);
    QVERIFY2(info.contains("100.0 × 100.0 × 100.0 mm"), info);
}

void TestCliFacets::unfolded()
{
    const QString mesh = putMesh(path(u"dice.obj"_s), cube(2.0));
    const Run told = facets(mesh, {u"--size"_s, u"60"_s, u"--unfold"_s, u"--stock"_s, u"card"_s});
    QVERIFY2(told.status == 0, told.err);
    // A cross of 240 × 180 mm has room on A4 one way; 5 folds, and a flap at each of 7 seams.
    QCOMPARE(told.err, QByteArray("Nets: 1, folds: 12, seams: 7\n"));
    const Model model = made();
    QCOMPARE(model.sectionCount(), std::size_t(1));
    const Section &net = *model.section(0);
    QCOMPARE(net.name, std::string("dice net 1"));
    QCOMPARE(net.marks.size(), std::size_t(2));
    QVERIFY(net.marks.front()->kind == Mark::Kind::Scored);
    QCOMPARE(net.marks.front()->paths.size(), std::size_t(12));
    QVERIFY(std::abs(net.frame.origin.y() - 0.5 * model.stockOf(0).thickness) < 1e-9);
    const Run bare = facets(
        mesh, {u"--size"_s, u"60"_s, u"--unfold"_s, u"--thickness"_s, u"1"_s, u"--flap"_s, u"0"_s});
    QCOMPARE(bare.err, QByteArray("Nets: 1, folds: 5, seams: 7\n"));
    QVERIFY(std::abs(made().section(0)->shape->area() - 6.0 * 60.0 * 60.0) < 1e-6);
}

void TestCliFacets::tooThickToFold()
{
    const Run told =
        facets(putMesh(path(u"dice.obj"_s), cube(2.0)), {u"--unfold"_s, u"--thickness"_s, u"6"_s});
    QCOMPARE(told.status, 2);
    QVERIFY2(told.err.startsWith("A sheet of 6 mm does not fold, expected at most 3 mm;"),
             told.err);
}

// Wrong: a file whose faces look inwards is built round the outside of itself.
void TestCliFacets::insideOut()
{
    const Run told =
        facets(putMesh(path(u"inside.obj"_s), turnedOver(cube(2.0))), {u"--size"_s, u"100"_s});
    QVERIFY2(told.status == 0, told.err);
    QVERIFY(run({u"info"_s, path(u"out.fff"_s)}).out.contains("100.0 × 100.0 × 100.0 mm"));
}

void TestCliFacets::simplified()
{
    const QString mesh = putMesh(path(u"ball.obj"_s), sphere(20.0, 40, 60));
    const Run told = facets(mesh, {u"--faces"_s, u"20"_s, u"--size"_s, u"200"_s});
    QVERIFY2(told.status == 0, told.err);
    const std::size_t count = made().sectionCount();
    QVERIFY2(count >= 8 && count <= 20, told.err);
}

void TestCliFacets::edgesWithoutFingersAreNamed()
{
    const Run told = facets(putMesh(path(u"round.obj"_s), icosphere()), {});
    QVERIFY2(told.status == 0, told.err);
    QVERIFY2(told.err.startsWith("No fingers where sheets meet at less than 30° or more than 150°: "
                                 "round 1 and round "),
             told.err);
    QVERIFY2(told.err.endsWith("\nSections: 80, joints: 0\n"), told.err);
    QCOMPARE(told.err.count('\n'), 2);
}

void TestCliFacets::wrongUse_data()
{
    QTest::addColumn<QString>("arguments");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("no file to write") << u"a.obj"_s << QByteArray("-o is missing");
    QTest::newRow("a drawing") << u"a.obj -o b.svg"_s << QByteArray("expected .fff");
    QTest::newRow("a flap of nothing")
        << u"a.obj -o b.fff --flap 5"_s << QByteArray("--flap is of --unfold");
    QTest::newRow("no mesh") << u"-o b.fff"_s << QByteArray("No file was given");
    QTest::newRow("too few faces")
        << u"a.obj -o b.fff --faces 3"_s << QByteArray("--faces: found \"3\", expected a whole");
    QTest::newRow("too many") << u"a.obj -o b.fff --faces 501"_s << QByteArray("from 4 to 500");
    QTest::newRow("a word") << u"a.obj -o b.fff --faces few"_s << QByteArray("found \"few\"");
    QTest::newRow("no size") << u"a.obj -o b.fff --size -1"_s << QByteArray("--size: found");
}

void TestCliFacets::wrongUse()
{
    QFETCH(const QString, arguments);
    QFETCH(const QByteArray, said);
    const Run told = run(QStringList{u"facets"_s} + arguments.split(u' '));
    QCOMPARE(told.status, 1);
    QVERIFY2(told.err.contains(said), told.err);
    QVERIFY2(told.err.contains("\nUsage: flatfitfab-cli facets MESH -o OUT.fff"), told.err);
}

void TestCliFacets::whatCannotBeBuilt_data()
{
    QTest::addColumn<MeshDraft>("draft");
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("round") << sphere(50.0, 30, 40) << QStringList{}
                           << QByteArray("flat pieces, expected at most 500; --faces makes them");
    QTest::newRow("tiny") << cube(2.0) << QStringList{u"--size"_s, u"4"_s}
                          << QByteArray("no flat piece of it is large enough");
    QTest::newRow("no surface") << cubesAtAnEdge(20.0) << QStringList{u"--faces"_s, u"12"_s}
                                << QByteArray(
                                       "found \"an edge with three faces or more\", expected");
}

void TestCliFacets::whatCannotBeBuilt()
{
    QFETCH(MeshDraft, draft);
    QFETCH(const QStringList, options);
    QFETCH(const QByteArray, said);
    QFile::remove(path(u"out.fff"_s));
    const Run told = facets(putMesh(path(u"bad.obj"_s), draft), options);
    QCOMPARE(told.status, 2);
    QVERIFY2(told.err.contains(said), told.err);
    QVERIFY(!QFile::exists(path(u"out.fff"_s)));
}

FFF_TEST(TestCliFacets)
#include "tst_cli_facets.moc"
