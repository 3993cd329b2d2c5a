// A hand that does not wait for the view: slit and outline in one stroke of 0.8 s.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/contour_points.h"
#include "core/interaction/hand_in_turn.h"
#include "core/interaction/stroke_words.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

#include <cmath>
#include <numbers>

using namespace fff;
using namespace fff::test;
using Type = PointerEvent::Type;

namespace {

constexpr double kStrokeTime = 800.0; // ms, from the press to the release
constexpr double kSample = 8.0;       // ms between events of the mouse

/// What the hand draws after it left: offsets from the slit's end (px), the slit's direction being
/// `way`. Rounded and uneven, as a fast hand is.
std::vector<Vec2> ellipseRound(const Vec2 &way, double longer, double shorter, int count)
{
    const Vec2 side(-way.y(), way.x());
    std::vector<Vec2> path;
    // Out to the rim, then round.
    for (int i = 1; i <= count; ++i) {
        const double t = static_cast<double>(i) / count, out = std::min(1.0, t / 0.15);
        const double angle = 2.0 * std::numbers::pi * std::max(0.0, (t - 0.12) / 0.88);
        const double wobble = 1.0 + 0.03 * std::sin(5.0 * angle + 1.0);
        path.push_back(out * wobble *
                       (longer * std::cos(angle) * way + shorter * std::sin(angle) * side));
    }
    return path;
}

/// From its end to one side, in a bow, back to where the slit began.
std::vector<Vec2> halfOutline(const Vec2 &way, double reach, double height, int count)
{
    const Vec2 side(-way.y(), way.x());
    std::vector<Vec2> path;
    for (int i = 1; i <= count; ++i) {
        const double angle = std::numbers::pi * i / count;
        path.push_back(0.5 * reach * (std::cos(angle) - 1.0) * way +
                       height * std::sin(angle) * side);
    }
    return path;
}

struct View
{
    const char *name;
    const char *camera;
    double turn, lean; // of the section, degrees: about the world's Y, then about its own x
};
constexpr View kViews[] = {{"from the front", "front", 0, 0},
                           {"from a corner", "iso1", 0, 0},
                           {"turned away", "front", 35, 0},
                           {"leaning back", "front", 0, 25},
                           {"leaning, from a corner", "iso4", -20, -12},
                           {"from above", "top", 0, 80}};

/// A plate that lies so, in the middle of the view.
void addSectionIn(Desk &desk, const View &view)
{
    const Eigen::AngleAxisd turn(radians(view.turn), Vec3::UnitY());
    const Eigen::AngleAxisd lean(-radians(view.lean), Vec3::UnitX());
    const Frame frame{Vec3(0, 300, 0), turn * (lean * Vec3::UnitX()),
                      turn * (lean * Vec3::UnitY())};
    desk.session.commit(QStringLiteral("Draw"),
                        withSection(desk.session.committed().document,
                                    polygonShape(rectangle(-60, -60, 60, 60)), frame));
    Camera camera = desk.interaction.camera();
    QVERIFY(orientationOfView(view.camera, camera.orientation));
    camera.target = frame.origin;
    camera.millimetresPerPixel = 0.5;
    desk.interaction.setCamera(camera);
}

/// The hand from the middle of the plate out in a direction of the screen, until the slit is there.
/// Returns how many ms that took.
double drawSlit(Desk &desk, const Vec2 &way)
{
    const Vec2 start = desk.screen({0, 300, 0});
    const double begin = desk.time;
    desk.press(start);
    for (int i = 1; i < 60; ++i) {
        desk.send(Type::Move, start + 12.0 * i * way);
        const auto *slit = desk.interaction.overlay().find<sign::Slit>();
        if (slit && slit->hasLeft)
            break;
    }
    return desk.time - begin;
}

void draw(Desk &desk, const std::vector<Vec2> &path)
{
    const Vec2 start = desk.cursor;
    for (const Vec2 &p : path)
        desk.send(Type::Move, start + p);
}

Vec2 directionOf(int direction)
{
    const double angle = radians(30.0 * direction + 7.0);
    return {std::cos(angle), std::sin(angle)};
}

/// How far the points of one outline are from the other, mm.
double farthest(const Section &a, const Section &b)
{
    double most = 0.0;
    for (const Vec2 &p : a.shape->region().outer) {
        const Vec3 world = a.frame.toWorld(p);
        const Vec2 there = b.frame.toLocal(world);
        most = std::max({most, std::abs(b.frame.height(world)),
                         nearestPlace(b.shape->contour(), there).distance});
    }
    return most;
}

} // namespace

