// Strokes along guides: what is caught lies on the guide, what leaves it is the hand's own.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/tolerances.h"
#include "core/geometry/fit.h"
#include "core/stroke/stroke_contour.h"
#include "tests/core/stroke/sloppy_hand.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kHalfTurn = std::numbers::pi;
constexpr double kCatch = 12.7; // mm
constexpr double kFitTolerance = 0.5;

/// A guide as a cut of a mesh gives it: cubics along the outline.
Contour guideOf(const Outline &outline)
{
    return Contour::fromSegments(fitClosedCurve(outline.line, {.tolerance = 0.05})).value();
}

std::shared_ptr<const Guides> guidesOf(const std::vector<Contour> &contours)
{
    auto guides = std::make_shared<Guides>();
    for (const Contour &contour : contours)
        guides->lines.emplace_back(CurvePath::around(contour));
    guides->reach = kCatch;
    return guides;
}

StrokeContour contourOf(const Samples &samples, std::shared_ptr<const Guides> guides,
                        std::vector<FreeSamples> free = {})
{
    return strokeContour(
        samples,
        {.tolerance = kFitTolerance, .guides = std::move(guides), .free = std::move(free)});
}

/// A hand that goes along the outline from one place to another, so far off it as `off` says.
Samples besides(const Outline &outline, double from, double to,
                const std::function<double(double)> &off, double step = 3.0)
{
    Samples samples;
    const int count = static_cast<int>(std::abs(to - from) / step);
    for (int i = 0; i <= count; ++i) {
        const double along = from + (to - from) * i / count;
        const Vec2 way = (outline.at(along + 0.5) - outline.at(along - 0.5)).normalized();
        samples.push_back(outline.at(along) +
                          off(static_cast<double>(i) / count) * Vec2(way.y(), -way.x()));
    }
    return samples;
}

std::function<double(double)> wobble(double size, double phase)
{
    return [=](double t) {
        return size * (std::sin(23.0 * t + phase) + 0.5 * std::sin(71.0 * t + 2.0 * phase));
    };
}

double furthest(const Samples &from, const Samples &to)
{
    const PolylineDistance distance(to);
    double most = 0.0;
    for (const Vec2 &p : from)
        most = std::max(most, distance(p));
    return most;
}

Samples closedPolygon(const Contour &contour)
{
    Samples line = contour.polygon(0.001);
    line.push_back(line.front());
    return line;
}

double sharpestTurn(const std::vector<CubicBezier> &chain)
{
    double most = 0.0;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        most = std::max(
            most, std::acos(std::clamp(endDirection(chain[i]).dot(startDirection(chain[i + 1])),
                                       -1.0, 1.0)));
    return most;
}

std::vector<Outline> roundOutlines()
{
    return {roundOutline(100, 60), roundOutline(40, 40), concaveOutline(90)};
}

} // namespace

class TestGuidedLine : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void placesOnALine();
    void allRoundIsTheGuide();
    void aPartLiesOnTheGuideAndPassesSmoothly();
    void whatOnlyCrossesStaysFree();
    void freeSamplesAreFree();
    void theOtherSideOfSomethingThinIsLeftAlone();
    void awayFromTheGuideAndBack();
    void howFarItIsOff();
    void itHoldsALittleLonger();
    void hastyStrokes();
    void sloppyStrokesMakeContours();
};

void TestGuidedLine::placesOnALine()
{
    const Contour circle = guideOf(roundOutline(50, 50));
    const PathLocator guide(CurvePath::around(circle));
    QVERIFY(std::abs(guide.length() - 2.0 * kHalfTurn * 50.0) < 0.1);
    for (int i = 0; i < 100; ++i) {
        const double a = 0.3 + 0.0618 * i;
        const auto place = guide.nearest(SloppyHand::way(a) * (45.0 + 0.1 * i), 20.0);
        QVERIFY(place);
        QVERIFY(std::abs(place->at.norm() - 50.0) < 0.06);
        QVERIFY((guide.at(place->along) - place->at).norm() < 1e-9);
        QVERIFY(cross(place->at.normalized(), SloppyHand::way(a)) < 1e-3);
    }
    QVERIFY(!guide.nearest(Vec2(0, 0), 40.0));
    // Pieces are cut from it, forwards, backwards and across its start.
    for (const auto &[from, to] : {std::pair(10.0, 200.0), std::pair(200.0, 10.0),
                                   std::pair(300.0, 330.0), std::pair(-20.0, 15.0)}) {
        const std::vector<CubicBezier> pieces = guide.piece(from, to);
        QVERIFY((pieces.front().p0 - guide.at(from)).norm() < 1e-4);
        QVERIFY((pieces.back().p3 - guide.at(to)).norm() < 1e-4);
        double length = 0.0;
        for (const CubicBezier &piece : pieces)
            for (int k = 0; k < 200; ++k)
                length += (piece.at((k + 1) / 200.0) - piece.at(k / 200.0)).norm();
        QVERIFY(std::abs(length - std::abs(to - from)) < 0.02);
        QVERIFY(sharpestTurn(pieces) < 0.02);
    }
}

