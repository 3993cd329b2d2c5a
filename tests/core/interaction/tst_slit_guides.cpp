// Slits that a hand draws nearly upright, level, square to the contour or along the last one.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/contour_points.h"
#include "core/interaction/contour_words.h"
#include "core/interaction/pen_tool.h"
#include "core/interaction/slit_guides.h"
#include "core/interaction/stroke_words.h"
#include "tests/core/interaction/desk.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <cmath>
#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

using Leads = SlitGuide::Kind;

Vec2 towards(double angle)
{
    return {std::cos(radians(angle)), std::sin(radians(angle))};
}

ShapePointer polygonOf(int corners, double radius, double turn)
{
    std::vector<Vec2> points;
    for (int i = 0; i < corners; ++i)
        points.push_back(radius * towards(turn + 360.0 * i / corners));
    return polygonShape(points);
}

/// What a straight way from → … (as far as need be, in one step) becomes.
struct Led
{
    Vec2 drawn, to;
    std::optional<SlitGuide> guide;
};
Led led(const Model &model, const SectionPointer &section, const Vec2 &from, const Vec2 &way,
        bool snaps = true)
{
    Stroke stroke(Stroke::Options{});
    stroke.beginInSection(section->shape, {0.0, from});
    stroke.move({8.0, from + 1000.0 * way});
    Led result;
    result.drawn = stroke.slitTo();
    result.guide =
        SlitGuides(model, section, from, Eigen::Quaterniond::Identity()).lead(stroke, snaps);
    result.to = stroke.slitTo();
    return result;
}

SectionPointer upright(const ShapePointer &shape)
{
    Section section;
    section.id = SectionId{1};
    section.shape = shape;
    section.frame = {Vec3(0, 100, 0), Vec3::UnitX(), Vec3::UnitY()};
    return std::make_shared<const Section>(section);
}

bool isOnContour(const Section &section, const Vec2 &p)
{
    // As near as a search for the nearest place can tell.
    return nearestPlace(section.shape->contour(), p).distance < 1e-6;
}

} // namespace

class TestSlitGuides : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void levelAndUprightWithinFiveDegrees();
    void worldGoesBeforeAnEdgeThatIsNearlySo();
    void squareToTheContourWhereItLeaves();
    void squareToACurve();
    void alongTheLastSlit();
    void leaningSectionsHaveTheirOwnUpright();
    void inHasteItIsWhatWasDrawnInside();
    void tangentialSlitsStayWhereTheyLeave();
    void theGuideIsSeenBeforeItLeaves();
    void controlLeavesItFree();
    void thePenHasTheSame();
};

void TestSlitGuides::levelAndUprightWithinFiveDegrees()
{
    const SectionPointer section = upright(polygonOf(64, 100.0, 2.0));
    const Model model{Document(), {}};
    const Vec2 from(13.0, -21.0); // squares of the contour lie elsewhere
    for (int axis = 0; axis < 4; ++axis)
        for (const double off : {-4.9, -3.0, -0.5, 0.0, 2.0, 4.9, 5.1, -5.1}) {
            const Led slit = led(model, section, from, towards(90.0 * axis + off));
            const Vec2 exact = towards(90.0 * axis), way = slit.to - from;
            QVERIFY(isOnContour(*section, slit.to));
            const bool isLed =
                slit.guide && slit.guide->kind == (axis % 2 ? Leads::Upright : Leads::Level);
            if (std::abs(off) > 5.0)
                QVERIFY(!isLed);
            else
                QVERIFY2(isLed && std::abs(cross(way.normalized(), exact)) < 1e-12,
                         qPrintable(QString::number(off)));
        }
    // Free in between.
    const Led askew = led(model, upright(polygonOf(4, 100.0, 20.0)), from, towards(33.0));
    QVERIFY(!askew.guide && askew.to == askew.drawn);
}

/// An edge that a hand drew level is off by a degree or so, and not meant to be.
void TestSlitGuides::worldGoesBeforeAnEdgeThatIsNearlySo()
{
    const Model model{Document(), {}};
    for (const double lean : {-1.5, -0.6, 0.6, 1.5})
        for (const double off : {-1.0, -0.5, 0.5, 1.0}) {
            const SectionPointer section = upright(polygonOf(4, 100.0, 45.0 + lean));
            const Led slit = led(model, section, {5.0, -7.0}, towards(90.0 + off));
            QVERIFY(slit.guide && slit.guide->kind == Leads::Upright);
            QCOMPARE(slit.to.x(), 5.0);
        }
}

void TestSlitGuides::squareToTheContourWhereItLeaves()
{
    const Model model{Document(), {}};
    for (int turn = 10; turn < 90; turn += 7) {
        const SectionPointer section = upright(polygonOf(4, 100.0, turn));
        const Vec2 from(5.0, -7.0);
        for (int edge = 0; edge < 4; ++edge)
            for (const double off : {-4.5, 1.0, 4.5}) {
                const double normal = turn + 45.0 + 90.0 * edge;
                const double world = std::abs(std::remainder(normal + off, 90.0));
                const Led slit = led(model, section, from, towards(normal + off));
                if (world <= std::abs(off) + 2.1)
                    continue; // the world's directions are nearly as near
                QVERIFY(slit.guide && slit.guide->kind == Leads::RightAngle);
                QVERIFY(std::abs(cross((slit.to - from).normalized(), towards(normal))) < 1e-12);
                QVERIFY(isOnContour(*section, slit.to));
            }
    }
}

