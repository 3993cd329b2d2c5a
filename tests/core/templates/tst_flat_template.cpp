// Pictures and drawings as they lie: how large, on which plane, turned how, and two of them
// aligned.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/outlines.h"
#include "core/templates/flat_template.h"
#include "core/templates/moved_template.h"
#include "core/templates/template_curves.h"
#include "core/templates/template_picture.h"
#include "tests/test_program.h"

#include <cmath>
#include <numbers>
#include <random>

using namespace fff;

namespace {

constexpr double kClose = 1e-9;

/// White, with a black rectangle from (x0, y0) to (x1, y1), pixels from the upper left.
TemplatePicturePointer drawn(int width, int height, int x0, int y0, int x1, int y1)
{
    auto picture = std::make_shared<TemplatePicture>();
    picture->width = width;
    picture->height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool isBlack = x >= x0 && x < x1 && y >= y0 && y < y1;
            const std::uint8_t shade = isBlack ? 0 : 255;
            picture->rgba.insert(picture->rgba.end(), {shade, shade, shade, 255});
        }
    return picture;
}

Template pictureOf(TemplatePicturePointer picture, double scale = 0.5)
{
    Template one;
    one.kind = TemplateKind::Picture;
    one.name = "picture";
    one.scale = scale;
    one.picture = std::move(picture);
    return one;
}

Section sectionAt(const Frame &frame)
{
    Section section;
    section.id = SectionId{7};
    section.name = "Plate";
    section.frame = frame;
    section.shape =
        Shape::make(Contour::ofPolygon({{10, 0}, {50, 0}, {50, 80}, {10, 80}}), {}).value();
    return section;
}

Model modelWith(const Section &section)
{
    Model model;
    model.document.sections.push_back(std::make_shared<const Section>(section));
    return model;
}

bool near(const Vec3 &a, const Vec3 &b)
{
    return (a - b).norm() < kClose;
}

} // namespace

class TestFlatTemplate : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sampledHasTheSameTones();
    void standardPlanes();
    void onASection();
    void turningIsAboutTheMiddle();
    void itIsAsLongAsTheLineSays();
    void linesThatSayNothing();
    void flippedItIsItsMirrorImage();
    void whatIsDrawnInIt();
    void twoPicturesAreAligned();
    void whatCannotBeAligned();
    void linesOfADrawing();
    void greysOfColours();
};

void TestFlatTemplate::standardPlanes()
{
    const Template one = pictureOf(drawn(200, 100, 0, 0, 1, 1));
    QCOMPARE(flatSize(one), Vec2(100, 50));
    const Template front = laidOn(one, StandardPlane::Front);
    const auto corners = cornersOf(front, front.placement());
    QVERIFY(near(corners[0], {-50, 0, 0}) && near(corners[1], {50, 0, 0}) &&
            near(corners[2], {50, 50, 0}) && near(corners[3], {-50, 50, 0}));
    // Seen along −x, the right is −z.
    const Template side = laidOn(one, StandardPlane::Side);
    QVERIFY(near(cornersOf(side, side.placement())[2], {0, 50, -50}));
    QVERIFY(near(side.frame.normal(), Vec3::UnitX()));
    // Seen from above, up is away.
    const Template ground = laidOn(one, StandardPlane::Ground);
    QVERIFY(near(cornersOf(ground, ground.placement())[2], {50, 0, -25}));
    QVERIFY(near(ground.frame.normal(), Vec3::UnitY()));
    for (const Template &laid : {front, side, ground})
        QCOMPARE(turnOf(laid.frame), 0.0);
}

void TestFlatTemplate::onASection()
{
    // Its x points down, so upright is a quarter turn.
    const Section section = sectionAt({{5, 100, 0}, -Vec3::UnitY(), Vec3::UnitX()});
    const Model model = modelWith(section);
    const Template one = laidOn(pictureOf(drawn(200, 100, 0, 0, 1, 1)), section);
    const auto corners = cornersOf(one, *worldPlacement(one, model));
    const Vec3 middle = section.frame.toWorld({30, 40});
    QVERIFY(near(corners[0], middle + Vec3(-50, -25, 0)));
    QVERIFY(near(corners[2], middle + Vec3(50, 25, 0)));
    QVERIFY(std::abs(turnOf(*worldFrame(one, model))) < kClose);
    QCOMPARE(flatOnGround(one), one);
    QVERIFY(!worldPlacement(one, Model()));
    QVERIFY(!worldFrame(one, Model()));
}

