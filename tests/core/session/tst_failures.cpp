// A section that cannot be cut out, and an operation that fails: all that speaks of the model says
// so.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/checks.h"
#include "core/analysis/plan_checks.h"
#include "core/base/fault_point.h"
#include "core/fabrication/wholeness.h"
#include "core/io/cutting_file.h"
#include "core/io/fff_format.h"
#include "core/io/obj_writer.h"
#include "core/session/assembly_steps.h"
#include "core/session/finding_text.h"
#include "tests/core/operations/operation_models.h"
#include "tests/core/session/all_findings.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

/// One of their slits takes a boolean.
Document crossed()
{
    Document document = newDocument();
    add(document, "Body", shapeOf(circle({0, 40}, 40), {circle({0, 40}, 9)}), frontFrame());
    add(document, "Wing", shapeOf(circle({0, 40}, 30)), sideFrame({3, 0, 0}));
    return document;
}

AnalysisPointer wholeOf(const Model &model)
{
    AnalysisCaches caches;
    return analyseNext(model, caches);
}

/// With the first call of this kind failing.
AnalysisPointer faulty(const Document &document, FaultPoint point)
{
    const Model model = evaluate(document);
    const FaultWatch watch(point, 0);
    AnalysisPointer analysis = wholeOf(model);
    prepareDrawing(*analysis);
    return analysis;
}

/// The one section that failed.
std::size_t failedIn(const Analysis &analysis)
{
    const std::vector<int> missing = sectionsWithoutSolid(analysis.bodies);
    return missing.size() == 1 ? static_cast<std::size_t>(missing.front()) : std::size_t(-1);
}

} // namespace

class TestFailures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatCannotBeCutStaysWhole();
    void noFileIsMade_data();
    void noFileIsMade();
    void checksNameTheSection();
    void thePlanIsUnknown_data();
    void thePlanIsUnknown();
    void aFailedOperationIsSaid();
    void aFailureDoesNotStay();
    void theDocumentIsStillSaved();
};

// Wrong: it would weigh nothing, and the model would stand where it falls.
void TestFailures::whatCannotBeCutStaysWhole()
{
    const Document document = crossed();
    const AnalysisPointer whole = wholeOf(evaluate(document));
    const AnalysisPointer analysis = faulty(document, FaultPoint::Boolean);
    QCOMPARE(uncutSections(whole->bodies), std::vector<int>());
    const std::size_t failed = failedIn(*analysis);
    QVERIFY(failed < 2U);
    QCOMPARE(uncutSections(analysis->bodies), std::vector<int>{static_cast<int>(failed)});
    const CutSection &cut = *analysis->cuts[failed];
    QCOMPARE(cut.failure()->code, ErrorCode::NotWorkedOut);
    QCOMPARE(cut.parts().size(), std::size_t(1));
    QVERIFY(std::abs(cut.area() - document.sections[failed]->shape->area()) < 1e-9);
    QVERIFY(cut.area() > whole->cuts[failed]->area());
    QVERIFY(analysis->bodies.mass().mass > whole->bodies.mass().mass);
    QCOMPARE(analysis->cuts[1 - failed]->area(), whole->cuts[1 - failed]->area());
}

void TestFailures::noFileIsMade_data()
{
    QTest::addColumn<FaultPoint>("point");
    QTest::addColumn<bool>("hasParts");
    QTest::newRow("a boolean") << FaultPoint::Boolean << false;
    QTest::newRow("its curves") << FaultPoint::Curves << false;
    QTest::newRow("its triangles") << FaultPoint::Triangles << true;
}

// Wrong: someone would cut or print a model with a section that is not theirs.
void TestFailures::noFileIsMade()
{
    QFETCH(FaultPoint, point);
    QFETCH(bool, hasParts);
    const AnalysisPointer analysis = faulty(crossed(), point);
    const std::vector<std::string> name{analysis->model.section(failedIn(*analysis))->name};
    const Result<io::CuttingFile> svg = io::makeCuttingFile(*analysis);
    QCOMPARE(svg.has_value(), hasParts);
    if (!hasParts) {
        QCOMPARE(svg.error().code, ErrorCode::NotCutOut);
        QCOMPARE(svg.error().args, name);
    }
    const Result<std::string> obj = io::writeObj(analysis->model, analysis->bodies);
    QVERIFY(!obj);
    QCOMPARE(obj.error().code, hasParts ? ErrorCode::NotSolid : ErrorCode::NotCutOut);
    QCOMPARE(obj.error().args, name);
}

