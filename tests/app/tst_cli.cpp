// Runs the real program as a person or a script would.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "core/model/operation_edits.h"
#include "core/operations/operation_kind.h"
#include "tests/app/cli_run.h"
#include "tests/core/assembly/known_models.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include <cmath>

using namespace fff;
using namespace fff::test;

namespace {

QJsonObject object(const QByteArray &json)
{
    return QJsonDocument::fromJson(json).object();
}

/// d attributes of all paths that carry the cutting colour.
QStringList cutPaths(const QString &file, QString *viewBox = nullptr, QString *width = nullptr)
{
    QFile svg(file);
    QStringList paths;
    if (!svg.open(QIODevice::ReadOnly))
        return paths;
    QXmlStreamReader xml(&svg);
    QStringList strokes; // inherited
    while (!xml.atEnd()) {
        const auto token = xml.readNext();
        if (token == QXmlStreamReader::StartElement) {
            const auto attributes = xml.attributes();
            strokes.push_back(attributes.hasAttribute(QLatin1String("stroke"))
                                  ? attributes.value(QLatin1String("stroke")).toString()
                                  : strokes.value(strokes.size() - 1));
            if (xml.name() == QLatin1String("svg") && viewBox) {
                *viewBox = attributes.value(QLatin1String("viewBox")).toString();
                *width = attributes.value(QLatin1String("width")).toString();
            }
            if (xml.name() == QLatin1String("path") && strokes.last() == QLatin1String("#ff0000"))
                paths += attributes.value(QLatin1String("d")).toString();
        } else if (token == QXmlStreamReader::EndElement) {
            strokes.pop_back();
        }
    }
    return xml.hasError() ? QStringList() : paths;
}

/// Narrower than two slits, which reach into it from both ends and beyond its middle.
Document withAStripOfSlits()
{
    Document document = withSection(newDocument(), polygonShape(rectangle(-1, 10, 1, 40)), side(0));
    for (const double way : {-1.0, 1.0}) {
        document = withSection(std::move(document), polygonShape(rectangle(-30, 5, 30, 45)),
                               front(0.1 * way));
        JointOverride wanted;
        wanted.a = document.sections.front()->ref();
        wanted.b = document.sections.back()->ref();
        wanted.opens = Vec2(0, way);
        wanted.shares = {{{0.1 * way, 25}, 0.6}};
        document = setJointOverride(std::move(document), wanted).value();
    }
    return document;
}

} // namespace

class TestCli : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void wrongUse_data();
    void wrongUse();
    void badInput_data();
    void badInput();
    void helpAndVersion();
    void infoTellsTheModel();
    void partsAreCutAndClosed();
    void partsComeInTheirOrder();
    void exportIsTrueToSize();
    void kerfThatClosesSlitsIsRefused();
    void jointsWithoutANumberAreSaid();
    void exportKeepsTheOldFileWhenItCannotWrite();
    void nativeExportReadsBackEqual();
    void optionsOverrideTheDocument();
    void replayDrawsAndUndoes();
    void checkSaysWhatIsWrong_data();
    void checkSaysWhatIsWrong();
    void checkListsWhatTheReaderMended();
    void infoTellsHowItStands();
    void sheetsAsFiles();
    void whatCannotBeMadeIsSaid();
    void namesDoNothingToATerminal();
    void solidsAreExported();
    void renderNeedsADisplayAndSaysSo();
    void onlyRenderNeedsADisplay();

private:
    QString path(const char *name) const { return m_folder->filePath(QLatin1String(name)); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestCli::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    const Model pair =
        twoSections(polygonShape(rectangle(-50, 0, 50, 50), {rectangle(-40, 10, -20, 30)}), front(),
                    polygonShape(rectangle(-50, 20, 50, 90)), side());
    QVERIFY(io::writeDocument(path("pair.fff"), pair.document));
}

