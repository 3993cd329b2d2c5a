#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/units.h"
#include "core/interaction/contour_words.h"
#include "core/interaction/hover_words.h"
#include "core/interaction/stroke_words.h"
#include "core/interaction/view_fit.h"
#include "core/io/document_file.h"
#include "core/model/edit_words.h"
#include "core/session/session_commands.h"
#include "tests/core/geometry/polyline_distance.h"
#include "tests/core/geometry/turns.h"
#include "tests/core/interaction/desk.h"
#include "tests/core/session/script_run.h"
#include "tests/test_program.h"

#include <QDir>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace fff;
using namespace fff::test;

// Every script of tests/data/strokes/stroke_*.json is a person's hand (tests/tools/make_strokes.py
// writes them). What would be wrong: a section that does not stand on its slit, a view that is not
// straight or loses the slit, a contour that is not what was drawn, or a stroke that ends in
// something else than it says.

namespace {

/// All that is looked at while a script is played.
struct Watched
{
    int turns = 0;                      // that came to their end
    double worstTilt = 0.0;             // radians from frontoparallel, at the ends of turns
    double worstPin = 0.0;              // px from the slit's end to the cursor, then and before
    double scale = 0.0;                 // mm a px, while the last contour was drawn
    std::optional<sign::Stroke> stroke; // the last one, as it was before its release
    bool wasEverMirrored = false;
    Camera cameraBefore; // the last press
};

class Player : public ScriptRun
{
public:
    Player()
    {
        host.attach(interaction);
        registerSessionCommands(commands, session, interaction);
    }

    Result<void> play(const QString &name)
    {
        const Result<QByteArray> script = scriptNamed(QStringLiteral("stroke_") + name);
        if (!script)
            return tl::unexpected(script.error());
        return replay(*script, session, interaction, commands,
                      [this](const ReplayEvent &event) { watch(event); });
    }

    Vec2 screen(const Vec3 &p) const
    {
        return interaction.camera().toScreen(p, interaction.viewport());
    }

    void watch(const ReplayEvent &event)
    {
        const bool isPointer = event.type == ReplayEvent::Type::Press ||
                               event.type == ReplayEvent::Type::Move ||
                               event.type == ReplayEvent::Type::Release;
        if (isPointer)
            cursor = event.position;
        if (event.type == ReplayEvent::Type::Press)
            watched.cameraBefore = interaction.camera();
        const Overlay &overlay = interaction.overlay();
        const bool isTurning = interaction.hint().words.text == hints::kTurning;
        const bool hasTurned = overlay.find<sign::Capsule>() && wasTurning;
        if (overlay.find<sign::Slit>() && (isTurning || hasTurned))
            watched.worstPin = std::max(watched.worstPin,
                                        (screen(overlay.find<sign::Slit>()->to) - cursor).norm());
        if (hasTurned) {
            ++watched.turns;
            const Camera &camera = interaction.camera();
            // The slit lies in the canvas and the parent's normal does.
            const Vec3 slit =
                (overlay.find<sign::Slit>()->to - overlay.find<sign::Slit>()->from).normalized();
            const Vec3 normal = parentOf(overlay.find<sign::Slit>()->section).normal();
            const double tilt = std::asin(
                std::clamp(camera.backward().cross(slit.cross(normal)).norm(), -1.0, 1.0));
            watched.worstTilt = std::max(watched.worstTilt, tilt);
        }
        wasTurning = isTurning;
        if (overlay.find<sign::Stroke>()) {
            watched.stroke = *overlay.find<sign::Stroke>();
            watched.scale = interaction.camera().millimetresPerPixel;
            watched.wasEverMirrored =
                watched.wasEverMirrored || overlay.find<sign::Stroke>()->isMirrored;
        }
    }

    const Frame &parentOf(const std::string &name) const
    {
        for (const SectionPointer &section : sections()) {
            if (section->name == name)
                return section->frame;
        }
        qFatal("no section of the name that the slit speaks of");
    }

    CommandRegistry commands;
    Watched watched;
    Vec2 cursor = Vec2::Zero();
    bool wasTurning = false;
};

/// From its last corner back to the first one, too.
PolylineDistance toRing(std::vector<Vec2> corners)
{
    corners.push_back(corners.front());
    return PolylineDistance(corners);
}

/// Height above the ground, mm.
double lowestOf(const Section &section)
{
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec2 &p : section.shape->region().outer)
        lowest = std::min(lowest, section.frame.toWorld(p).y());
    return lowest;
}