// Wrong: the list of checks would be green for a model that cannot be made.
void TestFailures::checksNameTheSection()
{
    const AnalysisPointer analysis = faulty(crossed(), FaultPoint::Boolean);
    const std::vector<Finding> found = checks(*analysis);
    const Finding *finding = find(found, kNotCutOut);
    QVERIFY(finding);
    QCOMPARE(finding->severity, Severity::Error);
    const std::size_t failed = failedIn(*analysis);
    const QString name = QString::fromStdString(analysis->model.section(failed)->name);
    QCOMPARE(finding->sections, std::vector<SectionRef>{analysis->model.ref(failed)});
    QVERIFY(findingText(*finding, analysis->model).contains(name));
    QVERIFY(!find(checks(*wholeOf(evaluate(crossed()))), kNotCutOut));
}

void TestFailures::thePlanIsUnknown_data()
{
    noFileIsMade_data();
}

// Wrong: a plan would be made for parts that nobody knows.
void TestFailures::thePlanIsUnknown()
{
    QFETCH(FaultPoint, point);
    const AnalysisPointer analysis = faulty(crossed(), point);
    const ModelPlan plan = planOf(*analysis);
    QCOMPARE(plan.plan.verdict, AssemblyPlan::Verdict::NotFound);
    QVERIFY(plan.failure);
    const std::vector<Finding> found = planChecks(*analysis, plan);
    const Finding *finding = find(found, kOrderUnknown);
    QVERIFY(finding);
    QCOMPARE(finding->severity, Severity::Unknown);
    const std::size_t failed = failedIn(*analysis);
    const QString name = QString::fromStdString(analysis->model.section(failed)->name);
    QCOMPARE(finding->sections, std::vector<SectionRef>{analysis->model.ref(failed)});
    QVERIFY(findingText(*finding, analysis->model).contains(name));
    QVERIFY(!assemblySteps(analysis, plan));
    QVERIFY(whyNoSteps(*analysis, plan).contains(name));
}

// Wrong: a model without half of its sections would be cut.
void TestFailures::aFailedOperationIsSaid()
{
    Document document = newDocument();
    const SectionId panel = add(document, "Panel", shapeOf(circle({0, 0}, 70)), frontFrame());
    Operation grid = operation("grid", {{"section", {panel}}},
                               {{"fitSheet", false},
                                {"cellWidth", 60.0},
                                {"cellHeight", 60.0},
                                {"edge", std::string("jigsaw")}});
    grid.name = "Tiles";
    add(document, grid);
    int calls = 0;
    {
        const FaultWatch watch;
        evaluate(document);
        calls = watch.calls(FaultPoint::Boolean);
    }
    QVERIFY(calls > 0);
    for (const int call : {0, calls / 2, calls - 1}) {
        Model model;
        {
            const FaultWatch watch(FaultPoint::Boolean, call);
            model = evaluate(document);
        }
        QCOMPARE(failedOperations(model).size(), std::size_t(1));
        const AnalysisPointer analysis = wholeOf(model);
        const Result<io::CuttingFile> svg = io::makeCuttingFile(*analysis);
        QVERIFY(!svg);
        QCOMPARE(svg.error().code, ErrorCode::OperationFailed);
        QCOMPARE(svg.error().args, std::vector<std::string>{"Tiles"});
        const std::vector<Finding> found = checks(*analysis);
        const Finding *finding = find(found, kNotMade);
        QVERIFY(finding && finding->severity == Severity::Error);
        QVERIFY(findingText(*finding, model).contains(QStringLiteral("Tiles")));
        QVERIFY(planOf(*analysis).failure);
    }
    QVERIFY(failedOperations(evaluate(document)).empty());
}

// Wrong: an edit would not help, though what failed is gone.
void TestFailures::aFailureDoesNotStay()
{
    Document document = crossed();
    AnalysisCaches caches;
    {
        const FaultWatch watch(FaultPoint::Boolean, 0);
        analyseNext(evaluate(document), caches);
    }
    QVERIFY(!haveParts(caches.last->model, caches.last->bodies));
    const std::vector<SectionId> wing{document.sections[1]->id};
    document = removeSections(std::move(document), wing).value();
    const AnalysisPointer next = analyseNext(evaluate(document), caches);
    QVERIFY(haveParts(next->model, next->bodies));
}

// Wrong: hours of work would be lost with a slit.
void TestFailures::theDocumentIsStillSaved()
{
    const Document document = crossed();
    const AnalysisPointer analysis = faulty(document, FaultPoint::Boolean);
    QVERIFY(io::writeFff(analysis->model.document).value() == io::writeFff(document).value());
}

FFF_TEST(TestFailures)
#include "tst_failures.moc"