void TestSlitGuides::squareToACurve()
{
    const Model model{Document(), {}};
    const SectionPointer section = upright(*Shape::make(test::circle({0, 0}, 80)));
    // Out of a point that is not the middle, square to it is away from the middle.
    const double angle = 37.0;
    const Vec2 from = 30.0 * towards(angle);
    for (const double off : {-4.0, 3.0}) {
        const Led slit = led(model, section, from, towards(angle + off));
        QVERIFY(slit.guide && slit.guide->kind == Leads::RightAngle);
        const NearestPlace place = nearestPlace(section->shape->contour(), slit.to);
        const Vec2 along =
            section->shape->contour().segment(place.at.segment).derivative(place.at.t);
        QVERIFY(std::abs(along.normalized().dot((slit.to - from).normalized())) < 1e-6);
        QVERIFY(place.distance < 1e-6);
    }
}

void TestSlitGuides::alongTheLastSlit()
{
    Desk desk;
    desk.addPlate();
    const SectionPointer plate = desk.sections().front();
    Document document = desk.session.committed().document;
    NewSection second;
    second.shape = polygonOf(4, 10.0, 45.0);
    second.parent = Parent{plate->ref(), {-20, 0}, {-20 - 100 * std::cos(radians(27)), -51}};
    second.parent->slitTo = second.parent->slitFrom - 80.0 * towards(27.0);
    document = *addSection(document, second);
    const Model model{document, {}};
    const Vec2 from(10.0, 5.0);
    for (const double off : {-4.0, 0.5, 4.0}) {
        for (const double back : {0.0, 180.0}) {
            const Led slit = led(model, plate, from, towards(27.0 + off + back));
            QVERIFY(slit.guide && slit.guide->kind == Leads::Parallel);
            QVERIFY(std::abs(cross((slit.to - from).normalized(), towards(27.0))) < 1e-12);
            QVERIFY(isOnContour(*plate, slit.to));
        }
    }
    // Not on a section that the direction does not lie in.
    Section across = *plate;
    across.frame = {plate->frame.origin, Vec3::UnitZ(), Vec3::UnitY()};
    const Led slit = led(model, std::make_shared<const Section>(across), from, towards(27.0 + 1.0));
    QVERIFY(!slit.guide);
}

/// Upright in a plane that leans is straight uphill.
void TestSlitGuides::leaningSectionsHaveTheirOwnUpright()
{
    const Model model{Document(), {}};
    for (const double lean : {-60.0, -5.0, 5.0, 30.0}) {
        Section section = *upright(polygonOf(64, 100.0, 2.0));
        const Eigen::AngleAxisd turn(radians(lean), Vec3::UnitX());
        const Eigen::AngleAxisd about(radians(20.0), Vec3::UnitY());
        const Eigen::AngleAxisd inPlane(radians(33.0), Vec3::UnitZ());
        const auto turned = about * turn * inPlane;
        section.frame = {Vec3(0, 100, 0), turned * Vec3::UnitX(), turned * Vec3::UnitY()};
        const auto pointer = std::make_shared<const Section>(section);
        const Led level = led(model, pointer, {13, -21}, towards(-33.0 + 4.0));
        QVERIFY(level.guide && level.guide->kind == Leads::Level);
        const Vec3 way = section.frame.directionToWorld(level.to - Vec2(13, -21)).normalized();
        QVERIFY(std::abs(way.y()) < 1e-12);
        const Led up = led(model, pointer, {13, -21}, towards(57.0 - 4.0));
        QVERIFY(up.guide && up.guide->kind == Leads::Upright);
        const Vec3 uphill = section.frame.directionToWorld(up.to - Vec2(13, -21)).normalized();
        QVERIFY(std::abs(uphill.dot(way)) < 1e-12);
    }
}

// Wrong: a stroke that leaves almost along an edge jumps to the other end of the section.
// Wrong: of a quick stroke, whose next sample after the last one in the section is round a corner
// already, the slit slants towards that.
void TestSlitGuides::inHasteItIsWhatWasDrawnInside()
{
    const Model model{Document(), {}};
    const SectionPointer section = upright(polygonOf(4, 100.0, 45.0)); // to y = 70.7
    const Vec2 from(5.0, 30.0), last(6.5, 66.0);
    for (const bool turns : {true, false}) {
        Stroke stroke(Stroke::Options{});
        stroke.beginInSection(section->shape, {0.0, from});
        stroke.move({8.0, from + 0.5 * (last - from)});
        stroke.move({16.0, turns ? last : Vec2(5.2, 36.0)});
        stroke.move({24.0, Vec2(40.0, 100.0)});
        const SlitGuides guides(model, section, from, Eigen::Quaterniond::Identity());
        const auto guide = guides.lead(stroke, true);
        QCOMPARE(guide && guide->kind == Leads::Upright, turns);
        if (turns)
            QCOMPARE(stroke.slitTo().x(), 5.0);
    }
}

