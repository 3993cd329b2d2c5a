#include <QTest> // first: moc stumbles over some standard headers

#include "core/fabrication/summary.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"
#include "ui/bench/measures.h"

using namespace fff;
using namespace fff::test;

class TestMeasures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sizeIsThatOfTheSlabs();
    void massIsThatOfTheParts();
};

// A box round a turned section's box is larger than the section: a bridge was said to be twice as
// high as it is.
void TestMeasures::sizeIsThatOfTheSlabs()
{
    Session session;
    const Polygon strip = {{0, 0}, {100, 100}, {90, 110}, {-10, 10}};
    session.reset(withSection(newDocument(), polygonShape(strip),
                              *makeFrame({0, 0, 0}, {1, -1, 0}, {1, 1, 0})));
    const Vec3 size = ui::Measures(session).size();
    QVERIFY((size - slabBounds(session.model()).size()).norm() < 1e-9);
    // The strip lies level in the world: 141.4 mm wide, 14.1 mm high, 3 mm thick.
    QVERIFY((size - Vec3(std::sqrt(20000.0), std::sqrt(200.0), 3.0)).norm() < 1e-9);
}

void TestMeasures::massIsThatOfTheParts()
{
    Session session;
    const Model pair = twoSections(polygonShape(rectangle(-50, 0, 50, 50)), front(),
                                   polygonShape(rectangle(-50, 20, 50, 90)), side());
    session.reset(pair.document);
    const Analysis &analysis = session.currentAnalysis();
    QVERIFY(std::abs(ui::Measures(session).mass() - analysis.bodies.mass().mass) < 1e-6);
}

FFF_TEST(TestMeasures)
#include "tst_measures.moc"