bool standsOnItsSlit(const Document &document, const Section &section)
{
    const Section *parent = document.find(section.parent->section.drawn);
    return parent && test::standsOnItsSlit(*parent, section);
}

/// Each control point has its mirror image among the others, across the canvas' x axis.
bool isMirrorImageOfItself(const Contour &contour, const MirrorAxis &axis)
{
    for (const Vec2 &p : contour.points()) {
        const Vec2 image = axis.mirrored(p);
        const bool isThere = std::any_of(contour.points().begin(), contour.points().end(),
                                         [&](const Vec2 &q) { return (q - image).norm() < 1e-9; });
        if (!isThere)
            return false;
    }
    return true;
}

enum Outcome { Drawn, Mirrored, Nothing };

struct Wanted
{
    int sections = 2;
    int steps = 2;             // of the history
    Outcome outcome = Drawn;   // of the last stroke
    Text hint = {};            // at the end; none: not looked at
    bool isWholeStroke = true; // the contour is all that was drawn: not cut, no loop left out
    int turns = 1;
};

} // namespace

class TestStrokes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void strokes_data();
    void strokes();
    void everyScriptIsPlayed();
    void theSlitIsWhereItWasDrawn();
    void holesAreOutside();
    void theTurnMayStopShort();
    void groundCutsFlat();
    void planesAreWhereTheyAreCalled();
    void shapesWithAKnownAnswer();
    void endsAndSmallOnes();
    void roomIsMade();
    void selectionByRubberBand();
    void droppedToTheGround();
    void onTheBridge();
};

void TestStrokes::strokes_data()
{
    QTest::addColumn<Wanted>("wanted");
    const auto row = [](const char *name, const Wanted &wanted = {}) {
        QTest::newRow(name) << wanted;
    };
    const auto nothing = [](Text why, int turns = 1) {
        return Wanted{1, 1, Nothing, why, true, turns};
    };
    for (const char *name : {"slit_right",
                             "slit_left",
                             "slit_up",
                             "slit_down",
                             "slit_slanted",
                             "slit_from_behind",
                             "slit_from_a_corner",
                             "slit_in_one_jump",
                             "moves_in_the_turn",
                             "zoomed_in",
                             "zoomed_out",
                             "zoomed_close",
                             "perspective",
                             "perspective_from_a_corner",
                             "room_is_made",
                             "rectangle",
                             "circle",
                             "leaves_the_window",
                             "slit_leaves_the_window",
                             "shift_keeps_one_side",
                             "symmetry_is_off"})
        row(name);
    row("in_haste", {2, 2, Drawn, {}, true, 0}); // it does not wait for the turn's end
    row("in_haste_mirrored", {2, 2, Mirrored, {}, true, 0});
    row("hole_is_left_into", {2, 3});
    row("hole_is_jumped_over", {2, 3});
    row("press_without_drag", {1, 1, Nothing, {}, true, 0});
    row("drag_below_the_threshold", {1, 1, Nothing, {}, true, 0});
    row("tiny_contour", nothing(hints::kTooShort));
    row("there_and_back", nothing(hints::kNoArea));
    row("self_crossing", {2, 2, Drawn, hints::kCrossesItself, false});
    for (const char *name :
         {"spiky_overshot", "spiky_short", "spiky_hooked", "circle_overshot", "circle_in_a_moment"})
        row(name, {2, 2, Drawn, {}, false});
    row("circle_taken", {2, 3, Drawn, {}, false});
    row("circle_taken_back", {2, 3, Drawn, {}, false});
    row("eye", {1, 2, Drawn, {}, false, 0});
    row("twitch", nothing(hints::kTwitch));
    row("mirrored_at_6_1", {2, 2, Mirrored});
    row("starts_past_the_axis", {2, 2, Mirrored});
    row("first_mirrored_by_shift", {1, 1, Mirrored, {}, true, 0});
    row("mirrored_downwards", {2, 2, Mirrored});
    for (const char *phase : {"slit", "turn", "dead_zone", "contour"}) {
        const int turns = QByteArray(phase) == "slit" || QByteArray(phase) == "turn" ? 0 : 1;
        row(qPrintable(QStringLiteral("escape_in_%1").arg(QLatin1String(phase))),
            {1, 1, Nothing, {}, true, turns});
        row(qPrintable(QStringLiteral("undo_in_%1").arg(QLatin1String(phase))),
            {0, 1, Nothing, {}, true, turns});
    }
    row("cut_at_the_ground", {2, 2, Drawn, hints::kCutAtGround, false});
    row("below_the_ground_on_purpose", {2, 2, Drawn, {}, false}); // its ends are led to a corner
    row("all_below_the_ground", {1, 1, Nothing, hints::kBelowGround, true, 0});
    for (const char *plane : {"plane_ground", "plane_front", "plane_side", "plane_parallel"})
        row(plane, {2, 2, Drawn, {}, true, 0});
    row("redrawn", {1, 2, Drawn, {}, true, 0});
    row("hole", {1, 2, Drawn, {}, true, 0});
    row("hole_outside", {1, 1, Nothing, hints::kHoleOutside, true, 0});
    row("hole_over_the_edge", {1, 2, Drawn, hints::kHoleIsNotch, false, 0});
    row("previous_view", {1, 1, Nothing, {}, true, 0});
    row("rubber_band", {1, 1, Nothing, {}, true, 0});
    row("dropped_to_the_ground", {1, 2, Nothing, {}, true, 0});
}

