// To which side the slits of a mesh's slices open.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/analysis.h"
#include "core/assembly/assembly.h"
#include "core/base/tolerances.h"
#include "core/model/template_edits.h"
#include "core/operations/baking.h"
#include "core/operations/excerpt.h"
#include "core/templates/template_mesh.h"
#include "tests/core/operations/operation_models.h"
#include "tests/core/templates/made_forms.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace fff;
using namespace fff::test;

namespace {

Document sliced(const MeshDraft &draft, const char *direction, int count)
{
    Template one;
    one.name = "Form";
    one.file = "form.stl";
    one.mesh = makeTemplateMesh(mended(draft).value().mesh, {}).value();
    Document document =
        addTemplate(newDocument(), stood(one, *one.mesh, UpAxis::Y, one.mesh->mesh->size()))
            .value();
    Operation slices =
        operation("slices", {},
                  {{"direction", std::string(direction)}, {"count", static_cast<double>(count)}});
    slices.subject = document.templates.front()->id;
    add(document, slices);
    return document;
}

/// The slits of a's, from the bottom to the mouth in the world, by the names of both sections.
std::map<std::pair<std::string, std::string>, Vec3> openings(const Model &model)
{
    std::map<std::pair<std::string, std::string>, Vec3> ways;
    const Assembly assembly = assemble(model);
    for (const Joint &joint : assembly.joints) {
        const Section &a = *model.section(static_cast<std::size_t>(joint.a));
        const Section &b = *model.section(static_cast<std::size_t>(joint.b));
        for (const Slit &slit : assembly.slits[static_cast<std::size_t>(joint.a)])
            if (slit.joint == joint.id && slit.overlap >= 0)
                ways[{a.name, b.name}] = a.frame.directionToWorld(slit.mouth - slit.inner);
    }
    return ways;
}

std::vector<SectionRef> allOf(const Model &model)
{
    std::vector<SectionRef> all;
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        all.push_back(model.ref(i));
    return all;
}

} // namespace

class TestSliceSides : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void rowsOpenToOneSide_data();
    void rowsOpenToOneSide();
    void mirrorImagesAreCutAlike();
    void drawnOnesStayAsTheyAre_data();
    void drawnOnesStayAsTheyAre();
    void aroundAnAxisNoneIsCutInTwo_data();
    void aroundAnAxisNoneIsCutInTwo();
    void aWishGoesFirst();
};

// Wrong: by how curves happen to be fitted to the mesh, a section opens up here and down there, and
// the grid can only be woven together, if at all.
void TestSliceSides::rowsOpenToOneSide_data()
{
    QTest::addColumn<int>("form");
    QTest::addColumn<QString>("direction");
    QTest::addColumn<int>("count");
    for (const int form : {0, 1, 2})
        for (const char *direction : {"xz", "xy", "yz"})
            for (const int count : {4, 7, 10})
                QTest::addRow("form %d %s %d", form, direction, count)
                    << form << QString::fromLatin1(direction) << count;
}

void TestSliceSides::rowsOpenToOneSide()
{
    QFETCH(const int, form);
    QFETCH(const QString, direction);
    QFETCH(const int, count);
    const MeshDraft draft = form == 0   ? sphere(60.0, 60, 91)
                            : form == 1 ? ellipsoid(Vec3::Zero(), {40.0, 90.0, 55.0})
                                        : head(48, 61);
    const Model model = evaluate(sliced(draft, qPrintable(direction), count));
    const auto ways = openings(model);
    QVERIFY(ways.size() >= static_cast<std::size_t>(count));
    // What is across both rows is the axis of all joints; +Z of a grid across X and Y.
    const Vec3 up = direction == QLatin1String("xz")   ? Vec3::UnitY()
                    : direction == QLatin1String("xy") ? Vec3::UnitZ()
                                                       : Vec3::UnitX();
    for (const auto &[names, way] : ways)
        QVERIFY2(way.dot(up) > 0.0, (names.first + " in " + names.second).c_str());
}

