#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/units.h"
#include "core/session/assembly_plan.h"
#include "tests/core/assembly/known_models.h"

#include <set>

using namespace fff;
using namespace fff::test;

namespace {

using Verdict = AssemblyPlan::Verdict;

struct Case
{
    const char *name;
    Document document;
    Verdict verdict;
    std::vector<int> locked;
};

std::vector<Case> cases()
{
    const ShapePointer plate = polygonShape(rectangle(-30, 0, 30, 40));
    const ShapePointer slot = polygonShape(rectangle(-60, -60, 60, 60));
    std::vector<Case> all;
    const auto add = [&](const char *name, Document document, Verdict verdict,
                         std::vector<int> locked = {}) {
        all.push_back({name, std::move(document), verdict, std::move(locked)});
    };
    add("nothing", newDocument(), Verdict::Possible);
    add("one plate", withSection(newDocument(), plate, front()), Verdict::Possible);
    add("two that do not meet",
        withSection(withSection(newDocument(), plate, front()), plate, front(-50)),
        Verdict::Possible);
    add("two that cross", withSection(withSection(newDocument(), plate, front()), plate, side()),
        Verdict::Possible);
    add("two that cross at 35 degrees",
        withSection(withSection(newDocument(), plate, front()), plate, turned(radians(35.0))),
        Verdict::Possible);
    add("a chain of two", chain(2), Verdict::Possible);
    add("a chain of nine", chain(9), Verdict::Possible);
    add("a comb of seven", comb(7), Verdict::Possible);
    for (const auto &[name, across, along] :
         {std::tuple("a crate of 2 by 2", 2, 2), std::tuple("a crate of 3 by 5", 3, 5),
          std::tuple("a crate of 8 by 8", 8, 8), std::tuple("a crate of 12 by 12", 12, 12)})
        add(name, eggCrate(across, along), Verdict::Possible);
    add("three through each other", triangle(), Verdict::Impossible, {0, 1, 2});
    {
        Document document = triangle();
        document =
            withSection(std::move(document), polygonShape(rectangle(-18, -45, -2, -15)), side(15));
        add("a fourth on three through each other", std::move(document), Verdict::Impossible,
            {0, 1, 2});
    }
    add("a star of eight", star(8), Verdict::Possible);
    // 7.5 mm out of its slit, then aside: straight on it would run into the arm.
    add("out from under an arm", underAnArm(40), Verdict::Possible);
    add("held by an arm", underAnArm(60), Verdict::Impossible, {0, 1});
    add("two that are furnished first", furnished(), Verdict::Possible);
    add("a tongue through a slot",
        withSection(withSection(newDocument(), slot, {Vec3::Zero(), Vec3::UnitX(), -Vec3::UnitZ()}),
                    polygonShape(rectangle(-10, -20, 10, 40)), front()),
        Verdict::Possible);
    return all;
}

bool isInside(const Region &region, const Vec2 &p)
{
    const auto winds = [&](const Polygon &ring) {
        bool inside = false;
        for (std::size_t i = 0, k = ring.size() - 1; i < ring.size(); k = i++) {
            if ((ring[i].y() > p.y()) != (ring[k].y() > p.y()) &&
                p.x() < ring[i].x() + (ring[k].x() - ring[i].x()) * (p.y() - ring[i].y()) /
                                          (ring[k].y() - ring[i].y()))
                inside = !inside;
        }
        return inside;
    };
    return winds(region.outer) && std::none_of(region.holes.begin(), region.holes.end(), winds);
}

/// Points all over a part, a little below its surface: on both faces beside each corner and along
/// each edge.
struct Probe
{
    const Region *region;
    Frame frame;
    double half;
    std::vector<Vec3> points;

