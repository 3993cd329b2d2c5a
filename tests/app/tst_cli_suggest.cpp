// `suggest`, as scripts read it.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/app/cli_run.h"
#include "tests/core/templates/made_forms.h"
#include "tests/test_program.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

using namespace fff;
using namespace fff::test;
using namespace Qt::Literals::StringLiterals;

class TestCliSuggest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aModelThatIsInOrder();
    void theSeedSaysAll();
    void aStockAndASize();
    void fewerThanWanted();
    void nothingComesOfIt();
    void wrongUse_data();
    void wrongUse();
    void unreadable();

private:
    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }
    QString put(const char *name, const MeshDraft &draft)
    {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly))
            return {};
        for (const Vec3 &p : draft.positions)
            file.write(QStringLiteral("v %1 %2 %3\n")
                           .arg(p.x(), 0, 'g', 17)
                           .arg(p.y(), 0, 'g', 17)
                           .arg(p.z(), 0, 'g', 17)
                           .toLatin1());
        for (const Triangle &t : draft.triangles)
            file.write(QStringLiteral("f %1 %2 %3\n")
                           .arg(t[0] + 1)
                           .arg(t[1] + 1)
                           .arg(t[2] + 1)
                           .toLatin1());
        return file.fileName();
    }
    QByteArray bytes(const char *name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    QJsonObject info(const char *name) const
    {
        return QJsonDocument::fromJson(run({u"info"_s, path(name), u"--json"_s}).out).object();
    }

    QTemporaryDir m_folder;
};

void TestCliSuggest::aModelThatIsInOrder()
{
    const QString mesh = put("animal.obj", animal());
    const Run told = run({u"suggest"_s, mesh, u"-o"_s, path("animal.fff"), u"--count"_s, u"6"_s});
    QVERIFY2(told.status == 0, told.err);
    QCOMPARE(run({u"check"_s, path("animal.fff")}).status, 0);
    const QJsonObject found = info("animal.fff");
    QCOMPARE(found[u"sections"].toInt(), 6);
    QCOMPARE(found[u"components"].toInt(), 1);
    QVERIFY(found[u"assemblable"].toBool());
    QVERIFY(found[u"stable"].toBool());
}

void TestCliSuggest::theSeedSaysAll()
{
    const QString mesh = put("vase.obj", vase());
    for (const auto &[name, seed] :
         {std::pair("a.fff", u"3"_s), std::pair("b.fff", u"3"_s), std::pair("c.fff", u"4"_s)})
        QCOMPARE(
            run({u"suggest"_s, mesh, u"-o"_s, path(name), u"--count"_s, u"4"_s, u"--seed"_s, seed})
                .status,
            0);
    QVERIFY(!bytes("a.fff").isEmpty());
    QCOMPARE(bytes("a.fff"), bytes("b.fff"));
    QVERIFY(bytes("a.fff") != bytes("c.fff"));
}

void TestCliSuggest::aStockAndASize()
{
    const QString mesh = put("bracket.obj", bracket());
    QCOMPARE(run({u"suggest"_s, mesh, u"-o"_s, path("bracket.fff"), u"--count"_s, u"3"_s,
                  u"--size"_s, u"200"_s, u"--stock"_s, u"acrylic"_s})
                 .status,
             0);
    const QJsonObject found = info("bracket.fff");
    const QJsonArray low = found[u"bounds"][0].toArray(), high = found[u"bounds"][1].toArray();
    for (int axis = 0; axis < 3; ++axis)
        QVERIFY(high[axis].toDouble() - low[axis].toDouble() < 205.0);
    QVERIFY(run({u"info"_s, path("bracket.fff")}).out.contains("Acrylic"));
}

void TestCliSuggest::fewerThanWanted()
{
    const QString mesh = put("cube.obj", cube(60.0));
    const Run told = run({u"suggest"_s, mesh, u"-o"_s, path("cube.fff"), u"--count"_s, u"90"_s,
                          u"--size"_s, u"60"_s});
    QCOMPARE(told.status, 0);
    QVERIFY2(told.err.startsWith("cube.obj: Only "), told.err);
    QCOMPARE(told.err.count('\n'), 1);
}

void TestCliSuggest::nothingComesOfIt()
{
    const QString mesh = put("cube.obj", cube(2.0));
    const Run told = run({u"suggest"_s, mesh, u"-o"_s, path("none.fff"), u"--size"_s, u"2"_s});
    QCOMPARE(told.status, 2);
    QVERIFY2(told.err.startsWith("cube.obj: cube is too small"), told.err);
    QCOMPARE(told.err.count('\n'), 1);
    QVERIFY(!QFile::exists(path("none.fff")));
}

void TestCliSuggest::wrongUse_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("says");
    const QStringList good{u"a.obj"_s, u"-o"_s, u"a.fff"_s};
    QTest::newRow("no output") << QStringList{u"a.obj"_s} << QByteArray("-o is missing");
    QTest::newRow("no mesh") << QStringList{u"-o"_s, u"a.fff"_s} << QByteArray("No file");
    QTest::newRow("no number") << good + QStringList{u"--count"_s, u"x"_s}
                               << QByteArray("--count: found \"x\", expected a whole number");
    QTest::newRow("half a section")
        << good + QStringList{u"--count"_s, u"2.5"_s} << QByteArray("from 1 to 100");
    QTest::newRow("none") << good + QStringList{u"--count"_s, u"0"_s}
                          << QByteArray("from 1 to 100");
    QTest::newRow("too many") << good + QStringList{u"--count"_s, u"101"_s}
                              << QByteArray("from 1 to 100");
    QTest::newRow("a seed below 0")
        << good + QStringList{u"--seed"_s, u"-1"_s} << QByteArray("--seed: found \"-1\"");
    QTest::newRow("no size") << good + QStringList{u"--size"_s, u"0"_s}
                             << QByteArray("--size: found \"0\"");
    QTest::newRow("no stock") << good + QStringList{u"--stock"_s, u"cheese"_s}
                              << QByteArray("There is no stock \"cheese\"");
}

void TestCliSuggest::wrongUse()
{
    QFETCH(const QStringList, arguments);
    QFETCH(const QByteArray, says);
    const Run told = run(QStringList{u"suggest"_s} + arguments);
    QCOMPARE(told.status, 1);
    QVERIFY2(told.err.contains(says), told.err);
    QVERIFY(told.err.contains("flatfitfab-cli suggest MESH -o OUT.fff"));
}

void TestCliSuggest::unreadable()
{
    QFile file(path("a.obj"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("v 0 0 0\nv 1 x 0\n");
    file.close();
    const QStringList out{u"-o"_s, path("a.fff")};
    const Run told = run(QStringList{u"suggest"_s, file.fileName()} + out);
    QCOMPARE(told.status, 2);
    QVERIFY2(told.err.endsWith("a.obj:2: found \"x\", expected a number\n"), told.err);
    QCOMPARE(run(QStringList{u"suggest"_s, path("gone.stl")} + out).status, 2);
}

FFF_TEST(TestCliSuggest)
#include "tst_cli_suggest.moc"
