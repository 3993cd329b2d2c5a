#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/stroke/stroke_contour.h"
#include "tests/core/stroke/sloppy_hand.h"
#include "tests/test_program.h"

#include <functional>

using namespace fff;
using namespace fff::test;

// A hand never ends where it began: it goes on beside its start, across it, stops short of it, or
// hooks back as it is lifted or put down. What would be wrong: a barb or a notch where it was
// closed, a corner of the outline that is gone, or one that nobody drew.

namespace {

constexpr double kTolerance = 2.0;
constexpr double kDrift = 60.0;     // px
constexpr double kBentAside = 45.0; // degrees

/// Where on an outline the hand begins.
struct Start
{
    const char *name;
    Outline outline; // from there on
    double radius;   // of its bend there, px: what is left out of one nobody can tell
};

const std::vector<Start> &starts()
{
    static const std::vector<Start> all = [] {
        const Outline star = spikyOutline(150.0, 65.0, 5);
        const double edge = star.length() / 10.0;
        const Outline box = polygonOutline("box", {{0, 0}, {260, 0}, {260, 160}, {0, 160}});
        const Outline concave = concaveOutline(170.0);
        return std::vector<Start>{
            {"a circle", roundOutline(100.0, 100.0), 100.0},
            {"an ellipse at its tip", roundOutline(160.0, 70.0), 30.0},
            {"a small circle", roundOutline(40.0, 40.0), 40.0},
            {"a bulge of a concave one", concave, 68.0},
            {"a bay of a concave one", concave.from(concave.length() / 6.0), 29.0},
            {"a side of a concave one", concave.from(concave.length() / 12.0), 100.0},
            {"a tip of a spiky one", star, 100.0},
            {"an inner corner of a spiky one", star.from(edge), 100.0},
            {"an edge of a spiky one", star.from(0.5 * edge), 100.0},
            {"a corner of a box", box, 100.0},
            {"an edge of a box", box.from(130.0), 100.0},
        };
    }();
    return all;
}

double headingAt(const Outline &outline, double along)
{
    const Vec2 way = outline.at(along + 2.0) - outline.at(along - 2.0);
    return std::atan2(way.y(), way.x());
}

/// What the hand does at the ends; `by` in px.
using Ends = std::function<Samples(const Start &, double by)>;

Samples onAlongIt(const Start &start, double by)
{
    SloppyHand hand;
    hand.along(start.outline, 0.0, start.outline.length() + by);
    return hand.samples();
}

/// Straight on where the outline turns, `aside` of its start.
Samples straightOn(const Start &start, double by, double aside)
{
    const double length = start.outline.length();
    const double heading = headingAt(start.outline, length - 4.0);
    SloppyHand hand;
    hand.along(start.outline, 0.0, length - kDrift);
    // Bit by bit beside it, so that the hand itself draws no corner.
    for (double s = 4.0; s <= kDrift; s += 4.0) {
        const double u = s / kDrift;
        const Vec2 off = aside * u * u * (3.0 - 2.0 * u) * perpendicular(SloppyHand::way(heading));
        hand.to(start.outline.at(length - kDrift + s) + off);
    }
    hand.by(by, heading);
    return hand.samples();
}

Samples short_(const Start &start, double by)
{
    SloppyHand hand;
    hand.along(start.outline, 0.0, start.outline.length() - by);
    return hand.samples();
}

Samples late(const Start &start, double by)
{
    SloppyHand hand;
    hand.along(start.outline, by, start.outline.length());
    return hand.samples();
}

/// Lifted: back by an angle, `before` short of the start.
Samples hookAtEnd(const Start &start, double by, double angle, double before)
{
    const double end = start.outline.length() - before;
    SloppyHand hand;
    hand.along(start.outline, 0.0, end);
    hand.by(by, headingAt(start.outline, end - 3.0) + angle);
    return hand.samples();
}

Samples hookAtStart(const Start &start, double by, double angle, double after)
{
    const double heading = headingAt(start.outline, after + 3.0) + std::numbers::pi + angle;
    SloppyHand hand;
    hand.start(start.outline.at(after) - by * SloppyHand::way(heading));
    hand.to(start.outline.at(after));
    hand.along(start.outline, after, start.outline.length());
    return hand.samples();
}

struct Case
{
    const char *name;
    Ends ends;
    double allowed = 0.0; // px that the contour may be off, besides
    bool isGap = false;   // something is not drawn
};

const std::vector<Case> &cases()
{
    static const std::vector<Case> all{
        {"goes on along it", onAlongIt, 0.0},
        {"goes straight on", [](const Start &s, double by) { return straightOn(s, by, 0.0); }, 0.0},
        {"goes on to its left", [](const Start &s, double by) { return straightOn(s, by, 5.0); },
         5.0},
        {"goes on to its right", [](const Start &s, double by) { return straightOn(s, by, -5.0); },
         5.0},
        {"stops short", short_, 3.0, true},
        {"starts late", late, 3.0, true},
        {"hooks back to the left",
         [](const Start &s, double by) { return hookAtEnd(s, by, 2.4, 0.0); }, 0.0},
        {"hooks back to the right",
         [](const Start &s, double by) { return hookAtEnd(s, by, -2.4, 0.0); }, 0.0},
        {"stops short and hooks back",
         [](const Start &s, double by) { return hookAtEnd(s, std::max(5.0, 0.5 * by), 2.7, 12.0); },
         0.0},
        {"goes on and hooks back",
         [](const Start &s, double by) {
             return hookAtEnd(s, std::max(5.0, 0.5 * by), -2.7, -10.0);
         },
         0.0},
        {"hooks at its start, left",
         [](const Start &s, double by) { return hookAtStart(s, by, 0.7, 0.0); }, 0.0},
        {"hooks at its start, right",
         [](const Start &s, double by) { return hookAtStart(s, by, -0.7, 0.0); }, 0.0},
    };
    return all;
}

} // namespace

