// What the judge says of the joints of real models, of the samples and of drawings at random: by
// its own means, with no more of the product than what is cut and which way each joint is said to
// come apart. Prints those that do not hold.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/assembly_plan.h"
#include "core/io/document_file.h"
#include "tests/core/analysed.h"
#include "tests/core/session/held_pairs.h"
#include "tests/core/session/random_drawings.h"
#include "tests/rounds.h"
#include "tests/test_program.h"

#include <QDir>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

using namespace fff;
using namespace fff::test;

namespace {

struct Tally
{
    int held = 0, notHeld = 0;
    QByteArray fault; // the first one
};

/// Shifts alone: turns by name, which differ between the two pieces.
bool areOpposite(const Freedom &one, const Freedom &other)
{
    const auto shifts = [](const Freedom &freedom) {
        return std::count_if(freedom.free.begin(), freedom.free.end(), [](const SmallMove &move) {
            return move.kind == SmallMove::Kind::Shift;
        });
    };
    return one.free.size() == other.free.size() && shifts(one) == shifts(other) &&
           std::all_of(one.free.begin(), one.free.end(), [&](const SmallMove &move) {
               return move.kind == SmallMove::Kind::Turn ||
                      std::any_of(other.free.begin(), other.free.end(), [&](const SmallMove &back) {
                          return back.isShiftAlong(-move.direction);
                      });
           });
}

/// Judges all joints of whole sections, says which do not hold, and what cannot be of any joint.
void judgeAll(const QByteArray &model, const Analysis &analysis, Tally &tally)
{
    const std::vector<JudgedPiece> pieces = judgedPieces(analysis.bodies);
    for (const JudgedPair &pair : judged(pieces, pairsOfWholeSections(analysis))) {
        const auto expect = [&](bool isSo, const char *otherwise) {
            if (!isSo && tally.fault.isEmpty())
                tally.fault = model + " | " + toText(pair) + ": " + otherwise;
        };
        expect(pair.freedom.inEachOther < kFreeDepth, "they are in each other");
        expect(!pair.freedom.touches || pair.comesOff(), "they do not come apart");
        expect(!pair.isHeld() || !pair.goesSideways(), "they hold, but not sideways");
        const HeldPair round = turnedRound(pair.pair);
        const Freedom back =
            judge(pieces[static_cast<std::size_t>(round.piece)],
                  pieces[static_cast<std::size_t>(round.other)], round.slack, round.ways);
        expect(areOpposite(pair.freedom, back), "one can go where the other cannot give way");
        ++(pair.isHeld() ? tally.held : tally.notHeld);
        if (!pair.isHeld())
            qInfo("%s | %s", model.constData(), toText(pair).constData());
    }
}

void filesOf(const QString &folder, const QString &kind)
{
    QTest::addColumn<QString>("path");
    for (const QFileInfo &file :
         QDir(folder).entryInfoList({QStringLiteral("*.") + kind}, QDir::Files, QDir::Name))
        QTest::newRow(qPrintable(file.fileName())) << file.filePath();
}

constexpr int kDrawings = 200, kOfRow = 20;

Analysis drawn(int seed)
{
    return analysed(randomDrawing(static_cast<std::uint64_t>(seed)));
}

} // namespace

class TestHeldPairs : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void drawingsAreOfAllKinds();
    void realModels_data();
    void realModels();
    void samples_data() { filesOf(QStringLiteral(FFF_SAMPLES), QStringLiteral("fff")); }
    void samples();
    void drawings_data();
    void drawings();
    void whatIsPutOnLastComesOff_data() { drawings_data(); }
    void whatIsPutOnLastComesOff();
};

