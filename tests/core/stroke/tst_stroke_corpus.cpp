#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/boolean.h"
#include "core/geometry/fit.h"
#include "core/stroke/stroke_contour.h"
#include "tests/core/geometry/polyline_distance.h"
#include "tests/core/geometry/published_fits.h"
#include "tests/core/geometry/turns.h"
#include "tests/core/stroke/stroke_corpus.h"
#include "tests/test_program.h"

#include <map>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kReach = 4.0 * kCorpusTolerance;
/// A joint that turns by less was not meant as a corner: it has to be smooth.
constexpr double kLeastCorner = 0.2;
/// Where the ends of a closed stroke are led together (closed_line.h): so far from its start, by so
/// much.
constexpr double kClosingStretch = 70.0 * kCorpusTolerance, kClosingShift = 3.0 * kCorpusTolerance;

/// In tolerances, how far the line that is meant may be off the samples.
constexpr double kMeant = 1.6;
/// Of samples a quarter of a metre apart, mm.
constexpr double kHugeStep = 3.0;

const std::vector<CorpusStroke> &corpus()
{
    static const std::vector<CorpusStroke> strokes = StrokeCorpus::make();
    return strokes;
}

std::vector<Vec2> flattened(const std::vector<CubicBezier> &chain, double chord)
{
    std::vector<Vec2> line;
    for (const CubicBezier &s : chain) {
        const int count = s.chordCount(chord);
        for (int i = line.empty() ? 0 : 1; i <= count; ++i)
            line.push_back(s.at(double(i) / count));
    }
    return line;
}

/// By how much the segment's control polygon turns: below a half turn it has no loop.
double turnWithin(const CubicBezier &s)
{
    const auto turn = [](const Vec2 &a, const Vec2 &b) {
        return a.isZero() || b.isZero() ? 0.0 : std::abs(std::atan2(cross(a, b), a.dot(b)));
    };
    return turn(s.p1 - s.p0, s.p2 - s.p1) + turn(s.p2 - s.p1, s.p3 - s.p2);
}

std::vector<CubicBezier> ourFit(const CorpusStroke &stroke)
{
    return fitCurve(stroke.samples, {.tolerance = kCorpusTolerance});
}

StrokeContour ourContour(const CorpusStroke &stroke)
{
    return strokeContour(stroke.samples, {.tolerance = kCorpusTolerance});
}

} // namespace

class TestStrokeCorpus : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasTwoHundredStrokes();
    void fitKeepsItsBound_data() { rows(); }
    void fitKeepsItsBound();
    void contourIsWhatWasDrawn_data() { rows(); }
    void contourIsWhatWasDrawn();
    void growingStrokeIsFittedFromScratch();
    void needsFewSegments();

private:
    void rows();
};

void TestStrokeCorpus::rows()
{
    QTest::addColumn<const CorpusStroke *>("stroke");
    for (const CorpusStroke &stroke : corpus())
        QTest::newRow(stroke.name.c_str()) << &stroke;
}

void TestStrokeCorpus::hasTwoHundredStrokes()
{
    QVERIFY2(corpus().size() >= 200, qPrintable(QString::number(corpus().size())));
}

/// A sample off the curve, a curve that swings out between samples, a loop inside a segment or a
/// kink where there is no corner is not what the hand drew.
void TestStrokeCorpus::fitKeepsItsBound()
{
    QFETCH(const CorpusStroke *, stroke);
    const std::vector<CubicBezier> chain = ourFit(*stroke);
    QVERIFY(!chain.empty());
    QCOMPARE(chain.front().p0, stroke->samples.front());
    QCOMPARE(chain.back().p3, stroke->samples.back());
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
        QCOMPARE(chain[i].p3, chain[i + 1].p0);
        const double turn = turnBetween(chain[i], chain[i + 1]);
        QVERIFY2(turn < 1e-9 || turn > kLeastCorner, qPrintable(QString::number(turn)));
    }
    constexpr double kChord = 0.02;
    const std::vector<Vec2> line = flattened(chain, kChord);
    const PolylineDistance toCurve(line), toSamples(stroke->samples);
    double off = 0.0, over = 0.0;
    for (const Vec2 &p : stroke->samples)
        off = std::max(off, toCurve(p));
    for (const Vec2 &p : line)
        over = std::max(over, toSamples(p));
    QVERIFY2(off <= kCorpusTolerance + kChord, qPrintable(QString::number(off)));
    QVERIFY2(over <= kCorpusTolerance, qPrintable(QString::number(over)));
    for (const CubicBezier &s : chain)
        QVERIFY2(turnWithin(s) < 3.14, qPrintable(QString::number(turnWithin(s))));
}

