// Dimensions that drive: what is typed for one stretches its section, and what lies on it follows.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/fff_format.h"
#include "core/model/dimensions.h"
#include "core/model/moving.h"
#include "core/model/symmetric_section.h"
#include "tests/core/operations/driven_models.h"
#include "tests/test_program.h"

#include <cmath>

using namespace fff;
using namespace fff::test;

namespace {

/// The shelf with a length between two places of its board, made of the value "w", 100 mm.
Document measured(const Vec2 &from, const Vec2 &to)
{
    const Document plain = shelf();
    const SectionRef board = plain.sections[0]->ref();
    Document document =
        addDimension(plain, {board, {from.x(), from.y(), 0.0}}, {board, {to.x(), to.y(), 0.0}})
            .value();
    return withValue(std::move(document), "w", "100 mm");
}

std::string lengthKey(const Document &document)
{
    return key("dimension", document.dimensions[0].id.value, "length");
}

Document driving(const Vec2 &from, const Vec2 &to)
{
    const Document document = measured(from, to);
    return madeOf(document, lengthKey(document), "w");
}

Vec2 sizeOf(const Document &document, std::size_t section)
{
    return document.sections[section]->shape->bounds().size();
}

Document holding(Document document, HoldsTo end)
{
    Section rib = *document.sections[1];
    rib.parent->holdsTo = end;
    document.sections[1] = std::make_shared<const Section>(rib);
    return document;
}

double ribAt(const Document &document)
{
    return document.sections[1]->frame.origin.x();
}

} // namespace

class TestDrivenDimensions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theSectionFollows();
    void typedAndByAValueAreAlike();
    void whatLiesOnItFollows();
    void aSectionOnAnotherOneKeepsItsSlit();
    void aSymmetricSectionStaysOne();
    void childrenFollowAsTheyAreTold();
    void measuredByHandItIsAlongAnAxis();
    void oneThatIsAslant();
    void withinASizeThatIsDriven();
    void severalOnOneAxis();
    void whatStandsGoesOnStanding();
    void roundCornersStayRound();
    void whatIsTypedCountsOrIsRefused();
    void threeSides();
    void whatDoesNotGoTogetherGoesNowhere();
    void oneWithinAnother();
    void whatCannotBeStretched();
    void filesKeepIt();
};

void TestDrivenDimensions::theSectionFollows()
{
    const Document document = driving({50, 0}, {150, 0});
    QCOMPARE(document.bindings.size(), std::size_t(1));
    const Document longer = typed(document, "w", "160 mm");
    QVERIFY(std::abs(numberAt(longer, lengthKey(longer)) - 160.0) < 1e-9);
    QVERIFY((sizeOf(longer, 0) - Vec2(260, 40)).norm() < 1e-9);
    QVERIFY(driven(longer).document.isSame(longer));
    const Document back = typed(longer, "w", "100 mm");
    QVERIFY((sizeOf(back, 0) - Vec2(200, 40)).norm() < 1e-9);
    QCOMPARE(numberAt(back, lengthKey(back)), 100.0);
    // The width that follows from it is another number, and both can be wanted at once.
    const Document both =
        madeOf(longer, key("section", longer.sections[0]->id.value, "width"), "2*w");
    QVERIFY((sizeOf(both, 0) - Vec2(320, 40)).norm() < 1e-6);
    QVERIFY(std::abs(numberAt(both, lengthKey(both)) - 160.0) < 1e-6);
}

void TestDrivenDimensions::typedAndByAValueAreAlike()
{
    const Document document = measured({50, 0}, {150, 0});
    const Document byValue = typed(madeOf(document, lengthKey(document), "w"), "w", "130 mm");
    const Document byHand = madeOf(document, lengthKey(document), "130 mm");
    QVERIFY(byHand.bindings.empty());
    QVERIFY(*byHand.sections[0]->shape == *byValue.sections[0]->shape);
    QVERIFY(byHand.dimensions == byValue.dimensions);
}

