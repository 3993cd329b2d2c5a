// Whether a model holds, from the model to the verdict: what the stresses are is tested in physics.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/bearable_mass.h"
#include "core/io/document_file.h"
#include "core/model/edits.h"
#include "core/model/load_edits.h"
#include "core/operations/evaluate.h"
#include "tests/test_program.h"
#include "tests/told.h"

#include <QDir>

#include <cmath>

using namespace fff;
using namespace fff::test;
using namespace Qt::Literals::StringLiterals;

namespace {

Analysis analysisOf(const Document &document)
{
    AnalysisCaches caches;
    return analyse(evaluate(document), caches);
}

Document fileOf(const QString &path)
{
    const auto loaded = io::readDocument(path);
    return loaded ? loaded->document : Document();
}

Document sample(const char *name)
{
    return fileOf(QStringLiteral(FFF_SAMPLES) + u'/' + QLatin1String(name));
}

Strength strengthOf(const Document &document)
{
    StrengthCaches caches;
    return fff::strengthOf(analysisOf(document), {}, caches);
}

double weightOf(const Structure &structure)
{
    double sum = 0.0;
    for (const Member &member : structure.members)
        sum += member.mass * structure.gravity.norm();
    for (const MemberLoad &load : structure.loads)
        sum -= load.force.dot(structure.up);
    return sum;
}

double carriedOf(const Strength &strength)
{
    double sum = 0.0;
    for (const FootForce &foot : strength.equilibrium().feet)
        sum += foot.force.dot(strength.made.structure.up);
    return sum;
}

Document withWeights(Document document, double factor)
{
    for (Load &weight : document.loads)
        weight.mass *= factor;
    return document;
}

/// All drawn sections elsewhere on the ground; of a document without operations.
Document moved(Document document, double angle, const Vec3 &by)
{
    const Eigen::AngleAxisd turn(angle, Vec3::UnitY());
    for (SectionPointer &pointer : document.sections) {
        Section section = *pointer;
        section.frame.origin = turn * section.frame.origin + by;
        section.frame.x = turn * section.frame.x;
        section.frame.y = turn * section.frame.y;
        pointer = std::make_shared<const Section>(std::move(section));
    }
    return document;
}

} // namespace

class TestStrength : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void glassesOfThePaper_data();
    void glassesOfThePaper();
    void models_data();
    void models();
    void glasses();
    void weightsAreBornNearly();
    void movedAlongTheGround();
    void weightBesideItsSection();
    void nothing();
    void unknownStrength();
    void whatStaysWeakensAcrylic();
    void ductileStockYields();
};

void TestStrength::models_data()
{
    QTest::addColumn<QString>("path");
    const auto add = [](const QString &folder, const QString &kind) {
        for (const QFileInfo &file :
             QDir(folder).entryInfoList({u"*."_s + kind}, QDir::Files, QDir::Name))
            QTest::newRow(qPrintable(file.fileName())) << file.filePath();
    };
    add(QStringLiteral(FFF_SAMPLES), u"fff"_s);
    add(QStringLiteral(FFF_SHARED_MODELS), u"txt"_s);
}

// Wrong: forces that balance nothing, 1e28 MPa, or a number for what was not worked out.
void TestStrength::models()
{
    QFETCH(QString, path);
    const Strength strength = strengthOf(fileOf(path));
    const Structure &structure = strength.made.structure;
    QVERIFY(strength.verdict != HoldVerdict::NotWorkedOut);
    QVERIFY(std::isfinite(strength.cornerUse));
    for (const Equilibrium &solution : strength.envelope)
        QVERIFY2(solution.worstResidual <= 1e-9,
                 qPrintable(QString::number(solution.worstResidual)));
    for (const BodyStrength &body : strength.bodies) {
        QVERIFY(!body.neck || body.neck->stress.neck < 1000.0); // MPa
        QVERIFY(!body.corner || body.corner->stress.corner < 1000.0);
    }
    if (strength.equilibrium().balance() == Balance::Stands)
        QVERIFY(std::abs(carriedOf(strength) - weightOf(structure)) < 1e-9 * weightOf(structure));
}

