// The numbers of joints in a colour for each. If this fails, mates are told to be what they are
// not, or a laser cuts what it was to engrave.
#include "core/analysis/cutting.h"
#include "core/fabrication/joint_colours.h"
#include "core/io/dxf_writer.h"
#include "core/io/machine_library.h"
#include "core/io/pdf_writer.h"
#include "core/io/svg_writer.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <QRegularExpression>
#include <QTest>

#include <map>

using namespace fff;
using namespace fff::test;

class TestJointColours : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void noneMeansSomethingToAMachine();
    void bothPartsHaveTheSame();
    void onlyWhereTheyAreAskedFor();
};

namespace {

/// A plate with two others across it: two joints.
CuttingDrawing drawn(bool hasJointColours)
{
    Document document = withSection(newDocument(), plateOf(-60, 0, 60, 60), front());
    for (const double at : {-30.0, 30.0})
        document = withSection(std::move(document), plateOf(-40, 0, 40, 60), side(at));
    CuttingOptions options;
    options.hasJointColours = hasJointColours;
    return makeCutting(analysed(document), options)->drawing;
}

/// How many paths have which colour.
std::map<QString, int> coloursOf(const std::string &svg)
{
    std::map<QString, int> colours;
    static const QRegularExpression path(QStringLiteral("<path stroke=\"(#[0-9a-f]{6})\""));
    for (auto it = path.globalMatch(QString::fromStdString(svg)); it.hasNext();)
        ++colours[it.next().captured(1)];
    return colours;
}

QString colour(std::uint32_t rgb)
{
    return QStringLiteral("#%1").arg(rgb, 6, 16, QLatin1Char('0'));
}

} // namespace

void TestJointColours::noneMeansSomethingToAMachine()
{
    std::vector<Machine> machines{usualMachine()};
    for (const auto &machine : io::machineLibrary())
        machines.push_back(*machine);
    QVERIFY(machines.size() > 3);
    for (const Machine &machine : machines)
        for (int joint = 1; joint <= 40; ++joint) {
            const std::uint32_t one = jointColour(joint, machine);
            QVERIFY(one != jointColour(joint + 1, machine));
            for (const Machine::Process &process : machine.processes) {
                int most = 0;
                for (const int shift : {16, 8, 0})
                    most =
                        std::max(most, std::abs(static_cast<int>(one >> shift & 0xFFU) -
                                                static_cast<int>(process.colour >> shift & 0xFFU)));
                QVERIFY2(most >= 40, machine.key.c_str());
            }
        }
}

void TestJointColours::bothPartsHaveTheSame()
{
    const std::map<QString, int> colours = coloursOf(io::writeSvg(drawn(true)));
    for (const int joint : {1, 2})
        QCOMPARE(colours.at(colour(jointColour(joint, usualMachine()))), 2);
    // The parts' own numbers stay as they are.
    QCOMPARE(colours.at(colour(usualMachine().of(Purpose::Number).colour)), 3);
    QVERIFY(io::writePdf(drawn(true)) != io::writePdf(drawn(false)));
}

void TestJointColours::onlyWhereTheyAreAskedFor()
{
    const std::map<QString, int> colours = coloursOf(io::writeSvg(drawn(false)));
    for (const int joint : {1, 2})
        QVERIFY(!colours.contains(colour(jointColour(joint, usualMachine()))));
    // Layers say what is done.
    QCOMPARE(io::writeDxf(drawn(true)), io::writeDxf(drawn(false)));
}

FFF_TEST(TestJointColours)
#include "tst_joint_colours.moc"
