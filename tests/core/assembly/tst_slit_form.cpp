#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/assembly/assembly.h"
#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <random>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kFine = 1e-4; // mm, chords of the curves that are looked at

Stock milled(SlitEnd end, double tool, double bumps = 0.0)
{
    Stock stock;
    stock.slitEnd = end;
    stock.toolDiameter = tool;
    stock.bumps = bumps;
    return stock;
}

/// What all cuts of a slit take together.
struct Removed
{
    std::vector<Polygon> outlines;

    Removed(const Stock &stock, const SlitBox &box)
    {
        SlitForm form = formOf(stock, 2.0 * box.half);
        form.held = box.length;
        for (const Contour &cut : slitCuts(form, box))
            outlines.push_back(cut.flatten(kFine).points);
    }
    bool holds(const Vec2 &p) const
    {
        return std::any_of(outlines.begin(), outlines.end(), [&](const Polygon &outline) {
            return locate(p, outline) != Side::Outside;
        });
    }
    double distanceToBoundary(const Vec2 &p) const // of one outline
    {
        double nearest = std::numeric_limits<double>::infinity();
        const Polygon &outline = outlines.front();
        for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
            const Vec2 edge = outline[i] - outline[j];
            const double share =
                std::clamp(edge.dot(p - outline[j]) / edge.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (outline[j] + share * edge - p).norm());
        }
        return nearest;
    }
    Box2 box() const
    {
        Box2 all;
        for (const Polygon &outline : outlines)
            all.extend(bounds(outline));
        return all;
    }
};

std::vector<Vec2> innerCorners(const SlitBox &box)
{
    std::vector<Vec2> corners{{0, box.half}, {0, -box.half}};
    if (!box.isOpen)
        corners.insert(corners.end(), {{box.length, box.half}, {box.length, -box.half}});
    return corners;
}

void addRows()
{
    QTest::addColumn<Stock>("stock");
    QTest::addColumn<SlitBox>("box");
    const std::pair<const char *, SlitEnd> ends[] = {
        {"round", SlitEnd::Round}, {"dogbone", SlitEnd::Dogbone}, {"T-bone", SlitEnd::TBone}};
    const std::pair<const char *, SlitBox> boxes[] = {
        {"a slit as wide as its tool", {30.0, 1.5, true}},
        {"a wide slit", {30.0, 5.0, true}},
        {"a slit in which the arcs all but meet", {30.0, 2.27, true}},
        {"a mortise", {30.0, 2.0, false}},
        {"a mortise that its ends just leave room in", {9.7, 2.0, false}}};
    for (const auto &[endName, end] : ends)
        for (const auto &[boxName, box] : boxes)
            QTest::addRow("%s of %s", endName, boxName) << milled(end, 3.0) << box;
}

/// A plate whose upper edge is this line of points, cut down to y = 20 at x = 50, by a stock.
struct CutPlate
{
    Model model;
    Assembly assembly;

    CutPlate(const Polygon &upperEdge, const Stock &like, const Frame &guestFrame = side(50.0))
    {
        Document document = newDocument();
        Stock stock = *document.stocks.front();
        stock.slitEnd = like.slitEnd;
        stock.toolDiameter = like.toolDiameter;
        stock.leadIn = like.leadIn;
        stock.bumps = like.bumps;
        stock.clearance = like.clearance;
        document = *setStock(std::move(document), stock);
        Polygon outer{{0, 0}, {100, 0}};
        outer.insert(outer.end(), upperEdge.begin(), upperEdge.end());
        document = withSection(std::move(document), polygonShape(outer), front());
        document =
            withSection(std::move(document), polygonShape(rectangle(-20, 20, 20, 90)), guestFrame);
        model = evaluate(std::move(document));
        assembly = assemble(model);
    }
    const Slit &slit() const { return assembly.slits[0].at(0); }
    const Polygon &outline() const { return model.section(0)->shape->region().outer; }
    double distanceToContour(const Vec2 &p) const
    {
        double nearest = std::numeric_limits<double>::infinity();
        const Polygon &ring = outline();
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            const Vec2 edge = ring[i] - ring[j];
            const double share = std::clamp(edge.dot(p - ring[j]) / edge.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (ring[j] + share * edge - p).norm());
        }
        return nearest;
    }
};

} // namespace

