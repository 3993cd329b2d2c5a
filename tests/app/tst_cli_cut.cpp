// `cut`, as scripts read it.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/app/cli_run.h"
#include "tests/app/mesh_files.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

using namespace fff;
using namespace fff::test;
using namespace Qt::Literals::StringLiterals;

class TestCliCut : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theContract();
    void openOnesAreSaid();
    void aSize();
    void text();
    void wrongUse_data();
    void wrongUse();
    void unreadable();

private:
    QString put(const char *name, const MeshDraft &draft)
    {
        return putMesh(m_folder.filePath(QLatin1String(name)), draft);
    }

    QTemporaryDir m_folder;
};

void TestCliCut::theContract()
{
    const QString mesh = put("ring.obj", torus(30.0, 10.0, 60, 30));
    const Run told = run({u"cut"_s, mesh, u"--plane"_s, u"0,0,1,0,0,2"_s, u"--json"_s});
    QCOMPARE(told.status, 0);
    const QJsonObject cut = QJsonDocument::fromJson(told.out).object();
    const QJsonArray loops = cut[u"loops"].toArray();
    QCOMPARE(loops.size(), 2);
    QVERIFY(!loops[0][u"hole"].toBool() && loops[1][u"hole"].toBool());
    double area = 0.0;
    for (const QJsonValue &loop : loops) {
        QVERIFY(loop[u"closed"].toBool());
        const QJsonArray points = loop[u"points"].toArray();
        QVERIFY(points.size() >= 60);
        for (qsizetype i = 0; i < points.size(); ++i) {
            const QJsonValue a = points[i], b = points[(i + 1) % points.size()];
            QVERIFY(std::abs(a[2].toDouble() - 1.0) < 1e-9);
            area += 0.5 * (a[0].toDouble() * b[1].toDouble() - a[1].toDouble() * b[0].toDouble());
        }
    }
    QVERIFY(std::abs(cut[u"area"].toDouble() - area) < 1e-6);
    QCOMPARE(cut[u"plane"][u"normal"][2].toDouble(), 1.0);
    QCOMPARE(cut[u"report"].toArray().size(), 0);
}

void TestCliCut::openOnesAreSaid()
{
    const QString mesh =
        put("cup.obj", without(sphere(10.0, 20, 30), [](const Vec3 &p) { return p.z() > 5.0; }));
    const QJsonObject cut =
        QJsonDocument::fromJson(
            run({u"cut"_s, mesh, u"--plane"_s, u"0,0,0,0,1,0"_s, u"--json"_s}).out)
            .object();
    QVERIFY(!cut[u"loops"][0][u"closed"].toBool());
    const QJsonArray report = cut[u"report"].toArray();
    QCOMPARE(report.size(), 2); // what is open in the mesh, and in the cut
    QVERIFY(report[0].toString().contains(u"open"));
    QVERIFY(report[1].toString().contains(u"closed"));
}

void TestCliCut::aSize()
{
    const QString mesh = put("cube.obj", moved(cube(2.0), {100, 200, 300}));
    const QJsonObject cut =
        QJsonDocument::fromJson(run({u"cut"_s, mesh, u"--plane"_s, u"0,50,0,0,1,0"_s, u"--size"_s,
                                     u"100"_s, u"--json"_s})
                                    .out)
            .object();
    QVERIFY(std::abs(cut[u"area"].toDouble() - 10000.0) < 1e-6);
}

void TestCliCut::text()
{
    const QString mesh = put("cube.obj", cube(2.0));
    const Run told = run({u"cut"_s, mesh, u"--plane"_s, u"0,0,0,0,1,0"_s});
    QCOMPARE(told.status, 0);
    QVERIFY(told.out.contains("Faces: 12, shells: 1"));
    QVERIFY(told.out.contains("4.00 mm"));
    QVERIFY(run({u"cut"_s, mesh, u"--plane"_s, u"0,9,0,0,1,0"_s}).out.contains("does not cut"));
}

void TestCliCut::wrongUse_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("no plane") << QStringList{u"a.obj"_s};
    QTest::newRow("five numbers") << QStringList{u"a.obj"_s, u"--plane"_s, u"1,2,3,4,5"_s};
    QTest::newRow("a word") << QStringList{u"a.obj"_s, u"--plane"_s, u"1,2,3,4,5,x"_s};
    QTest::newRow("no direction") << QStringList{u"a.obj"_s, u"--plane"_s, u"1,2,3,0,0,0"_s};
    QTest::newRow("not finite") << QStringList{u"a.obj"_s, u"--plane"_s, u"1,2,3,0,0,inf"_s};
    QTest::newRow("no file") << QStringList{u"--plane"_s, u"0,0,0,0,0,1"_s};
    QTest::newRow("a negative size")
        << QStringList{u"a.obj"_s, u"--plane"_s, u"0,0,0,0,0,1"_s, u"--size"_s, u"-4"_s};
}

void TestCliCut::wrongUse()
{
    QFETCH(const QStringList, arguments);
    const Run told = run(QStringList{u"cut"_s} + arguments);
    QCOMPARE(told.status, 1);
    QVERIFY(told.err.contains("flatfitfab-cli cut MESH --plane"));
}

void TestCliCut::unreadable()
{
    const QStringList plane{u"--plane"_s, u"0,0,0,0,0,1"_s};
    QFile file(m_folder.filePath(u"a.obj"_s));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("v 0 0 0\nv 1 x 0\n");
    file.close();
    const Run told = run(QStringList{u"cut"_s, file.fileName()} + plane);
    QCOMPARE(told.status, 2);
    QCOMPARE(told.err, file.fileName().toUtf8() + ":2: found \"x\", expected a number\n");
    QCOMPARE(run(QStringList{u"cut"_s, m_folder.filePath(u"gone.stl"_s)} + plane).status, 2);
}

FFF_TEST(TestCliCut)
#include "tst_cli_cut.moc"