void TestCli::wrongUse_data()
{
    QTest::addColumn<QStringList>("arguments");
    const auto row = [](const char *name, const char *arguments) {
        QTest::newRow(name) << QString::fromLatin1(arguments).split(u' ', Qt::SkipEmptyParts);
    };
    row("no verb", "");
    row("unknown verb", "carve x.fff");
    row("no file", "info");
    row("two files", "info a.fff b.fff");
    row("a margin that is no length", "export a.fff -o x.svg --margin wide");
    row("a spacing below nothing", "export a.fff -o x.svg --spacing -1");
    row("sheets in no known way", "export a.fff -o x.svg --sheets books");
    row("a picture that is none", "render a.fff -o x.jpg");
    row("a picture without pixels", "render a.fff -o x.png --size 0x10");
    row("a picture larger than any driver paints", "render a.fff -o x.png --size 90000x10");
    row("a view from nowhere", "render a.fff -o x.png --view above");
    row("a show of what is not there", "render a.fff -o x.png --show ghosts");
    row("unknown option", "info a.fff --colour red");
    row("option without its value", "info a.fff --thickness");
    row("export without output", "export a.fff");
    row("export to a kind that is not written", "export a.fff -o a.doc");
    row("thickness of zero", "info a.fff --thickness 0");
    row("thickness in words", "info a.fff --thickness thin");
    row("sheet of one number", "info a.fff --sheet 600");
    row("tolerance of zero", "parts a.fff --tolerance 0");
    row("a thickness that no number holds", "info a.fff --thickness 1e300");
    row("a sheet of two kilometres", "export a.fff -o - --format svg --sheet 2000000x400");
    row("a clearance that leaves no slit", "info a.fff --clearance -3");
    row("standard output of an unknown kind", "export a.fff -o -");
    row("an unknown stock", "info a.fff --stock cheese");
    row("a bad option with a bad file", "info absent.fff --thickness thin");
}

// Scripts rely on the status, people on the usage line.
void TestCli::wrongUse()
{
    QFETCH(QStringList, arguments);
    for (QString &argument : arguments)
        if (argument == QStringLiteral("a.fff"))
            argument = path("pair.fff");
    const Run result = run(arguments);
    QCOMPARE(result.status, 1);
    QVERIFY(result.out.isEmpty());
    QVERIFY(result.err.contains("flatfitfab-cli"));
}

void TestCli::badInput_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("a shopping list") << QByteArray("eggs\nflour\n");
    QTest::newRow("half a model") << QByteArray("HeaderParameters 1\nFlatFab 3\nP 0 0 0\n");
    QTest::newRow("broken JSON") << QByteArray("{\"format\": \"FlatFitFab\", \"version\": 1,");
    QTest::newRow("a newer version") << QByteArray("{\"format\": \"FlatFitFab\", \"version\": 99}");
}