class TestSlitForm : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void plainStocksHaveNone();
    void takesTheSquareAndMoreOnlyAtItsCorners_data() { addRows(); }
    void takesTheSquareAndMoreOnlyAtItsCorners();
    void toolReachesAllOfTheEnd_data() { addRows(); }
    void toolReachesAllOfTheEnd();
    void arcsAreAsRoundAsTheTool();
    void tooShortForItsRelief();
    void toolWiderThanTheSlit();
    void bumpsFaceEachOtherAndLeaveAGap();
    void leadInStaysAtTheContour_data();
    void leadInStaysAtTheContour();
    void leadInBeginsWhereEachWallLeaves();
    void bumpsAreWhereTheGuestIs();
    void everyStockNumberCounts();
};

// What would be wrong: plain slits that take the slow way.
void TestSlitForm::plainStocksHaveNone()
{
    const CutPlate plate({{100, 60}, {0, 60}}, Stock());
    for (const auto &slits : plate.assembly.slits)
        for (const Slit &slit : slits)
            QVERIFY(!slit.form);
}

// What would be wrong: a guest that does not go in as far as it is drawn, or material gone where
// nobody looks for it.
void TestSlitForm::takesTheSquareAndMoreOnlyAtItsCorners()
{
    QFETCH(Stock, stock);
    QFETCH(SlitBox, box);
    const Removed removed(stock, box);
    const double r = 0.5 * stock.toolDiameter + kToolAllowance;
    const Box2 all = removed.box();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> x(all.min.x() - 1.0, all.max.x() + 1.0),
        y(all.min.y() - 1.0, all.max.y() + 1.0);
    int more = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec2 p(x(random), y(random));
        const bool isInSquare =
            p.x() > 1e-6 && p.x() < box.length - 1e-6 && std::abs(p.y()) < box.half - 1e-6;
        const bool isRemoved = removed.holds(p);
        QVERIFY2(!isInSquare || isRemoved, qPrintable(QString::number(p.x())));
        if (!isRemoved || isInSquare)
            continue;
        ++more;
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec2 &corner : innerCorners(box))
            nearest = std::min(nearest, (corner - p).norm());
        const double beyond = stock.slitEnd == SlitEnd::Round ? box.half + r : 2.0 * r;
        QVERIFY(nearest < beyond + 1e-3);
    }
    QVERIFY(more > 0);
}

// What would be wrong: a corner that the mill leaves standing, so that the parts do not close.
void TestSlitForm::toolReachesAllOfTheEnd()
{
    QFETCH(Stock, stock);
    QFETCH(SlitBox, box);
    const Removed removed(stock, box);
    QCOMPARE(removed.outlines.size(), std::size_t(1));
    const double tool = 0.5 * stock.toolDiameter;
    // Where its middle may be: nowhere nearer to what stays than its radius.
    constexpr double kStep = 0.05;
    std::vector<Vec2> middles;
    const Box2 all = removed.box();
    const double end = box.isOpen ? 10.0 : all.max.x();
    for (double x = all.min.x(); x < end; x += kStep)
        for (double y = -kStep * std::floor(all.max.y() / kStep); y < all.max.y(); y += kStep)
            if (removed.holds({x, y}) && removed.distanceToBoundary({x, y}) >= tool - 2e-3)
                middles.push_back({x, y});
    QVERIFY(!middles.empty());
    std::mt19937 random(2);
    std::uniform_real_distribution<double> dx(all.min.x(), box.isOpen ? 6.0 : all.max.x()),
        dy(all.min.y(), all.max.y());
    const auto isReached = [&](const Vec2 &p) {
        return std::any_of(middles.begin(), middles.end(), [&](const Vec2 &middle) {
            return (middle - p).norm() < tool + 0.7 * kStep;
        });
    };
    for (const Vec2 &corner : innerCorners(box))
        QVERIFY(isReached(corner));
    for (int i = 0; i < 500; ++i) {
        const Vec2 p(dx(random), dy(random));
        if (removed.holds(p))
            QVERIFY2(isReached(p), qPrintable(QStringLiteral("%1 %2").arg(p.x()).arg(p.y())));
    }
}