class TestHastyStroke : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oneStrokeOf800MsMakesASection_data();
    void oneStrokeOf800MsMakesASection();
    void hasteDrawsWhatPatienceDraws();
    void halfAnOutlineIsMirrored();
    void framesChangeNothing();
    void theViewEndsTurned();
    void whatComesToNothingLeavesTheView();
    void aPatientHandLosesNothing();
    void afterARestTheHandMayGoOn();
    void aSteadyHandLosesNothingEither();
    void facedCanvasesAreNotTurnedTo();
    void theCueSaysWaitAndGoOn();
};

void TestHastyStroke::oneStrokeOf800MsMakesASection_data()
{
    QTest::addColumn<int>("view");
    QTest::addColumn<int>("direction");
    for (std::size_t view = 0; view < std::size(kViews); ++view)
        for (int direction = 0; direction < 12; ++direction)
            QTest::addRow("%s, to %d", kViews[view].name, 30 * direction)
                << static_cast<int>(view) << direction;
}

// Wrong: what a fast hand draws while the view turns is thrown away.
void TestHastyStroke::oneStrokeOf800MsMakesASection()
{
    QFETCH(int, view);
    QFETCH(int, direction);
    Desk desk;
    addSectionIn(desk, kViews[static_cast<std::size_t>(view)]);
    const Vec2 way = directionOf(direction);
    const double left = kStrokeTime - drawSlit(desk, way);
    draw(desk, ellipseRound(way, 130, 90, static_cast<int>(left / kSample) - 1));
    desk.release(desk.cursor);
    QCOMPARE(desk.sections().size(), std::size_t(2));
    desk.wait(1000.0);
    const Section &section = *desk.sections().back();
    QVERIFY(section.parent);
    // It is where the slit ends, whole, and as large as it was drawn.
    const Vec3 end = desk.sections().front()->frame.toWorld(section.parent->slitTo);
    QVERIFY(std::abs(section.frame.height(end)) < 1e-9);
    QCOMPARE(locate(section.frame.toLocal(end), section.shape->region()), Side::Inside);
    QVERIFY(section.shape->isPlain());
    const Vec3 backward = desk.interaction.camera().backward();
    const double seen = std::abs(section.frame.normal().dot(backward));
    const double scale = desk.interaction.camera().millimetresPerPixel;
    const double ratio =
        section.shape->area() * seen / (std::numbers::pi * 130 * 90 * scale * scale);
    QVERIFY2(ratio > 0.85 && ratio < 1.15, qPrintable(QString::number(ratio)));
    QVERIFY2(section.shape->contour().segmentCount() <= 12,
             qPrintable(QString::number(section.shape->contour().segmentCount())));
}

/// The same way of the hand, begun at once or when the view has turned, is the same outline.
void TestHastyStroke::hasteDrawsWhatPatienceDraws()
{
    for (const View &view : kViews)
        for (int direction = 0; direction < 12; ++direction) {
            Desk hasty, patient;
            for (Desk *desk : {&hasty, &patient}) {
                addSectionIn(*desk, view);
                const Vec2 way = directionOf(direction);
                drawSlit(*desk, way);
                if (desk == &patient)
                    desk->wait(kTurnTime);
                draw(*desk, ellipseRound(way, 130, 90, 70));
                desk->release(desk->cursor);
                QCOMPARE(desk->sections().size(), std::size_t(2));
            }
            const double off = std::max(farthest(*hasty.sections()[1], *patient.sections()[1]),
                                        farthest(*patient.sections()[1], *hasty.sections()[1]));
            QVERIFY2(off < 1e-6, qPrintable(QStringLiteral("%1, to %2: %3 mm")
                                                .arg(QLatin1String(view.name))
                                                .arg(30 * direction)
                                                .arg(off)));
        }
}