void TestCli::badInput()
{
    QFETCH(QByteArray, content);
    QFile file(path("bad.txt"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(content);
    file.close();
    const Run result = run({QStringLiteral("info"), file.fileName()});
    QCOMPARE(result.status, 2);
    QCOMPARE(result.err.trimmed().count('\n'), 0); // one line
    QVERIFY(result.err.contains("bad.txt"));
    QCOMPARE(run({QStringLiteral("info"), path("absent.fff")}).status, 2);
    QCOMPARE(run({QStringLiteral("info"), m_folder->path()}).status, 2);
}

void TestCli::helpAndVersion()
{
    QCOMPARE(run({QStringLiteral("--help")}).status, 0);
    QVERIFY(run({QStringLiteral("--version")}).out.startsWith("FlatFitFab "));
    for (const char *verb : {"info", "parts", "export", "replay"}) {
        const Run help = run({QLatin1String(verb), QStringLiteral("--help")});
        QCOMPARE(help.status, 0);
        QVERIFY(help.out.contains("--thickness"));
    }
}

void TestCli::infoTellsTheModel()
{
    const Run result = run({QStringLiteral("info"), path("pair.fff"), QStringLiteral("--json")});
    QCOMPARE(result.status, 0);
    const QJsonObject info = object(result.out);
    QCOMPARE(info[QLatin1String("format")].toString(), QStringLiteral("fff"));
    QCOMPARE(info[QLatin1String("sections")].toInt(), 2);
    QCOMPARE(info[QLatin1String("holes")].toInt(), 1);
    QCOMPARE(info[QLatin1String("joints")].toInt(), 1);
    QCOMPARE(info[QLatin1String("overlaps")].toInt(), 1);
    QCOMPARE(info[QLatin1String("slits")].toInt(), 2);
    QCOMPARE(info[QLatin1String("components")].toInt(), 1);
    QVERIFY(info[QLatin1String("unconnected")].toArray().isEmpty());
    // Areas without the slits: 100·50 − 20·20 − 3·15 and 100·70 − 3·15 mm², 3 mm thick, 660 kg/m³.
    const double expected = (5000 - 400 - 45 + 7000 - 45) * 3e-9 * 660;
    QVERIFY(std::abs(info[QLatin1String("mass")].toDouble() - expected) < 1e-9);
    const QJsonObject joint = info[QLatin1String("jointList")].toArray().at(0).toObject();
    QCOMPARE(joint[QLatin1String("kind")].toString(), QStringLiteral("crossLap"));
    QCOMPARE(joint[QLatin1String("angle")].toDouble(), 90.0);
    QCOMPARE(info[QLatin1String("bounds")].toArray().at(1).toArray().at(1).toDouble(), 90.0);
    // Without a display, for people.
    QVERIFY(run({QStringLiteral("info"), path("pair.fff")}).out.contains("Joints: 1"));
}

void TestCli::partsAreCutAndClosed()
{
    const Run result = run({QStringLiteral("parts"), path("pair.fff"), QStringLiteral("--json")});
    QCOMPARE(result.status, 0);
    const QJsonArray parts = object(result.out)[QLatin1String("parts")].toArray();
    QCOMPARE(parts.size(), 2);
    const auto areaOf = [](const QJsonArray &ring) {
        double sum = 0.0;
        for (int i = 0; i < ring.size(); ++i) {
            const QJsonArray a = ring[i].toArray(), b = ring[(i + 1) % ring.size()].toArray();
            sum += 0.5 * (a[0].toDouble() * b[1].toDouble() - a[1].toDouble() * b[0].toDouble());
        }
        return sum;
    };
    const QJsonObject first = parts[0].toObject();
    QVERIFY(std::abs(areaOf(first[QLatin1String("outer")].toArray()) - (5000.0 - 45.0)) < 1e-6);
    QVERIFY(std::abs(areaOf(first[QLatin1String("holes")].toArray().at(0).toArray()) + 400.0) <
            1e-6);
    QVERIFY(std::abs(areaOf(parts[1].toObject()[QLatin1String("outer")].toArray()) -
                     (7000.0 - 45.0)) < 1e-6);
}

// An order that leaves a part out, or moves one into place from nowhere, is no order.
void TestCli::partsComeInTheirOrder()
{
    const Run result = run({QStringLiteral("parts"), path("pair.fff"), QStringLiteral("--json")});
    QCOMPARE(result.status, 0);
    const QJsonArray steps = object(result.out)[QLatin1String("assembly")].toArray();
    QCOMPARE(steps.size(), 2);
    QCOMPARE(steps[0][QLatin1String("parts")].toArray(), QJsonArray{1});
    QCOMPARE(steps[0][QLatin1String("distance")].toDouble(), 0.0);
    QCOMPARE(steps[1][QLatin1String("parts")].toArray(), QJsonArray{2});
    QVERIFY(steps[1][QLatin1String("distance")].toDouble() > 0.0);
    const QJsonObject info =
        object(run({QStringLiteral("info"), path("pair.fff"), QStringLiteral("--json")}).out);
    QCOMPARE(info[QLatin1String("assemblable")], QJsonValue(true));
    QCOMPARE(info[QLatin1String("assemblyOrder")].toArray().size(), 2);
    QVERIFY(info[QLatin1String("blocked")].toArray().isEmpty());
}

// A file that comes out at another scale is a sheet wasted.
void TestCli::exportIsTrueToSize()
{
    const Run result = run({QStringLiteral("export"), path("pair.fff"), QStringLiteral("-o"),
                            path("pair.svg"), QStringLiteral("--kerf"), QStringLiteral("0")});
    QCOMPARE(result.status, 0);
    QString viewBox, width;
    const QStringList paths = cutPaths(path("pair.svg"), &viewBox, &width);
    QVERIFY(!paths.isEmpty());
    for (const QString &d : paths)
        QVERIFY(d.trimmed().endsWith(u'Z'));
    QCOMPARE(viewBox.split(u' ').value(2) + QStringLiteral("mm"), width);
}

// Parts whose slits the kerf swallows fit nowhere; saying nothing wastes the sheet.
void TestCli::kerfThatClosesSlitsIsRefused()
{
    const Run result = run({QStringLiteral("export"), path("pair.fff"), QStringLiteral("-o"),
                            path("thin.svg"), QStringLiteral("--kerf"), QStringLiteral("3")});
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains("Section 1"), result.err);
    QVERIFY(!QFile::exists(path("thin.svg")));
}

// Who looks for a joint's number that is not there thinks that the part is the wrong one.
void TestCli::jointsWithoutANumberAreSaid()
{
    Document document = withSection(newDocument(), polygonShape(rectangle(0, 0, 7, 3.5)), front());
    document =
        withSection(std::move(document), polygonShape(rectangle(-3.5, 0, 3.5, 3.5)), side(3.5));
    QVERIFY(io::writeDocument(path("tiny.fff"), document));
    const Run result =
        run({QStringLiteral("export"), path("tiny.fff"), QStringLiteral("-o"), path("tiny.svg")});
    QCOMPARE(result.status, 0);
    QVERIFY2(result.err.contains("No room for the numbers of all joints: Section 1, Section 2"),
             result.err);
}

void TestCli::exportKeepsTheOldFileWhenItCannotWrite()
{
    const QString target = m_folder->filePath(QStringLiteral("no/such/folder.svg"));
    const Run result =
        run({QStringLiteral("export"), path("pair.fff"), QStringLiteral("-o"), target});
    QCOMPARE(result.status, 4);
    QVERIFY(!QFile::exists(target));
    // Bad input must not touch an output that is there.
    QFile old(path("old.svg"));
    QVERIFY(old.open(QIODevice::WriteOnly));
    old.write("old");
    old.close();
    QCOMPARE(
        run({QStringLiteral("export"), path("absent.fff"), QStringLiteral("-o"), path("old.svg")})
            .status,
        2);
    QVERIFY(old.open(QIODevice::ReadOnly));
    QCOMPARE(old.readAll(), QByteArray("old"));
}

void TestCli::nativeExportReadsBackEqual()
{
    QCOMPARE(
        run({QStringLiteral("export"), path("pair.fff"), QStringLiteral("-o"), path("copy.fff")})
            .status,
        0);
    const auto before = io::readDocument(path("pair.fff")),
               after = io::readDocument(path("copy.fff"));
    QVERIFY(before && after);
    QVERIFY(before->document == after->document);
    const Run standard =
        run({QStringLiteral("export"), path("pair.fff"), QStringLiteral("-o"), QStringLiteral("-"),
             QStringLiteral("--format"), QStringLiteral("fff")});
    QFile copy(path("copy.fff"));
    QVERIFY(copy.open(QIODevice::ReadOnly));
    QCOMPARE(standard.out, copy.readAll());
}

void TestCli::optionsOverrideTheDocument()
{
    const auto widthOf = [&](const QStringList &options) {
        const Run result =
            run(QStringList{QStringLiteral("info"), path("pair.fff"), QStringLiteral("--json")} +
                options);
        return object(result.out)[QLatin1String("sectionList")]
            .toArray()
            .at(0)
            .toObject()[QLatin1String("slits")]
            .toArray()
            .at(0)
            .toObject()[QLatin1String("width")]
            .toDouble();
    };
    QCOMPARE(widthOf({}), 3.0);
    QCOMPARE(widthOf({QStringLiteral("--thickness"), QStringLiteral("6")}), 6.0);
    QCOMPARE(widthOf({QStringLiteral("--clearance"), QStringLiteral("-0.1")}), 2.9);
    QCOMPARE(widthOf({QStringLiteral("--stock"), QStringLiteral("acrylic")}), 3.175);
}

void TestCli::replayDrawsAndUndoes()
{
    const QString script = QStringLiteral(FFF_TEST_DATA "/strokes/first_section.json");
    QVERIFY(QFile::exists(script));
    QCOMPARE(
        run({QStringLiteral("replay"), script, QStringLiteral("-o"), path("drawn.fff")}).status, 0);
    const auto drawn = io::readDocument(path("drawn.fff"));
    QVERIFY(drawn);
    QCOMPARE(drawn->document.sections.size(), std::size_t(1));

    QFile bad(path("bad.json"));
    QVERIFY(bad.open(QIODevice::WriteOnly));
    bad.write(
        R"({"viewport": [1280, 800], "events": [{"type": "view", "name": "front"}, {"type": "dance"}]})");
    bad.close();
    const Run refused =
        run({QStringLiteral("replay"), bad.fileName(), QStringLiteral("-o"), path("drawn.fff")});
    QCOMPARE(refused.status, 2);
    QVERIFY(refused.err.contains("events[1]"));
}

void TestCli::checkSaysWhatIsWrong_data()
{
    QTest::addColumn<double>("height");
    QTest::addColumn<QString>("options");
    QTest::addColumn<int>("status");
    QTest::addColumn<QStringList>("codes");
    QTest::newRow("two plates on the ground") << 0.0 << QStringLiteral("") << 0 << QStringList();
    QTest::newRow("in the air") << 12.0 << QStringLiteral("") << 3
                                << QStringList{QStringLiteral("noContact")};
    QTest::newRow("in the ground")
        << -12.0 << QStringLiteral("") << 3 << QStringList{QStringLiteral("belowGround")};
    QTest::newRow("on small sheets")
        << 0.0 << QStringLiteral("--sheet 90x60") << 3
        << QStringList{QStringLiteral("tooLarge"), QStringLiteral("tooLarge")};
    QTest::newRow("two at once") << 12.0 << QStringLiteral("--sheet 90x60") << 3
                                 << QStringList{QStringLiteral("noContact"),
                                                QStringLiteral("tooLarge"),
                                                QStringLiteral("tooLarge")};
}

// A script that asks before cutting must get 3 for what cannot be built, and 0 for what can.
void TestCli::checkSaysWhatIsWrong()
{
    QFETCH(double, height);
    QFETCH(QString, options);
    QFETCH(int, status);
    QFETCH(QStringList, codes);
    const auto plate = [&] { return polygonShape(rectangle(-50, height, 50, height + 60)); };
    QVERIFY(
        io::writeDocument(path("m.fff"), twoSections(plate(), front(), plate(), side()).document));
    const QStringList arguments = QStringList{QStringLiteral("check"), path("m.fff")} +
                                  options.split(u' ', Qt::SkipEmptyParts);
    const Run asText = run(arguments),
              asJson = run(arguments + QStringList{QStringLiteral("--json")});
    QCOMPARE(asText.status, status);
    QCOMPARE(asJson.status, status);
    QVERIFY(asText.err.isEmpty() && asJson.err.isEmpty());
    QStringList found;
    QVERIFY(object(asJson.out).contains(QStringLiteral("problems")));
    for (const QJsonValue &value : object(asJson.out)[QStringLiteral("problems")].toArray()) {
        const QJsonObject problem = value.toObject();
        found += problem[QStringLiteral("code")].toString();
        QCOMPARE(problem[QStringLiteral("severity")].toString(), QStringLiteral("error"));
        QCOMPARE(problem[QStringLiteral("at")].toArray().size(), 3);
        QVERIFY(problem[QStringLiteral("sections")].isArray());
        QVERIFY(asText.out.contains(problem[QStringLiteral("text")].toString().toUtf8()));
    }
    QCOMPARE(found, codes);
}

// What the reader left out is gone from the model: only here does a script hear of it.
void TestCli::checkListsWhatTheReaderMended()
{
    const QString ant = QStringLiteral(FFF_SHARED_MODELS "/ant.txt");
    if (!QFile::exists(ant))
        FFF_WITHOUT_SHARED();
    QStringList codes;
    for (const QJsonValue &value :
         object(run({QStringLiteral("check"), ant, QStringLiteral("--json")})
                    .out)[QStringLiteral("problems")]
             .toArray()) {
        if (value[QStringLiteral("code")] == QStringLiteral("selfCrossing")) {
            QCOMPARE(value[QStringLiteral("sections")].toArray(),
                     QJsonArray{QStringLiteral("Section 2")});
            QCOMPARE(value[QStringLiteral("severity")].toString(), QStringLiteral("warning"));
        }
        codes += value[QStringLiteral("code")].toString();
    }
    QVERIFY(codes.contains(QStringLiteral("selfCrossing")));
}

// A script reads here what the window's badges say.
void TestCli::infoTellsHowItStands()
{
    const auto info = [&](const char *options) {
        return object(
            run(QStringList{QStringLiteral("info"), path("m.fff"), QStringLiteral("--json")} +
                QString::fromLatin1(options).split(u' ', Qt::SkipEmptyParts))
                .out);
    };
    const ShapePointer plate = polygonShape(rectangle(-50, 0, 50, 60));
    QVERIFY(io::writeDocument(path("m.fff"), twoSections(plate, front(), plate, side()).document));
    QJsonObject found = info("--thickness 4");
    QCOMPARE(found[QLatin1String("contacts")].toInt(),
             3); // one slit opens downwards and parts its edge
    QVERIFY(found[QLatin1String("stable")].toBool());
    QCOMPARE(found[QLatin1String("supportPolygon")].toArray().size(), 8);
    // From the middle to the line between the corners of two feet, (50, 2) and (2, 50).
    QVERIFY(std::abs(found[QLatin1String("stabilityMargin")].toDouble() - 52.0 / std::sqrt(2.0)) <
            1e-6);
    QVERIFY(found[QLatin1String("tipAngle")].toDouble() > 45.0);

    const ShapePointer high = polygonShape(rectangle(-50, 10, 50, 60));
    QVERIFY(io::writeDocument(path("m.fff"), twoSections(high, front(), high, side()).document));
    found = info("");
    QCOMPARE(found[QLatin1String("contacts")].toInt(), 0);
    QVERIFY(!found[QLatin1String("stable")].toBool() &&
            found[QLatin1String("stabilityMargin")].isNull());
    QVERIFY(found[QLatin1String("supportPolygon")].toArray().isEmpty());
}

void TestCli::sheetsAsFiles()
{
    const QStringList common{QStringLiteral("export"),   path("pair.fff"),
                             QStringLiteral("--sheet"),  QStringLiteral("112x100"),
                             QStringLiteral("--sheets"), QStringLiteral("files"),
                             QStringLiteral("-o")};
    const Run written = run(common + QStringList{path("cut.svg")});
    QCOMPARE(written.status, 0);
    QVERIFY(written.err.contains("sheets: 2"));
    QVERIFY(QFile::exists(path("cut-1.svg")) && QFile::exists(path("cut-2.svg")));
    QVERIFY(!QFile::exists(path("cut.svg")));
    QString viewBox, width;
    QCOMPARE(cutPaths(path("cut-1.svg"), &viewBox, &width).size() +
                 cutPaths(path("cut-2.svg")).size(),
             3); // two parts, one of them with a hole
    QCOMPARE(width, QStringLiteral("112mm"));

    QVERIFY(!written.err.contains("earlier"));
    // Wrong: who cuts all files that are there cuts sheets of another model.
    for (const char *name : {"cut-3.svg", "cut-12.svg", "cut-2024.svg", "cut-4.obj", "cut-x.svg"})
        QVERIFY(io::writeFile(path(name), "old"));
    const Run fewer = run(common + QStringList{path("cut.svg")});
    QCOMPARE(fewer.status, 0);
    QVERIFY2(
        fewer.err.contains("Sheets of an earlier export are still there: cut-3.svg, cut-12.svg\n"),
        fewer.err);
    QCOMPARE(*io::readFile(path("cut-3.svg")), std::string("old"));

    // A folder in the way of the second: the first keeps what it had.
    QVERIFY(QFile::remove(path("cut-2.svg")));
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("cut-2.svg")));
    QVERIFY(io::writeFile(path("cut-1.svg"), "old"));
    QCOMPARE(run(common + QStringList{path("cut.svg")}).status, 4);
    QCOMPARE(*io::readFile(path("cut-1.svg")), std::string("old"));

    QCOMPARE(run(common + QStringList{QStringLiteral("-"), QStringLiteral("--format"),
                                      QStringLiteral("svg")})
                 .status,
             1);
}