// Wrong: three legs bear what four do, or a glass weighs nothing.
void TestStrength::glasses()
{
    const Strength four = strengthOf(sample("glass_four_legs.fff"));
    const Strength three = strengthOf(sample("glass_three_legs.fff"));
    QCOMPARE(four.equilibrium().balance(), Balance::Stands);
    QCOMPARE(three.equilibrium().balance(), Balance::Stands);
    QVERIFY(four.cornerUse > 0.0);
    QVERIFY(three.cornerUse > four.cornerUse);
    QVERIFY(four.made.structure.loads.size() > 0);
    const Strength heavy = strengthOf(withWeights(sample("glass_four_legs.fff"), 100.0));
    QCOMPARE(heavy.verdict, HoldVerdict::Breaks);
}

// Wrong: a mass is named at which it does not crack, or has long since.
void TestStrength::weightsAreBornNearly()
{
    const Document document = sample("glass_three_legs.fff");
    const Analysis analysis = analysisOf(document);
    StrengthCaches caches;
    const Strength strength = fff::strengthOf(analysis, {}, caches);
    const BearableMass bearable = bearableMass(analysis, strength, {}, caches);
    QVERIFY(bearable.cracksFrom && bearable.breaksAt);
    QVERIFY(*bearable.cracksFrom < *bearable.breaksAt);
    double placed = 0.0;
    for (const Load &weight : document.loads)
        placed += weight.mass;
    const Strength cracking = strengthOf(withWeights(document, *bearable.cracksFrom / placed));
    const Strength breaking = strengthOf(withWeights(document, *bearable.breaksAt / placed));
    QVERIFY2(std::abs(cracking.cornerUse - 1.0) < 1e-3,
             qPrintable(QString::number(cracking.cornerUse)));
    QVERIFY2(std::abs(breaking.neckUse - 1.0) < 1e-3,
             qPrintable(QString::number(breaking.neckUse)));
}

// Wrong: it hangs on where on the table it stands.
void TestStrength::movedAlongTheGround()
{
    const Document document = sample("cutlery_man.fff");
    QVERIFY(document.operations.empty());
    const Strength here = strengthOf(document);
    const Strength there = strengthOf(moved(document, 0.7, {137.0, 0.0, -59.0}));
    QCOMPARE(there.verdict, here.verdict);
    QCOMPARE(there.bodies.size(), here.bodies.size());
    QVERIFY2(std::abs(there.cornerUse - here.cornerUse) < 1e-4 * here.cornerUse,
             qPrintable(QString::number(there.cornerUse / here.cornerUse, 'g', 12)));
}

// Wrong: a weight in the air is borne by nobody, or nobody hears of it.
void TestStrength::weightBesideItsSection()
{
    Document document = sample("glass_four_legs.fff");
    document.loads.front().spread = Spread::Point; // one force
    Load weight;
    weight.section = document.sections.front()->id;
    weight.position = {1e4, 1e4};
    weight.mass = 1e-3;
    document = *addLoad(std::move(document), weight);
    const Strength strength = strengthOf(document);
    QCOMPARE(strength.made.besideLoads.size(), std::size_t{1});
    QCOMPARE(strength.made.structure.loads.size(), document.loads.size());
    weight.section = SectionRef(OperationId{77}, "3"); // that is not there now
    document.loads.push_back(weight);
    QCOMPARE(strengthOf(document).made.structure.loads.size(), document.loads.size() - 1);
}

// Wrong: a crash, or a verdict on nothing.
void TestStrength::nothing()
{
    const Strength strength = strengthOf(newDocument());
    QCOMPARE(strength.verdict, HoldVerdict::Unstable);
    QCOMPARE(strength.worst, -1);
}

