// Slices along a curve: one piece at each place of the spine, evenly, and still there after edits.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/io/fff_format.h"
#include "core/model/template_edits.h"
#include "core/operations/baking.h"
#include "core/operations/insertion.h"
#include "core/operations/scaled_model.h"
#include "core/templates/template_mesh.h"
#include "tests/core/operations/operation_models.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kMajor = 60.0, kMinor = 10.0; // mm, of the tube
const Vec3 kMiddle(0.0, kMajor + kMinor, 0.0);

/// A tube about the z axis that stands on the ground, and the circle in its middle.
struct Tube
{
    explicit Tube(const MeshDraft &draft = torus(kMajor, kMinor, 180, 60), double radius = kMajor)
    {
        Template one;
        one.name = "Tube";
        one.file = "tube.stl";
        one.mesh = makeTemplateMesh(mended(draft).value().mesh, {}).value();
        one = stood(one, *one.mesh, UpAxis::Y, one.mesh->mesh->size());
        document = addTemplate(newDocument(), one).value();
        spine = add(document, "Spine", shapeOf(circle(Vec2::Zero(), radius)), frontFrame(kMiddle));
    }

    Document sliced(std::map<std::string, ParameterValue> values) const
    {
        values.emplace("direction", std::string("curve"));
        Operation slices = operation("slices", {{"spine", {spine}}}, std::move(values));
        slices.subject = document.templates.front()->id;
        Document next = document;
        add(next, slices);
        return next;
    }

    Document document;
    SectionId spine;
};

std::vector<SectionPointer> slicesOf(const Model &model)
{
    return model.evaluation.results.front()->sections;
}

Vec3 middleOf(const Section &section)
{
    return section.frame.toWorld(section.shape->centroid());
}

/// Round the tube's axis from the x axis, of 1.
double turnOf(const Section &section)
{
    const Vec3 way = middleOf(section) - kMiddle;
    const double turn = std::atan2(way.y(), way.x()) / kTurn;
    return turn < 0.0 ? turn + 1.0 : turn;
}

bool isDiscAt(const Section &section, double turn)
{
    const double angle = kTurn * turn;
    const Vec3 out(std::cos(angle), std::sin(angle), 0.0), way(-out.y(), out.x(), 0.0);
    return std::abs(section.shape->area() / (0.5 * kTurn * kMinor * kMinor) - 1.0) < 0.01 &&
           (middleOf(section) - kMiddle - kMajor * out).norm() < 0.1 &&
           (section.frame.normal() - way).norm() < 0.01;
}

} // namespace

class TestSlicesAlong : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void discsOfATube_data();
    void discsOfATube();
    void bySpacing();
    void aShiftMovesThemOn();
    void aPartOfTheContour_data();
    void aPartOfTheContour();
    void theWallOfAPipeStays();
    void whatIsElsewhereIsLeft();
    void aSpineBesideTheTube();
    void editsOfTheSpine();
    void editsOfTheTemplate();
    void withoutASpine();
    void onlyWhatChangesIsMadeAnew();
    void movedTurnedAndScaled();
    void mirroredBakedAndCopied();
};

void TestSlicesAlong::discsOfATube_data()
{
    QTest::addColumn<int>("count");
    for (const int count : {1, 2, 3, 12, 60})
        QTest::addRow("%d", count) << count;
}

// Wrong: a plane cuts the tube's other side, too, or places are not even.
void TestSlicesAlong::discsOfATube()
{
    QFETCH(int, count);
    const Model model = evaluate(Tube().sliced({{"count", double(count)}}));
    const auto slices = slicesOf(model);
    QCOMPARE(slices.size(), static_cast<std::size_t>(count));
    QVERIFY(model.evaluation.results.front()->notices.empty());
    for (int i = 0; i < count; ++i) {
        const Section &slice = *slices[static_cast<std::size_t>(i)];
        QVERIFY(isDiscAt(slice, (i + 0.5) / count));
        QCOMPARE(slice.made.key, "c/" + std::to_string(i) + "/0");
        QCOMPARE(slice.name, "Tube C" + std::to_string(i + 1));
    }
}