void TestDrivenDimensions::whatLiesOnItFollows()
{
    // The hole at x = 50 lies before what is stretched, the words at 150 behind it.
    const Document before = driving({80, 0}, {120, 0});
    const Document after = typed(before, "w", "70 mm");
    QCOMPARE(after.sections[0]->figures.size(), before.sections[0]->figures.size());
    const std::string hole = "figure/" + std::to_string(after.sections[0]->id.value) + "/1/";
    QCOMPARE(numberAt(after, hole + "diameter"), 10.0);
    QVERIFY(std::abs(numberAt(after, hole + "centreX") - 50.0) < 1e-9);
    QVERIFY(after.sections[0]->marks[0]->lettering);
    QVERIFY((after.sections[0]->marks[0]->lettering->at -
             before.sections[0]->marks[0]->lettering->at - Vec2(-30, 0))
                .norm() < 1e-9);
    QCOMPARE(after.loads[0].position, before.loads[0].position); // at x = 20
    // A hole in the middle of it keeps its numbers, too.
    const Document across = typed(driving({0, 0}, {200, 0}), "w", "400 mm");
    QCOMPARE(
        numberAt(across, "figure/" + std::to_string(across.sections[0]->id.value) + "/1/diameter"),
        10.0);
}

void TestDrivenDimensions::aSectionOnAnotherOneKeepsItsSlit()
{
    Document document = shelf();
    const SectionRef rib = document.sections[1]->ref();
    const Vec3 slit(100, 30, 0); // the middle of its slit, in the world
    document = addDimension(document, {rib, {-30, 0, 0}}, {rib, {30, 0, 0}}).value();
    document = madeOf(withValue(document, "w", "60 mm"), lengthKey(document), "w");
    const Document wide = typed(document, "w", "90 mm");
    QVERIFY((sizeOf(wide, 1) - Vec2(90, 60)).norm() < 1e-9);
    const Section &now = *wide.sections[1];
    const double middle = now.frame.toLocal(slit).x();
    QVERIFY(std::abs(now.shape->bounds().center().x() - middle) < 1e-9);
}

// Wrong: one half alone would follow, and the next edit of a point would not know the other.
void TestDrivenDimensions::aSymmetricSectionStaysOne()
{
    Document document = newDocument();
    const SectionId plate = add(
        document, "Plate",
        shapeOf(polygonContour(
            {{-50, 0}, {50, 0}, {50, 20}, {20, 20}, {20, 60}, {-20, 60}, {-20, 20}, {-50, 20}})),
        frontFrame());
    document = setSymmetry(std::move(document), plate, MirrorAxis{{0, 0}, {0, 1}}).value();
    document = addDimension(document, {plate, {20, 20, 0}}, {plate, {50, 20, 0}}).value();
    document = madeOf(document, lengthKey(document), "45 mm");
    QVERIFY(std::abs(numberAt(document, lengthKey(document)) - 45.0) < 1e-9);
    const Section &wide = *document.sections[0];
    QVERIFY(symmetryOf(wide));
    const Box2 box = wide.shape->bounds();
    QVERIFY((box.min - Vec2(-65, 0)).norm() < 1e-9 && (box.max - Vec2(65, 60)).norm() < 1e-9);
    // From side to side it is symmetric by itself.
    document = addDimension(document, {plate, {-20, 60, 0}}, {plate, {20, 60, 0}}).value();
    const std::string across = key("dimension", document.dimensions[1].id.value, "length");
    document = madeOf(document, across, "30 mm");
    QVERIFY(symmetryOf(*document.sections[0]));
    QVERIFY(std::abs(document.sections[0]->shape->bounds().size().x() - 120.0) < 1e-9);
}

void TestDrivenDimensions::childrenFollowAsTheyAreTold()
{
    // By its width, about its middle at 100, where the rib is: it is put to 150 first.
    Document wide = withValue(shelf(), "w", "200 mm");
    const SectionMove moves[] = {
        {.section = wide.sections[1]->id, .placement = Similarity::moved({50, 0, 0})}};
    wide = movedSections(wide, moves).value();
    const std::string width = key("section", wide.sections[0]->id.value, "width");
    wide = madeOf(wide, width, "w");
    const auto at = [&](HoldsTo end) { return ribAt(typed(holding(wide, end), "w", "300 mm")); };
    QVERIFY(std::abs(at(HoldsTo::Proportion) - 175.0) < 1e-9);
    QVERIFY(std::abs(at(HoldsTo::Left) - 100.0) < 1e-9);
    QVERIFY(std::abs(at(HoldsTo::Right) - 200.0) < 1e-9);
    QVERIFY(std::abs(at(HoldsTo::Top) - 175.0) < 1e-9); // across is not along
    const Document held = typed(holding(wide, HoldsTo::Right), "w", "300 mm");
    QVERIFY((0.5 * (held.sections[1]->parent->slitFrom + held.sections[1]->parent->slitTo) -
             Vec2(200, 30))
                .norm() < 1e-9);
    // By a dimension, of which the left place stays.
    const auto driven = [&](HoldsTo end, double x) {
        Document document = driving({0, 0}, {100, 0});
        const SectionMove to[] = {
            {.section = document.sections[1]->id, .placement = Similarity::moved({x - 100, 0, 0})}};
        document = movedSections(document, to).value();
        return ribAt(typed(holding(document, end), "w", "150 mm"));
    };
    QVERIFY(std::abs(driven(HoldsTo::Proportion, 60) - 90.0) < 1e-9);
    QVERIFY(std::abs(driven(HoldsTo::Left, 60) - 60.0) < 1e-9);
    QVERIFY(std::abs(driven(HoldsTo::Right, 60) - 110.0) < 1e-9);
    QVERIFY(std::abs(driven(HoldsTo::Proportion, 160) - 210.0) < 1e-9);
}