void TestSlitGuides::tangentialSlitsStayWhereTheyLeave()
{
    const Model model{Document(), {}};
    const SectionPointer plate = upright(polygonShape(rectangle(-100, -60, 100, 60)));
    const SectionPointer disc = upright(*Shape::make(test::circle({0, 0}, 80)));
    for (const double depth : {0.2, 1.0, 3.0, 8.0})
        for (double angle = -12.0; angle <= 12.0; angle += 0.5)
            for (const SectionPointer &section : {plate, disc}) {
                const Vec2 from(-40.0, section == plate ? 60.0 - depth
                                                        : std::sqrt(6400.0 - 1600.0) - depth);
                const Led slit = led(model, section, from, towards(angle));
                QVERIFY(isOnContour(*section, slit.to));
                const double length = (slit.drawn - from).norm();
                QVERIFY((slit.to - slit.drawn).norm() <= 0.25 * length + 1e-9);
                const double off = std::abs(cross((slit.to - from).normalized(), towards(angle)));
                QVERIFY(off <= std::sin(SlitGuides::kReach) + 1e-9);
            }
}

void TestSlitGuides::theGuideIsSeenBeforeItLeaves()
{
    Desk desk;
    desk.addPlate();
    desk.press(desk.plate(20, 3));
    desk.moveTo(desk.plate(70, 5));
    const Overlay &overlay = desk.interaction.overlay();
    const auto *guide = overlay.find<sign::Line>();
    QVERIFY(guide && guide->role == SignRole::Guide);
    QVERIFY(std::abs(guide->points[0].y() - guide->points[1].y()) < 1e-9);
    const auto *slit = overlay.find<sign::Slit>();
    QVERIFY(slit && !slit->hasLeft && std::abs(slit->to.y() - slit->from.y()) < 1e-9);
    desk.moveTo(desk.plate(70, 12)); // out of reach
    QVERIFY(!overlay.find<sign::Line>());
    QVERIFY((desk.screen(overlay.find<sign::Slit>()->to) - desk.cursor).norm() < 1e-6);
    desk.moveTo(desk.plate(110, 5));
    QVERIFY(overlay.find<sign::Line>()); // and in the turn
    desk.wait(kTurnTime);
    QVERIFY(!overlay.find<sign::Line>());
    const Vec2 start = desk.cursor;
    for (const Vec2 &p : {Vec2(90, 60), Vec2(90, -80), Vec2(-80, -80)})
        desk.moveTo(start + p);
    desk.release(desk.cursor);
    QCOMPARE(desk.sections().size(), std::size_t(2));
    const Parent &parent = *desk.sections()[1]->parent;
    QVERIFY((parent.slitTo - Vec2(100, parent.slitFrom.y())).norm() < 1e-9);
    // The new plane is level, exactly.
    QVERIFY(std::abs(std::abs(desk.sections()[1]->frame.normal().y()) - 1.0) < 1e-12);
}

void TestSlitGuides::controlLeavesItFree()
{
    for (const bool snaps : {true, false}) {
        Desk desk;
        desk.interaction.settings().snaps = snaps;
        desk.addPlate();
        desk.press(desk.plate(20, 3));
        desk.moveTo(desk.plate(70, 5));
        QCOMPARE(desk.interaction.overlay().find<sign::Line>() != nullptr, snaps);
        desk.moveTo(desk.plate(71, 5), kControl);
        QVERIFY(!desk.interaction.overlay().find<sign::Line>());
        desk.moveTo(desk.plate(110, 6), kControl);
        desk.wait(kTurnTime);
        const auto *slit = desk.interaction.overlay().find<sign::Slit>();
        QVERIFY(slit && slit->hasLeft && std::abs(slit->to.y() - slit->from.y()) > 2.0);
    }
}

void TestSlitGuides::thePenHasTheSame()
{
    Desk desk;
    desk.addPlate();
    desk.run("section.pen");
    desk.moveTo(desk.plate(20, 3));
    desk.press(desk.plate(20, 3));
    desk.moveTo(desk.plate(70, 5));
    const auto *guide = desk.interaction.overlay().find<sign::Line>();
    QVERIFY(guide && guide->role == SignRole::Guide);
    desk.moveTo(desk.plate(110, 5));
    desk.wait(3.0 * kTurnTime);
    const auto *slit = desk.interaction.overlay().find<sign::Slit>();
    QVERIFY(slit && slit->hasLeft);
    QVERIFY(std::abs(slit->to.y() - slit->from.y()) < 1e-9);
    QVERIFY(std::abs(slit->to.x() - 100.0) < 1e-9);
}

FFF_TEST(TestSlitGuides)
#include "tst_slit_guides.moc"
