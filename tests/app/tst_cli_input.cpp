// What is handed to the programs that is no good. If this fails, somebody waits for ever, looks for
// a mistake in the wrong place, or reads a number that means another one in their country.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "core/model/edits.h"
#include "tests/app/cli_run.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

using namespace fff;
using namespace fff::test;

namespace {

const QString kInput = QStringLiteral("INPUT");

/// Every verb and option that reads a file, which is where INPUT stands.
const QList<QStringList> &readers()
{
    const auto words = [](const char *text) {
        return QString::fromLatin1(text).split(u' ', Qt::SkipEmptyParts);
    };
    static const QList<QStringList> all{words("info INPUT"),
                                        words("info INPUT --json"),
                                        words("check INPUT"),
                                        words("parts INPUT --json"),
                                        words("export INPUT -o - --format svg"),
                                        words("operations INPUT"),
                                        words("replay INPUT -o - --format fff"),
                                        words("replay SCRIPT --from INPUT -o - --format fff")};
    return all;
}

} // namespace

class TestCliInput : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void stocksOutOfRangeAreBadInput_data();
    void stocksOutOfRangeAreBadInput();
    void anOptionThatWasGivenIsNamed();
    void aPipeWithoutAWriterIsGivenUp_data();
    void aPipeWithoutAWriterIsGivenUp();
    void endlessFilesEnd();
    void whatWasStraightenedIsOneSentence();
    void anEmptyNameIsOneLine_data();
    void anEmptyNameIsOneLine();
    void anEmptyOutputIsOneLine();
    void replayNamesTheDrawingAndItsLine_data();
    void replayNamesTheDrawingAndItsLine();
    void helpNeedsNoDisplay_data();
    void helpNeedsNoDisplay();
    void anotherCountryChangesNothing_data();
    void anotherCountryChangesNothing();

private:
    QString path(const char *name) const { return m_folder->filePath(QLatin1String(name)); }
    QString written(const char *name, const QByteArray &bytes) const
    {
        QFile file(path(name));
        return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size()
                   ? file.fileName()
                   : QString();
    }
    QStringList with(QStringList arguments, const QString &input) const
    {
        arguments.replaceInStrings(QStringLiteral("SCRIPT"), path("script.json"));
        for (QString &argument : arguments)
            argument = argument == kInput ? input : argument;
        return arguments;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestCliInput::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    const Model pair =
        twoSections(polygonShape(rectangle(-50, 0, 50, 50), {rectangle(-40, 10, -20, 30)}), front(),
                    polygonShape(rectangle(-50, 20, 50, 90)), side());
    QVERIFY(io::writeDocument(path("pair.fff"), pair.document));
    written("script.json", "{\"viewport\": [100, 100], \"events\": []}");
}

void TestCliInput::stocksOutOfRangeAreBadInput_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QByteArray>("value");
    for (const char *key : {"thickness", "density", "kerf", "clearance", "modulus",
                            "tensileStrength", "flexuralStrength"})
        for (const char *value : {"1e9", "1e308", "-5e8"})
            QTest::addRow("%s of %s", key, value) << QString::fromLatin1(key) << QByteArray(value);
}