void TestCli::whatCannotBeMadeIsSaid()
{
    const auto exported = [&](const Document &document) {
        QFile::remove(path("out.svg"));
        if (!io::writeDocument(path("some.fff"), document))
            return Run();
        return run({QStringLiteral("export"), path("some.fff"), QStringLiteral("-o"),
                    path("out.svg"), QStringLiteral("--kerf"), QStringLiteral("0")});
    };
    const Run some = exported(withAStripOfSlits());
    QCOMPARE(some.status, 0);
    QVERIFY2(some.err.contains("Cut away completely by slits, so there is no part: Section 1\n"),
             some.err);
    QVERIFY(QFile::exists(path("out.svg")));

    const Run locked = exported(triangle());
    QCOMPARE(locked.status, 0);
    QVERIFY2(locked.err.contains("\nSections block each other. "), locked.err);
    QVERIFY(QFile::exists(path("out.svg")));

    const Run plain =
        exported(withSection(newDocument(), polygonShape(rectangle(-30, 0, 30, 60)), front()));
    QCOMPARE(plain.status, 0);
    QCOMPARE(plain.err.count('\n'), 1);
}

// Wrong: a model from somebody else clears the screen, or makes up lines that we never wrote.
void TestCli::namesDoNothingToATerminal()
{
    const std::string evil = std::string("a\nb\x1b[2Jc\0d\x7f\xc2\x9b", 13);
    Document document = newDocument();
    Stock stock = *document.stocks.front();
    stock.name = evil;
    document = setStock(document, stock).value();
    document = withSection(std::move(document), polygonShape(rectangle(-30, 0, 30, 60)), front());
    document = *renameSection(document, document.sections.front()->id, evil);
    Operation operation = newOperation(*operationKind("linear"));
    operation.name = evil;
    document = addOperation(document, operation);
    QVERIFY(io::writeDocument(path("evil.fff"), document));
    const QByteArray shown = "a␊b␛[2Jc␀d␡�";
    for (const QStringList &verb :
         {QStringList{QStringLiteral("info")}, QStringList{QStringLiteral("parts")},
          QStringList{QStringLiteral("check"), QStringLiteral("--sheet"), QStringLiteral("9x9")},
          QStringList{QStringLiteral("operations")},
          QStringList{QStringLiteral("export"), QStringLiteral("--sheet"), QStringLiteral("9x9"),
                      QStringLiteral("-o"), path("out.svg")}}) {
        const Run result = run(verb + QStringList{path("evil.fff")});
        const QByteArray all = result.out + result.err;
        QVERIFY2(all.contains(shown), verb.front().toUtf8() + ": " + all);
        for (const char c : all)
            QVERIFY2(c == '\n' || (c != 0x7F && static_cast<unsigned char>(c) >= 0x20), all);
    }
    const Run json = run({QStringLiteral("parts"), path("evil.fff"), QStringLiteral("--json")});
    const QJsonObject part =
        QJsonDocument::fromJson(json.out)[QLatin1String("parts")][0].toObject();
    QCOMPARE(part[QLatin1String("section")].toString(), QString::fromStdString(evil));
}

