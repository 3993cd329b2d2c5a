// What must not change the strength of a model, whatever the model is.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/operations/evaluate.h"
#include "core/operations/scaled_model.h"
#include "tests/core/analysed.h"
#include "tests/core/session/law_models.h"
#include "tests/rounds.h"
#include "tests/test_program.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

constexpr int kDrawings = rounds(24),
              kCrates = rounds(8); // random ones; their rows are named by their seeds

/// Only rounding tells these answers apart: sums in another order, factors of stiff structures.
constexpr LawBound kRounding{1e-6};
/// Also the last digits of where slits are, after which a neck is looked for by golden section: it
/// stops at a fiftieth of the grid, wherever it is then.
constexpr LawBound kRefined{1e-3};
/// The same of the bridge, where in another order slits end a µm elsewhere, beside necks of a
/// millimetre; and of the whale, where rounding tells which ways to bear the load are none. Of what
/// the sheet bears.
constexpr LawBound kDelicate{3e-3, 1.0};
/// Where other lines are laid over the sections: a line of the grid has to be near the worst place,
/// which then is looked for; at a tooth's tip or the pointed end of a foot, where a neck is the
/// shorter the nearer it comes to the end, lines are nearer or farther by chance. Of what the sheet
/// bears.
constexpr double kOfTheGrid = 0.03;
constexpr double kOfPointedFeet = 0.07; // the same of a model that stands on nothing else
/// mm that feet may move on a contour that is nearly level.
constexpr double kFeet = 5.0;
/// What is in proportion or a sum, and is neither looked for nor factored anew.
constexpr double kExact = 1e-9;
constexpr double kSameLength = 1e-7; // mm

const LawBound &boundOf(const QString &name)
{
    return name == QLatin1String("bridge.txt") || name == QLatin1String("whale.fff") ? kDelicate
                                                                                     : kRefined;
}

Document eachSection(Document document, const std::function<void(Section &)> &edit)
{
    for (SectionPointer &pointer : document.sections) {
        Section section = *pointer;
        edit(section);
        pointer = std::make_shared<const Section>(std::move(section));
    }
    return document;
}

/// Every frame mapped; what lies in sections stays.
Document placed(const Document &document, const Eigen::Matrix3d &turn, const Vec3 &by)
{
    return eachSection(document, [&](Section &section) {
        section.frame.origin = turn * section.frame.origin + by;
        section.frame.x = turn * section.frame.x;
        section.frame.y = turn * section.frame.y;
    });
}

/// All lengths times k with the same stresses: forces times k², so densities over k.
Document inAnotherUnit(const Document &document, double k)
{
    Document scaled = scaledModel(document, k).value_or(Document());
    for (auto &pointer : scaled.stocks) {
        Stock stock = *pointer;
        for (double *length : {&stock.thickness, &stock.kerf, &stock.clearance, &stock.toolDiameter,
                               &stock.leadIn, &stock.bumps})
            *length *= k;
        stock.sheet *= k;
        stock.density /= k;
        pointer = std::make_shared<const Stock>(stock);
    }
    for (Load &load : scaled.loads) {
        load.mass *= k * k;
        load.filled *= k * k;
        load.push *= k * k;
        load.width *= k;
        load.height *= k;
    }
    return scaled;
}

/// What there is in a section's frame, with another origin.
Region moved(Region region, const Vec2 &by)
{
    for (Vec2 &p : region.outer)
        p += by;
    for (Polygon &hole : region.holes)
        for (Vec2 &p : hole)
            p += by;
    return region;
}

std::vector<SlitLine> moved(std::vector<SlitLine> slits, const Vec2 &by)
{
    for (SlitLine &slit : slits)
        slit.root += by;
    return slits;
}

std::vector<AppliedForce> moved(std::vector<AppliedForce> forces, const Vec2 &by)
{
    for (AppliedForce &force : forces) {
        force.at += by;
        force.slit.root += by;
    }
    return forces;
}

