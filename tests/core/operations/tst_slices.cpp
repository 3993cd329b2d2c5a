// A mesh in slices: what planes cut of it, what is left out, and that nothing is made anew
// needlessly.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/io/fff_format.h"
#include "core/model/template_edits.h"
#include "core/operations/baking.h"
#include "core/operations/insertion.h"
#include "core/templates/template_mesh.h"
#include "tests/core/operations/operation_models.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kHalfTurn = std::numbers::pi;

Document withMesh(const MeshDraft &draft)
{
    Template one;
    one.name = "Ball";
    one.file = "ball.stl";
    one.mesh = makeTemplateMesh(mended(draft).value().mesh, {}).value();
    return addTemplate(newDocument(), stood(one, *one.mesh, UpAxis::Y, one.mesh->mesh->size()))
        .value();
}

Document withSlices(Document document, std::map<std::string, ParameterValue> values)
{
    Operation slices = operation("slices", {}, std::move(values));
    slices.name = "Slices";
    slices.subject = document.templates.front()->id;
    add(document, slices);
    return document;
}

} // namespace

class TestSlices : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aBallAlongEachAxis();
    void aGridSlidesTogether();
    void aroundAnAxis();
    void bySpacing();
    void hollowOnesKeepTheirWall();
    void smallPiecesAreLeftOut();
    void onlyWhatChangesIsMadeAnew();
    void withoutItsTemplate();
    void bakedReadAndInserted();
};

void TestSlices::aBallAlongEachAxis()
{
    const Document document = withMesh(sphere(50.0, 120, 180));
    for (int axis = 0; axis < 3; ++axis) {
        const Model model = evaluate(
            withSlices(document, {{"direction", std::string(1, "xyz"[axis])}, {"count", 5.0}}));
        QCOMPARE(model.sectionCount(), std::size_t(5));
        for (int i = 0; i < 5; ++i) {
            const Section &slice = *model.section(static_cast<std::size_t>(i));
            const double at = (i - 2) * 20.0;
            QVERIFY(std::abs(slice.shape->area() / (kHalfTurn * (2500.0 - at * at)) - 1.0) < 0.01);
            Vec3 normal = Vec3::Zero();
            normal[axis] = 1.0;
            QVERIFY((slice.frame.normal() - normal).norm() < 1e-12);
            // Every point of it lies on the ball, within the error of a guide and of the facets.
            for (const Vec2 &p : slice.shape->contour().polygon(0.01))
                QVERIFY(std::abs((slice.frame.toWorld(p) - Vec3(0, 50, 0)).norm() - 50.0) < 0.1);
            QCOMPARE(slice.made.key, std::string(1, "xyz"[axis]) + "/" + std::to_string(i) + "/0");
        }
    }
}

void TestSlices::aGridSlidesTogether()
{
    const Model model = evaluate(withSlices(withMesh(sphere(50.0, 120, 180)),
                                            {{"direction", std::string("xz")}, {"count", 4.0}}));
    QCOMPARE(model.sectionCount(), std::size_t(8));
    QCOMPARE(model.section(0)->name, std::string("Ball X1"));
    QCOMPARE(model.section(7)->name, std::string("Ball Z4"));
}

void TestSlices::aroundAnAxis()
{
    const Model model = evaluate(withSlices(
        withMesh(sphere(50.0, 120, 180)), {{"direction", std::string("radial")}, {"count", 6.0}}));
    QCOMPARE(model.sectionCount(), std::size_t(6));
    for (const SectionPointer &slice : model.sections()) {
        QVERIFY(std::abs(slice->shape->area() / (kHalfTurn * 2500.0) - 1.0) < 0.01);
        QVERIFY(std::abs(slice->frame.normal().y()) < 1e-12);
    }
}

void TestSlices::bySpacing()
{
    const Model model =
        evaluate(withSlices(withMesh(sphere(50.0, 60, 90)), {{"direction", std::string("x")},
                                                             {"planesBy", std::string("spacing")},
                                                             {"spacing", 30.0}}));
    QCOMPARE(model.sectionCount(), std::size_t(4));
    QVERIFY(std::abs(model.section(1)->frame.origin.x() - model.section(0)->frame.origin.x() -
                     30.0) < 1e-9);
}

