// The skin of a model as a file, as scripts and printers take it.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "core/io/mesh_file.h"
#include "core/model/edits.h"
#include "tests/app/cli_run.h"
#include "tests/core/skin/discs.h"
#include "tests/test_program.h"

#include <QFile>
#include <QTemporaryDir>

#include <numbers>

using namespace fff;
using namespace fff::test;
using namespace Qt::Literals::StringLiterals;

class TestCliSkin : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aBall_data();
    void aBall();
    void solidsStaySolids();
    void nothingToMake();
    void wrongUse_data();
    void wrongUse();

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }
    QString put(const QString &name, const std::vector<SectionPointer> &sections) const
    {
        Document document = newDocument();
        for (const SectionPointer &section : sections) {
            NewSection one;
            one.shape = section->shape;
            one.frame = section->frame;
            document = addSection(document, one).value();
        }
        return io::writeDocument(path(name), document) ? path(name) : QString();
    }

    QTemporaryDir m_folder;
};

void TestCliSkin::aBall_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QStringList>("options");
    QTest::newRow("for printers") << u"ball.stl"_s << QStringList{u"--skin"_s};
    QTest::newRow("for other programs") << u"ball.obj"_s << QStringList{u"--skin"_s};
}

// Wrong: it is not closed, inside out, of another size, or lies on its side in a printer.
void TestCliSkin::aBall()
{
    QFETCH(QString, file);
    QFETCH(QStringList, options);
    std::vector<SectionPointer> discs = sphere(50.0, {0.0});
    const Eigen::Isometry3d up(Eigen::Translation3d(0.0, 80.0, 0.0));
    const QString model = put(u"ball.fff"_s, moved(discs, up));
    const Run told = run(QStringList{u"export"_s, model, u"-o"_s, path(file)} + options, false);
    QVERIFY2(told.status == 0, told.err);
    QVERIFY2(told.err.startsWith("Patches: 8, triangles: "), told.err);
    QVERIFY2(!told.err.contains("open"), told.err);
    const auto read = io::readMesh(path(file));
    QVERIFY(read);
    const double ball = 4.0 / 3.0 * std::numbers::pi * 125000.0;
    QVERIFY(std::abs(read->mesh->volume() / ball - 1.0) < 0.02);
    const bool isStl = file.endsWith(u".stl"_s);
    const Vec3 middle = isStl ? Vec3(0.0, 0.0, 80.0) : Vec3(0.0, 80.0, 0.0);
    QVERIFY((read->mesh->centroid() - middle).norm() < 0.5);
    QFile bytes(path(file));
    QVERIFY(bytes.open(QIODevice::ReadOnly));
    if (isStl) // head, count, and 50 bytes a triangle
        QCOMPARE(bytes.size(), qint64(84 + 50 * read->mesh->triangles().size()));
    else
        QVERIFY(bytes.readAll().contains("\no skin\n"));
}

void TestCliSkin::solidsStaySolids()
{
    const QString model = put(u"discs.fff"_s, sphere(50.0, {0.0}));
    QCOMPARE(run({u"export"_s, model, u"-o"_s, path(u"discs.obj"_s)}, false).status, 0);
    QFile file(path(u"discs.obj"_s));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(!file.readAll().contains("\no skin\n"));
}

void TestCliSkin::nothingToMake()
{
    const QString model = put(u"one.fff"_s, {disc(50.0, Vec3::UnitZ(), 0.0)});
    const Run told = run({u"export"_s, model, u"--skin"_s, u"-o"_s, path(u"none.stl"_s)}, false);
    QCOMPARE(told.status, 2);
    QCOMPARE(told.err, model.toUtf8() + ": no contours cross each other at their edges, so there "
                                        "is no skin\n");
    QVERIFY(!QFile::exists(path(u"none.stl"_s)));
}

void TestCliSkin::wrongUse_data()
{
    QTest::addColumn<QString>("file");
    QTest::newRow("a drawing") << u"ball.svg"_s;
    QTest::newRow("a model") << u"ball.fff"_s;
}

void TestCliSkin::wrongUse()
{
    QFETCH(QString, file);
    const QString model = put(u"wrong.fff"_s, sphere(50.0, {0.0}));
    const Run told =
        run({u"export"_s, model, u"--skin"_s, u"-o"_s, path(u"wrong_"_s + file)}, false);
    QCOMPARE(told.status, 1);
    QVERIFY2(told.err.contains("--skin: this kind of file cannot hold it; expected .obj or .stl."),
             told.err);
}

FFF_TEST(TestCliSkin)
#include "tst_cli_skin.moc"