// Wrong: a board whose ends were not hit quite level is none after that.
void TestDrivenDimensions::measuredByHandItIsAlongAnAxis()
{
    const Document document = driving({0, 10}, {200, 16});
    const Document wide = typed(document, "w", "260 mm");
    QVERIFY(std::abs(numberAt(wide, lengthKey(wide)) - 260.0) < 1e-9);
    QCOMPARE(sizeOf(wide, 0).y(), 40.0);
    for (const CubicBezier &edge : {wide.sections[0]->shape->contour().segment(0),
                                    wide.sections[0]->shape->contour().segment(1)})
        QVERIFY(std::abs((edge.p3 - edge.p0).x()) < 1e-9 ||
                std::abs((edge.p3 - edge.p0).y()) < 1e-9);
    // By less than they lie beside each other they cannot be apart along it.
    QVERIFY(std::abs(numberAt(typed(document, "w", "5 mm"), lengthKey(document)) - 5.0) < 1e-9);
}

/// All edges of its contour lie along its axes.
bool isSquare(const Section &section)
{
    const Contour &contour = section.shape->contour();
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const CubicBezier edge = contour.segment(i);
        const Vec2 way = edge.p3 - edge.p0;
        if (std::abs(way.x()) > 1e-9 && std::abs(way.y()) > 1e-9)
            return false;
    }
    return true;
}

// Wrong: from corner to corner of a board it sheared that, and beside its width it made a shard.
void TestDrivenDimensions::oneThatIsAslant()
{
    const double diagonal = std::hypot(200.0, 40.0);
    Document document = driving({0, 0}, {200, 40}); // 11 degrees off
    const auto apart = [](const Document &of, double length) {
        return typed(of, "w", (std::to_string(length) + " mm").c_str());
    };
    document = apart(document, 1.5 * diagonal);
    QVERIFY(isSquare(*document.sections[0]));
    QVERIFY((sizeOf(document, 0) - Vec2(300, 60)).norm() < 1e-4);
    QVERIFY(std::abs(numberAt(document, lengthKey(document)) - 1.5 * diagonal) < 1e-5);
    // Beside its width it is its height that follows, whatever came before.
    document = withValue(std::move(document), "all", "200 mm");
    document = madeOf(document, key("section", document.sections[0]->id.value, "width"), "all");
    for (const double high : {120.0, 30.0, 400.0, 60.0}) {
        document = apart(document, std::hypot(200.0, high));
        QVERIFY(isSquare(*document.sections[0]));
        QVERIFY2((sizeOf(document, 0) - Vec2(200, high)).norm() < 1e-3,
                 qPrintable(QString::number(high)));
    }
    document = typed(document, "all", "150 mm");
    QVERIFY(isSquare(*document.sections[0]));
    QVERIFY((sizeOf(document, 0) - Vec2(150, std::sqrt(200.0 * 200 + 60 * 60 - 150 * 150))).norm() <
            1e-3);
    QVERIFY(!driven(typeValue(document, idOf(document, "w"), "149 mm", {}).value()).errors.empty());
    // An arm that is drawn aslant becomes a longer one, as thick as before.
    Document arm = shelf();
    const Vec2 along = Vec2(1, 1).normalized(), across(-along.y(), along.x());
    const Polygon outline{{0, 0}, 120 * along, 120 * along + 20 * across, 20 * across};
    Section drawn = *arm.sections[1];
    drawn.shape = Shape::make(Contour::fromPolygon(outline).value()).value();
    arm.sections[1] = std::make_shared<const Section>(drawn);
    const Vec2 end = 120 * along;
    arm = addDimension(arm, {drawn.ref(), {0, 0, 0}}, {drawn.ref(), {end.x(), end.y(), 0}}).value();
    arm = madeOf(arm, lengthKey(arm), "180 mm");
    const Contour &longer = arm.sections[1]->shape->contour();
    QVERIFY(std::abs(std::abs(longer.signedArea()) - 180.0 * 20.0) < 1e-6);
}