    bool holds(const Vec3 &p, double depth) const
    {
        return std::abs(frame.height(p)) < half - depth && isInside(*region, frame.toLocal(p));
    }
};

Probe probeOf(const Analysis &analysis, const PartRef &part)
{
    const auto index = static_cast<std::size_t>(part.section);
    const CurvedRegion &piece = analysis.cuts[index]->parts()[static_cast<std::size_t>(part.piece)];
    Probe probe{&piece.region,
                analysis.model.section(index)->frame,
                0.5 * analysis.model.stockOf(index).thickness,
                {}};
    constexpr double kInset = 0.02, kStep = 1.0; // mm
    const auto addRing = [&](const Polygon &ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 a = ring[i], way = ring[(i + 1) % ring.size()] - a;
            const int steps = std::max(1, static_cast<int>(way.norm() / kStep));
            for (int k = 0; k < steps; ++k) {
                const Vec2 on = a + way * ((k + 0.5) / steps);
                for (const double side : {kInset, -kInset}) {
                    const Vec2 in = on + side * perpendicular(way).normalized();
                    if (!isInside(piece.region, in))
                        continue;
                    for (const double height : {probe.half - kInset, 0.0, kInset - probe.half})
                        probe.points.push_back(probe.frame.toWorld(in) +
                                               height * probe.frame.normal());
                }
            }
        }
    };
    addRing(piece.region.outer);
    for (const Polygon &hole : piece.region.holes)
        addRing(hole);
    return probe;
}

/// Whether a, moved by `by`, has a point well inside of b, or b one inside of a.
bool areInEachOther(const Probe &a, const Probe &b, const Vec3 &by)
{
    constexpr double kDepth = 0.01; // mm
    return std::any_of(a.points.begin(), a.points.end(),
                       [&](const Vec3 &p) { return b.holds(p + by, kDepth); }) ||
           std::any_of(b.points.begin(), b.points.end(),
                       [&](const Vec3 &p) { return a.holds(p - by, kDepth); });
}

/// What is wrong with a plan; empty when it can be carried out. Looks at points in regions, which
/// planning does not.
QString fault(const Analysis &analysis, const ModelPlan &plan)
{
    std::vector<Probe> probes;
    for (const PartRef &part : plan.parts)
        probes.push_back(probeOf(analysis, part));
    std::vector<std::set<int>> heaps; // of parts that are together
    const auto heapOf = [&](const std::vector<int> &parts) {
        return std::find(heaps.begin(), heaps.end(), std::set(parts.begin(), parts.end()));
    };
    for (std::size_t s = 0; s < plan.plan.steps.size(); ++s) {
        const AssemblyStep &step = plan.plan.steps[s];
        const QString where = QStringLiteral("step %1: ").arg(s + 1);
        if (step.parts.size() == 1)
            heaps.push_back({step.parts.front()});
        const auto moved = heapOf(step.parts);
        if (moved == heaps.end())
            return where + QStringLiteral("its group has not been put together");
        if (step.onto.empty())
            continue;
        const auto there = heapOf(step.onto);
        if (there == heaps.end())
            return where + QStringLiteral("what it is brought to is not there");
        // Backwards, out of its place.
        Vec3 place = Vec3::Zero();
        for (auto move = step.moves.rbegin(); move != step.moves.rend(); ++move) {
            if (std::abs(move->direction.norm() - 1.0) > 1e-9)
                return where + QStringLiteral("no unit direction");
            for (int i = 0; i <= 50; ++i) {
                const Vec3 by = place - move->direction * (move->distance * i / 50.0);
                for (const int part : step.parts)
                    for (const int other : step.onto)
                        if (areInEachOther(probes[static_cast<std::size_t>(part)],
                                           probes[static_cast<std::size_t>(other)], by))
                            return where + QStringLiteral("%1 runs into %2").arg(part).arg(other);
            }
            place -= move->direction * move->distance;
        }
        std::set<int> together = *moved;
        together.insert(there->begin(), there->end());
        std::erase_if(heaps,
                      [&](const std::set<int> &heap) { return together.contains(*heap.begin()); });
        heaps.push_back(std::move(together));
    }
    if (heaps.size() > 1 || (heaps.empty() && !plan.parts.empty()))
        return QStringLiteral("not all parts are together at the end");
    return heaps.empty() || heaps.front().size() == plan.parts.size()
               ? QString()
               : QStringLiteral("parts are missing at the end");
}

} // namespace