// What would be wrong: polygons where a machine wants arcs.
void TestSlitForm::arcsAreAsRoundAsTheTool()
{
    for (const SlitEnd end : {SlitEnd::Round, SlitEnd::Dogbone, SlitEnd::TBone}) {
        SlitForm form = formOf(milled(end, 3.0), 8.0);
        int arcs = 0;
        const std::vector<Contour> cuts = slitCuts(form, {30.0, 4.0, true});
        QCOMPARE(cuts.size(), std::size_t(1));
        for (int i = 0; i < cuts[0].segmentCount(); ++i) {
            const CubicBezier curve = cuts[0].segment(i);
            if (curve.isStraight(kClipGrid))
                continue;
            ++arcs;
            // The circle through three of its points holds the others.
            const Vec2 a = curve.at(0.0), b = curve.at(0.5) - a, c = curve.at(1.0) - a;
            const Vec2 toMiddle =
                perpendicular(b * c.squaredNorm() - c * b.squaredNorm()) / (2.0 * cross(b, c));
            QVERIFY(std::abs(toMiddle.norm() - 1.6) < 1e-3);
            for (const double t : {0.2, 0.4, 0.8})
                QVERIFY(std::abs((curve.at(t) - a - toMiddle).norm() - 1.6) < 1e-3);
        }
        QVERIFY(arcs >= 2);
        QVERIFY(cuts[0].signedArea() > 0.0);
    }
}

// What would be wrong: an outline that crosses itself, of which a boolean makes anything.
void TestSlitForm::tooShortForItsRelief()
{
    for (const SlitEnd end : {SlitEnd::Round, SlitEnd::Dogbone, SlitEnd::TBone}) {
        for (const SlitBox &box : {SlitBox{1.0, 2.0, true}, SlitBox{3.0, 2.0, false}}) {
            const Removed removed(milled(end, 3.0, 0.2), box);
            for (const Polygon &outline : removed.outlines)
                QVERIFY(signedArea(outline) > 0.0);
            for (double x = 0.01; x < box.length; x += 0.1)
                for (double y = 0.01 - box.half; y < box.half; y += 0.1)
                    QVERIFY(removed.holds({x, y}) || end == SlitEnd::Round);
            for (const Vec2 &corner : innerCorners(box))
                QVERIFY(removed.holds(corner * (1.0 - 1e-9)));
        }
    }
}

void TestSlitForm::toolWiderThanTheSlit()
{
    for (const SlitEnd end : {SlitEnd::Round, SlitEnd::Dogbone, SlitEnd::TBone}) {
        const SlitBox box{30.0, 1.0, true};
        const Removed removed(milled(end, 12.0), box);
        QCOMPARE(removed.outlines.size(), std::size_t(1));
        QVERIFY(signedArea(removed.outlines[0]) > 2.0 * box.half * box.length);
        // No arc comes out of the other wall.
        QVERIFY(removed.box().max.y() < 3.0 * box.half);
        for (double x = 0.01; x < box.length; x += 0.1)
            QVERIFY(removed.holds({x, 0.99}) && removed.holds({x, -0.99}));
    }
}

