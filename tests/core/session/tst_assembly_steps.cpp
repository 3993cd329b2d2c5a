#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/fabrication/part.h"
#include "core/session/assembly_steps.h"
#include "tests/core/assembly/known_models.h"
#include "tests/test_program.h"

#include <algorithm>

using namespace fff;
using namespace fff::test;

namespace {

struct Planned
{
    AnalysisPointer analysis;
    ModelPlan plan;
    AssemblyStepsPointer steps;
};

Planned planned(Document document)
{
    AnalysisCaches caches;
    Planned result;
    result.analysis = analyseNext(evaluate(std::move(document)), caches);
    result.plan = planOf(*result.analysis);
    result.steps = assemblySteps(result.analysis, result.plan);
    return result;
}

bool contains(const std::vector<int> &parts, int part)
{
    return std::find(parts.begin(), parts.end(), part) != parts.end();
}

int countThere(const std::vector<PartPlace> &places)
{
    return static_cast<int>(
        std::count_if(places.begin(), places.end(), [](const PartPlace &p) { return p.isThere; }));
}

Box3 boxOf(const AssemblySteps &steps, int part, const Vec3 &offset)
{
    Box3 box;
    const Body &body = steps.bodies.at(part);
    for (const Vec2 &p : body.outline().region.outer)
        for (const double side : {-0.5, 0.5})
            box.extend(Vec3(body.frame().toWorld(p) +
                            side * body.thickness() * body.frame().normal() + offset));
    return box;
}

/// Deeper in each other than rounding.
bool meet(const Box3 &a, const Box3 &b)
{
    constexpr double kRounding = 1e-6;
    return (a.min.array() < b.max.array() - kRounding).all() &&
           (b.min.array() < a.max.array() - kRounding).all();
}

} // namespace

class tst_assembly_steps : public QObject
{
    Q_OBJECT
private:
    static void models()
    {
        QTest::addColumn<Document>("document");
        QTest::newRow("one plate")
            << withSection(newDocument(), polygonShape(rectangle(0, 0, 40, 40)), front());
        QTest::newRow("a chain of nine") << chain(9);
        QTest::newRow("a comb of seven") << combModel(7);
        QTest::newRow("a crate of 3 by 5") << eggCrate(3, 5);
        QTest::newRow("a star of eight") << star(8);
        QTest::newRow("out from under an arm") << underAnArm(40);
        QTest::newRow("two that are furnished first") << furnished();
    }

private Q_SLOTS:
    void atTheEndAllIsInItsPlace_data() { models(); }
    /// Else the steps would end in another model than the one that was drawn.
    void atTheEndAllIsInItsPlace()
    {
        QFETCH(Document, document);
        const Planned model = planned(document);
        QVERIFY(model.steps);
        const Playback &playback = model.steps->playback;
        QCOMPARE(playback.partCount(), static_cast<int>(model.plan.bodies.size()));
        for (const PartPlace &place : playback.at(playback.stepCount())) {
            QVERIFY(place.isThere);
            QCOMPARE(place.offset, Vec3(Vec3::Zero()));
        }
    }

    void partsComeOnceAndStay_data() { models(); }
    /// Else a part would vanish, or come before its step.
    void partsComeOnceAndStay()
    {
        QFETCH(Document, document);
        const Planned model = planned(document);
        const Playback &playback = model.steps->playback;
        int before = 0;
        for (int i = 0; i <= 20 * playback.stepCount(); ++i) {
            const int there = countThere(playback.at(i / 20.0));
            QVERIFY(there >= before);
            before = there;
        }
        for (int step = 0; step < playback.stepCount(); ++step) {
            const auto begun = playback.before(step), ended = playback.at(step + 1.0);
            for (const int part : playback.plan().steps[static_cast<std::size_t>(step)].parts) {
                QVERIFY(begun[static_cast<std::size_t>(part)].isThere);
                QVERIFY(ended[static_cast<std::size_t>(part)].isMoving);
            }
            QCOMPARE(countThere(begun), countThere(ended));
        }
    }