// Wrong: with each change of an inner edge the section wandered aside, and did not come back.
void TestDrivenDimensions::withinASizeThatIsDriven()
{
    Document document = driving({50, 0}, {90, 0});
    document = withValue(std::move(document), "all", "200 mm");
    document = madeOf(document, key("section", document.sections[0]->id.value, "width"), "all");
    const Box2 box = document.sections[0]->shape->bounds();
    const auto isWhereItWas = [&](const Document &of) {
        const Box2 now = of.sections[0]->shape->bounds();
        return (now.min - box.min).norm() < 1e-9 && (now.max - box.max).norm() < 1e-9;
    };
    document = typed(document, "w", "100 mm");
    const Document before = document;
    for (const char *length : {"20 mm", "150 mm", "61 mm", "100 mm"}) {
        document = typed(document, "w", length);
        QVERIFY2(isWhereItWas(document), length);
    }
    const auto &points = document.sections[0]->shape->contour().points();
    const auto &was = before.sections[0]->shape->contour().points();
    for (std::size_t i = 0; i < points.size(); ++i)
        QVERIFY((points[i] - was[i]).norm() < 1e-9);
    // Whichever is set first.
    const Document one = typed(typed(before, "w", "70 mm"), "all", "260 mm");
    const Document other = typed(typed(before, "all", "260 mm"), "w", "70 mm");
    const auto &a = one.sections[0]->shape->contour().points();
    const auto &b = other.sections[0]->shape->contour().points();
    for (std::size_t i = 0; i < a.size(); ++i)
        QVERIFY((a[i] - b[i]).norm() < 1e-6);
}

/// The shelf's rib with this outline, and a driven length between each pair of its corners.
Document withLengths(const Polygon &corners,
                     const std::vector<std::pair<std::size_t, std::size_t>> &pairs)
{
    Document document = shelf();
    Section drawn = *document.sections[1];
    drawn.shape = Shape::make(Contour::fromPolygon(corners).value()).value();
    document.sections[1] = std::make_shared<const Section>(drawn);
    char name[] = "a";
    for (const auto &[from, to] : pairs) {
        const Vec2 a = corners[from], b = corners[to];
        document = addDimension(document, {drawn.ref(), {a.x(), a.y(), 0}},
                                {drawn.ref(), {b.x(), b.y(), 0}})
                       .value();
        document =
            withValue(std::move(document), name, (std::to_string((b - a).norm()) + " mm").c_str());
        document =
            madeOf(document, key("dimension", document.dimensions.back().id.value, "length"), name);
        ++name[0];
    }
    return document;
}

bool isSameOutline(const Document &a, const Document &b)
{
    const auto &p = a.sections[1]->shape->contour().points();
    const auto &q = b.sections[1]->shape->contour().points();
    return std::equal(p.begin(), p.end(), q.begin(), q.end(),
                      [](const Vec2 &x, const Vec2 &y) { return (x - y).norm() < 1e-6; });
}

// Wrong: an L with two lengths along its foot slid aside with each change, and did not come back.
void TestDrivenDimensions::severalOnOneAxis()
{
    const Polygon corners{{0, 0}, {100, 0}, {100, 30}, {60, 30}, {60, 90}, {0, 90}};
    for (const auto &pairs : {std::vector<std::pair<std::size_t, std::size_t>>{{0, 1}, {5, 4}},
                              {{1, 0}, {4, 5}},
                              {{0, 1}, {2, 3}}}) {
        const Document before = withLengths(corners, pairs);
        Document document = before;
        for (const char *length : {"90 mm", "70 mm", "140 mm", "100 mm"}) {
            document = typed(document, "a", length);
            const Box2 box = document.sections[1]->shape->bounds();
            QVERIFY2(std::abs(box.min.x()) < 1e-6, length);
        }
        QVERIFY(isSameOutline(document, before));
    }
}