/// Which neck is not as strained as the same one of the other; empty when all are.
QString differenceOf(const SectionStress &first, const SectionStress &second)
{
    if (first.necks.size() != second.necks.size() || first.isWorkedOut != second.isWorkedOut)
        return QStringLiteral("%1 necks, %2").arg(first.necks.size()).arg(second.necks.size());
    double largest = 0.0;
    for (const NeckStress &neck : first.necks)
        largest = std::max(largest, neck.cornerUse);
    for (std::size_t i = 0; i < first.necks.size(); ++i) {
        const NeckStress &here = first.necks[i], &there = second.necks[i];
        if (here.kind == SampleKind::Refined) // looked for, step by step
            continue;
        if (here.kind != there.kind || std::abs(here.length - there.length) > kSameLength ||
            std::abs(here.cornerUse - there.cornerUse) > kExact * largest)
            return QStringLiteral("%1 at %2; %3 at %4")
                .arg(here.cornerUse, 0, 'g', 12)
                .arg(told(here))
                .arg(there.cornerUse, 0, 'g', 12)
                .arg(told(there));
    }
    return {};
}

QString placeOf(const Strength &strength, bool isCorner)
{
    const int body = isCorner ? strength.worst : strength.worstNeck;
    if (body < 0)
        return QStringLiteral("nowhere");
    const BodyStrength &weak = strength.bodies[static_cast<std::size_t>(body)];
    return told(isCorner ? weak.corner : weak.neck);
}

/// What links and feet carry under so much of what hangs on it; which of them are at a bound.
struct Carried
{
    std::vector<double> forces;
    std::vector<bool> bounds;
};

Carried carriedUnder(const Strength &given, double factor)
{
    Structure structure = given.made.structure;
    for (MemberLoad &load : structure.loads) {
        load.force *= factor;
        load.moment *= factor;
    }
    const Equilibrium solved = solveEquilibrium(structure, {});
    Carried carried;
    for (const LinkForce &link : solved.links) {
        for (int i = 0; i < 3; ++i) {
            carried.forces.push_back(link.onA.force[i]);
            carried.forces.push_back(link.onA.moment[i] / structure.size);
        }
        carried.bounds.push_back(link.isOpen);
    }
    for (const FootForce &foot : solved.feet) {
        carried.forces.push_back(foot.force.y());
        carried.bounds.push_back(foot.isPressing);
    }
    return carried;
}

/// Of the sections as they are cut, in hundredths of mm².
std::vector<long> areasOf(const Document &document)
{
    std::vector<long> areas;
    for (const CutSectionPointer &cut : analysed(document).cuts)
        areas.push_back(std::lround(100.0 * cut->area()));
    return areas;
}

} // namespace

class TestStrengthLaws : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onTheTable_data() { models(); }
    void onTheTable();
    void mirrorImage_data() { models(); }
    void mirrorImage();
    void orderOfSections_data() { models(); }
    void orderOfSections();
    void aWeightInTwo_data() { models(); }
    void aWeightInTwo();
    void anotherUnit_data() { models(); }
    void anotherUnit();
    void inProportion_data() { models(); }
    void inProportion();
    void carriedByTheGround_data() { models(); }
    void carriedByTheGround();
    void anotherGrid_data() { models(); }
    void anotherGrid();
    void anotherOrigin_data() { models(); }
    void anotherOrigin();

private:
    void models();
    std::vector<QString> m_names;
};

void TestStrengthLaws::models()
{
    QTest::addColumn<QString>("name");
    if (m_names.empty())
        m_names = lawModels(kDrawings, kCrates);
    for (const QString &name : m_names)
        QTest::newRow(qPrintable(name)) << name;
}

// Wrong: it hangs on where on the table a model stands, and how it is turned there.
void TestStrengthLaws::onTheTable()
{
    QFETCH(QString, name);
    const Document document = lawModel(name);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3::UnitY()).toRotationMatrix();
    const Vec3 by(137.0, 0.0, -59.0);
    const QString difference = differenceOf(
        answerOf(document), answerOf(placed(document, turn, by)), boundOf(name),
        [&](const Vec3 &p) -> Vec3 { return turn * p + by; },
        [&](const Vec3 &f) -> Vec3 { return turn * f; });
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