void TestHastyStroke::halfAnOutlineIsMirrored()
{
    for (int direction = 0; direction < 12; ++direction) {
        Desk desk;
        addSectionIn(desk, kViews[0]);
        const Vec2 way = directionOf(direction);
        drawSlit(desk, way);
        draw(desk, halfOutline(way, 200, 110, 60));
        desk.release(desk.cursor);
        QCOMPARE(desk.sections().size(), std::size_t(2));
        const Section &section = *desk.sections().back();
        QVERIFY(section.shape->isPlain());
        const Vec3 end = desk.sections().front()->frame.toWorld(section.parent->slitTo);
        QVERIFY(section.shape->area() > 0.5 * std::numbers::pi * 50 * 55);
        QVERIFY(std::abs(section.frame.height(end)) < 1e-9);
    }
}

void TestHastyStroke::framesChangeNothing()
{
    std::vector<Vec2> points[2];
    for (const bool hasFrames : {false, true}) {
        Desk desk;
        addSectionIn(desk, kViews[1]);
        const Vec2 way = directionOf(0);
        drawSlit(desk, way);
        const Vec2 start = desk.cursor;
        for (const Vec2 &p : ellipseRound(way, 130, 90, 70)) {
            if (hasFrames)
                for (const double ms : {2.0, 3.0, 7.0})
                    desk.interaction.advance(desk.time + ms);
            desk.send(Type::Move, start + p);
        }
        desk.release(desk.cursor);
        QCOMPARE(desk.sections().size(), std::size_t(2));
        points[hasFrames] = desk.sections()[1]->shape->contour().points();
    }
    QVERIFY(points[0] == points[1]);
}

// Wrong: the stroke is over before the turn, and the view stays half turned.
void TestHastyStroke::theViewEndsTurned()
{
    Desk desk;
    addSectionIn(desk, kViews[0]);
    const Camera before = desk.interaction.camera();
    const Vec2 way = directionOf(0);
    drawSlit(desk, way);
    draw(desk, ellipseRound(way, 90, 70, 20));
    QVERIFY(desk.interaction.isAnimating());
    desk.release(desk.cursor);
    QCOMPARE(desk.sections().size(), std::size_t(2));
    QVERIFY(desk.interaction.isAnimating());
    desk.wait(kTurnTime);
    QVERIFY(!desk.interaction.isAnimating());
    const Section &section = *desk.sections().back();
    QVERIFY((section.frame.normal() - desk.interaction.camera().backward()).norm() < 1e-9);
    QVERIFY(desk.interaction.canGoBack());
    desk.interaction.goBack(desk.time, 0.0);
    QVERIFY(isSameCamera(desk.interaction.camera(), before));
}

void TestHastyStroke::whatComesToNothingLeavesTheView()
{
    for (const bool isEscaped : {false, true}) {
        Desk desk;
        addSectionIn(desk, kViews[1]);
        const Camera before = desk.interaction.camera();
        const Vec2 way = directionOf(0);
        drawSlit(desk, way);
        const std::vector<Vec2> path = ellipseRound(way, 90, 70, 40);
        if (isEscaped) {
            draw(desk, path);
            QVERIFY(desk.session.hasPreview());
            QVERIFY(desk.interaction.escape(desk.time));
        } else {
            draw(desk, {path.begin(), path.begin() + 4}); // straight on
            desk.release(desk.cursor);
            QCOMPARE(desk.hint(), hints::kTooShort);
        }
        desk.wait(1000.0);
        QCOMPARE(desk.sections().size(), std::size_t(1));
        QVERIFY(!desk.session.hasPreview());
        QVERIFY(isSameCamera(desk.interaction.camera(), before));
    }
}

/// A hand that overshoots, slows down, trembles and waits begins where the view brings the slit.
void TestHastyStroke::aPatientHandLosesNothing()
{
    for (int direction = 0; direction < 12; ++direction) {
        Desk desk;
        addSectionIn(desk, kViews[0]);
        const Vec2 way = directionOf(direction), side(-way.y(), way.x());
        drawSlit(desk, way);
        // 90 px of overshoot, half of it taken back, then it trembles.
        const Vec2 start = desk.cursor;
        for (const double x : {10.0, 30.0, 50.0, 65.0, 78.0, 86.0, 90.0, 88.0, 80.0, 65.0, 52.0})
            desk.send(Type::Move, start + x * way + 0.1 * x * side);
        while (desk.hint() == hints::kTurning) {
            desk.wait(12.0);
            desk.send(Type::Move,
                      desk.cursor + Vec2(static_cast<int>(desk.time) % 8 < 4 ? 1 : -1, 0));
        }
        QCOMPARE(desk.hint(), hints::kLeaveDeadZone);
        const auto *zone = desk.interaction.overlay().find<sign::Capsule>();
        QVERIFY(zone);
        // The slit's end is under the cursor, but for a tremble.
        const Vec3 end = zone->canvas.toWorld({zone->length, 0.0});
        QVERIFY((desk.screen(end) - desk.cursor).norm() < 3.0);
    }
}

