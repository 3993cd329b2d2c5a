// Sections that all cross in one axis: what is said of them.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/findings/connection.h"
#include "core/analysis/findings/loose_joints.h"
#include "core/analysis/findings/loose_pieces.h"
#include "core/analysis/findings/order.h"
#include "core/analysis/findings/thin_webs.h"
#include "core/base/units.h"
#include "core/model/edits.h"
#include "core/model/template_edits.h"
#include "core/operations/baking.h"
#include "core/templates/template_mesh.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/operations/operation_models.h"
#include "tests/core/session/all_findings.h"
#include "tests/core/session/staged.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

Document slicedAround(int count)
{
    Template one;
    one.name = "Ball";
    one.file = "ball.stl";
    one.mesh = makeTemplateMesh(mended(sphere(60.0, 60, 91)).value().mesh, {}).value();
    Document document =
        addTemplate(newDocument(), stood(one, *one.mesh, UpAxis::Y, one.mesh->mesh->size()))
            .value();
    Operation slices =
        operation("slices", {},
                  {{"direction", std::string("radial")}, {"count", static_cast<double>(count)}});
    slices.subject = document.templates.front()->id;
    add(document, slices);
    return document;
}

/// Plates that stand on the ground, through one upright line.
Document drawnAround(int count)
{
    Document document = newDocument();
    for (int i = 0; i < count; ++i) {
        const double angle = std::numbers::pi * i / count;
        const Frame frame{Vec3::Zero(), {std::cos(angle), 0.0, -std::sin(angle)}, Vec3::UnitY()};
        document = withSection(std::move(document), plateOf(-50, 0, 50, 80), frame);
    }
    return document;
}

} // namespace

class TestAroundAnAxis : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void slicesHoldAndGoTogether_data();
    void slicesHoldAndGoTogether();
    void drawnOnesAreCutInTwo();
};

void TestAroundAnAxis::slicesHoldAndGoTogether_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<bool>("isBaked");
    for (const int count : {3, 4, 6})
        for (const bool isBaked : {false, true})
            QTest::addRow("%d%s", count, isBaked ? ", baked" : "") << count << isBaked;
}

// Wrong: each pair of slices had a warning, of slits that are one and of slits that need not hold.
void TestAroundAnAxis::slicesHoldAndGoTogether()
{
    QFETCH(const int, count);
    QFETCH(const bool, isBaked);
    Document document = slicedAround(count);
    if (isBaked)
        document = baked(evaluate(document), document.operations.front()->id).value();
    const Staged all = staged(document);
    QVERIFY(find(all.found, kConnected));
    QVERIFY(find(all.found, kCanAssemble));
    QVERIFY(!find(all.found, kLoosePieces));
    QVERIFY(!find(all.found, kSlitsMeet));
    QVERIFY(!find(all.found, kLooseJoint));
}

// Of what is drawn through one line by hand the slits are halves: what that cuts in two is said.
void TestAroundAnAxis::drawnOnesAreCutInTwo()
{
    const Staged all = staged(drawnAround(3));
    const auto isError = [](const Finding &finding) { return finding.severity == Severity::Error; };
    QVERIFY(std::any_of(all.found.begin(), all.found.end(), isError));
    QVERIFY(!find(all.found, kConnected));
}

FFF_TEST(TestAroundAnAxis)
#include "tst_around_an_axis.moc"