void TestStrokes::strokes()
{
    QFETCH(Wanted, wanted);
    Player player;
    const QString name = QString::fromUtf8(QTest::currentDataTag());
    const Result<void> played = player.play(name);
    QVERIFY2(played, played ? "" : played.error().args.front().c_str());
    const Document &document = player.session.committed().document;
    const Watched &watched = player.watched;

    QCOMPARE(int(document.sections.size()), wanted.sections);
    QCOMPARE(player.session.history()->count(), wanted.steps);
    QVERIFY(!player.session.hasPreview());
    QVERIFY(!player.interaction.hasGesture());
    if (wanted.hint.source)
        QCOMPARE(player.interaction.hint().words.text, wanted.hint);
    QCOMPARE(watched.turns, wanted.turns);
    QVERIFY2(watched.worstTilt < 1e-6, qPrintable(QString::number(watched.worstTilt)));
    QVERIFY2(watched.worstPin < 1.0, qPrintable(QString::number(watched.worstPin)));
    for (const SectionPointer &section : document.sections) {
        if (section->parent)
            QVERIFY(standsOnItsSlit(document, *section));
        // A joint is smooth or a corner: nothing in between that a hand did not draw.
        for (const double turn : turnsOf(section->shape->contour()))
            QVERIFY2(turn < 1e-6 || turn > radians(8.0), qPrintable(QString::number(turn)));
    }
    if (wanted.outcome == Nothing) {
        // The view is where it was before the press, once it has returned.
        player.interaction.advance(1e6);
        const Camera &now = player.interaction.camera(), &before = watched.cameraBefore;
        QVERIFY((now.target - before.target).norm() < 1e-9);
        QVERIFY(now.orientation.angularDistance(before.orientation) < 1e-9);
        QCOMPARE(now.millimetresPerPixel, before.millimetresPerPixel);
        return;
    }

    QVERIFY(watched.stroke);
    const sign::Stroke &stroke = *watched.stroke;
    QCOMPARE(stroke.isMirrored, wanted.outcome == Mirrored);
    const Section &section = *document.sections.back();
    // The section has its x to the right and y up, the canvas its x along the slit.
    const auto onSection = [&](const Vec2 &p) {
        return section.frame.toLocal(stroke.canvas.toWorld(p));
    };
    if (stroke.isMirrored) {
        const Vec2 from = onSection(stroke.axis->point);
        const Vec2 along = onSection(stroke.axis->point + stroke.axis->direction) - from;
        QVERIFY(isMirrorImageOfItself(section.shape->contour(), {from, along.normalized()}));
        return;
    }
    if (!wanted.isWholeStroke)
        return;
    // What was drawn is what is there, within the fit's bound of 2 px.
    const double bound = 2.0 * watched.scale + 0.02;
    const Contour &contour = stroke.purpose == ContourTarget::Purpose::Hole
                                 ? section.shape->holes().back()
                                 : section.shape->contour();
    const PolylineDistance toOutline = toRing(contour.polygon(0.01));
    for (const Vec2 &sample : stroke.samples)
        QVERIFY2(toOutline(onSection(sample)) < bound,
                 qPrintable(QStringLiteral("a sample is %1 px away")
                                .arg(toOutline(onSection(sample)) / watched.scale)));
    std::vector<Vec2> fitted;
    for (const CubicBezier &piece : stroke.fitted) {
        for (int i = 0; i <= 32; ++i)
            fitted.push_back(piece.at(i / 32.0));
    }
    const PolylineDistance toSamples = toRing(stroke.samples);
    for (const Vec2 &p : fitted)
        QVERIFY2(toSamples(p) < bound, "the curve swings out");
}