/// A rest in the turn: what comes after it counts from there, where the slit's end is seen.
void TestHastyStroke::afterARestTheHandMayGoOn()
{
    Desk desk;
    addSectionIn(desk, kViews[0]);
    const Vec2 way = directionOf(0);
    drawSlit(desk, way);
    desk.moveTo(desk.cursor + 40.0 * way);
    desk.wait(300.0);
    const Vec2 rest = desk.cursor;
    draw(desk, ellipseRound(way, 130, 90, 70));
    const auto *slit = desk.interaction.overlay().find<sign::Slit>();
    QVERIFY(slit);
    QVERIFY((desk.screen(slit->to) - rest).norm() < 1e-6);
    desk.release(desk.cursor);
    QCOMPARE(desk.sections().size(), std::size_t(2));
}

/// Neither hasty nor patient: a stroke of more than two seconds that never stops.
void TestHastyStroke::aSteadyHandLosesNothingEither()
{
    for (int direction = 0; direction < 12; ++direction) {
        Desk steady, patient;
        for (Desk *desk : {&steady, &patient}) {
            addSectionIn(*desk, kViews[0]);
            const Vec2 way = directionOf(direction);
            drawSlit(*desk, way);
            if (desk == &patient)
                desk->wait(kTurnTime);
            draw(*desk, ellipseRound(way, 80, 65, 260));
            desk->release(desk->cursor);
            QCOMPARE(desk->sections().size(), std::size_t(2));
        }
        QVERIFY(farthest(*steady.sections()[1], *patient.sections()[1]) < 1e-6);
    }
}

/// A section that is seen on its narrow side: what stands across it is faced already.
void TestHastyStroke::facedCanvasesAreNotTurnedTo()
{
    for (const double turn : {62.0, 75.0, 85.0}) {
        Desk desk;
        addSectionIn(desk, {"", "front", turn, 0});
        const Camera before = desk.interaction.camera();
        drawSlit(desk, Vec2(0, -1));
        QCOMPARE(desk.hint(), hints::kLeaveDeadZone);
        QVERIFY(desk.interaction.camera().orientation.angularDistance(before.orientation) < 1e-12);
        draw(desk, ellipseRound(Vec2(0, -1), 130, 90, 60));
        desk.release(desk.cursor);
        QCOMPARE(desk.sections().size(), std::size_t(2));
        desk.wait(1000.0);
        QVERIFY(desk.interaction.camera().orientation.angularDistance(before.orientation) < 1e-12);
    }
    Desk desk;
    addSectionIn(desk, {"", "front", 55.0, 0});
    drawSlit(desk, Vec2(0, -1));
    QCOMPARE(desk.hint(), hints::kTurning);
}

void TestHastyStroke::theCueSaysWaitAndGoOn()
{
    Desk desk;
    addSectionIn(desk, kViews[0]);
    const auto cue = [&]() -> std::optional<Text> {
        const auto *label = desk.interaction.overlay().find<sign::Label>();
        if (!label || label->role != SignRole::Cue)
            return {};
        if ((desk.screen(label->places.front()) - desk.cursor).norm() > 1.0)
            return {};
        return std::get<Message>(label->words).text;
    };
    drawSlit(desk, Vec2(1, 0));
    QVERIFY(cue() == hints::kTurningNow);
    desk.moveTo(desk.cursor + Vec2(20, 3));
    QVERIFY(cue() == hints::kTurningNow);
    desk.wait(kTurnTime);
    QVERIFY(cue() == hints::kDrawOutline);
    desk.moveTo(desk.cursor + Vec2(10, 3));
    QVERIFY(cue() == hints::kDrawOutline);
    desk.moveTo(desk.cursor + Vec2(100, 60));
    QVERIFY(!cue());
}

FFF_TEST(TestHastyStroke)
#include "tst_hasty_stroke.moc"
