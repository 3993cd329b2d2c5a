// Planes near the ends of a mesh, and pieces that are thin all over: what is moved and left out.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/model/template_edits.h"
#include "core/templates/template_mesh.h"
#include "tests/core/operations/operation_models.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kSide = 100.0; // mm, of the block
constexpr double kRounding = 1e-6;

Model sliced(const MeshDraft &draft, std::map<std::string, ParameterValue> values, int version = 0)
{
    Template one;
    one.name = "Block";
    one.file = "block.stl";
    one.mesh = makeTemplateMesh(mended(draft).value().mesh, {}).value();
    Document document =
        addTemplate(newDocument(), stood(one, *one.mesh, UpAxis::Y, one.mesh->mesh->size()))
            .value();
    Operation slices = operation("slices", {}, std::move(values));
    slices.subject = document.templates.front()->id;
    if (version > 0)
        slices.version = version;
    add(document, slices);
    return evaluate(document);
}

double thicknessIn(const Model &model)
{
    return model.document.find(model.document.currentStock)->thickness;
}

/// The nearest that a plane comes to the end of what it cuts, mm; bounds: those of the mesh.
double nearestToAnEnd(const Model &model)
{
    const Template &one = *model.document.templates.front();
    const Box3 bounds = worldBounds(one, *one.mesh);
    double nearest = std::numeric_limits<double>::infinity();
    for (const SectionPointer &section : model.sections()) {
        const int axis = section->made.key.front() - 'x';
        const double at = section->frame.origin[axis];
        nearest = std::min({nearest, at - bounds.min[axis], bounds.max[axis] - at});
    }
    return nearest;
}

int noted(const Model &model, OperationNotice::Kind kind)
{
    int count = 0;
    for (const OperationNotice &notice : model.evaluation.results.front()->notices)
        count += notice.kind == kind ? notice.count : 0;
    return count;
}

std::map<std::string, ParameterValue> bySpacing(const char *direction, double spacing)
{
    return {{"direction", std::string(direction)},
            {"planesBy", std::string("spacing")},
            {"spacing", spacing}};
}

} // namespace

class TestSliceEnds : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void planesOfAGridKeepOffTheEnds();
    void manyMoveTogether();
    void shiftedOnesAreLeftOut();
    void rowsBesideEachOtherMayEnd();
    void whatIsFlatHasOnePlane();
    void whatIsThinIsLeftOut();
};

// Wrong: a millimetre before a steep wall a plane leaves a prong on every section across.
void TestSliceEnds::planesOfAGridKeepOffTheEnds()
{
    for (const double spacing : {49.0, 33.0, 99.9, 24.7, 12.3}) {
        const Model model = sliced(cube(kSide), bySpacing("xz", spacing));
        QVERIFY(model.sectionCount() > 0);
        QVERIFY(nearestToAnEnd(model) >= 1.5 * thicknessIn(model) - kRounding);
        QCOMPARE(noted(model, OperationNotice::Kind::LeftOut), 0);
    }
    // Those of a model that was made before stay where they are.
    const Model before = sliced(cube(kSide), bySpacing("xz", 49.0), 1);
    QCOMPARE(before.sectionCount(), std::size_t(6));
    QVERIFY(std::abs(nearestToAnEnd(before) - 1.0) < kRounding);
}

void TestSliceEnds::manyMoveTogether()
{
    constexpr int kCount = 30;
    const Model model = sliced(
        cube(kSide), {{"direction", std::string("xz")}, {"count", static_cast<double>(kCount)}});
    QCOMPARE(model.sectionCount(), std::size_t(2 * kCount));
    QVERIFY(std::abs(nearestToAnEnd(model) - 1.5 * thicknessIn(model)) < kRounding);
    const double step = (kSide - 3.0 * thicknessIn(model)) / (kCount - 1);
    for (int i = 1; i < kCount; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const double way =
            model.section(at)->frame.origin.x() - model.section(at - 1)->frame.origin.x();
        QVERIFY(std::abs(way - step) < kRounding);
    }
}

void TestSliceEnds::shiftedOnesAreLeftOut()
{
    constexpr double kCount = 4.0;
    for (const double shift : {-0.5, 0.5}) {
        const Model model = sliced(
            cube(kSide), {{"direction", std::string("xz")}, {"count", kCount}, {"shift", shift}});
        QCOMPARE(model.sectionCount(), std::size_t(6));
        QCOMPARE(noted(model, OperationNotice::Kind::LeftOut), 2);
        QVERIFY(nearestToAnEnd(model) >= 1.5 * thicknessIn(model) - kRounding);
        // The others are called as without a shift.
        QCOMPARE(model.section(0)->made.key, std::string(shift < 0.0 ? "x/1/0" : "x/0/0"));
    }
}

void TestSliceEnds::rowsBesideEachOtherMayEnd()
{
    const Model model = sliced(cube(kSide), bySpacing("x", 49.0));
    QCOMPARE(model.sectionCount(), std::size_t(3));
    QVERIFY(std::abs(nearestToAnEnd(model) - 1.0) < kRounding);
}

void TestSliceEnds::whatIsFlatHasOnePlane()
{
    const MeshDraft plate = box({0.0, 0.0, 0.0}, {kSide, kSide, 5.0});
    const Model model = sliced(plate, {{"direction", std::string("xz")}, {"count", 6.0}});
    const auto &sections = model.sections();
    QCOMPARE(std::count_if(sections.begin(), sections.end(),
                           [](const auto &one) { return one->made.key.front() == 'z'; }),
             std::ptrdiff_t(1));
    QCOMPARE(noted(model, OperationNotice::Kind::LeftOut), 5);
}

void TestSliceEnds::whatIsThinIsLeftOut()
{
    for (const double width : {1.0, 1.9, 2.1, 4.0}) { // in thicknesses
        const double depth = width * newDocument().stocks.front()->thickness;
        const MeshDraft plate = box({0.0, 0.0, 0.0}, {kSide, kSide, depth});
        const bool isThin = width < 2.0;
        const std::map<std::string, ParameterValue> values{{"direction", std::string("x")},
                                                           {"count", 3.0}};
        const Model model = sliced(plate, values);
        QCOMPARE(model.sectionCount(), std::size_t(isThin ? 0 : 3));
        QCOMPARE(noted(model, OperationNotice::Kind::Slivers), isThin ? 3 : 0);
        QCOMPARE(sliced(plate, values, 1).sectionCount(), std::size_t(3));
    }
}

FFF_TEST(TestSliceEnds)
#include "tst_slice_ends.moc"