void TestSlicesAlong::bySpacing()
{
    const double length = kTurn * kMajor;
    for (const double spacing : {30.0, length / 8.0, 300.0, 1000.0}) {
        const Model model =
            evaluate(Tube().sliced({{"planesBy", std::string("spacing")}, {"spacing", spacing}}));
        const auto slices = slicesOf(model);
        // So many that no two are nearer, round the seam as well. The contour is off a circle by
        // 0.03 %, so an eighth of that is one too many or not.
        const double room = length / spacing;
        QVERIFY(slices.size() == static_cast<std::size_t>(std::max(1.0, std::floor(room))) ||
                std::abs(room - std::round(room)) < 1e-3);
        for (std::size_t i = 1; i < slices.size(); ++i)
            QVERIFY(std::abs((turnOf(*slices[i]) - turnOf(*slices[i - 1])) * length - spacing) <
                    0.05);
    }
}

void TestSlicesAlong::aShiftMovesThemOn()
{
    for (const double shift : {-0.5, -0.2, 0.3, 0.5}) {
        const Model model = evaluate(Tube().sliced({{"count", 8.0}, {"shift", shift}}));
        const auto slices = slicesOf(model);
        QCOMPARE(slices.size(), std::size_t(8));
        for (std::size_t i = 0; i < 8; ++i)
            QVERIFY(isDiscAt(*slices[i], (static_cast<double>(i) + 0.5 + shift) / 8.0));
    }
}

void TestSlicesAlong::aPartOfTheContour_data()
{
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::addColumn<double>("size");
    QTest::newRow("a quarter") << 0.25 << 0.5 << 0.25;
    QTest::newRow("past the start") << 0.75 << 0.25 << 0.5;
    QTest::newRow("all but a little") << 0.0 << 0.99 << 0.99;
    QTest::newRow("from the end to the start") << 1.0 << 0.0 << 0.0;
}

void TestSlicesAlong::aPartOfTheContour()
{
    QFETCH(double, from);
    QFETCH(double, to);
    QFETCH(double, size);
    const Tube tube;
    const auto slices =
        slicesOf(evaluate(tube.sliced({{"from", from}, {"to", to}, {"count", 5.0}})));
    QCOMPARE(slices.size(), std::size_t(5));
    for (std::size_t i = 0; i < 5; ++i) {
        const double turn = from + size * (static_cast<double>(i) + 0.5) / 5.0;
        QVERIFY(isDiscAt(*slices[i], turn - std::floor(turn)));
    }
    if (size == 0.0)
        return;
    // What a shift takes beyond the end is left out, and those that stay keep their names.
    const auto moved = slicesOf(evaluate(tube.sliced({{"from", from},
                                                      {"to", to},
                                                      {"planesBy", std::string("spacing")},
                                                      {"spacing", size * kTurn * kMajor / 4.001},
                                                      {"shift", 0.5}})));
    QVERIFY(moved.size() == 4 || moved.size() == 3);
    QCOMPARE(moved.front()->made.key, std::string("c/0/0"));
}

// Wrong: the spine runs in the hollow of a pipe, and nothing is there to be cut.
void TestSlicesAlong::theWallOfAPipeStays()
{
    MeshDraft pipe = torus(kMajor, kMinor, 120, 40);
    append(pipe, turnedOver(torus(kMajor, 6.0, 120, 40)));
    const auto slices = slicesOf(evaluate(Tube(pipe).sliced({{"count", 7.0}})));
    QCOMPARE(slices.size(), std::size_t(7));
    for (const SectionPointer &slice : slices) {
        QCOMPARE(slice->shape->holes().size(), std::size_t(1));
        QVERIFY(std::abs(slice->shape->area() / (0.5 * kTurn * (100.0 - 36.0)) - 1.0) < 0.02);
    }
}