void TestFlatTemplate::turningIsAboutTheMiddle()
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> angle(-3.0, 3.0);
    for (const StandardPlane plane :
         {StandardPlane::Ground, StandardPlane::Front, StandardPlane::Side}) {
        const Template one = laidOn(pictureOf(drawn(30, 20, 0, 0, 1, 1)), plane);
        for (int i = 0; i < 20; ++i) {
            const double by = angle(random);
            const Template next = turned(one, by);
            QCOMPARE(next.frame.origin, one.frame.origin);
            QVERIFY(near(next.frame.normal(), one.frame.normal()));
            QVERIFY(std::abs(turnOf(next.frame) - by) < kClose);
            QVERIFY(std::abs(turnOf(turned(next, -by).frame)) < kClose);
        }
    }
    const Template stood =
        flatOnGround(turned(laidOn(pictureOf(drawn(60, 80, 0, 0, 1, 1)), StandardPlane::Front),
                            std::numbers::pi / 2.0));
    QVERIFY(std::abs(stood.frame.origin.y() - 15.0) < kClose);
}

void TestFlatTemplate::itIsAsLongAsTheLineSays()
{
    std::mt19937 random(6);
    std::uniform_real_distribution<double> place(-40.0, 40.0), length(1.0, 500.0);
    Template one = turned(laidOn(pictureOf(drawn(200, 100, 0, 0, 1, 1)), StandardPlane::Side), 0.3);
    one.frame.origin.y() += 500.0; // on the ground it would stay there instead
    for (int i = 0; i < 50; ++i) {
        const Vec2 from(place(random), place(random)), to(place(random), place(random));
        const double wanted = length(random);
        const Template next =
            sizedByLine(one, one.frame.toWorld(from), one.frame.toWorld(to), wanted, Model())
                .value();
        // The same places of the file, before and after.
        const auto inFile = [&](const Vec2 &p) {
            return one.placement().inverse()(one.frame.toWorld(p));
        };
        const Vec3 a = next.placement()(inFile(from)), b = next.placement()(inFile(to));
        QVERIFY(std::abs((b - a).norm() - wanted) < 1e-6);
        QVERIFY((a - one.frame.toWorld(from)).norm() < 1e-6);
    }
}

void TestFlatTemplate::linesThatSayNothing()
{
    const Template one = pictureOf(drawn(200, 100, 0, 0, 1, 1));
    const auto placeOf = [&](const Vec2 &from, const Vec2 &to, double length) {
        const Result<Template> next =
            sizedByLine(one, one.frame.toWorld(from), one.frame.toWorld(to), length, Model());
        return next ? std::string() : next.error().place;
    };
    QCOMPARE(placeOf({1, 1}, {1, 1}, 10.0), std::string("line"));
    QCOMPARE(placeOf({1, 1}, {std::nan(""), 1}, 10.0), std::string("line"));
    QCOMPARE(placeOf({0, 0}, {1, 0}, 0.0), std::string("length"));
    QCOMPARE(placeOf({0, 0}, {1, 0}, -5.0), std::string("length"));
    QCOMPARE(placeOf({0, 0}, {1, 0}, 1e9), std::string("size"));
    QCOMPARE(placeOf({0, 0}, {1, 0}, std::nan("")), std::string("length"));
}

void TestFlatTemplate::flippedItIsItsMirrorImage()
{
    Template one = laidOn(pictureOf(drawn(200, 100, 0, 0, 1, 1)), StandardPlane::Front);
    const auto before = cornersOf(one, one.placement());
    one.isFlipped = true;
    const auto after = cornersOf(one, one.placement());
    QVERIFY(near(before[0], after[1]) && near(before[2], after[3]));
}

void TestFlatTemplate::whatIsDrawnInIt()
{
    // Pixels from the upper left; the box counts from the middle, upwards.
    const Box2 box = drawnBox(*drawn(40, 20, 10, 5, 15, 8));
    QCOMPARE(box.min, Vec2(-10, 2));
    QCOMPARE(box.max, Vec2(-5, 5));
    // White on black is as good.
    auto inverted = std::make_shared<TemplatePicture>(*drawn(40, 20, 10, 5, 15, 8));
    for (std::size_t i = 0; i < inverted->rgba.size(); ++i)
        if (i % 4 != 3)
            inverted->rgba[i] = static_cast<std::uint8_t>(255 - inverted->rgba[i]);
    QCOMPARE(drawnBox(*inverted).min, box.min);
    QCOMPARE(drawnBox(*inverted).max, box.max);
    // What is transparent is not drawn, whatever its colour.
    auto cut = std::make_shared<TemplatePicture>(*drawn(40, 20, 0, 0, 40, 20));
    cut->isOpaque = false;
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 40; ++x)
            if (x < 20 || y < 10)
                cut->rgba[4 * (40 * y + x) + 3] = 0;
    QCOMPARE(drawnBox(*cut).min, Vec2(0, -10));
    QCOMPARE(drawnBox(*cut).max, Vec2(20, 0));
    const Box2 all = drawnBox(*drawn(40, 20, 0, 0, 0, 0));
    QCOMPARE(all.size(), Vec2(40, 20));
}