// Wrong: the person would look for an option that they never gave.
void TestCliInput::stocksOutOfRangeAreBadInput()
{
    QFETCH(QString, key);
    QFETCH(QByteArray, value);
    QFile file(path("pair.fff"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QString text = QString::fromUtf8(file.readAll());
    text.replace(QRegularExpression(QStringLiteral("\"%1\": [^,]*").arg(key)),
                 QStringLiteral("\"%1\": %2").arg(key, QString::fromLatin1(value)));
    const QString bad = written("bad.fff", text.toUtf8());
    for (const char *verb : {"info", "check", "parts"}) {
        const Run result = run({QLatin1String(verb), bad});
        QCOMPARE(result.status, 2);
        const QByteArray place = bad.toUtf8() + ":$.stocks[0]." + key.toLatin1() + ": ";
        QVERIFY2(result.err.startsWith(place), result.err);
        QVERIFY2(result.err.contains("expected"), result.err);
        QVERIFY2(!result.err.contains("--"), result.err);
        QCOMPARE(result.err.trimmed().count('\n'), 0);
    }
}

void TestCliInput::anOptionThatWasGivenIsNamed()
{
    const Result<io::LoadedDocument> loaded = io::readDocument(path("pair.fff"));
    QVERIFY(loaded);
    Stock stock = *loaded->document.stocks.front();
    stock.clearance = -1.0;
    QVERIFY(io::writeDocument(path("tight.fff"), setStock(loaded->document, stock).value()));
    const Run thin = run({QStringLiteral("info"), path("tight.fff"), QStringLiteral("--thickness"),
                          QStringLiteral("0.5")});
    QCOMPARE(thin.status, 1);
    // Wrong: the clearance stands in the file.
    QVERIFY2(thin.err.startsWith("--thickness 0.5 "), thin.err);
    QVERIFY2(!thin.err.contains("--clearance"), thin.err);
    const Run tight = run({QStringLiteral("info"), path("pair.fff"), QStringLiteral("--clearance"),
                           QStringLiteral("-9")});
    QCOMPARE(tight.status, 1);
    QVERIFY2(tight.err.startsWith("--clearance "), tight.err);
}

void TestCliInput::aPipeWithoutAWriterIsGivenUp_data()
{
    QTest::addColumn<QStringList>("arguments");
    for (const QStringList &arguments : readers())
        QTest::newRow(qPrintable(arguments.join(u' '))) << arguments;
}

// Wrong: it would wait until it is killed.
void TestCliInput::aPipeWithoutAWriterIsGivenUp()
{
#ifdef Q_OS_UNIX
    QFETCH(QStringList, arguments);
    QCOMPARE(mkfifo(QFile::encodeName(path("pipe")).constData(), 0600), 0);
    const Run result = run(with(arguments, path("pipe")));
    QCOMPARE(result.status, 2);
    QCOMPARE(result.err.trimmed().count('\n'), 0);
    QVERIFY2(result.err.startsWith(path("pipe").toUtf8()), result.err);
#endif
}

void TestCliInput::endlessFilesEnd()
{
#ifdef Q_OS_UNIX
    const QString script = written(
        "endless.json", "{\"viewport\": [100, 100], \"events\": [{\"type\": \"command\", \"name\": "
                        "\"section.importSections\", \"parameters\": {\"path\": \"/dev/zero\"}}]}");
    const Run drawing =
        run({QStringLiteral("replay"), script, QStringLiteral("-o"), QStringLiteral("-"),
             QStringLiteral("--format"), QStringLiteral("fff")});
    QCOMPARE(drawing.status, 2);
    QVERIFY2(drawing.err.contains("events[0]: zero: found "), drawing.err);
    const Run model = run({QStringLiteral("check"), QStringLiteral("/dev/zero")});
    QCOMPARE(model.status, 2);
    QCOMPARE(model.err.trimmed().count('\n'), 0);
#endif
}

// Wrong: eight lines of numbers before anything of the model is said, or no way to see them.
void TestCliInput::whatWasStraightenedIsOneSentence()
{
    QByteArray text = "HeaderParameters 1\nFlatFab 2\n";
    for (const char *place : {"0", "40"}) {
        text += QByteArray("P 0 ") + place +
                " 0\nT 1 0 0\nN 0 0.6 0.8\nB 0 1 0\n"
                "BoundaryCurves 1\nSketchPoints 0\nBezierPoints 13\n";
        for (const char *point : {"0 0", "1 0", "2 0", "3 0", "3 1", "3 2", "3 3", "2 3", "1 3",
                                  "0 3", "0 2", "0 1", "0 0"})
            text += QByteArray(point) + '\n';
    }
    const QString file = written("skewed.txt", text);
    const QByteArray sentence =
        "skewed.txt: 2 sections were slightly skewed and have been straightened.\n";
    const Run plain = run({QStringLiteral("info"), file});
    QCOMPARE(plain.status, 0);
    QCOMPARE(plain.err, sentence);
    const Run verbose = run({QStringLiteral("info"), file, QStringLiteral("--verbose")});
    QCOMPARE(verbose.out, plain.out);
    QVERIFY2(verbose.err.startsWith(sentence), verbose.err);
    QCOMPARE(verbose.err.count('\n'), 3);
    QVERIFY2(verbose.err.contains("skewed.txt:3: Section 1 was slightly skewed"), verbose.err);
}

void TestCliInput::anEmptyNameIsOneLine_data()
{
    aPipeWithoutAWriterIsGivenUp_data();
}

// Wrong: an empty variable in a script would end in words that name nothing.
void TestCliInput::anEmptyNameIsOneLine()
{
    QFETCH(QStringList, arguments);
    const Run result = run(with(arguments, QString()));
    QCOMPARE(result.status, 2);
    QCOMPARE(result.err, QByteArray("could not be opened: a file needs a name\n"));
}

void TestCliInput::anEmptyOutputIsOneLine()
{
    std::vector verbs{"export", "replay"};
#ifdef FFF_PROGRAM // with the window
    verbs.insert(verbs.end(), {"steps", "render"});
#endif
    for (const char *verb : verbs) {
        const QString input = qstrcmp(verb, "replay") == 0 ? path("script.json") : path("pair.fff");
        const Run result =
            run({QLatin1String(verb), input, QStringLiteral("-o"), QString()}, false);
        QCOMPARE(result.status, 1);
        QVERIFY2(result.err.startsWith("-o: a file needs a name.\nUsage: "), result.err);
    }
}

void TestCliInput::replayNamesTheDrawingAndItsLine_data()
{
    QTest::addColumn<QByteArray>("drawing");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("a broken path") << QByteArray("<svg>\n<path d=\"M0 0L1\"/></svg>")
                                   << QByteArray("bad.svg:2: found \"L1\", expected path data");
    QTest::newRow("no XML") << QByteArray("eggs")
                            << QByteArray("bad.svg:1: found nothing, expected XML");
    QTest::newRow("nothing in it")
        << QByteArray("<svg/>")
        << QByteArray("bad.svg: found nothing, expected lines, shapes or paths");
    QTest::newRow("text only")
        << QByteArray("<svg><text>words</text></svg>")
        << QByteArray(
               "bad.svg: found nothing, expected lines; text must be turned into paths first");
}

// Wrong: the person would look for the mistake in the script.
void TestCliInput::replayNamesTheDrawingAndItsLine()
{
    QFETCH(QByteArray, drawing);
    QFETCH(QByteArray, said);
    const QString svg = written("bad.svg", drawing);
    const QString script = written(
        "import.json",
        "{\"viewport\": [100, 100], \"events\": [{\"type\": \"view\", \"name\": \"front\"}, "
        "{\"type\": \"command\", \"name\": \"section.importSections\", \"parameters\": {\"path\": "
        "\"" +
            svg.toUtf8() + "\"}}]}");
    const Run result =
        run({QStringLiteral("replay"), script, QStringLiteral("-o"), QStringLiteral("-"),
             QStringLiteral("--format"), QStringLiteral("fff")});
    QCOMPARE(result.status, 2);
    QCOMPARE(result.err.trimmed().count('\n'), 0);
    QVERIFY2(result.err.startsWith(script.toUtf8() + ":events[1]: " + said), result.err);
}

void TestCliInput::helpNeedsNoDisplay_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<QStringList>("arguments");
    const QString cli = QStringLiteral(FFF_CLI);
    for (const char *option : {"--help", "--version"})
        QTest::addRow("command line %s", option) << cli << QStringList{QLatin1String(option)};
    for (const char *verb : {"info", "check", "parts", "export", "operations", "replay"})
        QTest::addRow("%s --help", verb)
            << cli << QStringList{QLatin1String(verb), QStringLiteral("--help")};
#ifdef FFF_PROGRAM
    for (const char *verb : {"render", "steps"})
        QTest::addRow("%s --help", verb)
            << cli << QStringList{QLatin1String(verb), QStringLiteral("--help")};
    for (const char *option : {"--help", "-h", "--version", "-v"})
        QTest::addRow("window %s", option)
            << QStringLiteral(FFF_PROGRAM) << QStringList{QLatin1String(option)};
#endif
}

// Wrong: a person at a server, or a packager's build, could not even ask which version it is.
void TestCliInput::helpNeedsNoDisplay()
{
    QFETCH(QString, program);
    QFETCH(QStringList, arguments);
    for (const char *platform : {"", "xcb"}) {
        const Run result = run(program, arguments, {{"QT_QPA_PLATFORM", platform}}, false);
        QCOMPARE(result.status, 0);
        QVERIFY(!result.out.isEmpty());
        QCOMPARE(result.err, QByteArray());
    }
}

void TestCliInput::anotherCountryChangesNothing_data()
{
    QTest::addColumn<QStringList>("arguments");
    for (const char *arguments :
         {"info INPUT", "info INPUT --json", "check INPUT --thickness 2.5", "check INPUT --json",
          "parts INPUT --json", "export INPUT -o - --format svg", "export INPUT -o - --format fff",
          "info INPUT --sheet 0.5x0.5", "check absent.fff", "info INPUT --kerf 1e9",
          "operations INPUT", "operations --json"})
        QTest::newRow(arguments) << QString::fromLatin1(arguments).split(u' ');
}

// Wrong: English sentences would have German numbers in them, and engraved letters other forms.
void TestCliInput::anotherCountryChangesNothing()
{
    QFETCH(QStringList, arguments);
    const QStringList words = with(arguments, path("pair.fff"));
    const QString cli = QStringLiteral(FFF_CLI);
    const Run usual = run(cli, words, {{"LC_ALL", "C.UTF-8"}});
    QVERIFY(!usual.out.isEmpty() || !usual.err.isEmpty());
    for (const char *variable : {"LC_ALL", "LC_NUMERIC", "LANG"}) {
        const Run german =
            run(cli, words, {{"LC_ALL", ""}, {"LANG", "C.UTF-8"}, {variable, "de_DE.UTF-8"}});
        QCOMPARE(german.status, usual.status);
        QCOMPARE(german.err, usual.err);
        QCOMPARE(german.out, usual.out);
    }
}

FFF_TEST(TestCliInput)
#include "tst_cli_input.moc"