void TestCli::solidsAreExported()
{
    QCOMPARE(
        run({QStringLiteral("export"), path("pair.fff"), QStringLiteral("-o"), path("out.obj")})
            .status,
        0);
    const QByteArray obj = QByteArray::fromStdString(*io::readFile(path("out.obj")));
    QCOMPARE(obj.count("\no "), 2);
    QVERIFY(obj.contains("\nf "));
    QVERIFY(io::writeDocument(path("empty.fff"), newDocument()));
    QCOMPARE(
        run({QStringLiteral("export"), path("empty.fff"), QStringLiteral("-o"), path("no.obj")})
            .status,
        2);
    QVERIFY(!QFile::exists(path("no.obj")));
}

// Qt ends a program without words when it finds no display.
void TestCli::renderNeedsADisplayAndSaysSo()
{
#ifndef FFF_PROGRAM
    QSKIP("the verb comes with the window, which this build leaves out");
#endif
    const Run run1 = run(
        {QStringLiteral("render"), path("pair.fff"), QStringLiteral("-o"), path("out.png")}, false);
    QCOMPARE(run1.status, 4);
    QCOMPARE(run1.err.count('\n'), 1);
    QVERIFY(run1.err.contains("display"));
    QVERIFY(!QFile::exists(path("out.png")));
}

void TestCli::onlyRenderNeedsADisplay()
{
    QList<QStringList> all{
        {QStringLiteral("info"), path("pair.fff")},
        {QStringLiteral("check"), path("pair.fff")},
        {QStringLiteral("parts"), path("pair.fff")},
        {QStringLiteral("export"), path("pair.fff"), QStringLiteral("-o"), path("out.svg")},
        {QStringLiteral("--help")}};
#ifdef FFF_PROGRAM // with the window
    all.append({QStringLiteral("render"), QStringLiteral("--help")});
#endif
    constexpr int kProblemsFound = 3; // of what falls at a touch
    for (const QStringList &arguments : all)
        QCOMPARE(run(arguments, false).status,
                 arguments.front() == QLatin1String("check") ? kProblemsFound : 0);
}

FFF_TEST(TestCli)
#include "tst_cli.moc"