// Wrong: left and right are not alike. Sections keep what lies in their planes; their normals turn
// round, so that pushes across them do, too.
void TestStrengthLaws::mirrorImage()
{
    QFETCH(QString, name);
    const Document document = lawModel(name);
    const Eigen::Matrix3d mirror = Vec3(-1.0, 1.0, 1.0).asDiagonal();
    Document image = placed(document, mirror, Vec3::Zero());
    for (Load &load : image.loads)
        load.push.z() = -load.push.z();
    if (areasOf(document) != areasOf(image))
        return; // of two ways to cut a joint that are as good the axis decides, which turns round
    const auto mirrored = [&](const Vec3 &v) -> Vec3 { return mirror * v; };
    const QString difference =
        differenceOf(answerOf(document), answerOf(image), boundOf(name), mirrored, mirrored);
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

// Wrong: who is first in the list counts, or which of a joint's two sections is called a.
void TestStrengthLaws::orderOfSections()
{
    QFETCH(QString, name);
    const Document document = lawModel(name);
    const StrengthAnswer first = answerOf(document);
    Document reversed = document; // swaps the pair of every joint
    std::reverse(reversed.sections.begin(), reversed.sections.end());
    const QString swapped = differenceOf(first, answerOf(reversed), boundOf(name));
    QVERIFY2(swapped.isEmpty(), qPrintable(swapped));
    Document shuffled = document;
    std::mt19937 random(7);
    for (std::size_t i = shuffled.sections.size(); i > 1; --i)
        std::swap(shuffled.sections[i - 1], shuffled.sections[random() % i]);
    const QString difference = differenceOf(first, answerOf(shuffled), boundOf(name));
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

// Wrong: two glasses of water at a place weigh something else than one of twice as much.
void TestStrengthLaws::aWeightInTwo()
{
    QFETCH(QString, name);
    const Document document = lawModel(name);
    Document halves = document;
    for (const Load &whole : document.loads) {
        Load half = whole;
        half.id = LoadId{halves.nextId++};
        half.mass *= 0.5;
        half.filled *= 0.5;
        half.push *= 0.5;
        halves.loads.push_back(half);
        Load &other = *std::find_if(halves.loads.begin(), halves.loads.end(),
                                    [&](const Load &load) { return load.id == whole.id; });
        half.id = other.id;
        other = half;
    }
    const QString difference = differenceOf(answerOf(document), answerOf(halves), kRounding);
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

// Wrong: a length is hidden in it: one of a plate, a joint, a corner. Between lines of the grid
// there are 1 to 10 mm whatever the unit, so that another grid is laid over the sections; what is
// nearer to the ground than 0.05 mm stands on it, so that feet move where a contour is nearly
// level.
void TestStrengthLaws::anotherUnit()
{
    QFETCH(QString, name);
    constexpr double kUnit = 1.25;
    const bool isPointed = name == QLatin1String("cutlery_man.fff");
    const LawBound bound{isPointed ? kOfPointedFeet : kOfTheGrid, 1.0, kFeet, false};
    const Document document = lawModel(name);
    StrengthRules rules;
    rules.notch.radius *= kUnit;
    rules.snugGrip *= kUnit * kUnit;
    const QString difference = differenceOf(
        answerOf(document), answerOf(inAnotherUnit(document, kUnit), rules), bound,
        [&](const Vec3 &p) -> Vec3 { return kUnit * p; },
        [&](const Vec3 &f) -> Vec3 { return kUnit * kUnit * f; });
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

// Wrong: forces are not in proportion while the same feet press and the same joints hold.
void TestStrengthLaws::inProportion()
{
    QFETCH(QString, name);
    const Analysis analysis = analysed(lawModel(name));
    StrengthCaches caches;
    const Strength strength = forcesIn(analysis, {}, caches);
    const Carried none = carriedUnder(strength, 0.0), once = carriedUnder(strength, 1.0),
                  twice = carriedUnder(strength, 2.0);
    if (none.bounds != once.bounds || once.bounds != twice.bounds)
        QSKIP("something lifts off, or is pulled open, in between");
    double largest = 0.0;
    for (const double force : twice.forces)
        largest = std::max(largest, std::abs(force));
    for (std::size_t i = 0; i < once.forces.size(); ++i)
        QVERIFY(std::abs(twice.forces[i] - 2.0 * once.forces[i] + none.forces[i]) <=
                kExact * largest);
}

// Wrong: the ground carries more or less than there is.
void TestStrengthLaws::carriedByTheGround()
{
    QFETCH(QString, name);
    const StrengthAnswer answer = answerOf(lawModel(name));
    if (answer.balance != Balance::Stands)
        QSKIP("it does not stand");
    Vec3 all = Vec3::Zero(); // along the ground's upright, which leans where the model does
    for (const auto &[point, force] : answer.feet)
        all += force;
    const double sum = all.norm();
    QVERIFY(answer.weight > 0.0);
    QVERIFY2(std::abs(sum - answer.weight) <= kExact * answer.weight,
             qPrintable(QString::number(sum / answer.weight - 1.0)));
}

// Wrong: where the lines of the grid happen to lie decides how strong a model is.
void TestStrengthLaws::anotherGrid()
{
    QFETCH(QString, name);
    const Analysis analysis = analysed(lawModel(name));
    StrengthCaches caches;
    const Strength strength = strengthOf(analysis, {}, caches);
    for (const double shift : {0.15, 0.85}) {
        StrengthCaches shifted;
        for (int i = 0; i < static_cast<int>(analysis.bodies.size()); ++i) {
            const PieceShape shape(analysis.bodies.at(i).outline().region, slitsOf(analysis, i));
            shifted.cuts[analysis.bodies.pointer(i)] = std::make_shared<const SectionCuts>(
                shape, SampleOptions{.spacing = 0.0, .gridShift = shift});
        }
        const Strength other = strengthOf(analysis, {}, shifted);
        for (const bool isCorner : {false, true}) {
            const double here = isCorner ? strength.cornerUse : strength.neckUse;
            const double there = isCorner ? other.cornerUse : other.neckUse;
            const QString both = QStringLiteral("%1 at %2; by %3 %4 at %5")
                                     .arg(here)
                                     .arg(placeOf(strength, isCorner))
                                     .arg(shift)
                                     .arg(there)
                                     .arg(placeOf(other, isCorner));
            QVERIFY2(std::abs(there - here) <= kOfTheGrid * std::max({here, there, 1.0}),
                     qPrintable(both));
        }
    }
}

// Wrong: rounding decides where a ray ends that grazes a corner, on which side of a cut a force
// acts that lies on it, which of two places is the nearest.
void TestStrengthLaws::anotherOrigin()
{
    QFETCH(QString, name);
    const Analysis analysis = analysed(lawModel(name));
    StrengthCaches caches;
    const Strength strength = strengthOf(analysis, {}, caches);
    SheetMaterial sheet;
    sheet.arealWeight = Vec3(1e-5, -2e-5, 1e-5);
    for (int i = 0; i < static_cast<int>(analysis.bodies.size()); ++i) {
        const auto found = caches.shares.find(analysis.bodies.pointer(i));
        if (found == caches.shares.end())
            continue;
        const Region &region = analysis.bodies.at(i).outline().region;
        const std::vector<SlitLine> slits = slitsOf(analysis, i);
        const std::vector<AppliedForce> &forces = found->second->forces;
        const SectionStress here = stressOf(SectionCuts(PieceShape(region, slits)), forces, sheet);
        for (const Vec2 &by : {Vec2(1.0 / 3.0, -1.0 / 7.0), Vec2(-17.1, 0.123456789)}) {
            const SectionCuts cuts(PieceShape(moved(region, by), moved(slits, by)));
            const QString difference = differenceOf(here, stressOf(cuts, moved(forces, by), sheet));
            QVERIFY2(difference.isEmpty(), qPrintable(difference));
        }
    }
}

FFF_TEST(TestStrengthLaws)
#include "tst_strength_laws.moc"
