// Parts as they are cut, put in place: real models and made-up assemblies of sections at all
// angles, with contours that run in and out, windows, arms and equal heights. If this fails, what
// was cut does not go together.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/units.h"
#include "core/io/document_file.h"
#include "core/model/operation_edits.h"
#include "core/model/template_edits.h"
#include "core/operations/slices.h"
#include "core/templates/template_mesh.h"
#include "tests/core/assembly/plan_replay.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/templates/made_forms.h"
#include "tests/test_program.h"

#include <QDir>

#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

using Random = std::mt19937_64;

double between(Random &random, double low, double high)
{
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

/// About the origin, in and out three to seven times.
Polygon wavy(Random &random, double radius)
{
    Polygon polygon;
    const double waves = std::floor(between(random, 3.0, 8.0));
    const double phase = between(random, 0.0, 6.0), height = between(random, 0.1, 0.35);
    constexpr int kPoints = 90;
    for (int i = 0; i < kPoints; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kPoints;
        const double r = radius * (1.0 + height * std::sin(waves * angle + phase));
        polygon.push_back(r * Vec2(std::cos(angle), std::sin(angle)));
    }
    return polygon;
}

/// A post at the left with arms to the right, each of which crosses the middle.
Polygon arms(Random &random, double size)
{
    const int count = 2 + static_cast<int>(random() % 2);
    const double step = 2.0 * size / (2 * count - 1);
    Polygon polygon{{-size, -size}};
    for (int i = 0; i < count; ++i) {
        const double reach = between(random, 0.5, 1.0) * size, low = -size + 2 * i * step;
        polygon.push_back({reach, low});
        polygon.push_back({reach, low + step});
        if (i + 1 < count) {
            const double inner = -between(random, 0.4, 0.7) * size;
            polygon.push_back({inner, low + step});
            polygon.push_back({inner, low + 2 * step});
        }
    }
    polygon.push_back({-size, size});
    return polygon;
}

ShapePointer madeUpShape(Random &random)
{
    const double size = between(random, 30.0, 80.0);
    switch (random() % 5) {
    case 0:
        return polygonShape(rectangle(-size, -40, size, 40)); // often as high as the other
    case 1:
        return polygonShape(arms(random, size));
    case 2: { // a window beside the middle
        const double at = between(random, 0.3, 0.5) * size, half = between(random, 3.0, 8.0);
        return polygonShape(wavy(random, size), {rectangle(at - half, -half, at + half, half)});
    }
    default:
        return polygonShape(wavy(random, size));
    }
}

struct Assembled
{
    Analysis analysis;
    ModelPlan plan;
};

/// Two to five sections that cross at 20° to 90°, wherever they meet with slits.
Assembled madeUpAssembly(Random &random)
{
    while (true) {
        Document document = newDocument();
        Stock stock = *document.stocks.front();
        stock.thickness = between(random, 2.0, 6.0);
        stock.clearance = 0.0;
        document = *setStock(std::move(document), stock);
        document = withSection(std::move(document), madeUpShape(random), front());
        const int count = 2 + static_cast<int>(random() % 4);
        for (int i = 1; i < count; ++i) {
            const double angle = random() % 3 == 0 ? 90.0 : between(random, 20.0, 160.0);
            Frame frame = turned(radians(angle));
            if (random() % 2 == 0)
                frame.origin.y() = between(random, -40.0, 40.0);
            if (i > 1) { // beside the others, some leaning over
                frame.origin.x() = between(random, -60.0, 60.0);
                if (random() % 2 == 0)
                    frame.y =
                        Vec3(Eigen::AngleAxisd(between(random, -1.0, 1.0), frame.x) * frame.y);
            }
            document = withSection(std::move(document), madeUpShape(random), frame);
        }
        AnalysisCaches caches;
        Assembled made{analyse(evaluate(document), caches), {}};
        const JointList &joints = made.analysis.assembly.joints;
        if (joints.empty() || std::any_of(joints.begin(), joints.end(), [](const Joint &joint) {
                return joint.kind == JointKind::None || joint.crossing->angle < radians(20.0);
            }))
            continue;
        made.plan = planOf(made.analysis);
        return made;
    }
}

/// Pairs of parts that are in each other.
std::set<std::pair<int, int>> inEachOther(const std::vector<CutPlate> &plates)
{
    std::set<std::pair<int, int>> pairs;
    for (int i = 0; i < static_cast<int>(plates.size()); ++i)
        for (int k = i + 1; k < static_cast<int>(plates.size()); ++k)
            if (areInEachOther(plates[static_cast<std::size_t>(i)],
                               plates[static_cast<std::size_t>(k)]))
                pairs.emplace(i, k);
    return pairs;
}

QByteArray named(const std::pair<int, int> &pair, const Assembled &made)
{
    const auto name = [&](int part) {
        const Body &body = made.analysis.bodies.at(part);
        return QByteArray::number(made.analysis.bodies.sectionOf(part)) + '.' +
               QByteArray::number(static_cast<int>(body.piece()));
    };
    return name(pair.first) + " and " + name(pair.second);
}

/// Whether a joint's slits hold the two parts.
const Joint *jointOf(const Assembled &made, const std::pair<int, int> &pair)
{
    const auto section = [&](int part) { return made.analysis.bodies.sectionOf(part); };
    return made.analysis.assembly.joints.find(section(pair.first), section(pair.second));
}

/// Whose slits at a right angle leave a gap of 1 µm between their bottoms; empty: nobody's.
QByteArray looseSlits(const Assembled &made, int &looked)
{
    // Files have six digits; so much off, a slab's edge is off by less than a quarter of a µm.
    constexpr double kRight = 1e-4; // radians
    const std::vector<CutPlate> plates = platesOf(made.analysis.bodies);
    for (const Slide &slide : slidesOf(made.analysis)) {
        const Joint *joint = jointOf(made, {slide.a, slide.b});
        if (!slidesAlongAxis(joint->kind) ||
            std::abs(joint->crossing->angle - radians(90.0)) > kRight)
            continue;
        ++looked;
        // A gap of 1 µm, and as much as is seen of what is in each other.
        const Vec3 onwards = -2e-3 * slide.direction;
        if (!areInEachOther(plates[static_cast<std::size_t>(slide.a)],
                            plates[static_cast<std::size_t>(slide.b)], onwards, 0.4e-3))
            return named({slide.a, slide.b}, made) + " have slits that leave a gap";
    }
    return {};
}

} // namespace