Q_DECLARE_METATYPE(Case)

class TestAssemblyPlan : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void modelsWithAKnownAnswer_data();
    void modelsWithAKnownAnswer();
    void whatIsBuiltFirstIsMovedAsOne();
    void theTimeIsKept();
    void platesInEachOtherAreFound();
};

void TestAssemblyPlan::modelsWithAKnownAnswer_data()
{
    QTest::addColumn<Case>("known");
    for (Case &known : cases())
        QTest::newRow(known.name) << known;
}

/// What would be wrong: a verdict that a person with the parts in hand would laugh at, or a plan in
/// which a part goes through another one.
void TestAssemblyPlan::modelsWithAKnownAnswer()
{
    QFETCH(Case, known);
    AnalysisCaches caches;
    const Analysis analysis = analyse(evaluate(known.document), caches);
    const ModelPlan plan = planOf(analysis);
    QVERIFY(plan.overlaps.empty());
    QCOMPARE(static_cast<int>(plan.plan.verdict), static_cast<int>(known.verdict));
    QCOMPARE(plan.plan.locked, known.locked);
    if (known.verdict != Verdict::Possible) {
        QVERIFY(plan.plan.steps.empty());
        return;
    }
    const QString wrong = fault(analysis, plan);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

/// What would be wrong: groups that are looked for only where single parts would do.
void TestAssemblyPlan::whatIsBuiltFirstIsMovedAsOne()
{
    AnalysisCaches caches;
    const ModelPlan plan = planOf(analyse(evaluate(furnished()), caches));
    QVERIFY(std::any_of(plan.plan.steps.begin(), plan.plan.steps.end(),
                        [](const AssemblyStep &step) { return step.parts.size() == 2; }));
}

/// What would be wrong: a verdict that was not thought through to its end.
void TestAssemblyPlan::theTimeIsKept()
{
    AnalysisCaches caches;
    const Analysis analysis = analyse(evaluate(eggCrate(4, 4)), caches);
    int asked = 0;
    const ModelPlan plan = planOf(analysis, [&asked] { return ++asked > 10; });
    QCOMPARE(static_cast<int>(plan.plan.verdict), static_cast<int>(Verdict::NotFound));
    QVERIFY(plan.plan.steps.empty() && plan.plan.locked.empty());
    QVERIFY(asked < 20);
}

/// What would be wrong: plates that touch count as being in each other, or such as lie in one plane
/// and need no axis to be in each other do not.
void TestAssemblyPlan::platesInEachOtherAreFound()
{
    const ShapePointer plate = polygonShape(rectangle(0, 0, 40, 40));
    const auto overlapsOfTwo = [&](const Frame &a, const Frame &b) {
        AnalysisCaches caches;
        return planOf(analyse(evaluate(withSection(withSection(newDocument(), plate, a), plate, b)),
                              caches))
            .overlaps;
    };
    QVERIFY(overlapsOfTwo(front(), front(3.0)).empty());
    const auto deep = overlapsOfTwo(front(), front(2.0));
    QCOMPARE(deep.size(), std::size_t(1));
    QVERIFY(std::abs(deep.front().how.depth - 1.0) < 1e-9);
    QVERIFY(overlapsOfTwo(front(), {{40, 0, 0}, Vec3::UnitX(), Vec3::UnitY()}).empty());
    QCOMPARE(overlapsOfTwo(front(), {{39, 5, 0}, Vec3::UnitX(), Vec3::UnitY()}).size(),
             std::size_t(1));
}

QTEST_APPLESS_MAIN(TestAssemblyPlan)
#include "tst_assembly_plan.moc"