    void betweenStepsAllRests_data() { models(); }
    /// Else what stands would wander while another part is looked at.
    void betweenStepsAllRests()
    {
        QFETCH(Document, document);
        const Planned model = planned(document);
        const Playback &playback = model.steps->playback;
        const std::vector<AssemblyStep> &steps = playback.plan().steps;
        for (int step = 0; step < playback.stepCount(); ++step) {
            const auto from = playback.before(step), to = playback.at(step + 1.0);
            for (std::size_t part = 0; part < from.size(); ++part) {
                if (!from[part].isThere)
                    continue;
                if (!contains(steps[static_cast<std::size_t>(step)].parts, static_cast<int>(part)))
                    QCOMPARE(from[part].offset, to[part].offset);
                const bool comesLater = std::any_of(
                    steps.begin() + step + 1, steps.end(), [&](const AssemblyStep &later) {
                        return contains(later.parts, static_cast<int>(part));
                    });
                if (!comesLater)
                    QCOMPARE(to[part].offset, Vec3(Vec3::Zero()));
            }
        }
    }

    void nothingJumps_data() { models(); }
    /// Played forwards or backwards: a part that is there goes its way without a jump.
    void nothingJumps()
    {
        QFETCH(Document, document);
        const Planned model = planned(document);
        const Playback &playback = model.steps->playback;
        double longest = 0.0;
        for (int step = 0; step < playback.stepCount(); ++step) {
            const std::vector<Vec3> &way = playback.way(step);
            double length = 0.0;
            for (std::size_t i = 1; i < way.size(); ++i)
                length += (way[i] - way[i - 1]).norm();
            longest = std::max(longest, length);
        }
        constexpr double kStep = 0.01;
        constexpr double kFastest = 4.0; // slower than a cubic ease in three quarters of a step
        for (double time = kStep; time < playback.stepCount(); time += kStep) {
            const auto a = playback.at(time), b = playback.at(time + kStep);
            for (std::size_t part = 0; part < a.size(); ++part) {
                if (a[part].isThere)
                    QVERIFY((a[part].offset - b[part].offset).norm() <=
                            kFastest * kStep * longest + 1e-9);
            }
        }
    }

    void distancesAreThePlans_data() { models(); }
    /// Else the part would seem to begin inside another one, or come from elsewhere.
    void distancesAreThePlans()
    {
        QFETCH(Document, document);
        const Planned model = planned(document);
        const Playback &playback = model.steps->playback;
        for (int i = 0; i < playback.stepCount(); ++i) {
            const AssemblyStep &step = playback.plan().steps[static_cast<std::size_t>(i)];
            Vec3 start = Vec3::Zero();
            for (const Move &move : step.moves)
                start -= move.distance * move.direction;
            const Vec3 more = playback.way(i).front() - start;
            if (step.parts.size() == 1)
                QVERIFY(more.norm() < 1e-9);
            else // further back on the same way
                QVERIFY((more + more.norm() * step.moves.front().direction).norm() < 1e-9);
        }
    }

    void drawnApartNoTwoPartsMeet_data() { models(); }
    /// Else one would cover the other, and the picture explain nothing.
    void drawnApartNoTwoPartsMeet()
    {
        QFETCH(Document, document);
        const Planned model = planned(document);
        const Playback &playback = model.steps->playback;
        const auto places = playback.at(playback.stepCount(), 1.0);
        for (int a = 0; a < playback.partCount(); ++a)
            for (int b = a + 1; b < playback.partCount(); ++b)
                QVERIFY(!meet(boxOf(*model.steps, a, places[static_cast<std::size_t>(a)].offset),
                              boxOf(*model.steps, b, places[static_cast<std::size_t>(b)].offset)));
        // The reach holds all of it, or the view would cut parts off.
        const Box3 reach = playback.reach(1.0);
        for (int a = 0; a < playback.partCount(); ++a) {
            Box3 both = reach;
            both.extend(boxOf(*model.steps, a, places[static_cast<std::size_t>(a)].offset));
            QVERIFY((both.min - reach.min).norm() + (both.max - reach.max).norm() < 1e-6);
        }
    }