// What would be wrong: a bump that closes its slit, or that presses on one side only.
void TestSlitForm::bumpsFaceEachOtherAndLeaveAGap()
{
    for (const double height : {0.05, 0.2, 5.0}) {
        for (const SlitBox &box :
             {SlitBox{30.0, 1.5, true}, SlitBox{30.0, 1.5, false}, SlitBox{2.0, 1.5, true}}) {
            const Removed removed(milled(SlitEnd::Square, 3.0, height), box);
            QCOMPARE(removed.outlines.size(), std::size_t(1));
            double narrowest = box.half;
            for (const Vec2 &p : removed.outlines[0])
                if (p.x() > 1e-3 && p.x() < box.length - 1e-3)
                    narrowest = std::min(narrowest, std::abs(p.y()));
            QVERIFY(narrowest >= 0.5 * box.half - 1e-9);
            if (box.length > 10.0 && height < 1.0) {
                QVERIFY(std::abs(narrowest - (box.half - height)) < 1e-3);
                QVERIFY(!removed.holds({0.5 * box.length, box.half - 0.9 * height}));
                QVERIFY(!removed.holds({0.5 * box.length, 0.9 * height - box.half}));
            }
            // The same on both walls.
            for (double x = 0.0; x < box.length; x += 0.05)
                QCOMPARE(removed.holds({x, 1.4}), removed.holds({x, -1.4}));
        }
    }
}

void TestSlitForm::leadInStaysAtTheContour_data()
{
    QTest::addColumn<double>("leadIn");
    QTest::addColumn<QVariantList>("upperEdge");
    const auto edge = [](std::initializer_list<double> numbers) {
        return QVariantList(numbers.begin(), numbers.end());
    };
    for (const double leadIn : {0.5, 2.0, 8.0}) {
        QTest::addRow("%g on a level edge", leadIn) << leadIn << edge({100, 60, 0, 60});
        QTest::addRow("%g on a slope", leadIn) << leadIn << edge({100, 90, 0, 30});
        QTest::addRow("%g on a steep slope", leadIn) << leadIn << edge({58, 90, 42, 30});
        QTest::addRow("%g in a valley", leadIn) << leadIn << edge({100, 80, 50, 55, 0, 80});
        QTest::addRow("%g in a narrow valley", leadIn)
            << leadIn << edge({100, 90, 54, 90, 51, 45, 49, 45, 46, 90, 0, 90});
        QTest::addRow("%g on a tip", leadIn) << leadIn << edge({100, 20, 50, 70, 0, 20});
        QTest::addRow("%g on a narrow finger", leadIn)
            << leadIn << edge({53, 20, 53, 60, 47, 60, 47, 20});
        QTest::addRow("%g at a step", leadIn)
            << leadIn << edge({100, 60, 50.5, 60, 50.5, 70, 0, 70});
    }
}

// What would be wrong: a chamfer that eats into the part, or that leaves a skin standing.
void TestSlitForm::leadInStaysAtTheContour()
{
    QFETCH(double, leadIn);
    QFETCH(QVariantList, upperEdge);
    Polygon edge;
    for (int i = 0; i + 1 < upperEdge.size(); i += 2)
        edge.push_back({upperEdge[i].toDouble(), upperEdge[i + 1].toDouble()});
    Stock stock;
    stock.leadIn = leadIn;
    const CutPlate plate(edge, stock);
    const Slit &slit = plate.slit();
    QVERIFY(slit.form);
    const std::vector<Polygon> outlines = slit.outlines(kFine);
    QCOMPARE(outlines.size(), std::size_t(1));
    const Polygon square = slit.outline();
    std::mt19937 random(3);
    const Box2 box = bounds(outlines[0]);
    std::uniform_real_distribution<double> x(box.min.x(), box.max.x()), y(box.min.y(), box.max.y());
    int more = 0;
    for (int i = 0; i < 50000; ++i) {
        const Vec2 p(x(random), y(random));
        const bool isCut = locate(p, outlines[0]) != Side::Outside;
        QVERIFY(isCut || locate(p, square) != Side::Inside);
        if (isCut && locate(p, square) == Side::Outside &&
            locate(p, plate.outline()) == Side::Inside) {
            ++more;
            QVERIFY(plate.distanceToContour(p) <= leadIn + 1e-6);
        }
    }
    QVERIFY(more > 0);
}

