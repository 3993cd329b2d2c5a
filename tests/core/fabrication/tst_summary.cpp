#include "core/assembly/assembly.h"
#include "core/fabrication/summary.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

namespace {

std::vector<CutSectionPointer> cutsOf(const Model &model)
{
    CutCache cache;
    const Assembly assembly = assemble(model);
    std::vector<CutSectionPointer> cuts;
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        cuts.push_back(cutSection(model.section(i)->shape, assembly.slits[i], cache));
    return cuts;
}

} // namespace

class TestSummary : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void massIsThatOfWhatIsLeft();
    void centreFollowsTheModel();
    void boundsHoldTheSlabs();
    void emptyModel();
};

// A mass with the slits still in it is too high, most of all in an egg crate.
void TestSummary::massIsThatOfWhatIsLeft()
{
    const Model model = twoSections(polygonShape(rectangle(-50, 0, 50, 50)), front(),
                                    polygonShape(rectangle(-50, 20, 50, 90)), side());
    const MassProperties mass = bodiesOf(model, cutsOf(model)).mass();
    QVERIFY(std::abs(mass.mass - (5000 - 45 + 7000 - 45) * 3e-9 * 660) < 1e-12);
    QVERIFY(std::abs(mass.centre.x()) < 1e-9 && std::abs(mass.centre.z()) < 1e-9);
    QVERIFY(mass.centre.y() > 25.0 && mass.centre.y() < 55.0);
}

void TestSummary::centreFollowsTheModel()
{
    const ShapePointer a = polygonShape(rectangle(-50, 0, 50, 50));
    const ShapePointer b = polygonShape(rectangle(-50, 20, 40, 90));
    const Model model = twoSections(a, front(), b, side());
    const Vec3 shift(11, -7, 300);
    const auto moved = [&](Frame frame) {
        frame.origin += shift;
        return frame;
    };
    const Model other = twoSections(a, moved(front()), b, moved(side()));
    const MassProperties one = bodiesOf(model, cutsOf(model)).mass(),
                         two = bodiesOf(other, cutsOf(other)).mass();
    QVERIFY(std::abs(one.mass - two.mass) < 1e-12);
    QVERIFY((two.centre - one.centre - shift).norm() < 1e-9);
}

void TestSummary::boundsHoldTheSlabs()
{
    const Model model = twoSections(polygonShape(rectangle(-50, 0, 50, 50)), front(),
                                    polygonShape(rectangle(-30, 20, 30, 90)), side());
    const Box3 box = slabBounds(model);
    QCOMPARE(box.min.x(), -50.0);
    QCOMPARE(box.max.y(), 90.0);
    QCOMPARE(box.max.z(), 30.0);
    const Model flat = twoSections(polygonShape(rectangle(-50, 0, 50, 50)), front(),
                                   polygonShape(rectangle(-50, 0, 50, 50)), front(10));
    QCOMPARE(slabBounds(flat).min.z(), -1.5);
    QCOMPARE(slabBounds(flat).max.z(), 11.5);
}

void TestSummary::emptyModel()
{
    const Model model = evaluate(newDocument());
    QCOMPARE(bodiesOf(model, {}).mass().mass, 0.0);
    QVERIFY(slabBounds(model).isEmpty());
}

FFF_TEST(TestSummary)
#include "tst_summary.moc"
