#include "core/fabrication/part.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/fabrication/parts_of.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

class TestParts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everySectionIsAPart();
    void bothMatesBearTheJointsNumber();
    void markPointsIntoTheMaterial();
    void piecesOfASectionAreNumberedBySize();
    void markGoesToThePieceAtTheBottom_data();
    void markGoesToThePieceAtTheBottom();
    void sectionCutAwayIsNoPart();
    void emptyModelHasNone();
};

namespace {

Model crossedPlates()
{
    return twoSections(polygonShape(rectangle(-50, 0, 50, 50)), front(),
                       polygonShape(rectangle(-50, 0, 50, 80)), side());
}

} // namespace

// Wrong: something drawn would not be cut, or carry another one's number.
void TestParts::everySectionIsAPart()
{
    const Model model = crossedPlates();
    const std::vector<Part> parts = partsOf(model);
    QCOMPARE(parts.size(), 2U);
    for (int i = 0; i < 2; ++i) {
        const Part &part = parts[static_cast<std::size_t>(i)];
        QCOMPARE(part.number, i + 1);
        QCOMPARE(part.section, i);
        QVERIFY(part.stock == model.document.currentStock);
        QVERIFY(part.outline.outer.signedArea() <
                model.section(static_cast<std::size_t>(i))->shape->area());
    }
}

// Wrong: nobody could tell which slit goes into which.
void TestParts::bothMatesBearTheJointsNumber()
{
    const std::vector<Part> parts = partsOf(crossedPlates());
    QCOMPARE(parts[0].joints.size(), 1U);
    QCOMPARE(parts[1].joints.size(), 1U);
    QCOMPARE(parts[0].joints[0].joint, 1);
    QCOMPARE(parts[1].joints[0].joint, 1);
    QCOMPARE(parts[0].joints[0].width, 3.0);
}

// Wrong: the joint's number would be burnt into the air of the slit.
void TestParts::markPointsIntoTheMaterial()
{
    for (const Part &part : partsOf(crossedPlates())) {
        const Part::JointMark &mark = part.joints.at(0);
        QVERIFY(std::abs(mark.direction.norm() - 1.0) < 1e-12);
        QVERIFY(locate(mark.inner + mark.direction, part.outline.region) == Side::Inside);
        QVERIFY(locate(mark.inner - mark.direction, part.outline.region) == Side::Outside);
    }
}

// Wrong: pieces of one section would be lost, or numbered differently from run to run.
void TestParts::piecesOfASectionAreNumberedBySize()
{
    const Model model =
        evaluate(withSection(newDocument(), polygonShape(rectangle(0, 0, 100, 20)), front()));
    Assembly assembly;
    assembly.slits.resize(1);
    const auto cut = std::make_shared<const CutSection>(
        *subtract(model.section(0)->shape->contour(), {}, {rectangle(30, -5, 33, 25)}, 0.01));
    const std::vector<Part> parts = makeParts(model, assembly, bodiesOf(model, {cut}));
    QCOMPARE(parts.size(), 2U);
    QCOMPARE(parts[0].number, 1);
    QCOMPARE(parts[1].number, 2);
    QCOMPARE(parts[0].section, 0);
    QCOMPARE(parts[1].section, 0);
    QCOMPARE(parts[0].outline.outer.signedArea(), 67.0 * 20.0);
    QCOMPARE(parts[1].outline.outer.signedArea(), 30.0 * 20.0);
}

void TestParts::markGoesToThePieceAtTheBottom_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<int>("part");
    QTest::newRow("a slit in the larger piece") << 60.0 << 0;
    QTest::newRow("a slit in the smaller piece") << 15.0 << 1;
}

// Wrong: a joint's number would stand on a piece that has no such joint.
void TestParts::markGoesToThePieceAtTheBottom()
{
    QFETCH(double, x);
    QFETCH(int, part);
    const Model model =
        evaluate(withSection(newDocument(), polygonShape(rectangle(0, 0, 100, 20)), front()));
    Slit slit;
    slit.inner = {x, 10};
    slit.mouth = {x, 21};
    slit.width = 3;
    slit.joint = 5;
    Assembly assembly;
    assembly.slits = {{slit}};
    const auto cut = std::make_shared<const CutSection>(*subtract(
        model.section(0)->shape->contour(), {}, {rectangle(30, -5, 33, 25), slit.outline()}, 0.01));
    const std::vector<Part> parts = makeParts(model, assembly, bodiesOf(model, {cut}));
    QCOMPARE(parts.size(), 2U);
    for (int i = 0; i < 2; ++i)
        QCOMPARE(parts[static_cast<std::size_t>(i)].joints.size(), i == part ? 1U : 0U);
    QCOMPARE(parts[static_cast<std::size_t>(part)].joints[0].joint, 5);
}

// Wrong: a crash on a section that its slits eat up.
void TestParts::sectionCutAwayIsNoPart()
{
    const Model model = crossedPlates();
    Assembly assembly;
    assembly.slits = {{Slit{}}, {}};
    const auto nothing = std::make_shared<const CutSection>(std::vector<CurvedRegion>{});
    QVERIFY(makeParts(model, assembly, bodiesOf(model, {nothing, nothing})).empty());
}

// Wrong: a crash on a new document.
void TestParts::emptyModelHasNone()
{
    QVERIFY(partsOf(evaluate(newDocument())).empty());
}

FFF_TEST(TestParts)
#include "tst_parts.moc"
