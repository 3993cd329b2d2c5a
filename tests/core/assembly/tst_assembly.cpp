#include "core/assembly/assembly.h"
#include "tests/core/assembly/plates.h"

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
    void anyCacheGivesTheSame();
    void anEditKeepsTheOtherCrossings();
    void aShapeThatIsGoneIsNotFoundAgain();
    void groupsAreTheConnectedOnes();
    void emptyModel();
};

void TestAssembly::eggCrateHasAllItsJoints()
{
    CrossingCache cache;
    const Assembly assembly = assemble(evaluate(eggCrate(6)), cache);
    QCOMPARE(assembly.joints.size(), std::size_t(36));
    for (std::size_t i = 0; i < assembly.joints.size(); ++i) {
        QCOMPARE(assembly.joints[i].id, static_cast<int>(i) + 1);
        QVERIFY(assembly.joints[i].a < assembly.joints[i].b);
    }
    for (const std::vector<Slit> &slits : assembly.slits)
        QCOMPARE(slits.size(), std::size_t(6));
}

// If the cache changed an answer, results would hang on what was looked at before.
void TestAssembly::anyCacheGivesTheSame()
{
    const Model model = evaluate(eggCrate(5));
    CrossingCache used, fresh;
    assemble(evaluate(eggCrate(3)), used);
    assemble(model, used);
    const Assembly a = assemble(model, used), b = assemble(model, fresh);
    QCOMPARE(a.joints.size(), b.joints.size());
    QVERIFY(a.slits == b.slits);
}

// An edit that recomputed its neighbours' neighbours would cost the whole model on every drag.
void TestAssembly::anEditKeepsTheOtherCrossings()
{
    const Document document = eggCrate(6);
    CrossingCache cache;
    const Assembly before = assemble(evaluate(document), cache);
    const SectionId moved = document.sections[4]->id;
    Frame frame = document.sections[4]->frame;
    frame.origin.z() -= 3.0;
    const Assembly after = assemble(evaluate(*moveSection(document, moved, frame)), cache);
    QCOMPARE(before.joints.size(), after.joints.size());
    for (std::size_t i = 0; i < before.joints.size(); ++i) {
        const bool touches = before.joints[i].a == 4 || before.joints[i].b == 4;
        QCOMPARE(before.joints[i].crossing != after.joints[i].crossing, touches);
    }
    // Undo finds all of them again.
    const Assembly undone = assemble(evaluate(document), cache);
    for (std::size_t i = 0; i < before.joints.size(); ++i)
        QCOMPARE(before.joints[i].crossing, undone.joints[i].crossing);
}

// Addresses get reused: a cache that trusted them would give a new shape an old one's slits.
void TestAssembly::aShapeThatIsGoneIsNotFoundAgain()
{
    CrossingCache cache;
    for (int round = 0; round < 200; ++round) {
        const double height = 10.0 + round;
        const Model model = twoSections(polygonShape(rectangle(-50, 0, 50, height)), front(),
                                        polygonShape(rectangle(-50, 5, 50, 500)), side());
        const Assembly assembly = assemble(model, cache);
        QCOMPARE(assembly.joints.at(0).crossing->overlaps.at(0).to -
                     assembly.joints.at(0).crossing->overlaps.at(0).from,
                 height - 5.0);
    }
}

void TestAssembly::groupsAreTheConnectedOnes()
{
    Document document = eggCrate(2);
    document = withSection(std::move(document), polygonShape(rectangle(900, 0, 950, 50)), front());
    CrossingCache cache;
    const Assembly assembly = assemble(evaluate(document), cache);
    const auto groups = connectedGroups(document.sections.size(), assembly.joints);
    QCOMPARE(groups.size(), std::size_t(2));
    QCOMPARE(groups[0].size(), std::size_t(4));
    QCOMPARE(groups[1], std::vector<int>{4});
}

void TestAssembly::emptyModel()
{
    CrossingCache cache;
    const Assembly assembly = assemble(evaluate(newDocument()), cache);
    QVERIFY(assembly.joints.empty());
    QVERIFY(connectedGroups(0, assembly.joints).empty());
}

QTEST_APPLESS_MAIN(TestAssembly)
#include "tst_assembly.moc"
