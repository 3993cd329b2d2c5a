// `values`, `--set` and `variants`, as scripts use them.
#include <QTest> // first: moc stumbles over some standard headers

#include "app/cli/table.h"
#include "core/io/document_file.h"
#include "core/model/bindings.h"
#include "core/model/edits.h"
#include "core/operations/driven.h"
#include "core/values/presets.h"
#include "core/values/value_edits.h"
#include "tests/app/cli_run.h"
#include "tests/core/operations/operation_models.h"
#include "tests/test_program.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

using namespace fff;
using namespace fff::test;
using namespace Qt::Literals::StringLiterals;

namespace {

Document withNamed(Document document, const char *name, const char *typed)
{
    Value value;
    value.name = name;
    value.kind = ValueKind::Length;
    value.typed = typed;
    return addValue(std::move(document), std::move(value)).value();
}

/// Two boards across each other, whose width and thickness are made of values.
Document cross()
{
    Document document = withNamed(withNamed(newDocument(), "width", "100 mm"), "half", "width/2");
    const SectionId a =
        add(document, "Board", shapeOf(polygonContour(rectangleAt(-50, 0, 100, 60))), frontFrame());
    add(document, "Rib", shapeOf(polygonContour(rectangleAt(-40, 0, 80, 60))), sideFrame({0, 0, 0}),
        Parent{a, {0, 30}, {0, 60}, false});
    for (const auto &[key, typed] :
         {std::pair{"stock/" + std::to_string(document.currentStock.value) + "/thickness",
                    "width/25"},
          std::pair{"section/" + std::to_string(a.value) + "/width", "2*half"}})
        document = bound(document, *placeOfKey(document, key), typed).value();
    return document;
}

} // namespace

class TestCliValues : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void listing();
    void setEqualsTyping();
    void aNumberThatCanBeTwo();
    void presetsAreSettings();
    void whatDoesNotFollowIsSaid();
    void optionsComeAfter();
    void wrongSettings_data();
    void wrongSettings();
    void variants();
    void columnsHaveNamesOfTheirOwn();
    void wrongLinesAreNamed();
    void tables();
    void rangesAreTried();

private:
    QString put(const QString &name, const QByteArray &bytes)
    {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            return {};
        return file.fileName();
    }
    QByteArray bytesOf(const QString &path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    QTemporaryDir m_folder;
    QString m_file;
};

void TestCliValues::initTestCase()
{
    QVERIFY(m_folder.isValid());
    m_file = m_folder.filePath(u"cross.fff"_s);
    QVERIFY(io::writeDocument(m_file, cross()));
}

void TestCliValues::listing()
{
    const Run json = run({u"values"_s, m_file, u"--json"_s, u"--set"_s, u"width=120"_s});
    QCOMPARE(json.status, 0);
    const QJsonObject object = QJsonDocument::fromJson(json.out).object();
    const QJsonArray values = object["values"_L1].toArray();
    QCOMPARE(values.size(), 2);
    QCOMPARE(values[1].toObject()["name"_L1].toString(), u"half"_s);
    QCOMPARE(values[1].toObject()["value"_L1].toDouble(), 60.0);
    const QJsonArray driven = object["driven"_L1].toArray();
    QCOMPARE(driven.size(), 2);
    QCOMPARE(driven[0].toObject()["value"_L1].toDouble(), 4.8);
    const Run text = run({u"values"_s, m_file});
    QCOMPARE(text.status, 0);
    QVERIFY2(text.out.contains("half = 50"), text.out.constData());
}