// Wrong: it depended on the end from which it was measured, and on whether it touched the ground.
void TestDrivenDimensions::whatStandsGoesOnStanding()
{
    for (const double low : {0.0, 30.0}) {
        const Polygon corners{{0, low}, {100, low}, {100, low + 60}, {0, low + 60}};
        for (const auto &pair : {std::pair<std::size_t, std::size_t>{1, 2}, {2, 1}}) {
            const Document before = withLengths(corners, {pair});
            const Document higher = typed(before, "a", "90 mm");
            QVERIFY(std::abs(higher.sections[1]->shape->bounds().min.y() - low) < 1e-9);
            QVERIFY(isSameOutline(typed(higher, "a", "60 mm"), before));
        }
    }
    // A height that touches the ground on the way does not stay there.
    Document document = withValue(shelf(), "h", "40 mm");
    document = madeOf(document, key("section", document.sections[0]->id.value, "height"), "h");
    const Box2 box = document.sections[0]->shape->bounds();
    for (const char *height : {"80 mm", "5 mm", "200 mm", "40 mm"}) {
        document = typed(document, "h", height);
        QVERIFY(std::abs(document.sections[0]->shape->bounds().min.y() - box.min.y()) < 1e-9);
    }
}

// Wrong: round corners that had little room left became ears.
void TestDrivenDimensions::roundCornersStayRound()
{
    const double k = 10.0 * 0.5522847498;
    const std::vector<Vec2> points{
        {10, 0},   {110.0 / 3, 0},  {190.0 / 3, 0},   {90, 0},   {90 + k, 0},   {100, 10 - k},
        {100, 10}, {100, 70.0 / 3}, {100, 110.0 / 3}, {100, 50}, {100, 50 + k}, {90 + k, 60},
        {90, 60},  {190.0 / 3, 60}, {110.0 / 3, 60},  {10, 60},  {10 - k, 60},  {0, 50 + k},
        {0, 50},   {0, 110.0 / 3},  {0, 70.0 / 3},    {0, 10},   {0, 10 - k},   {10 - k, 0}};
    Document document = shelf();
    Section drawn = *document.sections[1];
    drawn.shape = Shape::make(Contour::fromPoints(points).value()).value();
    document.sections[1] = std::make_shared<const Section>(drawn);
    document = addDimension(document, {drawn.ref(), {10, 0, 0}}, {drawn.ref(), {90, 0, 0}}).value();
    document = withValue(withValue(std::move(document), "a", "80 mm"), "all", "100 mm");
    document = madeOf(document, key("section", drawn.id.value, "width"), "all");
    document = madeOf(document, lengthKey(document), "a");
    for (const char *length : {"95 mm", "99 mm", "99.4 mm", "40 mm", "80 mm"}) {
        document = typed(document, "a", length);
        const Box2 box = document.sections[1]->shape->contour().bounds(); // of the control points
        QVERIFY2(std::abs(box.min.x()) < 1e-6 && std::abs(box.max.x() - 100.0) < 1e-6, length);
    }
    const std::vector<Vec2> &now = document.sections[1]->shape->contour().points();
    for (std::size_t i = 0; i < points.size(); ++i)
        QVERIFY((now[i] - points[i]).norm() < 1e-6);
}

// Wrong: a length came out as another one than was typed, without a word.
void TestDrivenDimensions::whatIsTypedCountsOrIsRefused()
{
    Document document = measured({0, 0}, {200, 40});
    const std::string section = std::to_string(document.sections[0]->id.value);
    document = madeOf(document, "section/" + section + "/width", "2*w");
    document = madeOf(document, "section/" + section + "/height", "0.4*w");
    const auto typedNow = bound(document, at(document, lengthKey(document)), "100 mm");
    QVERIFY(!typedNow);
    const double diagonal = numberAt(document, lengthKey(document));
    QVERIFY(bound(document, at(document, lengthKey(document)),
                  QString::number(diagonal, 'g', 17).toStdString() + " mm"));
}

// Wrong: of a triangle on a level side no three sides went together.
void TestDrivenDimensions::threeSides()
{
    Document document = shelf();
    Section drawn = *document.sections[1];
    const Polygon corners{{0, 0}, {100, 0}, {35, 80}};
    drawn.shape = Shape::make(Contour::fromPolygon(corners).value()).value();
    document.sections[1] = std::make_shared<const Section>(drawn);
    const char *const names[] = {"a", "b", "c"};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2 from = corners[i], to = corners[(i + 1) % 3];
        document = addDimension(document, {drawn.ref(), {from.x(), from.y(), 0}},
                                {drawn.ref(), {to.x(), to.y(), 0}})
                       .value();
        document = withValue(std::move(document), names[i],
                             (std::to_string((to - from).norm()) + " mm").c_str());
        document =
            madeOf(document, key("dimension", document.dimensions[i].id.value, "length"), names[i]);
    }
    for (const auto &[name, length] : {std::pair("a", "90 mm"), std::pair("b", "110 mm"),
                                       std::pair("c", "95 mm"), std::pair("a", "120 mm")}) {
        const Document next = typed(document, name, length);
        QVERIFY2(driven(next).errors.empty(), name);
        document = next;
    }
}

