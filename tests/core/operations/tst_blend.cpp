#include "core/geometry/contour_blend.h"
#include "core/geometry/contour_points.h"
#include "tests/core/operations/operation_models.h"
#include "tests/test_program.h"

#include <QTest>

#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

/// A disc on which two figures stand, at x = −60 and 60; the second is turned by `turn`.
struct Figures
{
    Document document = newDocument();
    SectionId root, first, last;

    explicit Figures(const Contour &base, double turn = 0.0, bool hasHoles = false)
    {
        root = add(document, "Base", shapeOf(base), {{0, 10, 0}, Vec3::UnitX(), -Vec3::UnitZ()});
        const std::vector<Contour> holes =
            hasHoles ? std::vector{circle({0, 40}, 5)} : std::vector<Contour>();
        first = add(document, "Thin",
                    shapeOf(polygonContour(rectangleAt(40, 0, 40, 60)),
                            hasHoles ? std::vector{circle({60, 45}, 5)} : holes),
                    {{-60, 0, 0}, Vec3::UnitZ(), Vec3::UnitY()});
        const Vec3 across(std::sin(turn), 0.0, std::cos(turn));
        last = add(document, "Thick",
                   shapeOf(polygonContour({{30, 0}, {90, 0}, {100, 40}, {90, 80}, {30, 80}}),
                           hasHoles ? std::vector{circle({60, 30}, 12)} : holes),
                   {{60, 0, 0}, across, Vec3::UnitY()});
    }

    Model blended(std::map<std::string, ParameterValue> values,
                  std::vector<SectionRef> sections = {})
    {
        if (sections.empty())
            sections = {first, last};
        add(document,
            operation("blend", {{"sections", sections}, {"along", {root}}}, std::move(values)));
        return evaluate(document);
    }
};

Contour slab()
{
    return polygonContour({{-160, -60}, {160, -60}, {160, 60}, {-160, 60}});
}

/// The largest distance of the section's curve from the other's, in space.
double distance(const Section &a, const Section &b)
{
    double most = 0.0;
    for (const Vec2 &p : uniformSamples(a.shape->contour(), 400)) {
        const Vec3 world = a.frame.toWorld(p);
        const double beside = std::abs(b.frame.height(world));
        most = std::max(
            {most, beside, nearestPlace(b.shape->contour(), b.frame.toLocal(world)).distance});
    }
    return most;
}

} // namespace

class TestBlend : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nearTheEndsItIsThem_data();
    void nearTheEndsItIsThem();
    void countsAndKeys();
    void anglesTurnEvenly();
    void slowEnds();
    void holesGoAlong();
    void threeSections();
    void apartMakesNothing();
};

void TestBlend::nearTheEndsItIsThem_data()
{
    QTest::addColumn<double>("turn");
    QTest::newRow("parallel") << 0.0;
    QTest::newRow("turned") << 0.5;
    QTest::newRow("turned the other way") << -0.7;
}

// Wrong: the row would jump where it meets the sections that it was made of.
void TestBlend::nearTheEndsItIsThem()
{
    QFETCH(double, turn);
    Figures figures(slab(), turn);
    const Model model = figures.blended({{"count", 200.0}});
    QCOMPARE(model.sectionCount(), 3U + 200U);
    const OperationId id = model.document.operations[0]->id;
    const Section &first = *model.section(1), &last = *model.section(2);
    // A two hundredth of the way, and of what differs, each.
    const double step = 2.0 * (120.0 + 40.0 + 100.0 * std::abs(turn)) / 201.0;
    QVERIFY(distance(*model.find({id, "0/1"}), first) < step);
    QVERIFY(distance(*model.find({id, "0/200"}), last) < step);
    for (int i = 2; i <= 200; ++i)
        QVERIFY(distance(*model.find({id, "0/" + std::to_string(i)}),
                         *model.find({id, "0/" + std::to_string(i - 1)})) < step);
    // They stand on the way between both, in equal steps.
    const double x1 = model.find({id, "0/1"})->frame.origin.x();
    const double x2 = model.find({id, "0/2"})->frame.origin.x();
    QVERIFY(std::abs((x2 - x1) - (x1 + 60.0)) < 1e-6);
}