void TestCliValues::setEqualsTyping()
{
    const Run bySet = run({u"export"_s, m_file, u"-o"_s, u"-"_s, u"--format"_s, u"svg"_s,
                           u"--set"_s, u"width=125 mm"_s});
    QCOMPARE(bySet.status, 0);
    Document byHand = cross();
    byHand.values = {};
    byHand.bindings.clear();
    Stock stock = *byHand.stocks[0];
    stock.thickness = 5.0;
    byHand = setStock(byHand, stock).value();
    const std::string width = "section/" + std::to_string(byHand.sections[0]->id.value) + "/width";
    byHand = bound(byHand, *placeOfKey(byHand, width), "125 mm").value();
    const QString file = m_folder.filePath(u"hand.fff"_s);
    QVERIFY(io::writeDocument(file, byHand));
    const Run typed = run({u"export"_s, file, u"-o"_s, u"-"_s, u"--format"_s, u"svg"_s});
    QCOMPARE(typed.status, 0);
    QVERIFY(!typed.out.isEmpty());
    QVERIFY(bySet.out == typed.out);
    // The order in which they are given says nothing.
    const QStringList rest{u"export"_s, m_file, u"-o"_s, u"-"_s, u"--format"_s, u"svg"_s};
    const Run one = run(rest + QStringList{u"--set"_s, u"width=90"_s, u"--set"_s, u"half=30"_s});
    const Run other = run(rest + QStringList{u"--set"_s, u"half=30"_s, u"--set"_s, u"width=90"_s});
    QCOMPARE(one.status, 0);
    QVERIFY(one.out == other.out);
    QVERIFY(one.out != bySet.out);
}

// Wrong: whoever writes decimals with a comma got a part a thousand times as large.
void TestCliValues::aNumberThatCanBeTwo()
{
    const auto set = [this](const QString &setting) {
        return run({u"values"_s, m_file, u"--json"_s, u"--set"_s, setting});
    };
    const Run unclear = set(u"width=1,125"_s);
    QCOMPARE(unclear.status, 1);
    QVERIFY2(unclear.err.contains("\"1,125\" can be 1.125 or 1125"), unclear.err.constData());
    for (const QString &clear : {u"width=1125"_s, u"width=112,5"_s, u"width=0,125"_s,
                                 u"width=max(1,125)"_s, u"width=1,125.5"_s})
        QVERIFY2(!set(clear).err.contains("can be 1.125"), qPrintable(clear));
}

void TestCliValues::presetsAreSettings()
{
    Document document = cross();
    Value width = *document.values.find(std::string_view("width"));
    width.isShown = true;
    document = changeValue(std::move(document), width).value();
    document.values = withPreset(document.values, takenPreset(document.values, "A5"));
    document.values = withPreset(
        document.values,
        takenPreset(typedValue(document.values, width.id, "125 mm", {}).value(), "wide one"));
    const QString file = m_folder.filePath(u"presets.fff"_s);
    QVERIFY(io::writeDocument(file, document));
    const auto svg = [&](const QStringList &settings) {
        QStringList arguments{u"export"_s, file, u"-o"_s, u"-"_s, u"--format"_s, u"svg"_s};
        for (const QString &setting : settings)
            arguments += {u"--set"_s, setting};
        const Run made = run(arguments);
        return made.status == 0 ? made.out : QByteArray();
    };
    const QByteArray wide = svg({u"width=125"_s});
    QVERIFY(!wide.isEmpty() && wide != svg({}));
    QCOMPARE(svg({u"Wide one"_s}), wide);
    QCOMPARE(svg({u"width=200"_s, u"wide one"_s}), wide); // the last counts
    QCOMPARE(svg({u"wide one"_s, u"width=100"_s}), svg({}));
    const Run wrong = run({u"values"_s, file, u"--set"_s, u"A6"_s});
    QCOMPARE(wrong.status, 1);
    QVERIFY2(wrong.err.contains("A5 or wide one"), wrong.err.constData());
    const Run text = run({u"values"_s, file, u"--set"_s, u"A5"_s});
    QVERIFY2(text.out.contains("Presets: A5, wide one. It is set to A5."), text.out.constData());
    const Run json = run({u"values"_s, file, u"--json"_s});
    const QJsonArray presets = QJsonDocument::fromJson(json.out).object()["presets"_L1].toArray();
    QCOMPARE(presets.size(), 2);
    QCOMPARE(presets[1].toObject()["settings"_L1].toObject()["width"_L1].toString(), u"125 mm"_s);
}

