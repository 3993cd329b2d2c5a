// `slices`, and meshes beside models that are drawn and played, as scripts use them.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "core/io/template_file.h"
#include "core/operations/evaluate.h"
#include "tests/app/cli_run.h"
#include "tests/app/mesh_files.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <QFile>
#include <QImage>
#include <QTemporaryDir>

#include <numbers>

using namespace fff;
using namespace fff::test;
using namespace Qt::Literals::StringLiterals;

class TestCliSlices : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void theContract_data();
    void theContract();
    void onTheStockThatIsNamed();
    void theSameTwice();
    void toStandardOutput();
    void whatIsMendedIsSaid();
    void wrongUse_data();
    void wrongUse();
    void unreadable_data();
    void unreadable();
    void nothingIsLargeEnough();
    void besideAModelThatIsPlayed();
    void picturesBesideAModelAreTraced();
    void whatIsFlatIsNoMesh();
    void wrongTemplates_data();
    void wrongTemplates();

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }
    Model modelIn(const QString &name) const
    {
        auto read = io::readDocument(path(name));
        return read ? evaluate(std::move(read->document)) : Model();
    }

    QTemporaryDir m_folder;
    QString m_ball;
};

void TestCliSlices::initTestCase()
{
    m_ball = putMesh(path(u"ball.obj"_s), sphere(2.0, 40, 60));
    QVERIFY(!m_ball.isEmpty());
    putMesh(path(u"open@home.obj"_s),
            without(sphere(20.0, 20, 30), [](const Vec3 &p) { return p.z() > 15.0; }));
}

void TestCliSlices::theContract_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<int>("sections");
    QTest::newRow("as it comes") << QStringList{} << 12;
    QTest::newRow("across X") << QStringList{u"--along"_s, u"X"_s, u"--count"_s, u"5"_s} << 5;
    QTest::newRow("across Y") << QStringList{u"--along"_s, u"y"_s, u"--count"_s, u"4"_s} << 4;
    QTest::newRow("across Z, by spacing")
        << QStringList{u"--along"_s, u"Z"_s, u"--spacing"_s, u"25"_s} << 4;
    QTest::newRow("a grid") << QStringList{u"--along"_s, u"XY"_s, u"--count"_s, u"3"_s} << 6;
    QTest::newRow("hollow") << QStringList{u"--count"_s, u"2"_s, u"--hollow"_s, u"10"_s} << 4;
    QTest::newRow("around") << QStringList{u"--along"_s, u"radial"_s, u"--count"_s, u"7"_s} << 7;
}

void TestCliSlices::theContract()
{
    QFETCH(const QStringList, options);
    QFETCH(int, sections);
    const QString out = path(u"out.fff"_s);
    QFile::remove(out);
    const Run told =
        run(QStringList{u"slices"_s, m_ball, u"-o"_s, out, u"--size"_s, u"100"_s} + options, false);
    QVERIFY2(told.status == 0, told.err);
    QVERIFY2(told.err.contains("Sections: " + QByteArray::number(sections)), told.err);
    const Model model = modelIn(u"out.fff"_s);
    QCOMPARE(model.sectionCount(), static_cast<std::size_t>(sections));
    // They are live: an operation of a mesh that the file holds, and stand on the ball.
    QCOMPARE(model.document.operations.size(), std::size_t(1));
    QCOMPARE(model.document.templates.size(), std::size_t(1));
    const bool isHollow = options.contains(u"--hollow"_s);
    for (const SectionPointer &section : model.sections())
        QCOMPARE(section->shape->holes().empty(), !isHollow);
    for (const SectionPointer &section : model.sections())
        for (const Vec2 &p : section->shape->contour().polygon(0.01))
            QVERIFY(std::abs((section->frame.toWorld(p) - Vec3(0, 50, 0)).norm() - 50.0) < 0.5);
}

void TestCliSlices::onTheStockThatIsNamed()
{
    const Run told = run({u"slices"_s, m_ball, u"-o"_s, path(u"acrylic.fff"_s), u"--stock"_s,
                          u"acrylic"_s, u"--thickness"_s, u"4"_s});
    QVERIFY2(told.status == 0, told.err);
    const Model model = modelIn(u"acrylic.fff"_s);
    QVERIFY(model.sectionCount() > 0);
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        QVERIFY(QString::fromStdString(model.stockOf(i).name).startsWith(u"Acrylic"));
        QCOMPARE(model.stockOf(i).thickness, 4.0);
    }
    // As large as where no file says: ten of the paper's units.
    const Template &one = *model.document.templates.front();
    QVERIFY(std::abs(worldBounds(one, *one.mesh).size().maxCoeff() - 254.0) < 1e-6);
}

