#include "core/assembly/cut_section.h"
#include "core/base/tolerances.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QTest>

#include <random>

using namespace fff;
using namespace fff::test;

namespace {

Slit slitAt(double x, double width = 3.0)
{
    Slit slit;
    slit.inner = {x, 20.0};
    slit.mouth = {x, 41.0};
    slit.width = width;
    return slit;
}

ShapePointer plate(double width = 40.0)
{
    return Shape::make(polygonContour(rectangleAt(0, 0, width, 40))).value();
}

/// Of slits that leave the section 4 mm before their mouth or less.
std::vector<SlitForm> forms()
{
    std::vector<SlitForm> forms;
    for (const SlitEnd end : {SlitEnd::Round, SlitEnd::Dogbone, SlitEnd::TBone, SlitEnd::Square}) {
        SlitForm form;
        form.end = end;
        form.radius = end == SlitEnd::Square ? 0.0 : 1.3;
        form.held = 8.0;
        if (end != SlitEnd::Square)
            forms.push_back(form);
        form.bumps = 0.1;
        forms.push_back(form);
    }
    return forms;
}

} // namespace

class TestCutSection : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void slitsTakeTheirArea();
    void sameSlitsGiveTheSameObject();
    void anyChangeOfASlitGivesAnother_data();
    void anyChangeOfASlitGivesAnother();
    void jointsNumbersDoNotMatter();
    void reusedAddressIsNotTheOldShape();
    void cacheIsBounded();
    void aFormGivesAnother();
    void formsAreCutAsTheBooleanDoes_data();
    void formsAreCutAsTheBooleanDoes();
    void reliefTakesWhatTheSquareTakes_data();
    void reliefTakesWhatTheSquareTakes();
    void whatWasCutBeforeDoesNotMatter_data();
    void whatWasCutBeforeDoesNotMatter();
};

// Wrong: mass and drawing would not be those of what is cut.
void TestCutSection::slitsTakeTheirArea()
{
    CutCache cache;
    const ShapePointer disc = Shape::make(circle({20, 20}, 20), {circle({20, 10}, 4)}).value();
    const auto whole = cutSection(disc, {}, cache);
    QVERIFY(std::abs(whole->area() - disc->area()) < 1e-9);
    Slit mortise = slitAt(30);
    mortise.mouth = {30, 25};
    const auto cut = cutSection(disc, {mortise}, cache);
    QVERIFY(std::abs(cut->area() - (disc->area() - 15.0)) < 1e-9);
    QCOMPARE(cut->triangulations()->size(), 1U);
    double triangles = 0.0;
    const Triangulation &t = cut->triangulations()->at(0);
    for (const auto &[a, b, c] : t.triangles) {
        const auto p = [&](int i) { return t.points[static_cast<std::size_t>(i)]; };
        triangles += 0.5 * cross(p(b) - p(a), p(c) - p(a));
    }
    QVERIFY(std::abs(triangles - area(cut->parts()[0].region)) < 1e-9);
}

// Wrong: dragging one section would cut all others again, and draw them again.
void TestCutSection::sameSlitsGiveTheSameObject()
{
    CutCache cache;
    const ShapePointer shape = plate();
    const auto first = cutSection(shape, {slitAt(10), slitAt(30)}, cache);
    cutSection(shape, {slitAt(11), slitAt(30)}, cache);
    QCOMPARE(cutSection(shape, {slitAt(10), slitAt(30)}, cache).get(), first.get());
    CutCache moved = std::move(cache);
    QCOMPARE(cutSection(shape, {slitAt(10), slitAt(30)}, moved).get(), first.get());
}

void TestCutSection::anyChangeOfASlitGivesAnother_data()
{
    QTest::addColumn<Vec2>("inner");
    QTest::addColumn<Vec2>("mouth");
    QTest::addColumn<double>("width");
    QTest::newRow("deeper") << Vec2(10, 19) << Vec2(10, 41) << 3.0;
    QTest::newRow("beside") << Vec2(10.001, 20) << Vec2(10.001, 41) << 3.0;
    QTest::newRow("wider") << Vec2(10, 20) << Vec2(10, 41) << 3.01;
    QTest::newRow("mouth farther out") << Vec2(10, 20) << Vec2(10, 42) << 3.0;
    QTest::newRow("upside down") << Vec2(10, 41) << Vec2(10, 20) << 3.0;
}

// Wrong: an edit of a joint would not show.
void TestCutSection::anyChangeOfASlitGivesAnother()
{
    QFETCH(Vec2, inner);
    QFETCH(Vec2, mouth);
    QFETCH(double, width);
    CutCache cache;
    const ShapePointer shape = plate();
    const auto before = cutSection(shape, {slitAt(10)}, cache);
    Slit other = slitAt(10);
    other.inner = inner;
    other.mouth = mouth;
    other.width = width;
    QVERIFY(cutSection(shape, {other}, cache) != before);
    QVERIFY(cutSection(plate(), {slitAt(10)}, cache) != before);
}