// What would be wrong: on a slope one wall with a long chamfer and the other one with none.
void TestSlitForm::leadInBeginsWhereEachWallLeaves()
{
    Stock stock;
    stock.leadIn = 2.0;
    const CutPlate plate({{100, 85}, {0, 35}}, stock); // rises by 1 in 2, 60 at the slit
    const Slit &slit = plate.slit();
    const bool isUp = slit.mouth.y() > slit.inner.y();
    QVERIFY(isUp);
    // Seen out of the slit, to the left is x < 50, where the wall leaves lower down.
    const double low = 60.0 - 0.25 * 3.0, high = 60.0 + 0.25 * 3.0;
    QVERIFY(std::abs(slit.inner.y() + slit.form->leadIns[0].from - (low - 2.0)) < 1e-9);
    QVERIFY(std::abs(slit.inner.y() + slit.form->leadIns[1].from - (high - 2.0)) < 1e-9);
    // Where the contour falls away, at 45°; where it rises, no farther along it than that.
    const Vec2 falling = slit.form->leadIns[0].to - Vec2(slit.form->leadIns[0].from, 0.0);
    QVERIFY(std::abs(falling.x() - falling.y()) < 1e-9);
    const Vec2 rising = slit.form->leadIns[1].to - Vec2(slit.form->leadIns[1].from, 0.0);
    QVERIFY(rising.x() > rising.y());
    QVERIFY(rising.y() > 1.5);
}

// What would be wrong: bumps beside a guest that is not there.
void TestSlitForm::bumpsAreWhereTheGuestIs()
{
    Stock stock;
    stock.bumps = 0.2;
    const CutPlate plate({{100, 200}, {0, 200}}, stock); // the guest ends at 90
    const Slit &slit = plate.slit();
    const std::vector<Polygon> outlines = slit.outlines(kFine);
    Box2 bumps;
    for (const Vec2 &p : outlines[0])
        if (std::abs(std::abs(p.x() - 50.0) - 1.5) > 1e-3)
            bumps.extend(p);
    QVERIFY(!bumps.isEmpty());
    const double overlapEnd = slit.mouth.y() > slit.inner.y() ? 90.0 : 20.0;
    QVERIFY(std::abs(bumps.center().y() - 0.5 * (slit.inner.y() + overlapEnd)) < 1e-6);
}

// What would be wrong: an edit of the stock after which the slits stay as they were.
void TestSlitForm::everyStockNumberCounts()
{
    Stock before = milled(SlitEnd::Dogbone, 3.0, 0.1);
    before.leadIn = 1.0;
    const CutPlate plate({{100, 60}, {0, 60}}, before);
    using Change = void (*)(Stock &);
    const Change changes[] = {
        [](Stock &stock) { stock.slitEnd = SlitEnd::Round; },
        [](Stock &stock) { stock.toolDiameter = 3.1; },
        [](Stock &stock) { stock.leadIn = 1.1; },
        [](Stock &stock) { stock.bumps = 0.2; },
        [](Stock &stock) { stock.clearance = 0.1; },
    };
    for (const Change change : changes) {
        Stock stock = *plate.model.document.stocks.front();
        change(stock);
        QVERIFY(!cutsTheSameSlits(*plate.model.document.stocks.front(), stock));
        const Model next = evaluate(*setStock(plate.model.document, stock));
        const Assembly changed = assemble(next, plate.model, plate.assembly);
        QVERIFY(!(changed.slits[0].at(0) == plate.slit()));
        QVERIFY(changed.slits == assemble(next).slits);
    }
}

FFF_TEST(TestSlitForm)
#include "tst_slit_form.moc"