// Wrong: who follows a mesh all round gets a jittery copy of its cut.
void TestGuidedLine::allRoundIsTheGuide()
{
    for (const Outline &outline : roundOutlines()) {
        const Contour guide = guideOf(outline);
        for (int k = 0; k < 40; ++k) {
            const double length = outline.length(), start = 0.03 * k * length;
            const double way = (k % 2 ? -1.0 : 1.0) * (length + (k % 5 - 2) * 8.0);
            const Samples samples = besides(outline, start, start + way, wobble(3.0, k));
            const StrokeContour stroke = contourOf(samples, guidesOf({guide}));
            QVERIFY2(stroke.contour, qPrintable(QString::number(k)));
            QVERIFY(stroke.guided->whole);
            QVERIFY(!stroke.isMirrored);
            QCOMPARE(stroke.contour->segmentCount(), guide.segmentCount());
            QVERIFY(furthest(closedPolygon(*stroke.contour), closedPolygon(guide)) < 1e-3);
            QVERIFY(furthest(closedPolygon(guide), closedPolygon(*stroke.contour)) < 1e-3);
        }
    }
}

void TestGuidedLine::aPartLiesOnTheGuideAndPassesSmoothly()
{
    for (const Outline &outline : roundOutlines()) {
        const Contour guide = guideOf(outline);
        const double length = outline.length();
        for (int k = 0; k < 24; ++k) {
            // Half round beside it, then inwards in a bow and back to where it began.
            const double start = 0.041 * k * length;
            const auto off = [k](double t) {
                const double in = std::clamp((t - 0.6) / 0.25, 0.0, 1.0);
                return wobble(2.5, k)(t) * (1.0 - in) - 30.0 * in * in * (3.0 - 2.0 * in);
            };
            const Samples samples = besides(outline, start, start + 0.85 * length, off);
            const StrokeContour stroke = contourOf(samples, guidesOf({guide}));
            QVERIFY(stroke.contour && stroke.guided);
            QVERIFY(!stroke.guided->whole);
            QVERIFY(!stroke.guided->pieces.empty());
            // What says that it is on the guide is.
            Samples caught;
            for (const FittedPiece &piece : stroke.guided->pieces)
                for (int i = 0; i <= 20; ++i)
                    caught.push_back(piece.curve.at(i / 20.0));
            QVERIFY(furthest(caught, closedPolygon(guide)) < 2e-3);
            QVERIFY(stroke.guided->onGuides > 0.4 * length);
            // It leaves without a corner, and stays near the hand.
            QVERIFY2(sharpestTurn(stroke.fitted) < 0.9,
                     qPrintable(QString::number(sharpestTurn(stroke.fitted))));
            QVERIFY(furthest(stroke.guided->points, samples) < kCatch);
            // The far end of what is free is the hand's.
            QVERIFY((stroke.guided->points.back() - samples.back()).norm() < 2.0);
        }
    }
}

void TestGuidedLine::whatOnlyCrossesStaysFree()
{
    const Outline outline = roundOutline(100, 60);
    const auto guides = guidesOf({guideOf(outline)});
    // A triangle across the guide, twice.
    const Samples samples = lines({{-150, 0}, {150, 20}, {0, 200}, {-150, 0}}, 3.0);
    const StrokeContour with = contourOf(samples, guides), without = contourOf(samples, nullptr);
    QVERIFY(with.contour && without.contour);
    QVERIFY(with.guided->pieces.empty());
    QVERIFY(*with.contour == *without.contour);
}

