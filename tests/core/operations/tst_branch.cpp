#include "core/assembly/assembly.h"
#include "core/operations/seeded.h"
#include "tests/core/operations/operation_models.h"
#include "tests/test_program.h"

#include <QTest>

#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

/// A letter Y on a base, with a leaf across each arm.
struct Tree
{
    Document document = newDocument();
    SectionId base, trunk, left, right;

    Tree()
    {
        base = add(document, "Base", shapeOf(circle({0, 0}, 40)), sideFrame({0, 0, 0}));
        trunk = add(document, "Trunk",
                    shapeOf(polygonContour({{-6, 20},
                                            {6, 20},
                                            {6, 70},
                                            {46, 110},
                                            {34, 118},
                                            {0, 84},
                                            {-34, 118},
                                            {-46, 110},
                                            {-6, 70}})),
                    frontFrame(), Parent{SectionRef(SectionId{2}), {0, 20}, {0, 40}});
        left = leaf("Left leaf", {-40, 114, 0}, {-1, 1, 0});
        right = leaf("Right leaf", {40, 114, 0}, {1, 1, 0});
    }

    SectionId leaf(const char *name, const Vec3 &tip, const Vec3 &way)
    {
        const Vec3 y = way.normalized();
        return add(
            document, name,
            shapeOf(Contour::fromPoints({{0, -10}, {15, 0}, {15, 20}, {0, 40}, {-15, 20}, {-15, 0}})
                        .value()),
            {tip, Vec3::UnitZ(), y},
            Parent{SectionRef(trunk), {tip.x(), tip.y() - 8}, {tip.x(), tip.y()}});
    }

    Model grown(std::vector<SectionRef> children, std::map<std::string, ParameterValue> values)
    {
        add(document,
            operation("branch", {{"root", {trunk}}, {"where", {base}}, {"children", children}},
                      std::move(values)));
        return evaluate(document);
    }
};

double overlapOf(const Model &model, const Section &a, const Section &b)
{
    Q_UNUSED(model);
    double most = 0.0;
    Model pair;
    pair.document = newDocument();
    for (const Section *section : {&a, &b})
        add(pair.document, "", section->shape, section->frame);
    pair = evaluate(pair.document);
    for (const Joint &joint : assemble(pair).joints)
        for (const Overlap &overlap : joint.crossing->overlaps)
            most = std::max(most, overlap.to - overlap.from);
    return most;
}

} // namespace

class TestBranch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void chosenChildrenGiveTheirPlace();
    void copiesHoldAsTheChildDid();
    void iterationsNest();
    void seedsAreTheSameEverywhere();
    void variationIsOfThePathAlone();
    void stops();
    void withoutAHolder();
    void hierarchyOfAnEarlierOne();
    void notAChild();
};

// Wrong: leaves and branches in one place, or the other leaf gone, too.
void TestBranch::chosenChildrenGiveTheirPlace()
{
    Tree tree;
    const Model model = tree.grown({tree.left}, {});
    const OperationId id = model.document.operations[0]->id;
    QVERIFY(!model.find(tree.left));
    QVERIFY(model.find(tree.right) && model.find(tree.base) && model.find(tree.trunk));
    QCOMPARE(model.sectionCount(), 3U + 3U); // trunk and both leaves again
    const std::string path = std::to_string(tree.left.value);
    const Section *trunk = model.find({id, path + "/0"});
    QVERIFY(trunk && model.find({id, path + "/" + std::to_string(tree.right.value)}));
    QCOMPARE(trunk->parent->section, SectionRef(tree.trunk));
    // Switched off, it is there again.
    Operation off = *model.document.operations[0];
    off.isOn = false;
    QVERIFY(evaluate(setOperation(model.document, off).value(), model).find(tree.left));
}

// Wrong: branches would hang loose, or sit too deep.
void TestBranch::copiesHoldAsTheChildDid()
{
    Tree tree;
    const Model before = evaluate(tree.document);
    const double depth = overlapOf(before, *before.find(tree.trunk), *before.find(tree.left));
    QVERIFY(depth > 5.0);
    const Model model = tree.grown({tree.left, tree.right}, {{"scale", 0.7}});
    const OperationId id = model.document.operations[0]->id;
    for (const SectionId child : {tree.left, tree.right}) {
        const Section *copy = model.find({id, std::to_string(child.value) + "/0"});
        QVERIFY(copy);
        const double got = overlapOf(model, *model.find(tree.trunk), *copy);
        QVERIFY2(std::abs(got - depth) < 0.05, qPrintable(QString::number(got)));
        // It lies where the leaf lay.
        QVERIFY(std::abs(std::abs(copy->frame.normal().dot(before.find(child)->frame.normal())) -
                         1.0) < 1e-9);
    }
}