// Wrong: a new joint elsewhere renumbers all and would cut everything again.
void TestCutSection::jointsNumbersDoNotMatter()
{
    CutCache cache;
    const ShapePointer shape = plate();
    const auto before = cutSection(shape, {slitAt(10)}, cache);
    Slit renumbered = slitAt(10);
    renumbered.joint = 7;
    renumbered.guest = 3;
    QCOMPARE(cutSection(shape, {renumbered}, cache).get(), before.get());
}

// Wrong: a new shape would look like one that is gone, once in a while.
void TestCutSection::reusedAddressIsNotTheOldShape()
{
    CutCache cache;
    for (int i = 0; i < 50; ++i) {
        const double width = 40.0 + i;
        QCOMPARE(cutSection(plate(width), {}, cache)->area(), 40.0 * width);
    }
}

// Wrong: a long session would fill the memory.
void TestCutSection::cacheIsBounded()
{
    CutCache cache;
    const ShapePointer shape = plate();
    std::weak_ptr<const CutSection> first = cutSection(shape, {slitAt(10)}, cache);
    QVERIFY(!first.expired());
    std::weak_ptr<const CutSection> last;
    for (int i = 0; i < 1500; ++i)
        last = cutSection(shape, {slitAt(11.0 + 0.01 * i)}, cache);
    QVERIFY(first.expired());
    QVERIFY(!last.expired());
}

// Wrong: another slit end in the stock would not show.
void TestCutSection::aFormGivesAnother()
{
    CutCache cache;
    const ShapePointer shape = plate();
    std::vector<CutSectionPointer> cuts{cutSection(shape, {slitAt(10)}, cache)};
    Slit last;
    for (const SlitForm &form : forms()) {
        last = slitAt(10);
        last.form = std::make_shared<const SlitForm>(form);
        cuts.push_back(cutSection(shape, {last}, cache));
        QCOMPARE(std::count(cuts.begin(), cuts.end(), cuts.back()), 1);
    }
    last.form = std::make_shared<const SlitForm>(*last.form); // an equal one
    QCOMPARE(cutSection(shape, {last}, cache), cuts.back());
    last.isOpen = false;
    QVERIFY(cutSection(shape, {last}, cache) != cuts.back());
}

void TestCutSection::formsAreCutAsTheBooleanDoes_data()
{
    QTest::addColumn<int>("form");
    for (std::size_t i = 0; i < forms().size(); ++i)
        QTest::addRow("form %d", static_cast<int>(i)) << static_cast<int>(i);
}

// Wrong: a part would hang on which way it was cut, or lose the curves that a machine is to follow.
void TestCutSection::formsAreCutAsTheBooleanDoes()
{
    QFETCH(int, form);
    const auto shared = std::make_shared<const SlitForm>(forms()[static_cast<std::size_t>(form)]);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(8.0, 92.0), tilt(-0.6, 0.6), depth(4.0, 30.0);
    const ShapePointer disc = Shape::make(circle({50, 10}, 50), {circle({50, -20}, 8)}).value();
    int alike = 0;
    for (int round = 0; round < 200; ++round) {
        std::vector<Slit> slits;
        for (int i = 0; i < 1 + round % 3; ++i) {
            const double x = place(random);
            const double top = 10.0 + std::sqrt(2500.0 - (x - 50.0) * (x - 50.0));
            const Vec2 way(std::sin(tilt(random)), -1.0);
            Slit slit;
            slit.mouth = Vec2(x, top) - 4.0 * way.normalized();
            slit.inner = Vec2(x, top) + depth(random) * way.normalized();
            slit.width = 3.0;
            slit.form = shared;
            slits.push_back(slit);
        }
        CutCache cache;
        const auto cut = cutSection(disc, slits, cache);
        const std::vector<CurvedRegion> parts =
            CutSection(*cutShape(*disc, slits, kCutChord)).parts(); // without chips
        QCOMPARE(cut->parts().size(), parts.size());
        double difference = cut->area();
        bool isSame = true;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            difference -= parts[i].outer.signedArea();
            for (const Contour &hole : parts[i].holes)
                difference -= hole.signedArea();
            isSame =
                isSame && cut->parts()[i].outer.segmentCount() == parts[i].outer.segmentCount();
        }
        QVERIFY2(std::abs(difference) < 1e-3, qPrintable(QString::number(difference)));
        alike += isSame ? 1 : 0;
        // Few pieces: each arc is a curve or two.
        QVERIFY(parts[0].outer.segmentCount() < 80);
    }
    QVERIFY(alike > 150);
}

void TestCutSection::reliefTakesWhatTheSquareTakes_data()
{
    formsAreCutAsTheBooleanDoes_data();
}

