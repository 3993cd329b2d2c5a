#include "core/assembly/assembly.h"
#include "core/model/load_edits.h"
#include "core/operations/baking.h"
#include "tests/core/operations/operation_models.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

namespace {

/// What is seen and cut of a section, whatever it is called.
struct Look
{
    std::string name;
    Frame frame;
    ShapePointer shape;
    StockId stock;
    std::vector<std::pair<Vec2, Vec2>> slits; // sorted

    bool operator==(const Look &o) const
    {
        return name == o.name && frame == o.frame && shape == o.shape && stock == o.stock &&
               slits == o.slits;
    }
};

std::multimap<std::string, Look> looks(const Model &model)
{
    const Assembly assembly = assemble(model);
    std::multimap<std::string, Look> all;
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        const Section &section = *model.section(i);
        Look look{section.name, section.frame, section.shape, section.stock, {}};
        for (const Slit &slit : assembly.slits[i])
            look.slits.emplace_back(slit.inner, slit.mouth);
        std::sort(look.slits.begin(), look.slits.end(), [](const auto &a, const auto &b) {
            return std::tuple(a.first.x(), a.first.y(), a.second.y()) <
                   std::tuple(b.first.x(), b.first.y(), b.second.y());
        });
        all.emplace(section.name, std::move(look));
    }
    return all;
}

} // namespace

class TestBaking : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void bakingChangesNothingVisible();
    void detachingChangesNothingVisible();
    void whatWasSaidOfInstancesFollows();
    void equalEndsKeepTheirSide();
    void nothingToBake();
};

// Wrong: ribs would jump, lose their slits, or be there twice.
void TestBaking::bakingChangesNothingVisible()
{
    FishBones bones;
    add(bones.document,
        operation("linear", {{"section", {bones.rib}}, {"along", {bones.spine}}},
                  {{"side", std::string("both")}, {"scale", std::string("thickness")}}));
    add(bones.document, operation("revolve", {{"section", {bones.rib}}, {"along", {bones.spine}}},
                                  {{"count", 6.0}, {"to", 0.3}}));
    Model model = evaluate(bones.document);
    const auto before = looks(model);
    for (int round = 0; round < 2; ++round) {
        const Document next = baked(model, model.document.operations.front()->id).value();
        model = evaluate(next, model);
        QVERIFY(looks(model) == before);
    }
    QVERIFY(model.document.operations.empty());
    QVERIFY(!model.evaluation.listing);
    for (const SectionPointer &section : model.document.sections)
        QVERIFY(section->id.isValid() && section->made == SectionRef());
}

// Wrong: taking one rib out to change it would already change it.
void TestBaking::detachingChangesNothingVisible()
{
    FishBones bones;
    const OperationId id = add(
        bones.document, operation("linear", {{"section", {bones.rib}}, {"along", {bones.spine}}}));
    const Model model = evaluate(bones.document);
    const Model after = evaluate(detached(model, {id, "3"}).value(), model);
    QVERIFY(looks(after) == looks(model));
    QCOMPARE(after.document.sections.size(), 3U);
    QCOMPARE(after.document.operations[0]->exceptions.at("3").state, Exception::State::Detached);
    // It is a section of its own now: the row moves without it.
    Frame frame = after.document.sections[1]->frame;
    frame.origin.x() += 2.0;
    const Model moved = evaluate(moveSection(after.document, bones.rib, frame).value(), after);
    QVERIFY(moved.document.sections[2]->frame == after.document.sections[2]->frame);
    QVERIFY(!(moved.find({id, "2"})->frame == after.find({id, "2"})->frame));
}

// Wrong: weights, joints set by hand and what was drawn on a rib would be lost.
void TestBaking::whatWasSaidOfInstancesFollows()
{
    FishBones bones;
    const OperationId id = add(
        bones.document, operation("linear", {{"section", {bones.rib}}, {"along", {bones.spine}}}));
    const SectionRef third(id, "3");
    bones.document = addLoad(bones.document, {{}, third, {1, 2}, 0.2}).value();
    JointOverride flipped;
    flipped.a = SectionRef(bones.spine);
    flipped.b = third;
    flipped.opens = Vec2(0, 1);
    flipped.shares = {{{70, 70}, 0.3}};
    bones.document = setJointOverride(bones.document, flipped).value();
    const SectionId child = add(bones.document, "Child", shapeOf(circle({0, 0}, 10)),
                                frontFrame({0, 40, 30}), Parent{third, {0, 0}, {5, 5}});
    const OperationId later =
        add(bones.document, operation("linear", {{"section", {third}}, {"along", {bones.spine}}},
                                      {{"count", 2.0}}));
    const Model model = evaluate(bones.document);
    for (const Document &next : {baked(model, id).value(), detached(model, third).value()}) {
        const Model after = evaluate(next, model);
        QVERIFY(looks(after) == looks(model));
        const SectionRef drawn = after.document.loads[0].section;
        QVERIFY(drawn.drawn.isValid());
        QCOMPARE(after.nameOf(drawn), model.nameOf(third));
        QCOMPARE(after.document.find(child)->parent->section, drawn);
        QCOMPARE(after.document.find(later)->inputs.at("section")[0].section, drawn);
        QVERIFY(after.document.jointOverride(SectionRef(bones.spine), drawn));
    }
}

// Wrong: two plates of equal height would swap the sides of their slits, since ids decide there.
void TestBaking::equalEndsKeepTheirSide()
{
    Document document = newDocument();
    const auto plate = shapeOf(polygonContour(rectangleAt(-50, 0, 100, 40)));
    const SectionId front = add(document, "Front", plate, frontFrame());
    const SectionId side = add(document, "Side", plate, sideFrame({-40, 0, 0}));
    const SectionId across = add(document, "Across", plate, frontFrame({0, 0, 40}));
    const OperationId rows =
        add(document, operation("linear", {{"section", {side}}, {"along", {front}}},
                                {{"count", 5.0}, {"side", std::string("both")}}));
    const OperationId columns =
        add(document, operation("linear", {{"section", {front}}, {"along", {side}}},
                                {{"count", 4.0}, {"side", std::string("both")}}));
    Q_UNUSED(across);
    Q_UNUSED(rows);
    const Model model = evaluate(document);
    QVERIFY(model.sectionCount() > 8);
    // The later one first: its sections come to stand before those of the other.
    const Model after = evaluate(baked(model, columns).value(), model);
    QVERIFY(looks(after) == looks(model));
    const Model all = evaluate(baked(after, rows).value(), after);
    QVERIFY(looks(all) == looks(model));
}

// Wrong: a crash, or a step of the history that does nothing.
void TestBaking::nothingToBake()
{
    FishBones bones;
    Operation off = operation("linear", {{"section", {bones.rib}}, {"along", {bones.spine}}});
    off.isOn = false;
    const OperationId id = add(bones.document, off);
    const Model model = evaluate(bones.document);
    QCOMPARE(baked(model, id).value().sections.size(), 2U);
    QVERIFY(!baked(model, OperationId{99}));
    QVERIFY(!detached(model, {id, "1"}));
    QVERIFY(!detached(model, SectionRef(bones.rib)));
}

FFF_TEST(TestBaking)
#include "tst_baking.moc"