void TestGuidedLine::freeSamplesAreFree()
{
    const Outline outline = roundOutline(100, 60);
    const auto guides = guidesOf({guideOf(outline)});
    const Samples samples = besides(outline, 0, outline.length(), wobble(2.0, 1));
    const StrokeContour all = contourOf(samples, guides, {{0, samples.size()}});
    QVERIFY(all.contour && all.guided->pieces.empty() && !all.guided->whole);
    QVERIFY(*all.contour == *contourOf(samples, nullptr).contour);
    const std::size_t third = samples.size() / 3;
    const StrokeContour some = contourOf(samples, guides, {{third, 2 * third}});
    QVERIFY(!some.guided->whole);
    QVERIFY(some.guided->onGuides < 0.7 * some.guided->length);
    QVERIFY(some.guided->onGuides > 0.5 * some.guided->length);
    QCOMPARE(some.guided->turnouts.size(), std::size_t(2));
}

// Wrong: along an ear of a rabbit the line would jump from one side to the other and back.
void TestGuidedLine::theOtherSideOfSomethingThinIsLeftAlone()
{
    const Outline ear = roundOutline(120, 5);
    const auto guides = guidesOf({guideOf(ear)});
    for (int k = 0; k < 20; ++k) {
        const double length = ear.length();
        const Samples samples =
            besides(ear, 0.28 * length, 0.47 * length, wobble(2.5, k)); // along one side
        const GuidedLine line = guided(samples, {}, *guides);
        QVERIFY(!line.pieces.empty());
        QVERIFY2(std::abs(line.onGuides - 0.19 * length) < 8.0,
                 qPrintable(QString::number(line.onGuides)));
        QVERIFY(line.turnouts.empty());
    }
}

void TestGuidedLine::awayFromTheGuideAndBack()
{
    const Outline outline = roundOutline(100, 80);
    const Contour guide = guideOf(outline);
    const double length = outline.length();
    for (int k = 0; k < 24; ++k) {
        const double start = 0.04 * k * length;
        // A bump of 45 mm in the middle of the way round.
        const auto off = [k](double t) {
            const double x = (t - 0.5) / 0.2;
            return 45.0 * std::exp(-x * x * x * x) + wobble(1.5, k)(t);
        };
        const Samples samples = besides(outline, start, start + length - 6.0, off);
        const StrokeContour stroke = contourOf(samples, guidesOf({guide}));
        QVERIFY(stroke.contour && !stroke.guided->whole);
        QVERIFY(stroke.guided->isLoop);
        QCOMPARE(stroke.guided->turnouts.size(), std::size_t(2));
        QVERIFY(!stroke.closing);
        QVERIFY((stroke.fitted.front().p0 - stroke.fitted.back().p3).norm() == 0.0);
        std::vector<CubicBezier> round = stroke.fitted;
        round.push_back(round.front());
        QVERIFY2(sharpestTurn(round) < 0.6, qPrintable(QString::number(sharpestTurn(round))));
        // Opposite the bump it is the guide, its start and end among it.
        Samples other;
        for (double along = -0.22 * length; along < 0.22 * length; along += 2.0)
            other.push_back(outline.at(start + along));
        QVERIFY(furthest(other, closedPolygon(*stroke.contour)) < 0.06);
    }
}

/// As each free point says that is looked at by itself.
void TestGuidedLine::howFarItIsOff()
{
    const Outline outline = roundOutline(100, 80);
    const Contour guide = guideOf(outline);
    const Contour other = guideOf(roundOutline(20, 20));
    const auto guides = guidesOf({other, guide});
    const Samples lines[] = {closedPolygon(other), closedPolygon(guide)};
    for (const double bump : {0.0, 20.0, 45.0, -60.0})
        for (int k = 0; k < 12; ++k) {
            const auto off = [&](double t) {
                const double x = (t - 0.5) / 0.2;
                return bump * std::exp(-x * x * x * x) + wobble(1.5, k)(t);
            };
            const double start = 0.08 * k * outline.length();
            const GuidedLine line =
                guided(besides(outline, start, start + 0.6 * outline.length(), off), {}, *guides);
            double most = 0.0;
            const PolylineDistance one(lines[0]), two(lines[1]);
            for (const Vec2 &p : line.points)
                most = std::max(most, std::min(one(p), two(p)));
            QVERIFY2(std::abs(line.farthest - most) < 0.02,
                     qPrintable(QStringLiteral("%1, not %2").arg(line.farthest).arg(most)));
            QVERIFY(line.mostOn && two(*line.mostOn) < 0.01);
            QCOMPARE(line.onGuides > 0.999 * line.length, bump == 0.0);
        }
    const GuidedLine nowhere = guided({{0, 0}, {10, 0}}, {}, Guides());
    QCOMPARE(nowhere.farthest, 0.0);
    QVERIFY(!nowhere.mostOn);
}