// Wrong: two sides of a slanting board that cannot be of two lengths took it metres away.
void TestDrivenDimensions::whatDoesNotGoTogetherGoesNowhere()
{
    Document document = shelf();
    const Vec2 u(std::cos(0.5236), std::sin(0.5236)), v(-u.y(), u.x());
    const Polygon corners{{0, 0}, 100 * u, 100 * u + 60 * v, 60 * v};
    Section drawn = *document.sections[1];
    drawn.shape = Shape::make(Contour::fromPolygon(corners).value()).value();
    document.sections[1] = std::make_shared<const Section>(drawn);
    const auto drive = [&](std::size_t from, std::size_t to, const char *name, const char *now) {
        document = addDimension(document, {drawn.ref(), {corners[from].x(), corners[from].y(), 0}},
                                {drawn.ref(), {corners[to].x(), corners[to].y(), 0}})
                       .value();
        document = withValue(std::move(document), name, now);
        document =
            madeOf(document, key("dimension", document.dimensions.back().id.value, "length"), name);
    };
    drive(0, 1, "a", "100 mm");
    drive(3, 2, "b", "100 mm");
    drive(1, 2, "c", "60 mm");
    for (const char *length : {"101 mm", "110 mm", "150 mm", "200 mm", "260 mm"}) {
        const Driven next = driven(typeValue(document, idOf(document, "b"), length, {}).value());
        if (!next.errors.empty())
            continue;
        const Box2 was = document.sections[1]->shape->bounds();
        const Box2 is = next.document.sections[1]->shape->bounds();
        QVERIFY2((is.center() - was.center()).norm() < 400.0, length);
    }
}

// Wrong: what does not contradict was said to, since it comes near it slowly.
void TestDrivenDimensions::oneWithinAnother()
{
    Document document = driving({50, 0}, {150, 0});
    document = madeOf(document, key("section", document.sections[0]->id.value, "width"), "200 mm");
    document = withValue(std::move(document), "all", "200 mm");
    document = madeOf(document, key("section", document.sections[0]->id.value, "width"), "all");
    for (const char *length : {"170 mm", "190 mm", "20 mm", "100 mm"}) {
        document = typed(document, "w", length);
        QVERIFY2(driven(document).errors.empty(), length);
        QVERIFY(std::abs(sizeOf(document, 0).x() - 200.0) < 1e-6);
    }
    QVERIFY(!driven(typeValue(document, idOf(document, "w"), "250 mm", {}).value()).errors.empty());
}

void TestDrivenDimensions::whatCannotBeStretched()
{
    const Document document = measured({50, 0}, {150, 0});
    QVERIFY(!bound(document, at(document, lengthKey(document)), "0 mm"));
    QVERIFY(!bound(document, at(document, lengthKey(document)), "-w"));
    // From one section to another, in the world, off the sheet: lengths that are only shown.
    const SectionRef board = document.sections[0]->ref(), rib = document.sections[1]->ref();
    for (const auto &[from, to] : {std::pair{Anchor{board, {0, 0, 0}}, Anchor{rib, {0, 0, 0}}},
                                   std::pair{Anchor{{}, {0, 0, 0}}, Anchor{{}, {0, 9, 0}}},
                                   std::pair{Anchor{board, {0, 0, 0}}, Anchor{board, {9, 0, 2}}}}) {
        const Document other = addDimension(shelf(), from, to).value();
        QVERIFY(!placeOfKey(other, lengthKey(other)));
    }
}

void TestDrivenDimensions::filesKeepIt()
{
    const Document document = holding(driving({50, 0}, {150, 0}), HoldsTo::Right);
    const std::string text = io::writeFff(document).value();
    const auto read = io::readFff(text);
    QVERIFY(read && read->document == document);
    QCOMPARE(io::writeFff(read->document).value(), text);
    QVERIFY(driven(read->document).document.isSame(read->document));
    std::string wrong = text;
    wrong.replace(wrong.find("\"right\""), 7, "\"beside\"");
    const auto failed = io::readFff(wrong);
    QVERIFY(!failed && failed.error().place.find("holdsTo") != std::string::npos);
}

FFF_TEST(TestDrivenDimensions)
#include "tst_driven_dimensions.moc"
