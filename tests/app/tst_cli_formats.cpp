// What the command line reads and writes is the table of formats. If this fails, a format that was
// added cannot be asked for, or is not named where people look for it.
#include <QTest> // first: moc stumbles over some standard headers

#include "app/cli/command_line.h"
#include "core/io/blobs.h"
#include "core/io/document_file.h"
#include "core/model/edits.h"
#include "tests/app/fault_run.h"
#include "tests/core/io/added_format.h"
#include "tests/test_program.h"

#include <QTemporaryDir>

using namespace fff;
using namespace fff::test;
using namespace Qt::Literals::StringLiterals;

class TestCliFormats : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatHelpSays();
    void anAddedFormatIsInHelp();
    void wordsOfOptions();
    void anAddedFormatIsReadAndWritten();
    void optionsOfAnAddedFormat_data();
    void optionsOfAnAddedFormat();
    void modelsWithBlobs();

private:
    QString put(const char *name, const std::string &bytes)
    {
        const QString path = m_folder.filePath(QLatin1String(name));
        return io::writeFile(path, bytes) ? path : QString();
    }
    static VerbRun run(const QStringList &arguments, const char *output = "")
    {
        return runVerb(arguments, QLatin1String(output), FaultPoint::Boolean, -1);
    }

    /// Without its line ends.
    static QString helpOfExport()
    {
        return QString::fromUtf8(run({u"export"_s, u"--help"_s}).out).simplified();
    }

    QTemporaryDir m_folder;
};

void TestCliFormats::whatHelpSays()
{
    const cli::Verb &verb = cli::verbNamed("export");
    QCOMPARE(cli::usageOf(verb),
             QStringLiteral("export FILE -o "
                            "OUT.{svg,dxf,pdf,lbrn2,gcode,csv,png,zip,obj,stl,3mf,fff} "
                            "[options]"));
    QCOMPARE(cli::purposeOf(verb),
             QStringLiteral("Cutting files, true to size; DXF with layers by purpose; PDF in true "
                            "size; a LightBurn project; G-code for lasers; the list of parts; a "
                            "picture of the sheets; all for a workshop; the solids in place; the "
                            "parts to print; or the model itself"));
    QCOMPARE(cli::usageOf(cli::verbNamed("replay")),
             QStringLiteral("replay SCRIPT.json [--from FILE] [--template TEMPLATE[@SIZE]] -o "
                            "OUT.{fff,svg,dxf,pdf,lbrn2,gcode,csv,png,zip,obj,stl,3mf} [options]"));
    QCOMPARE(cli::modelFiles(), QStringLiteral("a .fff file or a FlatFab .txt file"));
    const QString help = helpOfExport();
    for (const char *said :
         {"svg, dxf, pdf, lbrn2, gcode, csv, png, zip, obj, stl, 3mf or fff; needed if the file's "
          "name does "
          "not tell.",
          "Millimetres per unit of a FlatFab file (25.4).", "--dxf <VERSION>", "--paper <PAPER>",
          "--parts <HOW>", "--machine <NAME>", "generic, trotec"})
        QVERIFY2(help.contains(QLatin1String(said)), said);
}

void TestCliFormats::anAddedFormatIsInHelp()
{
    const io::AddedFormat added(addedFormat());
    const cli::Verb &verb = cli::verbNamed("export");
    QVERIFY(cli::usageOf(verb).endsWith(QStringLiteral(",3mf,fff,knots} [options]")));
    QVERIFY(cli::purposeOf(verb).endsWith(QStringLiteral("the model itself; or knots to tie")));
    QCOMPARE(cli::modelFiles(),
             QStringLiteral("a .fff file, a FlatFab .txt file or a Knots .knots file"));
    const QString help = helpOfExport();
    QVERIFY(help.contains(u"--knots-in-a-row <COUNT>"_s));
    QVERIFY(help.contains(u"Knots in a row (7)."_s));
    const VerbRun wrong = run({u"export"_s, put("a.fff", "knots 2")}, "a.xyz");
    QCOMPARE(wrong.status, int(cli::WrongUse));
    QVERIFY(wrong.err.contains(
        "a.xyz: this kind of file cannot be written; expected .svg, .dxf, "
        ".pdf, .lbrn2, .gcode, .csv, .png, .zip, .obj, .stl, .3mf, .fff or .knots."));
}

