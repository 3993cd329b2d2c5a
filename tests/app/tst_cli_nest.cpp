// `nest`, as scripts read it.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/nesting/problem.h"
#include "tests/app/cli_run.h"
#include "tests/core/nesting/nesting_oracle.h"
#include "tests/test_program.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include <numbers>

using namespace fff;
using namespace fff::test;
using namespace Qt::Literals::StringLiterals;

namespace {

/// Right triangles and a square that has a square hole, for a strip of 50.
constexpr const char *kInstance = R"({"name": "made up", "strip_height": 50.5, "items": [
  {"id": 4, "demand": 6, "allowed_orientations": [0.0, 180.0], "shape": {"type": "simple_polygon",
   "data": [[0, 0], [25, 0], [0, 25], [0, 0]]}},
  {"id": 7, "demand": 1, "allowed_orientations": [0.0, 90.0, 180.0, 270.0], "shape": {"type": "polygon",
   "data": {"outer": [[0, 0], [0, 50], [50, 50], [50, 0]], "inner": [[[10, 10], [40, 10], [40, 40], [10, 40]]]}}},
  {"id": 9, "demand": 1, "shape": {"type": "simple_polygon", "data": [[0, 0], [28, 0], [28, 28], [0, 28]]}}]})";

Vec2 turnOf(double degrees)
{
    const double angle = degrees * std::numbers::pi / 180.0;
    return {std::cos(angle), std::sin(angle)};
}

} // namespace

class TestCliNest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void anInstance();
    void sameSeedSameBytes();
    void aModel();
    void tooLargeOnesAreNamed();
    void sheetsWithoutRoom();
    void sheetsThatAreMissing();
    void text();
    void wrongUse_data();
    void wrongUse();
    void badInstances_data();
    void badInstances();

private:
    QString put(const QString &name, const QByteArray &bytes)
    {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            return {};
        return file.fileName();
    }

    QTemporaryDir m_folder;
    const QString m_sample = QStringLiteral(FFF_SAMPLES "/dinosaur.fff");
};

void TestCliNest::anInstance()
{
    const QString file = put(u"made.json"_s, kInstance);
    const Run told = run({u"nest"_s, file, u"--json"_s, u"--seconds"_s, u"0.2"_s});
    QCOMPARE(told.status, 0);
    const QJsonObject nest = QJsonDocument::fromJson(told.out).object();
    QCOMPARE(nest[u"instance"].toString(), u"made up"_s);
    QVERIFY(nest[u"seconds"].toDouble() > 0.0);

    nest::Problem problem;
    problem.stripHeight = 50.5;
    problem.pieces.resize(3);
    problem.pieces[0].outline.outer = {{0, 0}, {25, 0}, {0, 25}};
    problem.pieces[0].demand = 6;
    problem.pieces[1].outline = {{{0, 0}, {50, 0}, {50, 50}, {0, 50}},
                                 {{{10, 10}, {10, 40}, {40, 40}, {40, 10}}}};
    problem.pieces[2].outline.outer = {{0, 0}, {28, 0}, {28, 28}, {0, 28}};
    for (nest::Piece &piece : problem.pieces)
        piece.turnsFreely = true; // what turns are allowed is looked at below
    nest::Solution solution;
    solution.length = nest[u"length"].toDouble();
    for (const QJsonValue &item : nest[u"items"].toArray()) {
        const qint64 id = item[u"id"].toInteger();
        const double rotation = item[u"rotation"].toDouble();
        QVERIFY(id == 4 || id == 7 || id == 9);
        QVERIFY(id != 4 || rotation == 0.0 || rotation == 180.0);
        solution.places.push_back({id == 4 ? 0 : (id == 7 ? 1 : 2),
                                   0,
                                   turnOf(rotation),
                                   {item[u"at"][0].toDouble(), item[u"at"][1].toDouble()}});
    }
    QCOMPARE(whatIsWrong(problem, solution), QString());
    const double area = 6 * 312.5 + 2500.0 - 900.0 + 784.0;
    QVERIFY(std::abs(nest[u"density"].toDouble() - area / (50.5 * solution.length)) < 1e-6);
    // The square lies in the hole, four triangles in pairs above each other.
    QVERIFY2(solution.length < 101.0, qPrintable(QString::number(solution.length)));
}

void TestCliNest::sameSeedSameBytes()
{
    const QString file = put(u"made.json"_s, kInstance);
    const QStringList words{u"nest"_s, file, u"--json"_s, u"--seconds"_s, u"0.1"_s, u"--seed"_s};
    const QByteArray once = run(words + QStringList{u"3"_s}).out;
    QVERIFY(!once.isEmpty());
    QCOMPARE(run(words + QStringList{u"3"_s}).out, once);
}

void TestCliNest::aModel()
{
    const Run told = run({u"nest"_s, m_sample, u"--json"_s, u"--seconds"_s, u"0.2"_s, u"--seed"_s,
                          u"5"_s, u"--rotations"_s, u"90"_s});
    QCOMPARE(told.status, 0);
    const QJsonObject nest = QJsonDocument::fromJson(told.out).object();
    QCOMPARE(nest[u"seed"].toInteger(), 5);
    QVERIFY(nest[u"tooLarge"].toArray().isEmpty());
    const QJsonObject listed =
        QJsonDocument::fromJson(run({u"parts"_s, m_sample, u"--json"_s}).out).object();
    QSet<qint64> numbers;
    const QJsonArray sheets = nest[u"sheets"].toArray();
    QVERIFY(!sheets.isEmpty());
    for (const QJsonValue &sheet : sheets) {
        QCOMPARE(sheet[u"size"].toArray().size(), 2);
        QVERIFY(!sheet[u"stock"].toString().isEmpty());
        QVERIFY(sheet[u"fill"].toDouble() > 0.0 && sheet[u"fill"].toDouble() < 1.0);
        for (const QJsonValue &part : sheet[u"parts"].toArray()) {
            QVERIFY(!numbers.contains(part[u"number"].toInteger()));
            numbers.insert(part[u"number"].toInteger());
            QCOMPARE(std::fmod(part[u"rotation"].toDouble(), 90.0), 0.0);
            QCOMPARE(part[u"at"].toArray().size(), 2);
        }
    }
    QCOMPARE(numbers.size(), listed[u"parts"].toArray().size());
}

