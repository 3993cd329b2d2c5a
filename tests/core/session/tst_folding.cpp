// Fingers turn like hinges: sheets that nothing else holds fold, and that is said.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/cutting.h"
#include "core/analysis/findings/pulled_joints.h"
#include "core/analysis/findings/standing.h"
#include "core/analysis/findings/strength_findings.h"
#include "core/analysis/holding.h"
#include "core/model/edits.h"
#include "core/model/load_edits.h"
#include "core/operations/facet_model.h"
#include "core/session/finding_text.h"
#include "tests/core/analysed.h"
#include "tests/core/session/all_findings.h"
#include "tests/core/session/staged.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

/// Faces of a box, 100 × 80 × 60 mm, on the ground.
MeshDraft sidesOf(const std::string &sides)
{
    const Vec3 low(0.0, 0.0, 0.0), high(100.0, 80.0, 60.0);
    MeshDraft draft;
    for (int i = 0; i < 8; ++i)
        addPoint(draft, {i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                         i & 4 ? high.z() : low.z()});
    for (const char side : sides)
        switch (side) {
        case 'b': // back
            addQuad(draft, 0, 2, 3, 1);
            break;
        case 'f': // front
            addQuad(draft, 4, 5, 7, 6);
            break;
        case 'g': // at the ground
            addQuad(draft, 0, 1, 5, 4);
            break;
        case 't': // top
            addQuad(draft, 2, 6, 7, 3);
            break;
        case 'l':
            addQuad(draft, 0, 4, 6, 2);
            break;
        case 'r':
            addQuad(draft, 1, 3, 7, 5);
            break;
        default:
            qFatal("no such side");
        }
    return draft;
}

/// A sheet on the ground and one that leans out from its edge, by that from upright, degrees.
MeshDraft leaning(double degrees)
{
    const double angle = degrees / 180.0 * std::numbers::pi;
    const Vec3 up(-80.0 * std::sin(angle), 80.0 * std::cos(angle), 0.0);
    MeshDraft draft;
    for (const double z : {0.0, 100.0})
        for (const Vec3 &p : {Vec3(100.0, 0.0, 0.0), Vec3(0.0, 0.0, 0.0), up})
            addPoint(draft, p + Vec3(0.0, 0.0, z));
    addQuad(draft, 0, 3, 4, 1);
    addQuad(draft, 1, 4, 5, 2);
    return draft;
}

Document facetsOf(const MeshDraft &draft, double clearance)
{
    Document document = newDocument();
    Stock stock = *document.stocks.front();
    stock.clearance = clearance;
    document = setStock(std::move(document), stock).value();
    return facetModel(std::move(document), *meshOf(draft), "Sheet").value().document;
}

const Finding *foldsIn(const std::vector<Finding> &findings)
{
    return find(findings, kFolds);
}

std::vector<Finding> judged(const Document &document)
{
    return holdingOf(std::make_shared<const Analysis>(analysed(document)), {},
                     std::make_shared<StrengthCaches>())
        .findings;
}

QString namesOf(const std::vector<Finding> &findings)
{
    QStringList names;
    for (const Finding &finding : findings)
        names += QString::fromLatin1(finding.kind->name);
    return names.join(QStringLiteral(", "));
}

} // namespace

class TestFolding : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyWhatNothingElseHolds_data();
    void onlyWhatNothingElseHolds();
    void aLidIsNotHeldByItsFingers();
    void whatFoldsDoesNotStand();
    void aKerfWiderThanTheirGapsIsRefused();
};

void TestFolding::onlyWhatNothingElseHolds_data()
{
    QTest::addColumn<MeshDraft>("draft");
    QTest::addColumn<bool>("folds");
    QTest::newRow("a wall on a base") << sidesOf("gl") << true;
    QTest::newRow("a wall that leans out") << leaning(30.0) << true;
    QTest::newRow("a wall that leans in") << leaning(-30.0) << true;
    QTest::newRow("a lid on one wall") << sidesOf("glt") << true;
    QTest::newRow("a tube on its side") << sidesOf("gltr") << true;
    QTest::newRow("a corner of three") << sidesOf("glb") << false;
    QTest::newRow("a tube with an end") << sidesOf("gltrb") << false;
    QTest::newRow("an open box") << sidesOf("glrbf") << false;
    QTest::newRow("a box") << sidesOf("glrbft") << false;
}

void TestFolding::onlyWhatNothingElseHolds()
{
    QFETCH(MeshDraft, draft);
    QFETCH(bool, folds);
    // A tight fit holds a little by friction, which is not what is asked here.
    for (const double clearance : {0.1, 0.2}) {
        const std::vector<Finding> findings = judged(facetsOf(draft, clearance));
        QCOMPARE(foldsIn(findings) != nullptr, folds);
        QVERIFY2((find(findings, kHolds) != nullptr) == !folds, qPrintable(namesOf(findings)));
    }
}

// Wrong: it did not say in which order the sheets came, and one of the two ways off held anything.
void TestFolding::aLidIsNotHeldByItsFingers()
{
    for (const char *sides : {"glrbft", "tglrbf"}) {
        const Document document = facetsOf(sidesOf(sides), 0.1);
        Load push;
        push.kind = LoadKind::Push;
        push.push = Vec3(0.0, 0.0, 0.3); // outwards: more than the lid weighs, less than the box
        for (const SectionPointer &section : document.sections)
            if (section->frame.normal().y() > 0.9)
                push.section = section->id;
        const std::vector<Finding> findings = judged(addLoad(document, push).value());
        QVERIFY(find(findings, kHolds) == nullptr);
        const Finding *pulled = find(findings, kPulledOpen);
        QVERIFY2(pulled && pulled->severity == Severity::Error, qPrintable(namesOf(findings)));
    }
}

// Wrong: "Stands. Tips only past 63°" was green beside "Folds".
void TestFolding::whatFoldsDoesNotStand()
{
    for (const auto &[sides, folds] : {std::pair("glt", true), std::pair("glb", false)}) {
        const Staged all = staged(facetsOf(sidesOf(sides), 0.1));
        QCOMPARE(foldsIn(all.found) != nullptr, folds);
        QCOMPARE(find(all.found, kStands) == nullptr, folds);
        const Finding *would = find(all.found, kWouldStand);
        QCOMPARE(would != nullptr, folds);
        if (folds)
            QVERIFY(findingText(*would, all.analysis->model)
                        .startsWith(QStringLiteral("Would stand if it did not fold. ")));
    }
}

// Wrong: such gaps were left out of the file without a word.
void TestFolding::aKerfWiderThanTheirGapsIsRefused()
{
    Document document = facetsOf(sidesOf("glrbft"), 0.1);
    for (const bool closes : {false, true}) {
        Stock stock = *document.stocks.front();
        stock.kerf = closes ? 12.0 : 8.0; // of gaps of about 10 mm
        const Analysis analysis = analysed(setStock(document, stock).value());
        CuttingOptions options;
        options.compensatesKerf = true;
        const Result<Cutting> cutting = makeCutting(analysis, options);
        QCOMPARE(!cutting && cutting.error().code == ErrorCode::ClosedSlit, closes);
    }
}

FFF_TEST(TestFolding)
#include "tst_folding.moc"