// Wrong: a model is cut as it was, and whoever wrote 1/0 into it does not hear that it does not
// count.
void TestCliValues::whatDoesNotFollowIsSaid()
{
    Document document = cross();
    document.values =
        typedValue(document.values, document.values.list[0]->value.id, "1/0", {}).value();
    const QString file = m_folder.filePath(u"broken.fff"_s);
    QVERIFY(io::writeDocument(file, document));
    for (const QStringList &verb :
         {QStringList{u"check"_s, file},
          QStringList{u"export"_s, file, u"-o"_s, u"-"_s, u"--format"_s, u"svg"_s}}) {
        const Run said = run(verb);
        QVERIFY2(said.err.contains("broken.fff: width: "), said.err.constData());
    }
    QVERIFY(run({u"check"_s, m_file}).err.isEmpty());
}

void TestCliValues::optionsComeAfter()
{
    const Run json = run(
        {u"info"_s, m_file, u"--json"_s, u"--set"_s, u"width=125"_s, u"--thickness"_s, u"3.5"_s});
    QCOMPARE(json.status, 0);
    const QJsonObject stock =
        QJsonDocument::fromJson(json.out).object()["stocks"_L1].toArray()[0].toObject();
    QCOMPARE(stock["thickness"_L1].toDouble(), 3.5);
}

void TestCliValues::wrongSettings_data()
{
    QTest::addColumn<QString>("setting");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("no value") << u"width"_s << QByteArray("NAME=VALUE");
    QTest::newRow("no name") << u"=3"_s << QByteArray("NAME=VALUE");
    QTest::newRow("unknown") << u"depth=3"_s << QByteArray("width or half");
    QTest::newRow("unreadable") << u"width=3 +"_s << QByteArray("width");
    QTest::newRow("another kind") << u"width=30 °"_s << QByteArray("a length");
    QTest::newRow("circle") << u"width=half"_s << QByteArray("half");
    QTest::newRow("not possible") << u"width=-100"_s << QByteArray("Thickness");
}

void TestCliValues::wrongSettings()
{
    QFETCH(QString, setting);
    QFETCH(QByteArray, said);
    const Run wrong = run({u"info"_s, m_file, u"--set"_s, setting});
    QCOMPARE(wrong.status, 1);
    QVERIFY2(wrong.err.contains(said), wrong.err.constData());
    QVERIFY(wrong.out.isEmpty());
}

void TestCliValues::variants()
{
    const QString table = put(u"sizes.csv"_s, "width;half\n100;\n125;\"50\"\n");
    const QString folder = m_folder.filePath(u"made"_s);
    const Run made = run({u"variants"_s, m_file, u"--table"_s, table, u"-o"_s, folder});
    QVERIFY2(made.status == 0, made.err.constData());
    const QByteArray verdicts = bytesOf(folder + u"/verdicts.csv"_s);
    QCOMPARE(verdicts.count("\r\n"), 3);
    QVERIFY2(verdicts.startsWith("line,width,half,file,connection"), verdicts.constData());
    const Run second = run({u"export"_s, m_file, u"-o"_s, u"-"_s, u"--format"_s, u"svg"_s,
                            u"--set"_s, u"width=125"_s, u"--set"_s, u"half=50"_s});
    QVERIFY(bytesOf(folder + u"/variant-3.svg"_s) == second.out);
    QVERIFY(bytesOf(folder + u"/variant-2.svg"_s) != second.out);
}

// Wrong: two columns of one name, of which a spreadsheet takes either.
void TestCliValues::columnsHaveNamesOfTheirOwn()
{
    const QString file = m_folder.filePath(u"size.fff"_s);
    QVERIFY(io::writeDocument(file, withNamed(withNamed(cross(), "Size", "7"), "problem", "8")));
    const QString folder = m_folder.filePath(u"sized"_s);
    const QString table = put(u"named.csv"_s, "Size,problem\n5,6\n");
    QCOMPARE(run({u"variants"_s, file, u"--table"_s, table, u"-o"_s, folder}).status, 0);
    const QByteArray head = bytesOf(folder + u"/verdicts.csv"_s).split('\r').first();
    QVERIFY2(head.startsWith("line,Size,problem,file,connection"), head.constData());
    QVERIFY2(head.endsWith("size_,joints,problem_"), head.constData());
}