/// What would be wrong: drawings that leave out what joints are difficult for.
void TestHeldPairs::drawingsAreOfAllKinds()
{
    std::set<std::size_t> counts;
    std::map<JointKind, int> kinds;
    int oblique = 0, equalEnds = 0, windows = 0, shelves = 0, cutApart = 0, withClearance = 0;
    double thinnest = 1e9, thickest = 0.0, sharpest = 90.0;
    for (int seed = 0; seed < kDrawings; ++seed) {
        const Analysis analysis = drawn(seed);
        const Document &document = analysis.model.document;
        QVERIFY(randomDrawing(static_cast<std::uint64_t>(seed)) == document);
        counts.insert(document.sections.size());
        for (const SectionPointer &section : document.sections)
            windows += !section->shape->holes().empty();
        withClearance += document.stocks.front()->clearance > 0.0;
        for (const auto &stock : document.stocks) {
            thinnest = std::min(thinnest, stock->thickness);
            thickest = std::max(thickest, stock->thickness);
        }
        const JointList &joints = analysis.assembly.joints;
        for (const Joint &joint : joints) {
            ++kinds[joint.kind];
            const double degrees = joint.crossing->angle * 180.0 / std::numbers::pi;
            sharpest = std::min(sharpest, degrees);
            oblique += degrees < 60.0;
            for (const Overlap &overlap : joint.crossing->overlaps)
                equalEnds += std::abs(overlap.a.from.at - overlap.b.from.at) < 0.01 &&
                             std::abs(overlap.a.to.at - overlap.b.to.at) < 0.01;
            for (int third = joint.b + 1; third < static_cast<int>(document.sections.size());
                 ++third)
                shelves += joints.find(joint.a, third) && joints.find(joint.b, third);
        }
        for (int section = 0; section < static_cast<int>(document.sections.size()); ++section)
            cutApart += analysis.bodies.countOf(section) > 1;
    }
    qInfo("cross laps %d, extended %d, mortises %d, none %d; oblique %d, equal ends %d, three that "
          "cross %d, windows %d, cut apart %d, clearance %d, %.1f to %.1f mm, from %.0f degrees",
          kinds[JointKind::CrossLap], kinds[JointKind::ExtendedCrossLap], kinds[JointKind::Mortise],
          kinds[JointKind::None], oblique, equalEnds, shelves, windows, cutApart, withClearance,
          thinnest, thickest, sharpest);
    QCOMPARE(counts, (std::set<std::size_t>{2, 3, 4, 5, 6, 7, 8}));
    QVERIFY(kinds[JointKind::CrossLap] > 200 && kinds[JointKind::ExtendedCrossLap] > 100 &&
            kinds[JointKind::Mortise] > 20);
    QVERIFY(oblique > 100 && equalEnds > 20 && shelves > 50 && windows > 50 && cutApart > 50);
    QVERIFY(withClearance > 50 && withClearance < 150);
    QVERIFY(thinnest < 1.2 && thickest > 5.8 && sharpest < 25.0);
}

void TestHeldPairs::realModels_data()
{
    filesOf(QStringLiteral(FFF_SHARED_MODELS), QStringLiteral("txt"));
    if (QDir(QStringLiteral(FFF_SHARED_MODELS)).entryList({QStringLiteral("*.txt")}).isEmpty())
        QTest::newRow("no models here") << QString();
}

/// What would be wrong: joints that do not come apart the way that is said, or sections that are in
/// each other in spite of them; or a judge that contradicts itself, or finds that nothing holds.
void TestHeldPairs::realModels()
{
    QFETCH(QString, path);
    if (path.isEmpty())
        FFF_WITHOUT_SHARED();
    const auto loaded = io::readDocument(path);
    QVERIFY(loaded);
    Tally tally;
    judgeAll(QTest::currentDataTag(), analysed(loaded->document), tally);
    QVERIFY2(tally.fault.isEmpty(), tally.fault);
    QVERIFY(tally.held > 0);
}

/// What would be wrong: as with real models; and a sample with a joint that does not hold.
void TestHeldPairs::samples()
{
    QFETCH(QString, path);
    const auto loaded = io::readDocument(path);
    QVERIFY(loaded);
    Tally tally;
    judgeAll(QTest::currentDataTag(), analysed(loaded->document), tally);
    QVERIFY2(tally.fault.isEmpty(), tally.fault);
    QVERIFY(tally.held > 0);
    QCOMPARE(tally.notHeld, 0);
}

void TestHeldPairs::drawings_data()
{
    QTest::addColumn<int>("first");
    for (int first = 0; first < rounds(kDrawings); first += kOfRow)
        QTest::addRow("drawings %d to %d", first, first + kOfRow - 1) << first;
}

/// What would be wrong: as with real models.
void TestHeldPairs::drawings()
{
    QFETCH(int, first);
    Tally tally;
    for (int seed = first; seed < first + kOfRow; ++seed)
        judgeAll("drawing " + QByteArray::number(seed), drawn(seed), tally);
    QVERIFY2(tally.fault.isEmpty(), tally.fault);
    QVERIFY(tally.held > tally.notHeld);
    qInfo("%d hold, %d do not", tally.held, tally.notHeld);
}

/// What would be wrong: by the judge, the part that a plan brings in last does not come off all
/// others again.
void TestHeldPairs::whatIsPutOnLastComesOff()
{
    QFETCH(int, first);
    int looked = 0;
    for (int seed = first; seed < first + kOfRow; ++seed) {
        const Analysis analysis = drawn(seed);
        const ModelPlan plan = planOf(analysis);
        if (plan.plan.verdict != AssemblyPlan::Verdict::Possible || !plan.overlaps.empty() ||
            plan.plan.steps.empty() || plan.plan.steps.back().parts.size() != 1 ||
            plan.plan.steps.back().moves.empty())
            continue;
        const AssemblyStep &step = plan.plan.steps.back();
        const Vec3 out = -step.moves.back().direction;
        const Freedom freedom =
            judgedAmongAll(judgedPieces(analysis.bodies), step.parts.front(), std::span(&out, 1));
        const bool comesOff =
            std::any_of(freedom.free.begin(), freedom.free.end(),
                        [&](const SmallMove &move) { return move.isShiftAlong(out); });
        QVERIFY2(!freedom.touches || comesOff, "drawing " + QByteArray::number(seed));
        ++looked;
    }
    QVERIFY(looked > 0);
}

FFF_TEST(TestHeldPairs)
#include "tst_held_pairs.moc"