// Wrong: where the tube is gone, planes cut its other side, which has planes of its own.
void TestSlicesAlong::whatIsElsewhereIsLeft()
{
    const MeshDraft half =
        without(torus(kMajor, kMinor, 180, 60), [](const Vec3 &p) { return p.x() < 0.0; });
    Tube tube(half);
    Template one = *tube.document.templates.front();
    one.frame.origin.x() = 0.5 * (kMajor + kMinor); // its middle was put above the origin
    tube.document = setTemplate(tube.document, one).value();
    const auto slices = slicesOf(evaluate(tube.sliced({{"count", 20.0}})));
    QCOMPARE(slices.size(), std::size_t(10));
    for (const SectionPointer &slice : slices)
        QVERIFY(middleOf(*slice).x() > 0.0);
}

void TestSlicesAlong::aSpineBesideTheTube()
{
    for (const double radius : {kMajor - 12.0, kMajor - kMinor, kMajor + kMinor, kMajor + 30.0}) {
        const auto slices = slicesOf(
            evaluate(Tube(torus(kMajor, kMinor, 180, 60), radius).sliced({{"count", 9.0}})));
        QCOMPARE(slices.size(), std::size_t(9));
        for (std::size_t i = 0; i < 9; ++i)
            QVERIFY(isDiscAt(*slices[i], (static_cast<double>(i) + 0.5) / 9.0));
    }
}

void TestSlicesAlong::editsOfTheSpine()
{
    const Tube tube;
    const Document document = tube.sliced({{"count", 6.0}});
    const Model before = evaluate(document);
    const Document wider =
        setShape(document, tube.spine, shapeOf(circle(Vec2::Zero(), kMajor + 4.0))).value();
    const Model after = evaluate(wider, before);
    QCOMPARE(slicesOf(after).size(), std::size_t(6));
    for (std::size_t i = 0; i < 6; ++i) {
        QVERIFY(isDiscAt(*slicesOf(after)[i], (static_cast<double>(i) + 0.5) / 6.0));
        QCOMPARE(slicesOf(after)[i]->made.key, slicesOf(before)[i]->made.key);
    }
    const Model gone = evaluate(removeSections(document, std::vector{tube.spine}).value(), before);
    QCOMPARE(gone.sectionCount(), std::size_t(0));
    QVERIFY(gone.evaluation.results[0]->notices[0].kind == OperationNotice::Kind::InputMissing);
    QVERIFY(evaluate(document, before).evaluation.results[0] == before.evaluation.results[0]);
}

void TestSlicesAlong::editsOfTheTemplate()
{
    const Tube tube;
    const Document document = tube.sliced({{"count", 6.0}});
    const Model before = evaluate(document);
    Template thicker = *document.templates.front();
    thicker.frame.origin.z() += 3.0;
    const Model moved = evaluate(setTemplate(document, thicker).value(), before);
    QCOMPARE(slicesOf(moved).size(), std::size_t(6));
    for (std::size_t i = 0; i < 6; ++i) {
        QCOMPARE(slicesOf(moved)[i]->frame, slicesOf(before)[i]->frame); // of the spine alone
        QVERIFY((middleOf(*slicesOf(moved)[i]) - middleOf(*slicesOf(before)[i]) - Vec3(0, 0, 3))
                    .norm() < 0.05);
    }
    const Model without =
        evaluate(removeTemplate(document, document.templates.front()->id).value(), before);
    QVERIFY(without.evaluation.results[0]->notices[0].kind == OperationNotice::Kind::NoTemplate);
}

// Wrong: somebody who has chosen "along a curve" is not told what is still to be clicked.
void TestSlicesAlong::withoutASpine()
{
    Document document = Tube().sliced({});
    Operation slices = *document.operations.front();
    slices.inputs.clear();
    const Model model = evaluate(setOperation(document, slices).value());
    QCOMPARE(slicesOf(model).size(), std::size_t(0));
    const auto &notices = model.evaluation.results[0]->notices;
    QCOMPARE(notices.size(), std::size_t(1));
    QVERIFY(notices[0].kind == OperationNotice::Kind::InputMissing);
    QCOMPARE(notices[0].role, std::string("spine"));
    // For other directions there is nothing to be clicked.
    slices.parameters["direction"] = std::string("x");
    QVERIFY(
        evaluate(setOperation(document, slices).value()).evaluation.results[0]->notices.empty());
}

