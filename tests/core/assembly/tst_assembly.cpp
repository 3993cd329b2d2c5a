#include "core/assembly/assembly.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

namespace {

/// n × n standing strips.
Document eggCrate(int n)
{
    Document document = newDocument();
    const double length = 20.0 * (n + 1);
    const ShapePointer strip = polygonShape(rectangle(0, 0, length, 40));
    for (int i = 0; i < n; ++i) {
        document = withSection(std::move(document), strip, front(-20.0 * (i + 1)));
        document = withSection(std::move(document), strip, side(20.0 * (i + 1)));
    }
    return document;
}

} // namespace

class TestAssembly : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eggCrateHasAllItsJoints();
    void anEditKeepsTheOtherJoints();
    void jointsBehindANewOneAreCountedOn();
    void groupsAreTheConnectedOnes();
    void emptyModel();
};

void TestAssembly::eggCrateHasAllItsJoints()
{
    const Assembly assembly = assemble(evaluate(eggCrate(6)));
    QCOMPARE(assembly.joints.size(), std::size_t(36));
    for (std::size_t i = 0; i < assembly.joints.size(); ++i) {
        QCOMPARE(assembly.joints[i].id, static_cast<int>(i) + 1);
        QVERIFY(assembly.joints[i].a < assembly.joints[i].b);
    }
    for (const std::vector<Slit> &slits : assembly.slits)
        QCOMPARE(slits.size(), std::size_t(6));
}

// An edit that recomputed its neighbours' neighbours would cost the whole model on every drag.
void TestAssembly::anEditKeepsTheOtherJoints()
{
    const Document document = eggCrate(6);
    const Model model = evaluate(document);
    const Assembly before = assemble(model);
    const SectionId moved = document.sections[4]->id;
    Frame frame = document.sections[4]->frame;
    frame.origin.z() -= 3.0;
    const Model next = evaluate(*moveSection(document, moved, frame));
    const Assembly after = assemble(next, model, before);
    QCOMPARE(before.joints.size(), after.joints.size());
    for (std::size_t i = 0; i < before.joints.size(); ++i) {
        const bool touches = before.joints[i].a == 4 || before.joints[i].b == 4;
        QCOMPARE(before.joints[i].crossing != after.joints[i].crossing, touches);
    }
    // Sections 0, 2, 4 … are parallel: the edit concerns the odd ones; 4 is cut where it was.
    for (std::size_t i = 0; i < before.slits.size(); ++i)
        QCOMPARE(before.slits.pointer(i) != after.slits.pointer(i), i % 2 == 1);
}

// The pictures of the past would show up in the model: ids and indices of what lies behind an
// inserted or removed joint shift.
void TestAssembly::jointsBehindANewOneAreCountedOn()
{
    const Document document = eggCrate(3);
    const Model model = evaluate(document);
    const Assembly before = assemble(model);
    Frame away = document.sections[1]->frame;
    away.origin.x() += 500.0;
    const Model without = evaluate(*moveSection(document, document.sections[1]->id, away));
    const Assembly fewer = assemble(without, model, before);
    QCOMPARE(fewer.joints.size(), std::size_t(6));
    QVERIFY(fewer.slits == assemble(without).slits);
    const Assembly again = assemble(model, without, fewer);
    QVERIFY(again.slits == before.slits);
    int id = 0;
    for (const Joint &joint : again.joints)
        QCOMPARE(joint.id, ++id);
    QCOMPARE(again.joints.find(0, 1)->id, 1);
    QVERIFY(!again.joints.find(0, 2));
}

void TestAssembly::groupsAreTheConnectedOnes()
{
    Document document = eggCrate(2);
    document = withSection(std::move(document), polygonShape(rectangle(900, 0, 950, 50)), front());
    const auto groups = heldGroups(analysed(document));
    QCOMPARE(groups.size(), std::size_t(2));
    QCOMPARE(groups[0].size(), std::size_t(4));
    QCOMPARE(groups[1], std::vector<int>{4});
}

void TestAssembly::emptyModel()
{
    const Assembly assembly = assemble(evaluate(newDocument()));
    QVERIFY(assembly.joints.empty());
    QVERIFY(heldGroups(analysed(newDocument())).empty());
}

FFF_TEST(TestAssembly)
#include "tst_assembly.moc"