void TestCliValues::wrongLinesAreNamed()
{
    const QString table = put(u"wrong.csv"_s, "width\n100\nabc\n-4\n110,7\n120\n");
    const QString folder = m_folder.filePath(u"some"_s);
    const Run made = run({u"variants"_s, m_file, u"--table"_s, table, u"-o"_s, folder});
    QCOMPARE(made.status, 2);
    for (const char *place : {"wrong.csv:3:", "wrong.csv:4:", "wrong.csv:5:"})
        QVERIFY2(made.err.contains(place), made.err.constData());
    QVERIFY(QFile::exists(folder + u"/variant-2.svg"_s));
    QVERIFY(!QFile::exists(folder + u"/variant-3.svg"_s));
    QVERIFY(QFile::exists(folder + u"/variant-6.svg"_s));
    QCOMPARE(run({u"variants"_s, m_file, u"-o"_s, folder}).status, 1);
    QCOMPARE(run({u"variants"_s, m_file, u"-o"_s, folder, u"--table"_s, u"none.csv"_s}).status, 2);
}

void TestCliValues::tables()
{
    const auto rows = cli::readTable(u"\ufeffa, b\r\n\r\n\" 1,5\", \"say \"\"x\"\"\"\n2,3"_s);
    QVERIFY(rows);
    QCOMPARE(rows->size(), std::size_t(3));
    QCOMPARE((*rows)[0].cells, QStringList({u"a"_s, u"b"_s}));
    QCOMPARE((*rows)[1].cells, QStringList({u" 1,5"_s, u"say \"x\""_s}));
    QCOMPARE((*rows)[1].line, 3);
    QCOMPARE((*cli::readTable(u"a;b\n1,5;2"_s))[1].cells, QStringList({u"1,5"_s, u"2"_s}));
    QVERIFY(!cli::readTable(u"a\n\"1"_s));
    QVERIFY(cli::readTable(QString())->empty());
}

// Wrong: a script that makes thirty of them does not hear that some fall over.
void TestCliValues::rangesAreTried()
{
    Document document = cross();
    Value width = *document.values.find(std::string_view("width"));
    width.isShown = true;
    width.range = {90.0, 120.0, {}};
    const QString good = m_folder.filePath(u"good.fff"_s), bad = m_folder.filePath(u"bad.fff"_s);
    QVERIFY(io::writeDocument(good, changeValue(document, width).value()));
    width.range.most = 4000.0; // no sheet is as wide, and no slit
    QVERIFY(io::writeDocument(bad, changeValue(document, width).value()));
    const Run holds = run({u"values"_s, good, u"--try"_s});
    QVERIFY2(holds.status == 0, holds.out.constData());
    QVERIFY2(holds.out.contains("2 of 2 corners"), holds.out.constData());
    const Run fails = run({u"values"_s, bad, u"--try"_s, u"--json"_s});
    QCOMPARE(fails.status, 3);
    const QJsonObject tried = QJsonDocument::fromJson(fails.out).object()["tried"_L1].toObject();
    const QJsonArray places = tried["places"_L1].toArray();
    QCOMPARE(tried["corners"_L1].toInt(), 2);
    QVERIFY(places.size() > 40);
    int failing = 0;
    for (const QJsonValue &place : places)
        failing += place.toObject()["holds"_L1].toBool() ? 0 : 1;
    QCOMPARE(tried["failing"_L1].toInt(), failing);
    QCOMPARE(places[0].toObject()["values"_L1].toObject()["width"_L1].toDouble(), 90.0);
    QVERIFY(!places[1].toObject()["holds"_L1].toBool());
    // The same seed, the same places.
    QVERIFY(run({u"values"_s, bad, u"--try"_s, u"--json"_s, u"--seed"_s, u"1"_s}).out == fails.out);
    const Run none = run({u"values"_s, m_file, u"--try"_s});
    QCOMPARE(none.status, 0);
    QCOMPARE(run({u"values"_s, m_file, u"--try"_s, u"--seed"_s, u"x"_s}).status, 1);
}

FFF_TEST(TestCliValues)
#include "tst_cli_values.moc"