// Wrong: another number than asked, or names for them that change.
void TestBlend::countsAndKeys()
{
    for (const int count : {1, 6, 18}) {
        Figures figures(slab());
        const Model model = figures.blended({{"count", double(count)}});
        QCOMPARE(static_cast<int>(model.sectionCount()), 3 + count);
        QCOMPARE(model.section(3)->made.key, std::string("0/1"));
        QCOMPARE(model.section(3)->name, std::string("Thin 1"));
        for (std::size_t i = 3; i < model.sectionCount(); ++i) {
            QVERIFY(model.section(i)->shape->isPlain());
            QVERIFY(model.section(i)->parent->section == SectionRef(figures.root));
        }
    }
}

// Wrong: the row would turn all at once.
void TestBlend::anglesTurnEvenly()
{
    Figures figures(slab(), 0.6);
    const Model model = figures.blended({{"count", 5.0}});
    const Vec3 first = model.section(1)->frame.normal();
    for (int i = 1; i <= 5; ++i) {
        const Vec3 n = model.find({model.document.operations[0]->id, "0/" + std::to_string(i)})
                           ->frame.normal();
        QVERIFY(std::abs(n.y()) < 1e-12);
        const double angle = std::acos(std::min(1.0, std::abs(n.dot(first))));
        QVERIFY(std::abs(angle - 0.1 * i) < 1e-6);
    }
}

// Wrong: easing would do nothing.
void TestBlend::slowEnds()
{
    Figures figures(slab());
    const Model model = figures.blended({{"count", 3.0}, {"easing", std::string("slow")}});
    const auto x = [&](const char *key) {
        return model.find({model.document.operations[0]->id, key})->frame.origin.x();
    };
    QVERIFY(std::abs(x("0/2")) < 1e-6);
    QVERIFY(std::abs(x("0/1") - (-60.0 + 120.0 / 16.0)) < 1e-6); // 4 · (1/4)³
}

// Wrong: windows would be lost between two sections that have one.
void TestBlend::holesGoAlong()
{
    Figures figures(slab(), 0.0, true);
    const Model model = figures.blended({{"count", 1.0}});
    const Shape &half = *model.section(3)->shape;
    QCOMPARE(half.holes().size(), 1U);
    const Box2 box = half.holes()[0].bounds();
    QVERIFY((box.size() - Vec2(17, 17)).norm() < 0.1);
}

// Wrong: only the first two of three poses would be blended.
void TestBlend::threeSections()
{
    Figures figures(slab());
    const SectionId middle =
        add(figures.document, "Middle", shapeOf(polygonContour(rectangleAt(45, 0, 30, 100))),
            {{10, 0, 0}, Vec3::UnitZ(), Vec3::UnitY()});
    const Model model = figures.blended({{"count", 2.0}}, {figures.first, middle, figures.last});
    QCOMPARE(model.sectionCount(), 4U + 4U);
    const OperationId id = model.document.operations[0]->id;
    QVERIFY(std::abs(model.find({id, "0/1"})->frame.origin.x() - (-60.0 + 70.0 / 3.0)) < 1e-6);
    QVERIFY(std::abs(model.find({id, "1/2"})->frame.origin.x() - (10.0 + 100.0 / 3.0)) < 1e-6);
}

// Wrong: a crash, or sections somewhere.
void TestBlend::apartMakesNothing()
{
    Figures figures(circle({0, 0}, 20)); // the figures stand beside it
    const Model model = figures.blended({});
    QCOMPARE(model.sectionCount(), 3U);
    QCOMPARE(model.evaluation.results[0]->notices.front().kind, OperationNotice::Kind::InputsApart);
    Figures one(slab());
    const Model alone = one.blended({}, {one.first});
    QCOMPARE(alone.evaluation.results[0]->notices.front().kind,
             OperationNotice::Kind::InputMissing);
}

FFF_TEST(TestBlend)
#include "tst_blend.moc"
