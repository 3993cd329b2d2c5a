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
    void replayDrawsAndUndoes();
    void checkSaysWhatIsWrong_data();
    void checkSaysWhatIsWrong();
    void checkListsWhatTheReaderMended();
    void infoTellsHowItStands();
    void namesDoNothingToATerminal();
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