class TestTheyFit : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void madeUpAssemblies_data();
    void madeUpAssemblies();
    void slitsLeaveNoGap();
    void grids_data();
    void grids();
    void realModels_data();
    void realModels();
    void slitsOfRealModelsLeaveNoGap_data() { realModels_data(); }
    void slitsOfRealModelsLeaveNoGap();
};

constexpr int kAssemblies = 200, kOfRow = 20;

void TestTheyFit::madeUpAssemblies_data()
{
    QTest::addColumn<int>("first");
    for (int first = 0; first < kAssemblies; first += kOfRow)
        QTest::addRow("assemblies %d to %d", first, first + kOfRow - 1) << first;
}

/// What would be wrong: parts that are in each other though slits hold them, or without a word.
void TestTheyFit::madeUpAssemblies()
{
    QFETCH(int, first);
    int withPlan = 0;
    for (int i = first; i < first + kOfRow; ++i) {
        Random random(static_cast<quint64>(i));
        const Assembled made = madeUpAssembly(random);
        const QByteArray name = "assembly " + QByteArray::number(i) + ": ";
        std::set<std::pair<int, int>> said;
        for (const PartOverlap &overlap : made.plan.overlaps)
            said.emplace(overlap.a, overlap.b);
        for (const auto &pair : inEachOther(platesOf(made.analysis.bodies))) {
            QVERIFY2(!jointOf(made, pair),
                     name + named(pair, made) + " are in each other in spite of their slits");
            QVERIFY2(said.contains(pair), name + named(pair, made) + " are in each other unsaid");
        }
        if (made.plan.plan.verdict == AssemblyPlan::Verdict::Possible) {
            ++withPlan;
            QVERIFY2(fault(made.analysis, made.plan).isEmpty(),
                     name + fault(made.analysis, made.plan).toUtf8());
        }
    }
    QVERIFY2(withPlan >= 6, QByteArray::number(withPlan) + " of 20 had a plan");
}

/// What would be wrong: slits that are too deep, so that sections sit loose.
void TestTheyFit::slitsLeaveNoGap()
{
    int looked = 0;
    for (int i = 0; i < kAssemblies; ++i) {
        Random random(static_cast<quint64>(i));
        const Assembled made = madeUpAssembly(random);
        if (made.plan.bodies.size() != 2)
            continue; // a third one may have taken the bottom of a slit away
        const auto loose = looseSlits(made, looked);
        QVERIFY2(loose.isEmpty(), "assembly " + QByteArray::number(i) + ": " + loose);
    }
    QVERIFY2(looked >= 10, QByteArray::number(looked));
}