void TestCliNest::tooLargeOnesAreNamed()
{
    const Run told =
        run({u"nest"_s, m_sample, u"--json"_s, u"--seconds"_s, u"0"_s, u"--sheet"_s, u"60x40"_s});
    QCOMPARE(told.status, 0);
    const QJsonArray names = QJsonDocument::fromJson(told.out).object()[u"tooLarge"].toArray();
    QVERIFY(!names.isEmpty());
    QVERIFY(told.err.contains(names[0].toString().toUtf8() + ": a part is too large"));
}

/// A file was written all the same, its parts over the edge, and all was well.
void TestCliNest::sheetsWithoutRoom()
{
    const QString svg = m_folder.filePath(u"out.svg"_s);
    const QStringList small{m_sample, u"--sheet"_s, u"9x9"_s};
    for (const QStringList &words :
         {QStringList{u"export"_s, u"-o"_s, svg}, QStringList{u"nest"_s, u"--json"_s}}) {
        const Run told = run(words + small);
        QCOMPARE(told.status, 2);
        QVERIFY(told.out.isEmpty());
        QVERIFY2(told.err.endsWith("have no room within margins of 5 mm.\n"), told.err.constData());
    }
    QVERIFY(!QFile::exists(svg));
}

void TestCliNest::sheetsThatAreMissing()
{
    const Run told = run(
        {u"nest"_s, m_sample, u"--json"_s, u"--seconds"_s, u"0"_s, u"--sheet"_s, u"250x200:1"_s});
    QCOMPARE(told.status, 0);
    const QJsonArray sheets = QJsonDocument::fromJson(told.out).object()[u"sheets"].toArray();
    QVERIFY(sheets.size() > 1);
    for (qsizetype i = 0; i < sheets.size(); ++i)
        QCOMPARE(sheets[i][u"missing"].toBool(), i > 0);
    QVERIFY(told.err.contains("that are missing: " + QByteArray::number(sheets.size() - 1)));
}

void TestCliNest::text()
{
    const Run strip = run({u"nest"_s, put(u"made.json"_s, kInstance), u"--seconds"_s, u"0"_s});
    QVERIFY(strip.out.startsWith("Length: "));
    const Run model = run({u"nest"_s, m_sample, u"--seconds"_s, u"0"_s});
    QVERIFY(model.out.startsWith("Parts: "));
    QVERIFY(model.out.contains("% covered"));
}

void TestCliNest::wrongUse_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("no file") << QStringList{};
    QTest::newRow("a turning that is none") << QStringList{u"a.json"_s, u"--rotations"_s, u"45"_s};
    QTest::newRow("negative seconds") << QStringList{u"a.json"_s, u"--seconds"_s, u"-1"_s};
    QTest::newRow("days") << QStringList{u"a.json"_s, u"--seconds"_s, u"86400"_s};
    QTest::newRow("a negative seed") << QStringList{u"a.json"_s, u"--seed"_s, u"-1"_s};
    QTest::newRow("a spacing in words") << QStringList{u"a.json"_s, u"--spacing"_s, u"wide"_s};
    QTest::newRow("a negative margin") << QStringList{u"a.json"_s, u"--margin"_s, u"-2"_s};
}

void TestCliNest::wrongUse()
{
    QFETCH(const QStringList, arguments);
    const Run told = run(QStringList{u"nest"_s} + arguments);
    QCOMPARE(told.status, 1);
    QVERIFY(told.err.contains("flatfitfab-cli nest FILE"));
}

void TestCliNest::badInstances_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QByteArray>("place");
    const QByteArray good = kInstance;
    QTest::newRow("nothing") << QByteArray() << QByteArray("");
    QTest::newRow("a list") << QByteArray("[]") << QByteArray("$");
    QTest::newRow("no height") << QByteArray(R"({"items": []})") << QByteArray("$.strip_height");
    QTest::newRow("no items") << QByteArray(R"({"strip_height": 4})") << QByteArray("$.items");
    QTest::newRow("another shape")
        << QByteArray(good).replace("\"polygon\"", "\"circle\"") << QByteArray("items[1]");
    QTest::newRow("two points") << QByteArray(good).replace("[28, 0], [28, 28], [0, 28]", "[28, 0]")
                                << QByteArray("items[2]");
    QTest::newRow("a demand below nothing")
        << QByteArray(good).replace("\"demand\": 6", "\"demand\": -6") << QByteArray("items[0]");
    QTest::newRow("too large for the strip")
        << QByteArray(good).replace("50.5", "30.5") << QByteArray("items[1]");
}

void TestCliNest::badInstances()
{
    QFETCH(const QByteArray, bytes);
    QFETCH(const QByteArray, place);
    const Run told = run({u"nest"_s, put(u"bad.json"_s, bytes), u"--seconds"_s, u"0"_s});
    QCOMPARE(told.status, 2);
    QVERIFY2(told.err.contains(place) && told.err.contains("bad.json"), told.err.constData());
    QCOMPARE(told.err.count('\n'), 1);
}

FFF_TEST(TestCliNest)
#include "tst_cli_nest.moc"