// Wrong: a build that runs it again changes what is under version control.
void TestCliSlices::theSameTwice()
{
    QByteArray bytes[2];
    for (QByteArray &of : bytes) {
        QCOMPARE(run({u"slices"_s, m_ball, u"-o"_s, path(u"same.fff"_s)}).status, 0);
        QFile file(path(u"same.fff"_s));
        QVERIFY(file.open(QIODevice::ReadOnly));
        of = file.readAll();
    }
    QVERIFY(!bytes[0].isEmpty());
    QCOMPARE(bytes[0], bytes[1]);
}

void TestCliSlices::toStandardOutput()
{
    const Run told = run({u"slices"_s, m_ball, u"-o"_s, u"-"_s, u"--along"_s, u"X"_s});
    QCOMPARE(told.status, 0);
    QFile file(path(u"piped.fff"_s));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(told.out);
    file.close();
    QCOMPARE(modelIn(u"piped.fff"_s).sectionCount(), std::size_t(6));
}

// A file may have an @ in its name.
void TestCliSlices::whatIsMendedIsSaid()
{
    const Run told = run({u"slices"_s, path(u"open@home.obj"_s), u"-o"_s, path(u"open.fff"_s)});
    QVERIFY2(told.status == 0, told.err);
    QVERIFY2(told.err.startsWith("open@home.obj: ") && told.err.contains("open"), told.err);
}

void TestCliSlices::wrongUse_data()
{
    QTest::addColumn<QString>("arguments");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("no file to write") << u"a.obj"_s << QByteArray("-o is missing");
    QTest::newRow("a name that is none") << u"a.obj -o "_s << QByteArray("-o: a file needs a name");
    QTest::newRow("a drawing") << u"a.obj -o b.svg"_s << QByteArray("expected .fff");
    QTest::newRow("no mesh") << u"-o b.fff"_s << QByteArray("No file was given");
    QTest::newRow("two meshes") << u"a.obj b.obj -o b.fff"_s << QByteArray("Too many files: b.obj");
    QTest::newRow("a direction that is none")
        << u"a.obj -o b.fff --along W"_s << QByteArray("--along: found \"W\", expected X, Y, Z");
    QTest::newRow("a curve, which nobody drew")
        << u"a.obj -o b.fff --along curve"_s << QByteArray("--along: found \"curve\", expected X");
    QTest::newRow("no planes") << u"a.obj -o b.fff --count 0"_s
                               << QByteArray("--count: found \"0\", expected a whole number");
    QTest::newRow("half a plane") << u"a.obj -o b.fff --count 2.5"_s
                                  << QByteArray("--count: found \"2.5\"");
    QTest::newRow("too many") << u"a.obj -o b.fff --count 501"_s << QByteArray("from 1 to 500");
    QTest::newRow("no spacing") << u"a.obj -o b.fff --spacing 0"_s
                                << QByteArray("--spacing: found \"0\"");
    QTest::newRow("both") << u"a.obj -o b.fff --count 3 --spacing 10"_s
                          << QByteArray("expected one of them");
    QTest::newRow("a spacing of what is around")
        << u"a.obj -o b.fff --along radial --spacing 10"_s << QByteArray("expected --count");
    QTest::newRow("a wall of nothing")
        << u"a.obj -o b.fff --hollow 0"_s << QByteArray("--hollow: found \"0\"");
    QTest::newRow("no size") << u"a.obj -o b.fff --size 0"_s << QByteArray("--size: found \"0\"");
    QTest::newRow("a stock that nobody sells")
        << u"a.obj -o b.fff --stock Unobtainium"_s << QByteArray("There is no stock");
}

void TestCliSlices::wrongUse()
{
    QFETCH(const QString, arguments);
    QFETCH(const QByteArray, said);
    const Run told = run(QStringList{u"slices"_s} + arguments.split(u' '));
    QCOMPARE(told.status, 1);
    QVERIFY2(told.err.contains(said), told.err);
    QVERIFY2(told.err.contains("\nUsage: flatfitfab-cli slices MESH -o OUT.fff"), told.err);
    QCOMPARE(told.err.count('\n'), 2);
}

void TestCliSlices::unreadable_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("a word for a number")
        << QByteArray("v 0 0 0\nv 1 x 0\n") << QByteArray(":2: found \"x\", expected a number\n");
    QTest::newRow("no faces") << QByteArray("v 0 0 0\nv 1 0 0\n") << QByteArray();
    QTest::newRow("empty") << QByteArray() << QByteArray();
}

void TestCliSlices::unreadable()
{
    QFETCH(const QByteArray, bytes);
    QFETCH(const QByteArray, said);
    QFile file(path(u"bad.obj"_s));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
    file.close();
    const QString out = path(u"never.fff"_s);
    const Run told = run({u"slices"_s, file.fileName(), u"-o"_s, out});
    QCOMPARE(told.status, 2);
    QCOMPARE(told.err.count('\n'), 1);
    QVERIFY2(told.err.contains(said), told.err);
    QVERIFY(!QFile::exists(out));
    QCOMPARE(run({u"slices"_s, path(u"gone.stl"_s), u"-o"_s, out}).status, 2);
}