void TestFlatTemplate::twoPicturesAreAligned()
{
    // The same thing, 60 high in one picture and 30 in the other, each somewhere in there.
    Template front = pictureOf(drawn(100, 100, 5, 20, 45, 80), 2.0);
    Template side = pictureOf(drawn(80, 50, 50, 0, 60, 30), 7.0);
    for (const bool isFlipped : {false, true}) {
        front.isFlipped = side.isFlipped = isFlipped;
        const auto pair = aligned(front, drawnBox(front), side, drawnBox(side));
        QVERIFY(pair);
        const auto [a, b] = *pair;
        QCOMPARE(a.scale, 2.0);
        QCOMPARE(b.scale, 4.0);
        const auto boxIn = [](const Template &one) {
            Box3 box;
            const Box2 drawn = drawnBox(one);
            for (const Vec2 &p : {drawn.min, drawn.max})
                box.extend(one.placement()({p.x(), p.y(), 0.0}));
            return box;
        };
        QVERIFY(near(boxIn(a).min, {-40, 0, 0}) && near(boxIn(a).max, {40, 120, 0}));
        QVERIFY(near(boxIn(b).min, {0, 0, -20}) && near(boxIn(b).max, {0, 120, 20}));
        // Once more changes nothing.
        const auto again = aligned(a, drawnBox(a), b, drawnBox(b));
        QVERIFY(near(again->first.frame.origin, a.frame.origin));
        QVERIFY(near(again->second.frame.origin, b.frame.origin));
        QCOMPARE(again->second.scale, b.scale);
    }
}

void TestFlatTemplate::whatCannotBeAligned()
{
    const Template one = pictureOf(drawn(10, 10, 0, 0, 5, 5));
    const Box2 flat{{0, 0}, {5, 0}};
    QCOMPARE(aligned(one, flat, one, drawnBox(one)).error().place, std::string("front"));
    QCOMPARE(aligned(one, drawnBox(one), one, flat).error().place, std::string("side"));
    QCOMPARE(aligned(one, drawnBox(one), one, {{0, 0}, {1, 1e-7}}).error().place,
             std::string("side"));
}

void TestFlatTemplate::linesOfADrawing()
{
    const auto square = [](double from, double to) {
        return CurvePath::fromLine({{from, from}, {to, from}, {to, to}, {from, to}, {from, from}})
            .value();
    };
    // A square with a hole in it whose edges came by themselves, and a line beside it.
    std::vector<CurvePath> lines{square(0, 30)};
    for (const Polygon &edge : {Polygon{{10, 10}, {20, 10}}, Polygon{{20, 10}, {20, 20}},
                                Polygon{{20, 20}, {10, 10}}, Polygon{{40, 0}, {60, 20}}})
        lines.push_back(CurvePath::fromLine(edge).value());
    const TemplateCurvesPointer curves = makeTemplateCurves(lines).value();
    QCOMPARE(curves->size, Vec2(60, 30));
    QCOMPARE(curves->lines.size(), std::size_t(3));
    QCOMPARE(curves->outlines.size(), std::size_t(1));
    QCOMPARE(curves->outlines[0].holes.size(), std::size_t(1));
    QCOMPARE(curves->open.size(), std::size_t(1));
    QCOMPARE(curves->outlines[0].outer.bounds().min, Vec2(-30, -15));
    QVERIFY(!makeTemplateCurves({}));
    QVERIFY(!makeTemplateCurves({CurvePath::fromLine({{3, 4}, {3, 4}}).value()}));
}

void TestFlatTemplate::greysOfColours()
{
    TemplatePicture picture;
    picture.width = 4;
    picture.height = 1;
    picture.rgba = {0, 0, 0, 255, 255, 255, 255, 255, 0, 0, 0, 0, 0, 0, 0, 128};
    const GreyPicture dark = greyOf(picture, TraceBy::Darkness);
    QCOMPARE(dark.grey, (std::vector<std::uint8_t>{0, 255, 255, 127}));
    const GreyPicture opaque = greyOf(picture, TraceBy::Opacity);
    QCOMPARE(opaque.grey, (std::vector<std::uint8_t>{0, 0, 255, 127}));
}

// Wrong: the threshold that is offered for a large picture, which is looked at in part, is another
// one than that of all of it.
void TestFlatTemplate::sampledHasTheSameTones()
{
    const TemplatePicturePointer all = drawn(403, 301, 50, 60, 250, 200);
    for (const std::int64_t most : {1'000'000LL, 121'303LL, 30'000LL, 5'000LL}) {
        const TemplatePicture some = sampledPicture(*all, most);
        QCOMPARE(some.rgba.size(), static_cast<std::size_t>(4 * some.pixels()));
        QVERIFY(some.pixels() <= most + some.width + some.height + 1);
        if (most >= all->pixels())
            QVERIFY(some.rgba == all->rgba);
        const auto dark = [](const TemplatePicture &picture) {
            std::int64_t count = 0;
            for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
                count += picture.rgba[i] == 0;
            return double(count) / double(picture.pixels());
        };
        QVERIFY2(std::abs(dark(some) - dark(*all)) < 0.01, qPrintable(QString::number(most)));
    }
}

FFF_TEST(TestFlatTemplate)
#include "tst_flat_template.moc"