// Wrong: a guest that does not go in, or parts that lose material away from their slits. Nasty: the
// ends run into each other, into the hole and out of the edge.
void TestCutSection::reliefTakesWhatTheSquareTakes()
{
    QFETCH(int, form);
    SlitForm bare = forms()[static_cast<std::size_t>(form)];
    bare.bumps = 0.0;
    const ShapePointer shape =
        Shape::make(polygonContour(rectangleAt(0, 0, 100, 40)), {circle({80, 15}, 5)}).value();
    std::vector<Slit> slits{slitAt(20), slitAt(24.5), slitAt(50), slitAt(80, 4.0), slitAt(2.5)};
    slits[2].inner.y() = 0.5;
    slits[3].inner.y() = 20.5;
    std::vector<Slit> square = slits;
    Slit mortise;
    mortise.inner = {60, 10};
    mortise.mouth = {70, 10};
    mortise.width = 3.0;
    mortise.isOpen = false;
    square.push_back(mortise);
    slits.push_back(mortise);
    for (Slit &slit : slits)
        slit.form = std::make_shared<const SlitForm>(bare);
    CutCache cache;
    const auto plain = cutSection(shape, square, cache), cut = cutSection(shape, slits, cache);
    const auto isIn = [](const CutSection &section, const Vec2 &p) {
        return std::any_of(section.parts().begin(), section.parts().end(), [&](const auto &part) {
            return locate(p, part.region) == Side::Inside;
        });
    };
    int less = 0;
    for (double x = 0.03; x < 100.0; x += 0.11) {
        for (double y = 0.03; y < 40.0; y += 0.11) {
            const Vec2 p(x, y);
            if (isIn(*cut, p))
                QVERIFY(isIn(*plain, p));
            else if (isIn(*plain, p)) {
                ++less;
                double nearest = 1e9;
                for (const Slit &slit : square)
                    for (const Vec2 &corner : slit.outline())
                        nearest = std::min(nearest, (corner - p).norm());
                QVERIFY(nearest < std::max(2.0 * bare.radius, 4.0));
            }
        }
    }
    const bool hasMore = bare.radius > 0.0 || bare.leadIns[0].top > 0.0;
    QCOMPARE(less > 0, hasMore);
}

void TestCutSection::whatWasCutBeforeDoesNotMatter_data()
{
    QTest::addColumn<std::vector<double>>("before");
    QTest::addColumn<std::vector<double>>("now");
    using Places = std::vector<double>;
    const Places four{20, 40, 60, 80};
    QTest::newRow("one slit moved") << four << Places{20, 40, 65, 80};
    QTest::newRow("the first went") << four << Places{40, 60, 80};
    QTest::newRow("one within went") << four << Places{20, 60, 80};
    QTest::newRow("two came at the end") << four << Places{20, 40, 60, 80, 90, 95};
    QTest::newRow("one came at the start") << four << Places{10, 20, 40, 60, 80};
    QTest::newRow("another order") << four << Places{80, 20, 60, 40};
    QTest::newRow("all went") << four << Places{};
    QTest::newRow("from none") << Places{} << four;
    QTest::newRow("one moved over a corner") << four << Places{20, 40, 60, 100};
    QTest::newRow("one moved back from a corner") << Places{20, 40, 60, 100} << four;
    QTest::newRow("two run into each other") << four << Places{20, 40, 42, 80};
    QTest::newRow("two moved apart") << Places{20, 40, 42, 80} << four;
}

// Wrong: what is cut would hang on how a person came to it, and differ in the file made tomorrow.
void TestCutSection::whatWasCutBeforeDoesNotMatter()
{
    QFETCH(std::vector<double>, before);
    QFETCH(std::vector<double>, now);
    const auto slits = [](const std::vector<double> &places) {
        std::vector<Slit> all;
        for (const double x : places)
            all.push_back(slitAt(x));
        return all;
    };
    const std::vector<ShapePointer> shapes{
        plate(100.0), Shape::make(circle({50, 10}, 60), {circle({50, 0}, 10)}).value()};
    for (const ShapePointer &shape : shapes) {
        CutCache cache, none;
        const auto known = cutSection(shape, slits(before), cache);
        const auto next = cutSection(shape, slits(now), cache, known.get());
        const auto fresh = cutSection(shape, slits(now), none);
        QCOMPARE(next->parts().size(), fresh->parts().size());
        for (std::size_t i = 0; i < fresh->parts().size(); ++i) {
            QVERIFY(next->parts()[i].outer == fresh->parts()[i].outer);
            QVERIFY(next->parts()[i].holes == fresh->parts()[i].holes);
            QCOMPARE(next->parts()[i].region.outer, fresh->parts()[i].region.outer);
        }
        // And back, as undo goes.
        QCOMPARE(cutSection(shape, slits(before), cache, next.get()), known);
    }
}

FFF_TEST(TestCutSection)
#include "tst_cut_section.moc"