    /// A row of ribs along one beam: what comes later is further away.
    void laterOnesAreDrawnFurtherApart()
    {
        // A tower: each on top of the one before.
        Document document = newDocument();
        for (int i = 0; i < 4; ++i)
            document =
                withSection(std::move(document), polygonShape(rectangle(-20, 0, 20, 30)),
                            i % 2 == 0 ? Frame{{0, 20.0 * i, 0}, Vec3::UnitX(), Vec3::UnitY()}
                                       : Frame{{0, 20.0 * i, 0}, -Vec3::UnitZ(), Vec3::UnitY()});
        const Planned model = planned(document);
        QVERIFY(model.steps);
        const Playback &playback = model.steps->playback;
        const auto places = playback.at(playback.stepCount(), 1.0);
        double before = -1.0;
        for (int i = 0; i < playback.stepCount(); ++i) {
            const int part = playback.plan().steps[static_cast<std::size_t>(i)].parts.front();
            const double away = places[static_cast<std::size_t>(part)].offset.norm();
            QVERIFY(away > before);
            before = away;
        }
    }

    void numbersAreThoseEngraved_data() { models(); }
    /// Else a person would look for the wrong part on the table.
    void numbersAreThoseEngraved()
    {
        QFETCH(Document, document);
        const Planned model = planned(document);
        const std::vector<Part> parts =
            makeParts(model.analysis->model, model.analysis->assembly, model.analysis->bodies);
        QCOMPARE(parts.size(), model.steps->bodies.size());
        for (std::size_t i = 0; i < parts.size(); ++i) {
            QCOMPARE(AssemblySteps::numberOf(static_cast<int>(i)), parts[i].number);
            QCOMPARE(model.steps->bodies.sectionOf(static_cast<int>(i)), parts[i].section);
            QVERIFY(model.steps->bodies[i].outline().region.outer == parts[i].outline.region.outer);
        }
    }

    /// What a person reads has to be what is shown.
    void sentencesSayWhatIsDone()
    {
        Document document = newDocument();
        NewSection spine;
        spine.name = "Spine";
        spine.shape = polygonShape(rectangle(0, 0, 60, 30));
        document = *addSection(std::move(document), spine);
        NewSection rib;
        rib.name = "Rib";
        rib.shape = polygonShape(rectangle(-20, 10, 20, 50));
        rib.frame = side(30);
        document = *addSection(std::move(document), rib);
        const Planned model = planned(document);
        QCOMPARE(stepTitle(*model.steps, 1), QStringLiteral("Step 2 of 2"));
        QCOMPARE(stepText(*model.steps, 0), QStringLiteral("start with Spine"));
        QCOMPARE(stepText(*model.steps, 1), QStringLiteral("slide Rib down into Spine"));
        const Planned bent = planned(underAnArm(40));
        QVERIFY(stepText(*bent.steps, 1).contains(QStringLiteral("round the corner")));
        const Planned group = planned(furnished());
        QStringList texts;
        for (int i = 0; i < group.steps->playback.stepCount(); ++i)
            texts += stepText(*group.steps, i);
        QVERIFY2(texts.filter(QStringLiteral("start a group of its own with")).size() == 1,
                 qPrintable(texts.join(u'\n')));
        // Wrong: nobody would know which parts on the table are meant.
        QVERIFY2(texts.filter(QStringLiteral("(together since step ")).size() == 1,
                 qPrintable(texts.join(u'\n')));
    }

    /// Nothing false may be shown of what cannot be assembled, and a person wants to know why.
    void withoutStepsItIsSaidWhy()
    {
        const Planned locked = planned(triangle());
        QVERIFY(!locked.steps);
        QVERIFY(
            whyNoSteps(*locked.analysis, locked.plan).contains(QStringLiteral("block each other")));
        const Planned nothing = planned(newDocument());
        QVERIFY(!nothing.steps);
        QVERIFY(!whyNoSteps(*nothing.analysis, nothing.plan).isEmpty());
        ModelPlan late = locked.plan;
        late.plan = {};
        QVERIFY(!assemblySteps(locked.analysis, late));
        QVERIFY(whyNoSteps(*locked.analysis, late).contains(QStringLiteral("not found")));
        const Planned possible = planned(combModel(2));
        QVERIFY(whyNoSteps(*possible.analysis, possible.plan).isEmpty());
    }
};

FFF_TEST(tst_assembly_steps)
#include "tst_assembly_steps.moc"