// A word of an option, whatever the case; others are refused with what there is.
void TestCliFormats::wordsOfOptions()
{
    Document document = newDocument();
    NewSection section;
    section.shape = *Shape::make(*Contour::fromPolygon({{0, 0}, {50, 0}, {50, 40}, {0, 40}}));
    const QString model = m_folder.filePath(QStringLiteral("plate.fff"));
    QVERIFY(io::writeDocument(model, *addSection(document, section)));
    const auto written = [&](const QStringList &options) {
        return run(QStringList{u"export"_s, model} + options, "plate.dxf");
    };
    QVERIFY(written({}).file.contains("AC1015"));
    QVERIFY(written({u"--dxf"_s, u"R12"_s}).file.contains("AC1009"));
    const VerbRun wrong = written({u"--dxf"_s, u"r13"_s});
    QCOMPARE(wrong.status, int(cli::WrongUse));
    QVERIFY(wrong.err.contains("--dxf: found \"r13\", expected r2000 or r12."));
    QVERIFY(!wrong.hasWritten());
    const VerbRun machine = written({u"--machine"_s, u"K40"_s});
    QVERIFY2(
        machine.err.contains("K40 with MeerK40t: 0.2 m of cuts, about 1 min. Sheets are larger "
                             "than its bed of 300 x 200 mm; choose others by --sheet."),
        machine.err.constData());
    const VerbRun none = written({u"--machine"_s, u"k41"_s});
    QCOMPARE(none.status, int(cli::WrongUse));
    QVERIFY(none.err.contains("--machine: there is no machine \"k41\"; expected generic, trotec"));
}

void TestCliFormats::anAddedFormatIsReadAndWritten()
{
    const io::AddedFormat added(addedFormat());
    const QString file = put("a.txt", "knots 2");
    const VerbRun info = run({u"info"_s, file, u"--json"_s});
    QCOMPARE(info.status, int(cli::Done));
    QVERIFY2(info.out.contains("\"knots\""), info.out.constData());
    const VerbRun made = run({u"export"_s, file}, "b.knots");
    QVERIFY2(made.status == cli::Done, made.err.constData());
    QCOMPARE(made.file, QByteArray("2 parts in rows of 7\n"));
    QVERIFY(made.err.contains("Parts: 2"));
    QCOMPARE(run({u"export"_s, file, u"--format"_s, u"KNOTS"_s}, "b").file, made.file);
}

void TestCliFormats::optionsOfAnAddedFormat_data()
{
    QTest::addColumn<QString>("value");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("a value") << "3" << int(cli::Done) << QByteArray("2 parts in rows of 3\n");
    QTest::newRow("too much") << "10" << int(cli::WrongUse)
                              << QByteArray("--knots-in-a-row: found \"10\", expected a number "
                                            "from 1 to 9.");
}

void TestCliFormats::optionsOfAnAddedFormat()
{
    QFETCH(QString, value);
    QFETCH(int, status);
    QFETCH(QByteArray, said);
    const io::AddedFormat added(addedFormat());
    const VerbRun made =
        run({u"export"_s, put("a.txt", "knots 2"), u"--knots-in-a-row"_s, value}, "b.knots");
    QCOMPARE(made.status, status);
    QVERIFY((made.file + made.err).contains(said));
    QCOMPARE(made.hasWritten(), status == cli::Done);
}

void TestCliFormats::modelsWithBlobs()
{
    Document document = newDocument();
    NewSection section;
    section.shape = *Shape::make(*Contour::fromPolygon({{0, 0}, {50, 0}, {50, 40}, {0, 40}}));
    document = addBlob(*addSection(document, section), io::makeBlob("bytes", "image/png", "a.png"));
    const QString path = m_folder.filePath(QStringLiteral("blobs.fff"));
    QVERIFY(io::writeDocument(path, document));
    const VerbRun copy = run({u"export"_s, path}, "copy.fff");
    QCOMPARE(copy.status, int(cli::Done));
    QVERIFY2(copy.file == QByteArray::fromStdString(*io::readFile(path)), "the very same bytes");
    const VerbRun printed = run({u"export"_s, path, u"-o"_s, u"-"_s, u"--format"_s, u"fff"_s});
    QCOMPARE(printed.out, copy.file);
}

FFF_TEST(TestCliFormats)
#include "tst_cli_formats.moc"
