// Machines from JSON. If this fails, files are made for another machine than was asked for.
#include "core/io/error_text.h"
#include "core/io/machine_library.h"
#include "tests/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <set>

using namespace fff;
using namespace Qt::Literals::StringLiterals;

class TestMachineLibrary : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theLibraryIsInOrder();
    void aMachineSaysAllOrLittle();
    void whatIsWrongIsSaidWithItsPlace_data();
    void whatIsWrongIsSaidWithItsPlace();
    void byKeyOrByFile();
};

void TestMachineLibrary::theLibraryIsInOrder()
{
    const auto library = io::machineLibrary();
    QVERIFY(library.size() > 5);
    std::set<std::string> keys;
    for (const auto &machine : library) {
        keys.insert(machine->key);
        QVERIFY(!machine->key.empty() && !machine->name.empty() && machine->stroke > 0.0);
        if (machine->key != "lightburn")
            for (const Purpose purpose : {Purpose::InnerCut, Purpose::OuterCut})
                QVERIFY2(machine->of(purpose).colour != 0 ||
                             machine->of(Purpose::Engrave).colour != 0,
                         "black is burnt over areas by most programs");
    }
    QCOMPARE(keys.size(), library.size());
    // What is asked for by name is what is written without a name.
    const Machine &first = *library.front(), &usual = usualMachine();
    QCOMPARE(first.key, usual.key);
    QCOMPARE(first.stroke, usual.stroke);
    for (std::size_t i = 0; i < kPurposes; ++i)
        QCOMPARE(first.processes[i].colour, usual.processes[i].colour);
}

void TestMachineLibrary::aMachineSaysAllOrLittle()
{
    const auto read = io::readMachines(
        R"({"colours": {"c": {"stroke": 0.01, "outerCut": "#0000FF", "guide": null}},
            "machines": [{"key": "a", "name": "A"},
                         {"key": "b", "name": "B", "bed": [300, 200], "colours": "c",
                          "speeds": {"cut": 4, "travel": 50}, "powers": {"engrave": 0.1},
                          "layers": {"outerCut": 9},
                          "finish": {"tabs": 4, "tabWidth": 0.5, "lead": 2, "sharesCuts": true},
                          "gcode": {"head": ["G21", "$H"], "on": "M3", "mostPower": 255}}]})",
        "own.json");
    QVERIFY2(read, read ? "" : qPrintable(io::errorText(read.error())));
    QCOMPARE(read->size(), std::size_t(2));
    const Machine &plain = (*read)[0], &own = (*read)[1];
    QCOMPARE(plain.travel, usualMachine().travel);
    QCOMPARE(own.bed, Vec2(300, 200));
    QVERIFY(!own.hasGuides && plain.hasGuides);
    QCOMPARE(own.of(Purpose::OuterCut).colour, 0x0000FFU);
    QCOMPARE(own.of(Purpose::OuterCut).layer, 9);
    QCOMPARE(own.of(Purpose::InnerCut).speed, 4.0);
    QCOMPARE(own.of(Purpose::Number).power, 0.1);
    QCOMPARE(own.gcode.head, (std::vector<std::string>{"G21", "$H"}));
    QCOMPARE(own.gcode.foot, usualMachine().gcode.foot);
    QCOMPARE(own.gcode.mostPower, 255.0);
    QVERIFY(own.finish == (CutFinish{4, 0.5, 2.0, true}) && plain.finish.isPlain());
}

void TestMachineLibrary::whatIsWrongIsSaidWithItsPlace_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("said");
    const auto row = [](const char *name, const char *machine, const char *said) {
        QTest::newRow(name) << QByteArray(
                                   R"({"colours": {"c": {"engrave": "red"}}, "machines": [)") +
                                   machine + "]}"
                            << QString::fromLatin1(said);
    };
    row("no machine", "", "own.json:$.machines: ");
    row("no name", R"({"key": "a"})", "own.json:$.machines[0].name: ");
    row("two of a key", R"({"key": "a", "name": "A"}, {"key": "a", "name": "B"})",
        "own.json:$.machines[1]: ");
    row("a colour that is none", R"({"key": "a", "name": "A", "colours": "c"})",
        "own.json:$.colours.c.engrave: ");
    row("colours that are not there", R"({"key": "a", "name": "A", "colours": "d"})",
        "own.json:$.machines[0].colours: ");
    row("no speed", R"({"key": "a", "name": "A", "speeds": {"cut": 0}})",
        "own.json:$.machines[0].speeds.cut: ");
    row("too much power", R"({"key": "a", "name": "A", "powers": {"cut": 1.5}})",
        "own.json:$.machines[0].powers.cut: ");
    row("two lines in one", R"({"key": "a", "name": "A", "gcode": {"head": ["G21\nM3 S1000"]}})",
        "own.json:$.machines[0].gcode.head[0]: ");
    row("no bed", R"({"key": "a", "name": "A", "bed": [0, 100]})", "own.json:$.machines[0].bed: ");
    row("half a tab", R"({"key": "a", "name": "A", "finish": {"tabs": 0.5}})",
        "own.json:$.machines[0].finish.tabs: ");
    row("tabs without width", R"({"key": "a", "name": "A", "finish": {"tabWidth": 0}})",
        "own.json:$.machines[0].finish.tabWidth: ");
    QTest::newRow("no JSON") << QByteArray("{\"machines\": [}") << u"own.json:1: "_s;
}

void TestMachineLibrary::whatIsWrongIsSaidWithItsPlace()
{
    QFETCH(QByteArray, json);
    QFETCH(QString, said);
    const auto read = io::readMachines(json.toStdString(), "own.json");
    QVERIFY(!read);
    const QString text = io::errorText(read.error());
    QVERIFY2(text.startsWith(said), qPrintable(text));
}

void TestMachineLibrary::byKeyOrByFile()
{
    QVERIFY(io::machineNamed(u"K40"_s) && (*io::machineNamed(u"k40"_s))->bed == Vec2(300, 200));
    const auto none = io::machineNamed(u"k41"_s);
    QVERIFY(!none && none.error().code == ErrorCode::UnknownReference);
    const QTemporaryDir folder;
    QFile file(folder.filePath(u"own.json"_s));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"machines": [{"key": "a", "name": "Mine"}]})");
    file.close();
    const auto own = io::machineNamed(file.fileName());
    QVERIFY(own && (*own)->name == "Mine");
    QVERIFY(!io::machineNamed(folder.filePath(u"none.json"_s)));
}

FFF_TEST(TestMachineLibrary)
#include "tst_machine_library.moc"