void TestSliceSides::mirrorImagesAreCutAlike()
{
    constexpr int kCount = 8;
    constexpr double kFitted = 1.0; // mm, that ends of slits differ by as curves are fitted
    const Model model = evaluate(sliced(ellipsoid(Vec3::Zero(), {55.0, 70.0, 65.0}), "xz", kCount));
    const auto ways = openings(model);
    const auto named = [](int i, int k) {
        return std::pair("Form X" + std::to_string(i), "Form Z" + std::to_string(k));
    };
    int compared = 0;
    for (int i = 1; i <= kCount; ++i)
        for (int k = 1; k <= kCount; ++k) {
            const auto one = ways.find(named(i, k));
            if (one == ways.end())
                continue;
            for (const auto &[x, z] : {std::pair(kCount + 1 - i, k), {i, kCount + 1 - k}}) {
                const auto twin = ways.find(named(x, z));
                QVERIFY(twin != ways.end());
                QVERIFY((twin->second - one->second).norm() < kFitted);
                ++compared;
            }
        }
    QVERIFY(compared > kCount * kCount);
}

void TestSliceSides::drawnOnesStayAsTheyAre_data()
{
    QTest::addColumn<QString>("direction");
    QTest::newRow("a grid") << QStringLiteral("xz");
    QTest::newRow("around an axis") << QStringLiteral("radial");
}

// Wrong: slices that become drawn sections would turn their slits round, baked or copied.
void TestSliceSides::drawnOnesStayAsTheyAre()
{
    QFETCH(const QString, direction);
    const Document document =
        sliced(ellipsoid(Vec3::Zero(), {40.0, 90.0, 55.0}), qPrintable(direction), 7);
    const Model model = evaluate(document);
    const auto before = openings(model);
    const Document drawn = baked(model, document.operations.front()->id).value();
    const Document copied = excerpt(model, allOf(model));
    for (const Document *other : {&drawn, &copied}) {
        QVERIFY(other->operations.empty());
        const auto after = openings(evaluate(*other));
        QCOMPARE(after.size(), before.size());
        for (const auto &[names, way] : before)
            QVERIFY((after.at(names) - way).norm() < kFrameRounding);
    }
}

void TestSliceSides::aWishGoesFirst()
{
    Document document = sliced(sphere(60.0, 60, 91), "xz", 4);
    const Model model = evaluate(document);
    JointOverride wanted;
    wanted.a = model.ref(1);
    wanted.b = model.ref(5);
    wanted.opens = model.section(1)->frame.directionToLocal(-Vec3::UnitY());
    document = setJointOverride(std::move(document), std::move(wanted)).value();
    const std::pair<std::string, std::string> wished("Form X2", "Form Z2");
    const auto ways = openings(evaluate(document, model));
    QVERIFY(ways.contains(wished));
    for (const auto &[names, way] : ways)
        QCOMPARE(way.y() > 0.0, names != wished);
}

void TestSliceSides::aroundAnAxisNoneIsCutInTwo_data()
{
    QTest::addColumn<int>("form");
    QTest::addColumn<int>("count");
    for (const int form : {0, 1, 2})
        for (const int count : {2, 3, 4, 5, 7})
            QTest::addRow("form %d, %d planes", form, count) << form << count;
}

// Wrong: of three planes through one axis the one in the middle was cut from above and from below
// to the same place.
void TestSliceSides::aroundAnAxisNoneIsCutInTwo()
{
    QFETCH(const int, form);
    QFETCH(const int, count);
    const MeshDraft draft = form == 0   ? sphere(60.0, 60, 91)
                            : form == 1 ? ellipsoid(Vec3::Zero(), {40.0, 90.0, 55.0})
                                        : head(48, 61);
    const Model model = evaluate(sliced(draft, "radial", count));
    AnalysisCaches caches;
    const Analysis analysis = analyse(model, caches);
    for (int i = 0; i < count; ++i)
        QCOMPARE(analysis.bodies.countOf(i), 1);
    const auto ways = openings(model);
    QCOMPARE(ways.size(), static_cast<std::size_t>(count * (count - 1) / 2));
    double depth = 0.0; // of the first one's slits; what is above them is whole
    for (const auto &[names, way] : ways)
        if (count > 2) {
            QVERIFY2(way.y() < 0.0, (names.first + " in " + names.second).c_str());
            if (names.first == "Form R1")
                depth = std::max(depth, way.norm());
        }
    if (count > 2) {
        const double height = model.bounds().size().y();
        QVERIFY(std::abs(depth / height - (1.0 - 1.0 / count)) < 0.1);
    }
}

FFF_TEST(TestSliceSides)
#include "tst_slice_sides.moc"