/// A script that nobody plays would say nothing.
void TestStrokes::everyScriptIsPlayed()
{
    const QStringList files =
        QDir(QStringLiteral(FFF_TEST_DATA "/strokes")).entryList({QStringLiteral("stroke_*.json")});
    QVERIFY(files.size() >= 30);
    for (const QString &file : files) {
        Player player;
        const Result<void> played = player.play(file.mid(7).chopped(5));
        QVERIFY2(played, qPrintable(file));
    }
}

void TestStrokes::theSlitIsWhereItWasDrawn()
{
    Player player;
    QVERIFY(player.play(QStringLiteral("slit_up")));
    const Section &bodySection = *player.sections()[0], &section = *player.sections()[1];
    const double scale = player.watched.scale;
    const Box2 box = bodySection.shape->bounds();
    // 140 px up from where it was pressed to the upper edge, on the vertical through that place.
    const Parent &slit = *section.parent;
    QVERIFY(std::abs(slit.slitTo.x() - slit.slitFrom.x()) < 1e-9);
    QVERIFY(std::abs(slit.slitTo.y() - box.max.y()) < 2.0 * scale);
    QVERIFY(std::abs((slit.slitTo - slit.slitFrom).norm() - 140.0 * scale) < 2.0 * scale);
}

/// The slit ends at the hole's edge, also where the cursor jumped over the whole hole.
void TestStrokes::holesAreOutside()
{
    for (const char *name : {"hole_is_left_into", "hole_is_jumped_over"}) {
        Player player;
        QVERIFY(player.play(QLatin1String(name)));
        QCOMPARE(player.sections()[0]->shape->holes().size(), std::size_t(1));
        const std::vector<Vec2> hole = player.sections()[0]->shape->holes()[0].polygon(0.001);
        const Vec2 end = player.sections()[1]->parent->slitTo;
        QVERIFY2(toRing(hole)(end) < 0.01, name);
        QVERIFY(end.x() < bounds(hole).center().x()); // on the near side
    }
}

/// With 80° the slit's section stays to be seen, by the sine of 10°; the plane is the same.
void TestStrokes::theTurnMayStopShort()
{
    Player straight, tilted;
    tilted.interaction.settings().turnAngle = radians(80.0);
    QVERIFY(straight.play(QStringLiteral("slit_up")));
    QVERIFY(tilted.play(QStringLiteral("slit_up")));
    QVERIFY(std::abs(tilted.watched.worstTilt - radians(10.0)) < 1e-6);
    QVERIFY(tilted.watched.worstPin < 1.0);
    QCOMPARE(tilted.sections().size(), std::size_t(2));
    const Frame &a = straight.sections()[1]->frame, &b = tilted.sections()[1]->frame;
    QVERIFY((a.normal() - b.normal()).norm() < 1e-9);
    QVERIFY(std::abs(tilted.interaction.camera().backward().dot(
                tilted.sections()[0]->frame.normal())) > std::sin(radians(9.99)));
    QVERIFY(standsOnItsSlit(tilted.session.committed().document, *tilted.sections()[1]));
}

void TestStrokes::groundCutsFlat()
{
    Player player;
    QVERIFY(player.play(QStringLiteral("cut_at_the_ground")));
    QVERIFY(player.watched.stroke->cut);
    const Section &section = *player.sections()[1];
    double lowest = 1e9;
    int onGround = 0;
    for (const Vec2 &p : section.shape->contour().points())
        lowest = std::min(lowest, section.frame.toWorld(p).y());
    for (int i = 0; i < section.shape->contour().segmentCount(); ++i)
        onGround +=
            std::abs(section.frame.toWorld(section.shape->contour().segment(i).p0).y()) < 1e-9 ? 1
                                                                                               : 0;
    QVERIFY2(std::abs(lowest) < 1e-9, qPrintable(QString::number(lowest)));
    QVERIFY(onGround >= 2);

    Player free;
    QVERIFY(free.play(QStringLiteral("below_the_ground_on_purpose")));
    QVERIFY(lowestOf(*free.sections()[1]) < -10.0);
}