void TestSlicesAlong::onlyWhatChangesIsMadeAnew()
{
    Tube tube;
    const SectionId other =
        add(tube.document, "Other", shapeOf(circle(Vec2::Zero(), 5.0)), frontFrame({300, 50, 0}));
    const Document document = tube.sliced({{"count", 4.0}});
    const Model before = evaluate(document);
    const Model after =
        evaluate(moveSection(document, other, frontFrame({310, 50, 0})).value(), before);
    QCOMPARE(after.evaluation.results[0], before.evaluation.results[0]);
}

// Wrong: what is made hangs on where in the world it is.
void TestSlicesAlong::movedTurnedAndScaled()
{
    std::mt19937 random(20141005);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const Tube tube;
    const Document document = tube.sliced({{"count", 7.0}, {"from", 0.1}, {"to", 0.8}});
    const Model before = evaluate(document);
    for (int round = 0; round < 5; ++round) {
        const Vec3 way(100.0 * uniform(random), 100.0 * uniform(random), 100.0 * uniform(random));
        const Model moved = evaluate(moveAll(document, way));
        const double factor = 1.0 + 0.5 * uniform(random);
        const Model scaled = evaluate(scaledModel(document, factor).value());
        QCOMPARE(slicesOf(moved).size(), std::size_t(7));
        QCOMPARE(slicesOf(scaled).size(), std::size_t(7));
        for (std::size_t i = 0; i < 7; ++i) {
            const Section &was = *slicesOf(before)[i];
            QVERIFY((middleOf(*slicesOf(moved)[i]) - middleOf(was) - way).norm() < 0.02);
            QVERIFY((middleOf(*slicesOf(scaled)[i]) - factor * middleOf(was)).norm() < 0.05);
            QVERIFY(std::abs(slicesOf(scaled)[i]->shape->area() /
                                 (factor * factor * was.shape->area()) -
                             1.0) < 0.005);
        }
    }
}

void TestSlicesAlong::mirroredBakedAndCopied()
{
    Document document = Tube().sliced({{"count", 5.0}, {"from", 0.05}, {"to", 0.2}});
    const Model model = evaluate(document);
    const OperationId slices = document.operations.front()->id;

    const Document drawn = baked(model, slices).value();
    QCOMPARE(drawn.sections.size(), model.sectionCount());
    for (std::size_t i = 0; i < 5; ++i)
        QVERIFY(*drawn.sections[i + 1]->shape == *slicesOf(model)[i]->shape &&
                drawn.sections[i + 1]->frame == slicesOf(model)[i]->frame);

    const auto read = io::readFff(io::writeFff(document).value());
    QVERIFY(read);
    QVERIFY(read->document == document);

    const Insertion twice = inserted(document, document);
    const Operation &copy = *twice.document.operations[1];
    QVERIFY(copy.inputs.at("spine").front().section != SectionRef(Tube().spine));
    QCOMPARE(evaluate(twice.document).sectionCount(), 2 * model.sectionCount());

    add(document, operation("mirror", {}, {{"plane", std::string("x")}}));
    const Model mirrored = evaluate(document);
    const auto &images = mirrored.evaluation.results[1]->sections;
    for (const SectionPointer &slice : slicesOf(model)) {
        const Vec3 middle = middleOf(*slice);
        const Vec3 there(-middle.x(), middle.y(), middle.z());
        QVERIFY(std::any_of(images.begin(), images.end(), [&](const SectionPointer &image) {
            return (middleOf(*image) - there).norm() < 1e-6;
        }));
    }
}

FFF_TEST(TestSlicesAlong)
#include "tst_slices_along.moc"
