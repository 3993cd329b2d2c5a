#include "core/assembly/assembly.h"
#include "core/assembly/body.h"
#include "core/fabrication/summary.h"
#include "core/model/changes.h"
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

class TestBody : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void massIsThatOfWhatIsLeft();
    void centreFollowsTheModel();
    void boundsHoldTheSlabs();
    void emptyModel();
    void unchangedBodiesAreTheSameObjects();
    void piecesKeepTheirNames();
    void solidsAreTheOutlines();
};

// A mass with the slits still in it is too high, most of all in an egg crate.
void TestBody::massIsThatOfWhatIsLeft()
{
    const Model model = twoSections(polygonShape(rectangle(-50, 0, 50, 50)), front(),
                                    polygonShape(rectangle(-50, 20, 50, 90)), side());
    const MassProperties mass = bodiesOf(model, cutsOf(model)).mass();
    QVERIFY(std::abs(mass.mass - (5000 - 45 + 7000 - 45) * 3e-9 * 660) < 1e-12);
    QVERIFY(std::abs(mass.centre.x()) < 1e-9 && std::abs(mass.centre.z()) < 1e-9);
    QVERIFY(mass.centre.y() > 25.0 && mass.centre.y() < 55.0);
}

void TestBody::centreFollowsTheModel()
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

void TestBody::boundsHoldTheSlabs()
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

void TestBody::emptyModel()
{
    const Model model = evaluate(newDocument());
    QCOMPARE(bodiesOf(model, {}).mass().mass, 0.0);
    QVERIFY(slabBounds(model).isEmpty());
}

// An edit of one section must not make those who keep something of a body work it out anew.
void TestBody::unchangedBodiesAreTheSameObjects()
{
    Document document = newDocument();
    for (int i = 0; i < 5; ++i)
        document = withSection(document, polygonShape(rectangle(0, 0, 40, 30)), front(20.0 * i));
    const Model before = evaluate(document);
    const std::vector<CutSectionPointer> cuts = cutsOf(before);
    const Bodies first = bodiesOf(before, cuts);
    const SectionId gone = document.sections[1]->id, moved = document.sections[3]->id;
    document = *removeSections(document, {&gone, 1});
    document = *moveSection(document, moved, front(63.0));
    const Model after = evaluate(document);
    std::vector<CutSectionPointer> rest = cuts;
    rest.erase(rest.begin() + 1);
    const Bodies second = bodiesOf(after, rest, first, placesBefore(after, before));
    QCOMPARE(second.size(), std::size_t(4));
    QCOMPARE(second.pointer(0), first.pointer(0));
    QCOMPARE(second.pointer(1), first.pointer(2));
    QVERIFY(second.pointer(2) != first.pointer(3));
    QCOMPARE(second[2].key(), first[3].key());
    QCOMPARE(second.pointer(3), first.pointer(4));
    for (int i = 0; i < 4; ++i)
        QCOMPARE(second.sectionOf(i), i);
}

// Two halves of which now one, now the other is larger: whoever hides one of them, or hangs a
// weight on it, means that one.
void TestBody::piecesKeepTheirNames()
{
    const ShapePointer plate = polygonShape(rectangle(0, 0, 100, 30));
    const Model model = evaluate(withSection(newDocument(), plate, front()));
    std::vector<BodyKey> left;
    for (const double at : {30.0, 49.999, 50.0, 50.001, 70.0}) {
        const auto parts =
            subtract(plate->contour(), {}, {rectangle(at - 1, -5, at + 1, 35)}, 0.01);
        const Bodies bodies = bodiesOf(model, {std::make_shared<const CutSection>(*parts)});
        QCOMPARE(bodies.size(), std::size_t(2));
        QVERIFY(bodies[0].key() != bodies[1].key());
        for (const Body &body : bodies)
            if (body.box().min.x() < 1.0)
                left.push_back(body.key());
    }
    QCOMPARE(left.size(), std::size_t(5));
    QCOMPARE(std::count(left.begin(), left.end(), left.front()), 5);
}

void TestBody::solidsAreTheOutlines()
{
    const Model model = twoSections(polygonShape(rectangle(-50, 0, 50, 50)), front(),
                                    polygonShape(rectangle(-50, 20, 50, 90)), side());
    const Bodies bodies = bodiesOf(model, cutsOf(model));
    for (const Body &body : bodies) {
        const Result<SolidPointer> &solid = body.solid();
        QVERIFY(solid);
        QCOMPARE(*solid, *body.solid());
        double area = 0.0;
        for (const auto &triangle : (*solid)->triangles)
            area += 0.5 * (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).norm();
        QVERIFY(std::abs(area - body.cut()->area()) < 1e-6);
        QVERIFY(((*solid)->box.min - body.box().min).norm() < 1e-9);
        QVERIFY(((*solid)->box.max - body.box().max).norm() < 1e-9);
    }
}

FFF_TEST(TestBody)
#include "tst_body.moc"