void TestStrokes::planesAreWhereTheyAreCalled()
{
    const auto drawn = [](Player &player, const char *name) {
        return player.play(QLatin1String(name)) && player.sections().size() == 2;
    };
    Player ground, front, side, parallel;
    QVERIFY(drawn(ground, "plane_ground"));
    const Section &lying = *ground.sections()[1];
    QVERIFY(std::abs(std::abs(lying.frame.normal().y()) - 1.0) < 1e-12);
    // On the ground with its lower face.
    QVERIFY(std::abs(lying.frame.origin.y() - 0.5 * 3.0) < 1e-12);
    QVERIFY(drawn(front, "plane_front"));
    QVERIFY(std::abs(front.sections()[1]->frame.height(Vec3::Zero())) < 1e-12);
    QVERIFY(std::abs(std::abs(front.sections()[1]->frame.normal().z()) - 1.0) < 1e-12);
    QVERIFY(drawn(side, "plane_side"));
    QVERIFY(std::abs(std::abs(side.sections()[1]->frame.normal().x()) - 1.0) < 1e-12);
    QVERIFY(drawn(parallel, "plane_parallel"));
    const Frame &first = parallel.sections()[0]->frame, &second = parallel.sections()[1]->frame;
    QVERIFY((first.normal() - second.normal()).norm() < 1e-12);
    QVERIFY(std::abs(first.height(second.origin) - 25.4) < 1e-9);
    QVERIFY(!parallel.sections()[1]->parent);
}

void TestStrokes::shapesWithAKnownAnswer()
{
    Player rectangle, circle;
    QVERIFY(rectangle.play(QStringLiteral("rectangle")));
    const Contour &sides = rectangle.sections()[1]->shape->contour();
    QVERIFY2(sides.segmentCount() <= 5, qPrintable(QString::number(sides.segmentCount())));
    QVERIFY(circle.play(QStringLiteral("circle")));
    const Contour &round = circle.sections()[1]->shape->contour();
    QVERIFY2(round.segmentCount() <= 5, qPrintable(QString::number(round.segmentCount())));
    // And the body itself: a rectangle of four lines.
    QVERIFY(circle.sections()[0]->shape->contour().segmentCount() <= 5);
}

/// A slit near the view's edge comes towards its middle while the cursor rests in the dead zone,
/// and the cursor does not get out of it by that.
/// No barb, no notch, and no corner that nobody drew; what was offered is a figure by numbers.
void TestStrokes::endsAndSmallOnes()
{
    const auto corners = [](const Contour &contour) {
        const std::vector<double> turns = turnsOf(contour);
        return std::count_if(turns.begin(), turns.end(),
                             [](double turn) { return turn > radians(20.0); });
    };
    for (const char *name : {"spiky_overshot", "spiky_short", "spiky_hooked"}) {
        Player player;
        QVERIFY(player.play(QLatin1String(name)));
        QVERIFY2(corners(player.sections()[1]->shape->contour()) == 10, name);
    }
    for (const char *name : {"circle_overshot", "circle_in_a_moment", "circle_taken"}) {
        Player player;
        QVERIFY(player.play(QLatin1String(name)));
        const Section &section = *player.sections()[1];
        QVERIFY2(corners(section.shape->contour()) == 0, name);
        const double radius = 110.0 * player.watched.scale;
        const double area = std::abs(section.shape->contour().signedArea());
        QVERIFY2(std::abs(area / (std::numbers::pi * radius * radius) - 1.0) < 0.05, name);
        const bool isTaken = QByteArray(name) == "circle_taken";
        QCOMPARE(section.figures.size(), std::size_t(isTaken ? 1 : 0));
        QCOMPARE(player.interaction.hasOffer(), !isTaken);
    }
    Player back, drawn, eye;
    QVERIFY(back.play(QStringLiteral("circle_taken_back")));
    QVERIFY(drawn.play(QStringLiteral("circle_overshot")));
    QVERIFY(!back.interaction.hasOffer() && back.sections()[1]->figures.empty());
    QVERIFY(back.sections()[1]->shape->contour() == drawn.sections()[1]->shape->contour());
    QVERIFY(eye.play(QStringLiteral("eye")));
    const std::vector<Contour> &holes = eye.sections()[0]->shape->holes();
    QCOMPARE(holes.size(), std::size_t(1));
    QCOMPARE(corners(holes[0]), 0);
}