// Wrong: acrylic that is said to hold a shelf for years by what it bears in a test of a minute.
void TestStrength::whatStaysWeakensAcrylic()
{
    const Document document = sample("acrylic_thick_four.fff");
    const auto judged = [&](double share, bool isLasting) {
        Stock stock = *document.stocks[0];
        stock.lastingShare = share;
        AnalysisCaches caches;
        const Analysis analysis =
            *analyseNext(evaluate(*setStock(document, std::move(stock))), caches);
        StrengthRules rules;
        rules.isLasting = isLasting;
        StrengthCaches known;
        return fff::strengthOf(analysis, rules, known);
    };
    const Strength today = judged(0.25, false), months = judged(0.25, true),
                   other = judged(1.0, true);
    QCOMPARE(today.verdict, HoldVerdict::Holds);
    QVERIFY(std::abs(months.cornerUse - 4.0 * today.cornerUse) < 1e-9);
    QVERIFY(std::abs(months.neckUse - 4.0 * today.neckUse) < 1e-9);
    QCOMPARE(months.verdict, HoldVerdict::BarelyHolds);
    QCOMPARE(other.cornerUse, today.cornerUse);
}

// Von Mises lets bear more shear than the first principal stress only where there is tension, too:
// what is ductile is never strained more than twice as much, and differs where something shears.
void TestStrength::ductileStockYields()
{
    Document document = sample("acrylic_thick_four.fff");
    const Strength brittle = strengthOf(document);
    Stock stock = *document.stocks[0];
    stock.isDuctile = true;
    const Strength ductile = strengthOf(*setStock(document, stock));
    QVERIFY(ductile.neckUse >= brittle.neckUse * (1.0 - 1e-9));
    QVERIFY(ductile.neckUse <= 2.0 * brittle.neckUse);
    QVERIFY(ductile.neckUse != brittle.neckUse);
}

// Wrong: green for a sheet of which nobody knows what it bears.
void TestStrength::unknownStrength()
{
    Document document = sample("glass_four_legs.fff");
    for (auto &pointer : document.stocks) {
        Stock stock = *pointer;
        stock.tensileStrength = stock.flexuralStrength = {};
        pointer = std::make_shared<const Stock>(stock);
    }
    const Strength strength = strengthOf(document);
    QCOMPARE(strength.verdict, HoldVerdict::NotRated);
    QCOMPARE(strength.cornerUse, 0.0);
}

void TestStrength::glassesOfThePaper_data()
{
    QTest::addColumn<HoldVerdict>("verdict");
    QTest::addColumn<double>("least"); // of what is in the glass when it cracks, kg
    QTest::addColumn<double>("most");
    constexpr double kGlass = 0.275, kFull = 0.625;
    QTest::newRow("acrylic_thin_three.fff") << HoldVerdict::Breaks << 0.1 << kGlass;
    QTest::newRow("acrylic_thin_four.fff") << HoldVerdict::Breaks << kGlass << kFull;
    QTest::newRow("acrylic_thick_three.fff") << HoldVerdict::BarelyHolds << kFull << 2.0 * kFull;
    QTest::newRow("acrylic_thick_four.fff") << HoldVerdict::Holds << 2.0 * kFull << 10.0;
}

/// Source  J. McCrae et al. 2014, figure 17: three thin legs break before the glass is full, four
/// as
///         well, three thick ones may at their slits, four hold.
void TestStrength::glassesOfThePaper()
{
    QFETCH(HoldVerdict, verdict);
    QFETCH(double, least);
    QFETCH(double, most);
    const Document document = sample(QTest::currentDataTag());
    QCOMPARE(document.loads.size(), std::size_t(1));
    QCOMPARE(document.loads[0].mass, 0.625);
    QCOMPARE(document.stocks[0]->density, 1190.0);
    QCOMPARE(*fff::strengthOf(*document.stocks[0]), 60.0);
    AnalysisCaches caches;
    const Analysis analysis = *analyseNext(evaluate(document), caches);
    StrengthCaches known;
    const Strength strength = fff::strengthOf(analysis, {}, known);
    QCOMPARE(strength.verdict, verdict);
    const BearableMass bearable = bearableMass(analysis, strength, {}, known);
    QVERIFY(bearable.cracksFrom && bearable.breaksAt);
    QVERIFY2(*bearable.cracksFrom > least && *bearable.cracksFrom < most,
             qPrintable(QString::number(*bearable.cracksFrom)));
    if (verdict == HoldVerdict::BarelyHolds) // where leg and disc meet
        QVERIFY(*bearable.breaksAt > 2.0 * *bearable.cracksFrom);
}

FFF_TEST(TestStrength)
#include "tst_strength.moc"
