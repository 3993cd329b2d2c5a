// A mesh in slices: what planes cut of it, what is left out, and that nothing is made anew
// needlessly.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/assembly/crossing.h"
#include "core/io/fff_format.h"
#include "core/model/edits.h"
#include "core/model/operation_edits.h"
#include "core/model/template_edits.h"
#include "core/operations/baking.h"
#include "core/operations/insertion.h"
#include "core/templates/template_mesh.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/operations/operation_models.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <numbers>
#include <set>

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
    void aroundOtherAxes();
    void likeASection();
    void bySpacing();
    void hollowOnesKeepTheirWall();
    void hollowOnesAreWalledWhereTheyCross();
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

void TestSlices::aroundOtherAxes()
{
    for (const auto &[direction, axis] : {std::pair("radialX", 0), std::pair("radialZ", 2)}) {
        const Model model = evaluate(
            withSlices(withMesh(torus(50.0, 20.0, 120, 80)),
                       {{"direction", std::string(direction)}, {"count", 4.0}, {"shift", 0.1}}));
        QVERIFY(model.sectionCount() >= 4);
        std::set<std::pair<double, double>> normals;
        for (const SectionPointer &slice : model.sections()) {
            const Frame &frame = slice->frame;
            QVERIFY(std::abs(frame.normal()[axis]) < 1e-12);
            QVERIFY(std::abs(frame.x.norm() - 1.0) < 1e-12);
            QVERIFY(std::abs(frame.x.dot(frame.y)) < 1e-12);
            normals.insert({frame.normal()[(axis + 1) % 3], frame.normal()[(axis + 2) % 3]});
        }
        QCOMPARE(normals.size(), std::size_t(4));
    }
}

// In any direction: as a section that is picked lies.
void TestSlices::likeASection()
{
    Document document = withMesh(sphere(50.0, 120, 180));
    const Frame aslant = makeFrame({200, 30, 0}, {1.0, 0.4, 0.2}, Vec3(0.1, 0.9, 0.5)).value();
    const SectionId like = add(document, "Like", plateOf(-10, -10, 10, 10), aslant);
    document =
        withSlices(std::move(document), {{"direction", std::string("section")}, {"count", 5.0}});
    const OperationId id = document.operations.front()->id;
    QVERIFY(evaluate(document).evaluation.results.front()->sections.empty()); // none is picked
    Operation slices = *document.operations.front();
    slices.inputs["like"] = {OperationInput{SectionRef(like)}};
    document = setOperation(document, slices).value();
    const Model model = evaluate(document);
    QCOMPARE(model.evaluation.results.front()->sections.size(), std::size_t(5));
    const Vec3 middle(0.0, 50.0, 0.0);
    for (int i = 0; i < 5; ++i) {
        const Section &slice = *model.find(SectionRef(id, "s/" + std::to_string(i) + "/0"));
        QVERIFY((slice.frame.normal() - aslant.normal()).norm() < 1e-12);
        const double off = (i - 2) * 20.0;
        QVERIFY(std::abs(slice.frame.height(middle) + off) < 0.1); // the ball's chords
        const double wanted = kHalfTurn * (2500.0 - off * off);
        QVERIFY(std::abs(slice.shape->area() / wanted - 1.0) < 0.02);
    }
    // They follow it.
    const Frame upright = makeFrame({200, 30, 0}, Vec3::UnitX(), Vec3::UnitY()).value();
    const Model after = evaluate(moveSection(document, like, upright).value(), model);
    for (const auto &made : after.evaluation.results.front()->sections)
        QVERIFY((made->frame.normal() - Vec3::UnitZ()).norm() < 1e-12);
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

void TestSlices::hollowOnesAreWalledWhereTheyCross()
{
    const Model model = evaluate(withSlices(
        withMesh(sphere(50.0, 120, 180)),
        {{"direction", std::string("xz")}, {"count", 3.0}, {"hollow", true}, {"wall", 8.0}}));
    QCOMPARE(model.sectionCount(), std::size_t(6));
    for (std::size_t i = 0; i < 6; ++i) {
        const Section &slice = *model.section(i);
        QVERIFY(slice.shape->holes().size() >= 2);
        for (std::size_t k = 0; k < 6; ++k) {
            const Section &other = *model.section(k);
            if (std::abs(slice.frame.normal().dot(other.frame.normal())) > 0.5)
                continue;
            const Crossing crossing =
                findCrossing(*slice.shape, slice.frame, *other.shape, other.frame);
            QCOMPARE(crossing.overlaps.size(), std::size_t(1));
            // Each room is half a wall and half a sheet away from it at least.
            const double thickness = model.document.stocks.front()->thickness;
            for (const Contour &hole : slice.shape->holes())
                for (const Vec2 &p : hole.polygon(0.01))
                    QVERIFY(std::abs(other.frame.height(slice.frame.toWorld(p))) >
                            0.5 * (8.0 + thickness) - 0.05);
        }
    }
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