void TestGuidedLine::itHoldsALittleLonger()
{
    const Outline outline = roundOutline(200, 200);
    const auto guides = guidesOf({guideOf(outline)});
    const auto onGuides = [&](double off) {
        const Samples samples =
            besides(outline, 0, 600, [off](double t) { return t > 0.3 && t < 0.7 ? off : 0.0; });
        const GuidedLine line = guided(samples, {}, *guides);
        return line.turnouts.size();
    };
    QCOMPARE(onGuides(0.9 * kCatch), std::size_t(0));
    QCOMPARE(onGuides(1.25 * kCatch), std::size_t(0));
    QCOMPARE(onGuides(1.35 * kCatch), std::size_t(2));
}

/// Ten places on the way round are enough.
void TestGuidedLine::hastyStrokes()
{
    for (const Outline &outline : {roundOutline(100, 60), roundOutline(60, 60)}) {
        const Contour guide = guideOf(outline);
        for (int count = 10; count < 30; count += 3) {
            Samples samples;
            for (int i = 0; i <= count; ++i)
                samples.push_back(outline.at(outline.length() * i / count));
            const StrokeContour stroke = contourOf(samples, guidesOf({guide}));
            QVERIFY(stroke.contour);
            QVERIFY2(stroke.guided->whole, qPrintable(QString::number(count)));
        }
    }
}

void TestGuidedLine::sloppyStrokesMakeContours()
{
    for (int k = 0; k < 300; ++k) {
        SloppyHand dice(3.0, 0.0, static_cast<unsigned>(k));
        const std::vector<Outline> all = {roundOutline(100, 60), concaveOutline(90),
                                          spikyOutline(100, 50, 5), roundOutline(80, 9)};
        const Outline outline = all[static_cast<std::size_t>(k) % all.size()];
        const auto guides = guidesOf({guideOf(outline), guideOf(roundOutline(20, 15))});
        SloppyHand hand(dice.any(1.0, 20.0), dice.any(0.0, 3.0), static_cast<unsigned>(k));
        double place = dice.any(0.0, outline.length());
        hand.start(outline.at(place));
        for (int part = 0; part < 6; ++part) {
            if (dice.any(0.0, 1.0) < 0.5) {
                const double next = place + dice.any(-0.2, 0.5) * outline.length();
                hand.along(outline, place, next);
                place = next;
            } else {
                hand.to({dice.any(-150.0, 150.0), dice.any(-150.0, 150.0)});
                place = dice.any(0.0, outline.length());
                hand.to(outline.at(place));
            }
        }
        const Samples &samples = hand.samples();
        std::vector<FreeSamples> free;
        if (k % 3 == 0)
            free = {{samples.size() / 4, samples.size() / 3}};
        const StrokeContour stroke = contourOf(samples, guides, free);
        for (const CubicBezier &curve : stroke.fitted)
            QVERIFY(curve.p0.allFinite() && curve.p1.allFinite() && curve.p2.allFinite() &&
                    curve.p3.allFinite());
        for (std::size_t i = 0; i + 1 < stroke.fitted.size(); ++i)
            QVERIFY2(stroke.fitted[i].p3 == stroke.fitted[i + 1].p0,
                     qPrintable(QString::number(k)));
        QVERIFY2(stroke.contour || stroke.refusal != StrokeContour::Refusal::None,
                 qPrintable(QString::number(k)));
        const GuidedLine line = guided(samples, free, *guides);
        for (std::size_t i = 0; i < line.pieces.size(); ++i) {
            QVERIFY(line.pieces[i].to < line.points.size());
            QVERIFY(line.pieces[i].from < line.pieces[i].to);
            QVERIFY(i == 0 || line.pieces[i].from >= line.pieces[i - 1].to);
        }
    }
}

FFF_TEST(TestGuidedLine)
#include "tst_guided_line.moc"
