// Sections that all cross in one axis: what is said of them.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/findings/connection.h"
#include "core/analysis/findings/loose_joints.h"
#include "core/analysis/findings/loose_pieces.h"
#include "core/analysis/findings/moved_planes.h"
#include "core/analysis/findings/order.h"
#include "core/analysis/findings/thin_webs.h"
#include "core/analysis/trial.h"
#include "core/base/units.h"
#include "core/model/edits.h"
#include "core/model/template_edits.h"
#include "core/operations/baking.h"
#include "core/templates/template_mesh.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/operations/operation_models.h"
#include "tests/core/session/all_findings.h"
#include "tests/core/session/staged.h"
#include "tests/core/templates/made_forms.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

Document sliced(std::map<std::string, ParameterValue> values,
                const MeshDraft &draft = sphere(60.0, 60, 91), double size = 120.0)
{
    Template one;
    one.name = "Ball";
    one.file = "ball.stl";
    one.mesh = makeTemplateMesh(mended(draft).value().mesh, {}).value();
    Document document = addTemplate(newDocument(), stood(one, *one.mesh, UpAxis::Y, size)).value();
    Operation slices = operation("slices", {}, std::move(values));
    slices.subject = document.templates.front()->id;
    add(document, slices);
    return document;
}

Document slicedAround(int count)
{
    return sliced({{"direction", std::string("radial")}, {"count", static_cast<double>(count)}});
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
    void hollowOnesGoTogether_data();
    void hollowOnesGoTogether();
    void planesThatGoTogetherAreOffered();
    void otherPlanesAreThoughtOf_data();
    void otherPlanesAreThoughtOf();
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

void TestAroundAnAxis::hollowOnesGoTogether_data()
{
    QTest::addColumn<QString>("direction");
    for (const char *direction : {"xy", "xz", "yz", "radial", "radialX", "radialZ"})
        QTest::newRow(direction) << QString::fromLatin1(direction);
}

// Wrong: rings that cross in two walls each can be put together by no way.
void TestAroundAnAxis::hollowOnesGoTogether()
{
    QFETCH(const QString, direction);
    const Document document = sliced(
        {{"direction", direction.toStdString()}, {"count", 3.0}, {"hollow", true}, {"wall", 8.0}});
    const Staged all = staged(document);
    const Model model = evaluate(document);
    std::size_t holes = 0;
    for (const SectionPointer &section : model.sections())
        holes += section->shape->holes().size();
    QVERIFY2(holes >= 2 * model.sectionCount(), qPrintable(QString::number(holes)));
    QVERIFY(find(all.found, kConnected));
    QVERIFY(find(all.found, kCanAssemble));
    QVERIFY(!find(all.found, kLoosePieces));
    QVERIFY(!find(all.found, kSlitsMeet));
    QVERIFY(!find(all.found, kLooseJoint));
}

// Wrong: whoever has a grid that cannot be slid together is left alone with that.
void TestAroundAnAxis::planesThatGoTogetherAreOffered()
{
    int blocked = 0, offered = 0;
    for (const MadeForm &form : madeForms())
        for (const double count : {4.0, 5.0}) {
            const Document document =
                sliced({{"direction", std::string("xz")}, {"count", count}}, form.draft, 150.0);
            const Staged all = staged(document);
            const Finding *finding = find(all.found, kCannotAssemble);
            if (!finding)
                continue;
            ++blocked;
            std::vector<FindingAction> actions = movedPlanes(*finding, document);
            for (const FindingAction &action : otherPlanes(*finding, document))
                actions.push_back(action);
            offered += std::any_of(actions.begin(), actions.end(), [&](const auto &action) {
                const auto edit = carriedOut(action, *finding, *all.analysis);
                if (!edit)
                    return false;
                // As it is judged before it is offered.
                const std::vector<Finding> after = staged(edit->document).found;
                return isNoWorse(all.found, after) && helps(*finding, all.found, after) &&
                       !find(after, kCannotAssemble);
            });
        }
    QVERIFY2(blocked == 0 || offered >= blocked - 1,
             qPrintable(QStringLiteral("%1 of %2").arg(offered).arg(blocked)));
}

void TestAroundAnAxis::otherPlanesAreThoughtOf_data()
{
    QTest::addColumn<QString>("direction");
    QTest::addColumn<QString>("by");
    QTest::addColumn<int>("edits"); // of those that are tried last
    QTest::newRow("a grid by count") << "xz"
                                     << "count" << 13;
    QTest::newRow("a grid by spacing") << "xz"
                                       << "spacing" << 8;
    QTest::newRow("around") << "radial"
                            << "spacing" << 13; // has none, whatever stands there
    QTest::newRow("in one direction") << "x"
                                      << "count" << 0;
}

// Wrong: whoever slices by spacing, or around an axis, is offered nothing.
void TestAroundAnAxis::otherPlanesAreThoughtOf()
{
    QFETCH(const QString, direction);
    QFETCH(const QString, by);
    QFETCH(const int, edits);
    const Document document = sliced({{"direction", direction.toStdString()},
                                      {"count", 5.0},
                                      {"planesBy", by.toStdString()},
                                      {"spacing", 30.0}});
    AnalysisCaches caches;
    const Analysis analysis = analyse(evaluate(document), caches);
    Finding finding = makeFinding(kCannotAssemble, Severity::Error, Blocked());
    finding.sections = {analysis.model.ref(0)};
    int made = 0;
    std::vector<Document> seen{document};
    for (const auto &planes : {movedPlanes, otherPlanes})
        for (const FindingAction &action : planes(finding, document)) {
            QCOMPARE(action.kind->isLastResort, planes == otherPlanes);
            const auto edit = carriedOut(action, finding, analysis);
            if (!edit)
                continue;
            QVERIFY(edit->document.sections.empty()); // all of it is still the slices
            for (const Document &other : seen)
                QVERIFY(!(edit->document == other)); // none twice
            seen.push_back(edit->document);
            QVERIFY(!messageText(action.kind->words(action, finding, analysis.model)).isEmpty());
            made += planes == otherPlanes ? 1 : 0;
        }
    QCOMPARE(made, edits);
    QCOMPARE(areOfCrossingSlices(finding, document), edits > 0);
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