/// The contour does not cross itself and lies where the stroke or its closing piece does; without
/// one there is a reason.
void TestStrokeCorpus::contourIsWhatWasDrawn()
{
    QFETCH(const CorpusStroke *, stroke);
    const StrokeContour result = ourContour(*stroke);
    QCOMPARE(result.contour.has_value(), result.refusal == StrokeContour::Refusal::None);
    if (!result.contour)
        return;
    const Result<ResolvedContour> resolved = resolveCrossings(*result.contour);
    QVERIFY(resolved && !resolved->wasCrossing);
    QVERIFY(resolved->contour == *result.contour);

    std::vector<Vec2> drawn = stroke->samples;
    if (result.closing)
        for (int i = 0; i <= 200; ++i)
            drawn.push_back(result.closing->at(i / 200.0));
    else
        drawn.push_back(drawn.front());
    const PolylineDistance toDrawn(drawn);
    const Vec2 &start = stroke->samples.front();
    for (const Vec2 &p : result.contour->polygon(0.05)) {
        // Where noise is taken off, and where the line bends between samples that are far apart.
        const bool isMeant = stroke->family == "noisy hand" || stroke->family == "huge";
        double bound = (isMeant ? kMeant : 1.0) * kCorpusTolerance + 0.05;
        if (stroke->family == "huge")
            bound += kHugeStep; // ends that are led together, metres across
        if (!result.closing && (p - start).norm() < kClosingStretch)
            bound += kClosingShift;
        const double over = toDrawn(p);
        QVERIFY2(over <= bound, qPrintable(QString::number(over)));
    }
    if (!result.closing && !result.wasCrossing) {
        // Closed without a dent: nothing of the joint is sharper than what was drawn.
        const CubicBezier &first = result.fitted.front(), &last = result.fitted.back();
        QCOMPARE(last.p3, first.p0);
        const double turn = turnBetween(last, first);
        QVERIFY2(turn < 1e-9 || turn > kLeastCorner, qPrintable(QString::number(turn)));
    }
}

/// What is shown after each sample is what these samples give by themselves, whatever was fitted
/// before: nothing is kept in between.
void TestStrokeCorpus::growingStrokeIsFittedFromScratch()
{
    for (std::size_t k = 0; k < corpus().size(); k += 23) {
        std::vector<Vec2> growing;
        for (const Vec2 &p : corpus()[k].samples) {
            growing.push_back(p);
            if (growing.size() % 40 == 0)
                fitCurve(growing, {.tolerance = kCorpusTolerance});
        }
        const auto whole = ourFit(corpus()[k]);
        const auto grown = fitCurve(growing, {.tolerance = kCorpusTolerance});
        QCOMPARE(grown.size(), whole.size());
        for (std::size_t i = 0; i < whole.size(); ++i)
            QVERIFY(whole[i].p0 == grown[i].p0 && whole[i].p1 == grown[i].p1 &&
                    whole[i].p2 == grown[i].p2 && whole[i].p3 == grown[i].p3);
    }
}

/// At most twice the segments of the best of three published fits; where there is a known answer,
/// no more than that, for the whole contour. Prints the table.
void TestStrokeCorpus::needsFewSegments()
{
    struct Family
    {
        int strokes = 0, ours = 0, schneider = 0, plassStone = 0, levien = 0, best = 0;
        int contour = 0, hand = 0;
    };
    std::map<std::string, Family> families;
    QStringList tooMany;
    for (const CorpusStroke &stroke : corpus()) {
        Family &family = families[stroke.family];
        Box2 box;
        for (const Vec2 &p : stroke.samples)
            box.extend(p);
        const double step = std::max(0.5 * kReach, box.size().maxCoeff() / 500.0);
        const Stretches stretches = cutAtCorners(stroke.samples, std::max(kReach, step), step);
        const auto count = [](const std::vector<CubicBezier> &chain) {
            return static_cast<int>(chain.size());
        };
        const int schneider = count(SchneiderFit(kCorpusTolerance, kReach).fit(stretches));
        const int plassStone = count(PlassStoneFit(kCorpusTolerance, kReach).fit(stretches));
        const int levien = count(LevienFit(kCorpusTolerance, kReach).fit(stretches));
        const int best = std::min({schneider, plassStone, levien});
        const int ours = count(ourFit(stroke));
        const std::optional<Contour> contour = ourContour(stroke).contour;
        const int closed = contour ? contour->segmentCount() : 0;
        // A hand's answer is the contour's; its open chain may be cut where the pen began.
        if (stroke.handCount > 0 ? closed > stroke.handCount : ours > 2 * best)
            tooMany.append(QStringLiteral("%1: %2 (%3 closed)")
                               .arg(QString::fromStdString(stroke.name))
                               .arg(ours)
                               .arg(closed));
        ++family.strokes;
        family.ours += ours;
        family.schneider += schneider;
        family.plassStone += plassStone;
        family.levien += levien;
        family.best += best;
        family.contour += closed;
        family.hand += stroke.handCount;
    }
    Family all;
    const auto print = [](const char *name, const Family &f) {
        qDebug("%-15s %4d strokes: ours %4d, Schneider %4d, Plass & Stone %4d, Levien %5d, best of "
               "these %4d; closed %4d, by hand %4d",
               name, f.strokes, f.ours, f.schneider, f.plassStone, f.levien, f.best, f.contour,
               f.hand);
    };
    for (const auto &[name, family] : families) {
        print(name.c_str(), family);
        all.strokes += family.strokes;
        all.ours += family.ours;
        all.schneider += family.schneider;
        all.plassStone += family.plassStone;
        all.levien += family.levien;
        all.best += family.best;
        all.contour += family.contour;
        all.hand += family.hand;
    }
    print("all", all);
    QVERIFY2(tooMany.isEmpty(), qPrintable(tooMany.join(QStringLiteral(", "))));
}

FFF_TEST(TestStrokeCorpus)
#include "tst_stroke_corpus.moc"