void TestSlices::hollowOnesKeepTheirWall()
{
    const Model model = evaluate(withSlices(
        withMesh(sphere(50.0, 120, 180)),
        {{"direction", std::string("x")}, {"count", 5.0}, {"hollow", true}, {"wall", 12.0}}));
    QCOMPARE(model.sectionCount(), std::size_t(5));
    for (int i = 0; i < 5; ++i) {
        const Shape &shape = *model.section(static_cast<std::size_t>(i))->shape;
        const double at = (i - 2) * 20.0, r = std::sqrt(2500.0 - at * at);
        QCOMPARE(shape.holes().size(), std::size_t(1));
        const double wanted = kHalfTurn * (r * r - (r - 12.0) * (r - 12.0));
        QVERIFY2(std::abs(shape.area() / wanted - 1.0) < 0.02,
                 qPrintable(QString::number(shape.area() / wanted)));
    }
    // Where there is no room for a hole it is solid.
    const Model small = evaluate(withSlices(
        withMesh(sphere(50.0, 60, 90)),
        {{"direction", std::string("x")}, {"count", 2.0}, {"hollow", true}, {"wall", 60.0}}));
    QVERIFY(small.section(0)->shape->holes().empty());
}

void TestSlices::smallPiecesAreLeftOut()
{
    MeshDraft two = sphere(50.0, 60, 90);
    append(two, moved(sphere(5.0, 20, 30), {0, 0, 80}));
    const Document document = withMesh(two);
    const auto slices = [&](double least) {
        return evaluate(withSlices(
            document, {{"direction", std::string("x")}, {"count", 1.0}, {"smallest", least}}));
    };
    const Model all = slices(0.0), large = slices(100.0);
    QCOMPARE(all.sectionCount(), std::size_t(2));
    QCOMPARE(large.sectionCount(), std::size_t(1));
    QCOMPARE(large.evaluation.results[0]->notices.size(), std::size_t(1));
    QVERIFY(large.evaluation.results[0]->notices[0].kind == OperationNotice::Kind::Slivers);
}

void TestSlices::onlyWhatChangesIsMadeAnew()
{
    const Document document =
        withSlices(withMesh(sphere(50.0, 60, 90)), {{"direction", std::string("x")}});
    const Model before = evaluate(document);
    Template shown = *document.templates.front();
    shown.opacity = 0.75;
    shown.isLocked = true;
    const Model brighter = evaluate(setTemplate(document, shown).value(), before);
    QCOMPARE(brighter.evaluation.results[0], before.evaluation.results[0]);
    shown.scale *= 2.0;
    const Model larger = evaluate(setTemplate(document, shown).value(), before);
    QVERIFY(larger.section(0)->shape->area() > 3.9 * before.section(0)->shape->area());
}

void TestSlices::withoutItsTemplate()
{
    Document document =
        withSlices(withMesh(sphere(50.0, 60, 90)), {{"direction", std::string("x")}});
    document = removeTemplate(document, document.templates.front()->id).value();
    const Model model = evaluate(document);
    QCOMPARE(model.sectionCount(), std::size_t(0));
    QVERIFY(model.evaluation.results[0]->notices[0].kind == OperationNotice::Kind::NoTemplate);
}

void TestSlices::bakedReadAndInserted()
{
    const Document document =
        withSlices(withMesh(sphere(50.0, 60, 90)), {{"direction", std::string("xz")}});
    const Model model = evaluate(document);
    const Document drawn = baked(model, document.operations.front()->id).value();
    QCOMPARE(drawn.sections.size(), model.sectionCount());
    QVERIFY(*drawn.sections[0]->shape == *model.section(0)->shape);

    const auto read = io::readFff(io::writeFff(document).value());
    QVERIFY(read);
    QVERIFY(read->document == document);

    const Insertion twice = inserted(document, document);
    QCOMPARE(twice.document.operations[1]->subject, twice.document.templates[1]->id);
    QCOMPARE(evaluate(twice.document).sectionCount(), 2 * model.sectionCount());
}

FFF_TEST(TestSlices)
#include "tst_slices.moc"