// Wrong: an iteration more would change those before it.
void TestBranch::iterationsNest()
{
    for (const int iterations : {0, 1, 2, 3, 4}) {
        Tree tree;
        const Model model = tree.grown({tree.left, tree.right},
                                       {{"iterations", double(iterations)}, {"smallest", 0.0}});
        // 1 + 2 + 4 … trunks, and the leaves of the last ones; the base.
        const std::size_t trunks = (std::size_t(1) << (iterations + 1)) - 1;
        QCOMPARE(model.sectionCount(), 1U + trunks + (std::size_t(2) << iterations));
        QVERIFY(model.evaluation.results[0]->notices.empty());
    }
    Tree few, many;
    const Model small = few.grown({few.left}, {{"iterations", 3.0}});
    const Model large = many.grown({many.left}, {{"iterations", 5.0}});
    for (const SectionPointer &section : small.sections())
        if (const Section *same = large.find(section->ref()))
            QVERIFY(same->frame == section->frame);
    // All copies of a size share their shapes.
    std::set<const Shape *> shapes;
    Tree wide;
    const Model model = wide.grown({wide.left, wide.right}, {{"iterations", 3.0}});
    for (const SectionPointer &section : model.sections())
        shapes.insert(section->shape.get());
    QVERIFY2(shapes.size() <= 1 + 3 * 4, qPrintable(QString::number(shapes.size())));
}

// Wrong: a tree that a friend opens would be another one.
void TestBranch::seedsAreTheSameEverywhere()
{
    // Laid down once: FNV-1a of the seed and the path into mt19937_64, upper 53 bits.
    Seeded random(7, "12/14");
    const double first = random.symmetric(), second = random.symmetric();
    QVERIFY(std::abs(first - 0.1581310261498059) < 1e-15);
    QVERIFY(std::abs(second - -0.32021541766861583) < 1e-15);
    Tree tree;
    const Model model = tree.grown(
        {tree.left}, {{"seed", 7.0}, {"varyScale", 0.3}, {"varyAngle", 0.5}, {"iterations", 2.0}});
    const OperationId id = model.document.operations[0]->id;
    const std::string left = std::to_string(tree.left.value);
    const Vec3 origin = model.find({id, left + "/" + left + "/0"})->frame.origin;
    qInfo("%.12f %.12f %.12f", origin.x(), origin.y(), origin.z());
    QVERIFY((origin - Vec3(-74.863560324811, 146.525507382205, -42.324543187342)).norm() < 1e-9);
}

// Wrong: choosing one more leaf would bend all other branches.
void TestBranch::variationIsOfThePathAlone()
{
    const std::map<std::string, ParameterValue> values{
        {"iterations", 2.0}, {"varyScale", 0.3}, {"varyAngle", 0.5}, {"seed", 3.0}};
    Tree one, two;
    const Model first = one.grown({one.left}, values);
    const Model both = two.grown({two.right, two.left}, values);
    int same = 0;
    for (const SectionPointer &section : first.evaluation.results[0]->sections)
        if (const Section *other = both.find(section->made)) {
            QVERIFY(other->frame == section->frame);
            ++same;
        }
    QVERIFY(same >= 2);
}

// Wrong: the window would hang in a forest of a million, or cut dust.
void TestBranch::stops()
{
    Tree tree;
    const Model model = tree.grown({tree.left, tree.right},
                                   {{"iterations", 50.0}, {"scale", 1.0}, {"most", 100.0}});
    QVERIFY(model.evaluation.results[0]->sections.size() <= 100U);
    QVERIFY(model.evaluation.results[0]->sections.size() > 90U);
    QCOMPARE(model.evaluation.results[0]->notices.front().kind,
             OperationNotice::Kind::StoppedAtMost);
    Tree small;
    const Model tiny =
        small.grown({small.left}, {{"iterations", 50.0}, {"scale", 0.5}, {"smallest", 20.0}});
    for (const SectionPointer &section : tiny.evaluation.results[0]->sections)
        if (section->made.key.ends_with("/0"))
            QVERIFY(section->shape->bounds().size().maxCoeff() > 19.9);
    QVERIFY(tiny.evaluation.results[0]->sections.size() < 12U);
}

// Wrong: a tree that stands by itself could not branch.
void TestBranch::withoutAHolder()
{
    Tree tree;
    Document alone = removeSections(tree.document, std::vector{tree.base}).value();
    add(alone, operation("branch", {{"root", {tree.trunk}}, {"children", {tree.left}}}));
    const Model model = evaluate(alone);
    QCOMPARE(model.sectionCount(), 2U + 3U);
    const Section *copy =
        model.find({model.document.operations[0]->id, std::to_string(tree.left.value) + "/0"});
    QVERIFY(overlapOf(model, *model.find(tree.trunk), *copy) > 5.0);
}

// Wrong: the paper's tree, where each iteration is asked for by itself, could not be made.
void TestBranch::hierarchyOfAnEarlierOne()
{
    Tree tree;
    tree.grown({tree.left}, {});
    const OperationId first = tree.document.operations[0]->id;
    const SectionRef root(first, std::to_string(tree.left.value) + "/0");
    const SectionRef leaf(first,
                          std::to_string(tree.left.value) + "/" + std::to_string(tree.right.value));
    add(tree.document,
        operation("branch", {{"root", {root}}, {"where", {tree.trunk}}, {"children", {leaf}}}));
    const Model model = evaluate(tree.document);
    QVERIFY(model.evaluation.results[1]->notices.empty());
    QVERIFY(!model.find(leaf) && model.find(root));
    QCOMPARE(model.evaluation.results[1]->sections.size(), 3U);
}

// Wrong: something would be put somewhere.
void TestBranch::notAChild()
{
    Tree tree;
    const Model model = tree.grown({tree.base}, {});
    QCOMPARE(model.sectionCount(), 4U);
    QCOMPARE(model.evaluation.results[0]->notices.front().kind, OperationNotice::Kind::InputsApart);
}

FFF_TEST(TestBranch)
#include "tst_branch.moc"