void TestTheyFit::grids_data()
{
    QTest::addColumn<int>("form");
    for (std::size_t i = 0; i < madeForms().size(); ++i)
        QTest::newRow(madeForms()[i].name) << int(i);
}

/// Meshes as two rows of slices that slide into each other: as with those that are made up.
void TestTheyFit::grids()
{
    QFETCH(const int, form);
    const MadeForm made = madeForms()[std::size_t(form)];
    Template one;
    one.name = made.name;
    one.file = "form.obj";
    one.mesh = makeTemplateMesh(mended(made.draft).value().mesh, {}).value();
    Document document =
        addTemplate(newDocument(),
                    stood(one, *one.mesh, made.isUpright ? UpAxis::Y : UpAxis::Z, 150.0))
            .value();
    Operation slices = newOperation(kSlices);
    slices.subject = document.templates.front()->id;
    slices.parameters.insert_or_assign("direction", std::string("xz"));
    slices.parameters.insert_or_assign("count", 4.0);
    document = addOperation(std::move(document), std::move(slices));
    AnalysisCaches caches;
    Assembled all{analyse(evaluate(document), caches), {}};
    all.plan = planOf(all.analysis);
    QVERIFY(all.analysis.model.sectionCount() >= 4);
    std::set<std::pair<int, int>> said;
    for (const PartOverlap &overlap : all.plan.overlaps)
        said.emplace(overlap.a, overlap.b);
    for (const auto &pair : inEachOther(platesOf(all.analysis.bodies)))
        QVERIFY2(said.contains(pair), named(pair, all) + " are in each other unsaid");
    // Of some forms planes block each other, which is said, and for which others are offered.
    QVERIFY(all.plan.plan.verdict != AssemblyPlan::Verdict::NotFound);
    if (all.plan.plan.verdict == AssemblyPlan::Verdict::Possible)
        QCOMPARE(fault(all.analysis, all.plan), QString());
}

void TestTheyFit::realModels_data()
{
    QTest::addColumn<QString>("path");
    const QDir folder(QStringLiteral(FFF_SHARED_MODELS));
    for (const QString &file : folder.entryList({QStringLiteral("*.txt")}))
        QTest::newRow(qPrintable(file)) << folder.filePath(file);
    if (folder.entryList({QStringLiteral("*.txt")}).isEmpty())
        QTest::newRow("no models here") << QString();
}

/// What would be wrong: as with those that are made up.
void TestTheyFit::realModels()
{
    QFETCH(QString, path);
    if (path.isEmpty())
        FFF_WITHOUT_SHARED();
    const auto loaded = io::readDocument(path);
    QVERIFY(loaded);
    AnalysisCaches caches;
    Assembled made{analyse(evaluate(loaded->document), caches), {}};
    made.plan = planOf(made.analysis);
    std::set<std::pair<int, int>> said;
    for (const PartOverlap &overlap : made.plan.overlaps)
        said.emplace(overlap.a, overlap.b);
    for (const auto &pair : inEachOther(platesOf(made.analysis.bodies)))
        QVERIFY2(said.contains(pair), named(pair, made) + " are in each other unsaid");
    if (made.plan.plan.verdict == AssemblyPlan::Verdict::Possible)
        QCOMPARE(fault(made.analysis, made.plan), QString());
}

/// What would be wrong: as with those that are made up. Each pair alone: a third section may take
/// the bottom of a slit away.
void TestTheyFit::slitsOfRealModelsLeaveNoGap()
{
    QFETCH(QString, path);
    if (path.isEmpty())
        FFF_WITHOUT_SHARED();
    const auto loaded = io::readDocument(path);
    QVERIFY(loaded);
    const Model model = evaluate(loaded->document);
    int looked = 0;
    for (const Joint &joint : assemble(model).joints) {
        Document pair = model.document;
        pair.sections = {model.section(static_cast<std::size_t>(joint.a)),
                         model.section(static_cast<std::size_t>(joint.b))};
        AnalysisCaches caches;
        Assembled made{analyse(evaluate(std::move(pair)), caches), {}};
        made.plan = planOf(made.analysis);
        if (made.plan.bodies.size() != 2)
            continue; // its slits divide one of them: which part was held is not said
        const QByteArray loose = looseSlits(made, looked);
        QVERIFY2(loose.isEmpty(), QByteArray::number(joint.id) + ": " + loose);
    }
    qInfo("%d overlaps at a right angle", looked);
    QVERIFY(looked > 0); // there are some in each of them
}

FFF_TEST(TestTheyFit)
#include "tst_they_fit.moc"