void TestStrokes::roomIsMade()
{
    Player player;
    double before = 0.0, after = 0.0;
    const Result<QByteArray> script = scriptNamed(QStringLiteral("stroke_room_is_made"));
    QVERIFY(script);
    int waits = 0;
    QVERIFY(replay(*script, player.session, player.interaction, player.commands,
                   [&](const ReplayEvent &event) {
                       if (event.type != ReplayEvent::Type::Wait)
                           return;
                       const Overlay &overlay = player.interaction.overlay();
                       QVERIFY(overlay.find<sign::Capsule>());
                       const double x = player
                                            .screen(0.5 * (overlay.find<sign::Slit>()->from +
                                                           overlay.find<sign::Slit>()->to))
                                            .x();
                       (waits++ == 0 ? before : after) = x;
                   }));
    QCOMPARE(waits, 2);
    QVERIFY2(before > 0.7 * 1280 + 10.0, qPrintable(QString::number(before)));
    QVERIFY2(after < before - 10.0, qPrintable(QString::number(after)));
    QCOMPARE(player.sections().size(), std::size_t(2));
}

void TestStrokes::selectionByRubberBand()
{
    Player player;
    QVERIFY(player.play(QStringLiteral("rubber_band")));
    QCOMPARE(player.interaction.selection().size(), std::size_t(1));
    QVERIFY(!player.interaction.overlay().find<sign::Band>());
}

void TestStrokes::droppedToTheGround()
{
    Player player;
    QVERIFY(player.play(QStringLiteral("dropped_to_the_ground")));
    const Section &section = *player.sections()[0];
    QVERIFY(std::abs(lowestOf(section)) < 1e-9);
    QVERIFY(!player.commands.isEnabled("section.dropToGround")); // it stands there
    player.session.history()->undo();
    QVERIFY(player.commands.isEnabled("section.dropToGround"));
}

/// A real model: out of one of its sections, and back.
void TestStrokes::onTheBridge()
{
    const QString path = QStringLiteral(FFF_SHARED_MODELS "/bridge.txt");
    if (!QFile::exists(path))
        FFF_WITHOUT_SHARED();
    const Result<io::LoadedDocument> loaded = io::readDocument(path);
    QVERIFY(loaded);
    Desk desk;
    desk.session.reset(loaded->document);
    desk.interaction.setCamera(
        fitted(desk.interaction.camera(), desk.session.committed().bounds(), kViewport));
    const std::size_t count = desk.sections().size();
    // The first place from the middle downwards, 20 px deep, where something can be drawn on.
    Vec2 start(640, 400);
    for (int inside = 0; start.y() < 780 && inside < 5; start.y() += 4) {
        desk.send(PointerEvent::Type::Move, start);
        inside = desk.hint() == hints::kDragOutOfSection ? inside + 1 : 0;
    }
    start.y() -= 4;
    QCOMPARE(desk.hint(), hints::kDragOutOfSection);
    desk.press(start);
    while (desk.hint() != hints::kTurning && desk.cursor.y() > -2000)
        desk.send(PointerEvent::Type::Move, desk.cursor - Vec2(0, 10));
    QCOMPARE(desk.hint(), hints::kTurning);
    desk.wait(kTurnTime);
    const Overlay overlay = desk.interaction.overlay();
    QVERIFY(overlay.find<sign::Capsule>());
    QVERIFY((desk.screen(overlay.find<sign::Slit>()->to) - desk.cursor).norm() < 1.0);
    for (const Vec2 &way : {Vec2(120, 60), Vec2(120, -80), Vec2(-60, -120), Vec2(-140, 20)})
        desk.moveTo(desk.cursor + way);
    desk.release(desk.cursor);
    QCOMPARE(desk.sections().size(), count + 1);
    QVERIFY(standsOnItsSlit(desk.session.committed().document, *desk.sections().back()));
    // No other section was touched, and undo brings back the very objects.
    for (std::size_t i = 0; i < count; ++i)
        QVERIFY(desk.sections()[i] == loaded->document.sections[i]);
    const Analysis &analysis = desk.session.currentAnalysis();
    QVERIFY(!analysis.assembly.slits[count].empty());
    desk.session.history()->undo();
    QVERIFY(desk.session.committed().document.isSame(loaded->document));
}

FFF_TEST(TestStrokes)
#include "tests/told.h"
#include "tst_strokes.moc"