class TestForgivingEnds : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void neverABarbOrANotch_data();
    void neverABarbOrANotch();
};

void TestForgivingEnds::neverABarbOrANotch_data()
{
    QTest::addColumn<int>("start");
    QTest::addColumn<int>("how");
    for (std::size_t s = 0; s < starts().size(); ++s)
        for (std::size_t c = 0; c < cases().size(); ++c)
            QTest::addRow("%s, %s", starts()[s].name, cases()[c].name) << int(s) << int(c);
}

void TestForgivingEnds::neverABarbOrANotch()
{
    QFETCH(int, start);
    QFETCH(int, how);
    const Start &from = starts()[static_cast<std::size_t>(start)];
    const Case &ends = cases()[static_cast<std::size_t>(how)];
    QStringList wrong;
    for (const double by : {5.0, 10.0, 20.0, 30.0, 45.0, 60.0}) {
        if (ends.isGap && by > 1.2 * from.radius)
            continue;
        const Samples samples = ends.ends(from, by);
        const StrokeContour stroke = strokeContour(samples, {.tolerance = kTolerance});
        if (!stroke.contour) {
            wrong.append(QStringLiteral("%1: nothing").arg(by));
            continue;
        }
        const Misfit off = misfit(*stroke.contour, from.outline);
        // A hand that comes in beside its start has bent the line itself.
        const double bend = ends.allowed > 0.0 && !ends.isGap ? kBentAside : 0.0;
        if (off.distance > 6.0 + ends.allowed + 0.12 * by || off.sharpestFalse > bend ||
            off.lostCorners > 0)
            wrong.append(QStringLiteral("%1: %2 px off, %3 false corners (%4°), %5 lost")
                             .arg(by)
                             .arg(off.distance, 0, 'f', 1)
                             .arg(off.falseCorners)
                             .arg(off.sharpestFalse, 0, 'f', 0)
                             .arg(off.lostCorners));
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QStringLiteral("; "))));
}

FFF_TEST(TestForgivingEnds)
#include "tst_forgiving_ends.moc"