void TestCliSlices::nothingIsLargeEnough()
{
    const QString out = path(u"none.fff"_s);
    const Run told = run({u"slices"_s, m_ball, u"-o"_s, out, u"--size"_s, u"2"_s});
    QCOMPARE(told.status, 2);
    QVERIFY2(told.err.contains("no plane cuts a section of it that is large enough"), told.err);
    QVERIFY(!QFile::exists(out));
}

void TestCliSlices::besideAModelThatIsPlayed()
{
    QFile script(path(u"script.json"_s));
    QVERIFY(script.open(QIODevice::WriteOnly));
    script.write(R"({"viewport": [800, 600], "events": [{"type": "wait", "ms": 10}]})");
    script.close();
    const Run told =
        run({u"replay"_s, script.fileName(), u"--template"_s, m_ball + u"@80"_s, u"--template"_s,
             path(u"open@home.obj"_s), u"-o"_s, path(u"played.fff"_s)});
    QVERIFY2(told.status == 0, told.err);
    const Model model = modelIn(u"played.fff"_s);
    QCOMPARE(model.document.templates.size(), std::size_t(2));
    const Template &ball = *model.document.templates[0], &open = *model.document.templates[1];
    QVERIFY(std::abs(worldBounds(ball, *ball.mesh).size().maxCoeff() - 80.0) < 1e-9);
    QVERIFY(std::abs(worldBounds(open, *open.mesh).size().maxCoeff() - 254.0) < 1e-6);
    QCOMPARE(open.name, std::string("open@home"));
}

void TestCliSlices::picturesBesideAModelAreTraced()
{
    QImage image(100, 50, QImage::Format_RGB32);
    image.fill(Qt::white);
    for (int x = 20; x < 60; ++x)
        for (int y = 10; y < 40; ++y)
            image.setPixelColor(x, y, Qt::black);
    QVERIFY(image.save(path(u"block.png"_s)));
    QFile script(path(u"trace.json"_s));
    QVERIFY(script.open(QIODevice::WriteOnly));
    script.write(R"({"viewport": [800, 600], "events": [
        {"type": "command", "name": "template.trace", "parameters": {"smoothing": "0"}}]})");
    script.close();
    const Run told = run({u"replay"_s, script.fileName(), u"--template"_s, path(u"block.png@200"_s),
                          u"-o"_s, path(u"traced.fff"_s)});
    QVERIFY2(told.status == 0, told.err);
    const Model model = modelIn(u"traced.fff"_s);
    QCOMPARE(model.sectionCount(), std::size_t(1));
    QVERIFY(std::abs(model.section(0)->shape->area() / (80.0 * 60.0) - 1.0) < 1e-6);
    QCOMPARE(model.document.templates.size(), std::size_t(1));
    QVERIFY(model.document.templates[0]->picture);
}

void TestCliSlices::whatIsFlatIsNoMesh()
{
    const Run told = run({u"slices"_s, path(u"block.png"_s), u"-o"_s, path(u"never.fff"_s)});
    QCOMPARE(told.status, 2);
    QCOMPARE(told.err, QByteArray("block.png: found nothing, expected a mesh: this is flat\n"));
    QVERIFY(!QFile::exists(path(u"never.fff"_s)));
}

void TestCliSlices::wrongTemplates_data()
{
    QTest::addColumn<QString>("mesh");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("no size") << m_ball + u"@0"_s << 1 << QByteArray("--template: found");
    QTest::newRow("a word for a size") << m_ball + u"@large"_s << 1 << QByteArray("such as ball");
    QTest::newRow("below nothing") << m_ball + u"@-5"_s << 1 << QByteArray("--template: found");
    QTest::newRow("no end") << m_ball + u"@inf"_s << 1 << QByteArray("--template: found");
    QTest::newRow("not there") << path(u"gone.obj"_s) << 2 << QByteArray("gone.obj");
    QTest::newRow("not there, with a size")
        << path(u"gone.obj@80"_s) << 2 << QByteArray("gone.obj: could not");
}

void TestCliSlices::wrongTemplates()
{
    QFETCH(const QString, mesh);
    QFETCH(int, status);
    QFETCH(const QByteArray, said);
    const Run told = run({u"replay"_s, path(u"script.json"_s), u"--template"_s, mesh, u"-o"_s,
                          path(u"never.fff"_s)});
    QCOMPARE(told.status, status);
    QVERIFY2(told.err.contains(said), told.err);
    QVERIFY(!QFile::exists(path(u"never.fff"_s)));
}

FFF_TEST(TestCliSlices)
#include "tst_cli_slices.moc"
