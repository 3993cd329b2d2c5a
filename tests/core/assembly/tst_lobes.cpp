// What of a region lies in a strip. If this fails, sections meet beside their axis and nobody cuts
// them.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/assembly/lobes.h"
#include "tests/core/assembly/many_corners.h"
#include "tests/test_program.h"

#include <polyclipping/clipper.hpp>

#include <cmath>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kGrid = 1e-6;

ClipperLib::Path pathOf(const Polygon &polygon)
{
    ClipperLib::Path path;
    for (const Vec2 &p : polygon)
        path.emplace_back(std::llround(p.x() / kGrid), std::llround(p.y() / kGrid));
    return path;
}

/// By a library: the pieces of the region in the strip.
std::vector<Stretch> byClipper(const PlaneLine &line, const Region &region, double halfWidth)
{
    const Vec2 along = line.direction, across(-along.y(), along.x());
    Polygon strip;
    for (const auto &[s, side] : {std::pair(-500.0, -1.0), std::pair(500.0, -1.0),
                                  std::pair(500.0, 1.0), std::pair(-500.0, 1.0)})
        strip.push_back(line.point + s * along + side * halfWidth * across);
    ClipperLib::Clipper clipper;
    clipper.AddPath(pathOf(region.outer), ClipperLib::ptSubject, true);
    for (const Polygon &hole : region.holes)
        clipper.AddPath(pathOf(hole), ClipperLib::ptSubject, true);
    clipper.AddPath(pathOf(strip), ClipperLib::ptClip, true);
    ClipperLib::PolyTree tree;
    clipper.Execute(ClipperLib::ctIntersection, tree, ClipperLib::pftEvenOdd);
    std::vector<Stretch> pieces;
    for (const ClipperLib::PolyNode *node = tree.GetFirst(); node; node = node->GetNext()) {
        if (node->IsHole())
            continue;
        Stretch piece{1e9, -1e9};
        for (const ClipperLib::IntPoint &p : node->Contour) {
            const double s =
                line.along(kGrid * Vec2(static_cast<double>(p.X), static_cast<double>(p.Y)));
            piece = {std::min(piece.from, s), std::max(piece.to, s)};
        }
        pieces.push_back(piece);
    }
    std::sort(pieces.begin(), pieces.end(),
              [](const Stretch &a, const Stretch &b) { return a.from < b.from; });
    return pieces;
}

} // namespace

class TestLobes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void piecesAreThoseOfTheBoolean();
    void whatLiesInsideIsOnePiece();
    void shapesAnswerAsTheirRegions();
    void cutsLeaveTheRest();
};

void TestLobes::piecesAreThoseOfTheBoolean()
{
    std::mt19937_64 random(5);
    const auto number = [&random](double low, double high) {
        return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
    };
    int several = 0, plain = 0;
    for (int i = 0; i < 400; ++i) {
        Region region;
        const double waves = std::floor(number(2.0, 9.0)), height = number(0.1, 0.6);
        for (int k = 0; k < 120; ++k) {
            const double angle = 2.0 * 3.14159265358979 * k / 120;
            const double r = 50.0 * (1.0 + height * std::sin(waves * angle)) + number(-1.0, 1.0);
            region.outer.push_back(r * Vec2(std::cos(angle), std::sin(angle)));
        }
        for (int k = 0; k < static_cast<int>(random() % 3); ++k) {
            const Vec2 at(8.0 * k, number(-8.0, 8.0));
            region.holes.push_back({at, at + Vec2(0, 4), at + Vec2(5, 4), at + Vec2(5, 0)});
        }
        const double turn = number(0.0, 6.28);
        const PlaneLine line{Vec2(number(-60, 60), number(-60, 60)),
                             Vec2(std::cos(turn), std::sin(turn))};
        const double halfWidth = number(0.5, 20.0);
        const auto ours = lobesIn(line, region, halfWidth);
        const auto theirs = byClipper(line, region, halfWidth);
        QCOMPARE(ours.size(), theirs.size());
        if (isOneLobe(line, region, halfWidth)) {
            ++plain;
            QCOMPARE(theirs.size(), std::size_t(1));
            QVERIFY(!intervalsOn(line, region).empty());
        }
        several += ours.size() > 1 ? 1 : 0;
        for (std::size_t k = 0; k < ours.size(); ++k) {
            QVERIFY(std::abs(ours[k].from - theirs[k].from) < 1e-4);
            QVERIFY(std::abs(ours[k].to - theirs[k].to) < 1e-4);
        }
    }
    QVERIFY(several > 50 && plain > 50); // of both some
}

void TestLobes::whatLiesInsideIsOnePiece()
{
    const Region region{rectangle(2, -1, 8, 1), {{{4, -0.5}, {4, 0.5}, {5, 0.5}, {5, -0.5}}}};
    const auto pieces = lobesIn({Vec2::Zero(), Vec2::UnitX()}, region, 1.5);
    QCOMPARE(pieces.size(), std::size_t(1));
    QCOMPARE(pieces[0].from, 2.0);
    QCOMPARE(pieces[0].to, 8.0);
    QVERIFY(lobesIn({Vec2(0, 9), Vec2::UnitX()}, region, 1.5).empty());
}

// Wrong: sections on a long spine would meet beside their axis and nobody cuts them.
void TestLobes::shapesAnswerAsTheirRegions()
{
    std::mt19937_64 random(412);
    int one = 0, several = 0;
    for (const ShapePointer &shape :
         {spineOf(300), jaggedDisc(random, 500), jaggedDisc(random, 2000)}) {
        for (const PlaneLine &line : linesAcross(random, *shape)) {
            for (const double halfWidth : {1e-3, 1.5, 12.0}) {
                const bool isOne = isOneLobe(line, shape->region(), halfWidth);
                QCOMPARE(isOneLobe(line, *shape, halfWidth), isOne);
                const auto all = lobesIn(line, shape->region(), halfWidth);
                const auto ours = lobesIn(line, *shape, halfWidth);
                QCOMPARE(ours.size(), all.size());
                for (std::size_t i = 0; i < all.size(); ++i)
                    QVERIFY(ours[i].from == all[i].from && ours[i].to == all[i].to);
                one += isOne ? 1 : 0;
                several += all.size() > 1 ? 1 : 0;
            }
        }
    }
    QVERIFY(one > 50 && several > 50);
}

void TestLobes::cutsLeaveTheRest()
{
    const auto left = leftOf({{0, 10}, {12, 14}}, {{8, 13}, {3, 4}, {-5, 1}, {3.5, 5}});
    QCOMPARE(left.size(), std::size_t(3));
    QVERIFY(left[0].from == 1 && left[0].to == 3);
    QVERIFY(left[1].from == 5 && left[1].to == 8);
    QVERIFY(left[2].from == 13 && left[2].to == 14);
    QVERIFY(leftOf({{0, 10}}, {{-1, 11}}).empty());
}

FFF_TEST(TestLobes)
#include "tst_lobes.moc"
