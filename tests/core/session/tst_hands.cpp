#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/units.h"
#include "core/interaction/offer_words.h"
#include "core/interaction/stroke_words.h"
#include "core/session/session_commands.h"
#include "tests/core/session/hand_measures.h"
#include "tests/core/session/script_run.h"
#include "tests/test_program.h"
#include "tests/told.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>

using namespace fff;
using namespace fff::test;

// Fifty strokes as people draw them (tests/tools/make_hands.py), each with the outline that was
// meant. What would be wrong: a barb, a notch or a corner that nobody meant, a corner that was
// meant and is gone, an outline that is off by more than the hand was, a slit beside its guide,
// something made of a slip, or another shape offered than was meant.

namespace {

/// Turns and ways by which a corner is one to the eye.
const double kCorner = radians(35.0);
constexpr double kCornerWay = 0.6; // mm

enum class Guide { None, Free, Level, Upright, ToEdge, AlongLast };

struct Meant
{
    double most = 0.0, mean = 0.0; // mm that the outline may be off, which is what the hand is
    int corners = 0;
    Text offer = {};        // none: nothing is offered
    double mostTaken = 0.0; // mm that what is offered may be off
    Guide slit = Guide::None;
    double direction = 0.0;  // of a free slit, degrees
    bool isMirrored = false; // the hand draws one half
};

class HandRun : public ScriptRun
{
public:
    HandRun()
    {
        host.attach(interaction);
        registerSessionCommands(commands, session, interaction);
    }

    void play(const QString &name)
    {
        QFile file(QStringLiteral(FFF_TEST_DATA "/hands/") + name + QStringLiteral(".json"));
        QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(name));
        const QByteArray text = file.readAll();
        const Result<void> played =
            replay(text, session, interaction, commands, [this](const ReplayEvent &event) {
                if (event.type == ReplayEvent::Type::Press)
                    before = interaction.camera();
                if (event.type == ReplayEvent::Type::Move) {
                    const sign::Stroke *stroke = interaction.overlay().find<sign::Stroke>();
                    isMirrored = stroke && stroke->isMirrored;
                }
            });
        QVERIFY2(played, played ? "" : played.error().args.front().c_str());
        for (const QJsonValue place :
             QJsonDocument::fromJson(text).object()[QStringLiteral("meant")].toArray())
            meant.emplace_back(place[0].toDouble(), place[1].toDouble());
    }

    /// The places on the screen, where they are on the section.
    Ring meantOn(const Frame &frame) const
    {
        Ring ring;
        for (const Vec2 &place : meant) {
            const Ray ray = interaction.camera().rayThrough(place, interaction.viewport());
            const double far = -frame.height(ray.origin) / frame.normal().dot(ray.direction);
            ring.push_back(frame.toLocal(ray.origin + far * ray.direction));
        }
        return ring;
    }

    Text offer() const
    {
        const auto *label = interaction.overlay().offered.find<sign::Label>();
        const auto *words = label ? std::get_if<Message>(&label->words) : nullptr;
        return words ? words->text : Text();
    }

    CommandRegistry commands;
    Camera before; // the last press
    bool isMirrored = false;
    std::vector<Vec2> meant; // px
};

bool isHole(const QString &name)
{
    return name.contains(QLatin1String("hole")) || name.contains(QLatin1String("eye"));
}

/// Of what was drawn last.
const Contour &drawnOf(const HandRun &player, const QString &name)
{
    const Shape &shape = *player.sections().back()->shape;
    return isHole(name) ? shape.holes().back() : shape.contour();
}

double directionOf(const Section &section)
{
    const Vec2 way = section.parent->slitTo - section.parent->slitFrom;
    return degrees(std::atan2(way.y(), way.x()));
}

/// Of two directions on a line, degrees.
double angleBetween(double a, double b)
{
    return std::abs(std::remainder(a - b, 180.0));
}

} // namespace

class TestHands : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hands_data();
    void hands();
    void slips_data();
    void slips();
    void everyHandIsPlayed();
};

void TestHands::hands_data()
{
    QTest::addColumn<Meant>("meant");
    QTest::addColumn<QByteArray>("notYet"); // what is known to be otherwise
    const auto row = [](const char *name, const Meant &meant, const char *notYet = "") {
        QTest::newRow(name) << meant << QByteArray(notYet);
    };
    const Text circle = hints::kOfferCircle, ellipse = hints::kOfferEllipse,
               straight = hints::kOfferStraight, right = hints::kOfferRightAngles, none = {};
    // First sections.
    row("01_circle_patient", {0.5, 0.2, 0, circle, 0.5});
    row("02_circle_hasty", {0.75, 0.4, 0, circle, 0.75});
    row("03_circle_trembling", {2, 0.5, 0, circle, 0.5}, "a slow tremor has corners");
    row("04_circle_overshot", {0.5, 0.2, 0, circle, 0.5});
    row("05_circle_short", {0.5, 0.2, 0, circle, 0.5});
    row("06_circle_hooked", {0.5, 0.2, 0, circle, 0.5});
    row("07_circle_ten_places", {0.75, 0.3, 0, circle, 0.5});
    row("08_circle_past_its_start", {1, 0.4, 0, circle, 0.75});
    row("09_circle_crossed_at_its_start", {2.5, 0.5, 0, circle, 1});
    row("10_ellipse_nine_places", {1.25, 0.6, 0, ellipse, 1.5});
    row("11_ellipse_leaning", {1.25, 0.5, 0, ellipse, 1.25});
    row("12_box_patient", {0.75, 0.2, 4, right, 0.5});
    row("13_box_noisy", {0.5, 0.3, 4, right, 0.5});
    row("14_box_hasty", {2, 0.3, 4, right, 1.25});
    row("15_box_overshot", {1, 0.2, 4, right, 0.5});
    row("16_box_from_a_side", {1.25, 0.4, 4, right, 0.5});
    row("17_box_rounded", {0.5, 0.2, 0, none});
    row("18_star_patient", {0.75, 0.2, 10, straight, 0.75});
    row("19_star_noisy", {1, 0.2, 10, straight, 0.5},
        "between a mean and its samples the line goes back");
    row("20_star_hasty", {1, 0.3, 10, straight, 1}, "a blunt start is a corner beside the end");
    row("21_triangle_sloppy", {2, 0.5, 3, straight, 2});
    row("22_triangle_short", {1, 0.4, 3, straight, 1});
    row("23_heart", {1.5, 0.4, 2, none});
    row("24_leaf_beside_its_tip", {2, 0.4, 2, none});
    row("25_crescent", {0.75, 0.2, 2, none});
    row("26_cat", {0.75, 0.3, 6, none});
    row("27_trefoil", {1.5, 0.4, 0, none});
    row("28_angle_piece", {0.5, 0.2, 6, right, 0.5});
    row("29_spine_beyond_the_window", {0.75, 0.3, 0, none});
    // Holes: the view stays as it is.
    row("32_eye", {0.5, 0.2, 0, circle, 0.5});
    row("33_eye_hasty", {0.75, 0.4, 0, circle, 0.75});
    row("34_hole_box_from_behind", {0.5, 0.2, 4, right, 0.5});
    row("35_hole_near_the_edge", {0.75, 0.3, 0, ellipse, 0.5});
    // Across a body.
    row("36_slit_nearly_upright", {0.5, 0.2, 0, circle, 0.5, Guide::Upright});
    row("37_slit_left_free", {0.5, 0.2, 0, circle, 0.5, Guide::Free, 88.0});
    row("38_slit_along_the_last", {0.5, 0.2, 0, circle, 0.5, Guide::AlongLast});
    row("39_slit_square_to_the_edge",
        {0.5, 0.2, 0, circle, 0.5, Guide::ToEdge, 90.0 + degrees(std::atan(0.25))});
    row("40_slit_nearly_level", {0.5, 0.2, 0, ellipse, 0.5, Guide::Level});
    row("41_fin", {0.5, 0.2, 0, none, 0.0, Guide::Upright});
    row("42_leaf_by_half", {0.5, 0.2, 2, none, 0.0, Guide::Upright, 0.0, true});
    row("43_leg_downwards", {0.75, 0.2, 4, none, 0.0, Guide::Upright});
    row("44_box_on_a_slit", {1.5, 0.5, 4, right, 1.25, Guide::Upright});
    row("45_from_a_corner", {0.5, 0.2, 0, circle, 0.5, Guide::Upright});
    row("46_from_behind", {1, 0.4, 0, circle, 0.5, Guide::Upright});
    row("48_ring_at_once", {1, 0.4, 0, circle, 0.75, Guide::Upright});
    row("49_drop_at_once", {0.75, 0.3, 2, none, 0.0, Guide::Upright, 0.0, true});
    row("50_drop_at_once_sloppy", {1.25, 0.6, 2, none, 0.0, Guide::Upright, 0.0, true});
}

void TestHands::hands()
{
    QFETCH(Meant, meant);
    QFETCH(QByteArray, notYet);
    const QString name = QString::fromUtf8(QTest::currentDataTag());
    HandRun player;
    player.play(name);
    const bool hasSlit = meant.slit != Guide::None;
    const std::size_t others = meant.slit == Guide::AlongLast ? 2 : hasSlit ? 1 : 0;
    QCOMPARE(player.sections().size(), others + 1);
    QCOMPARE(player.isMirrored, meant.isMirrored);
    const Section &section = *player.sections().back();
    QCOMPARE(section.shape->holes().size(), std::size_t(isHole(name) ? 1 : 0));

    // The view.
    const Camera &now = player.interaction.camera();
    if (hasSlit) {
        QVERIFY(std::abs(now.backward().dot(section.frame.normal())) > 1.0 - 1e-9);
        QVERIFY(now.backward().dot(player.before.backward()) > -1e-9); // from the nearer side
    } else {
        QVERIFY(now.orientation.angularDistance(player.before.orientation) < 1e-9);
    }

    // The slit.
    if (hasSlit) {
        const double direction = directionOf(section);
        const double wanted = meant.slit == Guide::Level     ? 0.0
                              : meant.slit == Guide::Upright ? 90.0
                              : meant.slit == Guide::AlongLast
                                  ? directionOf(*player.sections()[others - 1])
                                  : meant.direction;
        const double bound = meant.slit == Guide::Free ? 0.5 : 1e-6;
        QVERIFY2(angleBetween(direction, wanted) < bound,
                 qPrintable(QString::number(direction, 'f', 9)));
        QVERIFY(!player.session.currentAnalysis().assembly.slits[others].empty());
        const Document &document = player.session.committed().document;
        QVERIFY(standsOnItsSlit(*document.find(section.parent->section.drawn), section));
    }

    // The outline, and what is offered in its place.
    const auto compare = [&](double most, double mean) {
        const Ring made = drawnOf(player, name).polygon(0.005);
        const Deviation off = deviation(made, player.meantOn(player.sections().back()->frame));
        QVERIFY2(off.most <= most, qPrintable(QString::number(off.most)));
        QVERIFY2(off.mean <= mean, qPrintable(QString::number(off.mean)));
        const int corners = sharpCorners(made, kCorner, kCornerWay);
        if (!notYet.isEmpty())
            QEXPECT_FAIL("", notYet.constData(), Abort);
        QCOMPARE(corners, meant.corners);
    };
    compare(meant.most, meant.mean);
    if (QTest::currentTestFailed() || !notYet.isEmpty())
        return;
    QCOMPARE(player.offer(), meant.offer);
    if (!meant.offer.source)
        return;
    player.interaction.takeOffer(1e6);
    compare(meant.mostTaken, meant.mean);
    const bool isFigure = meant.offer == hints::kOfferCircle || meant.offer == hints::kOfferEllipse;
    QCOMPARE(player.sections().back()->figures.size(), std::size_t(isFigure ? 1 : 0));
    QVERIFY(!player.interaction.hasOffer());
}

void TestHands::slips_data()
{
    QTest::addColumn<int>("sections");
    QTest::addColumn<Text>("why");
    QTest::newRow("30_twitch") << 0 << hints::kTwitch;
    QTest::newRow("31_there_and_back") << 0 << hints::kNoArea;
    QTest::newRow("47_twitch_on_a_slit") << 1 << hints::kTwitch;
}

/// Nothing is made, it is said why, and the view is where it was.
void TestHands::slips()
{
    QFETCH(int, sections);
    QFETCH(Text, why);
    HandRun player;
    player.play(QString::fromUtf8(QTest::currentDataTag()));
    QCOMPARE(int(player.sections().size()), sections);
    QCOMPARE(player.interaction.hint().words.text, why);
    QVERIFY(!player.interaction.hasOffer());
    const Camera &now = player.interaction.camera();
    QVERIFY(now.orientation.angularDistance(player.before.orientation) < 1e-9);
    QVERIFY((now.target - player.before.target).norm() < 1e-9);
}

/// A script that nobody plays would say nothing.
void TestHands::everyHandIsPlayed()
{
    const QDir folder(QStringLiteral(FFF_TEST_DATA "/hands"));
    QCOMPARE(folder.entryList({QStringLiteral("*.json")}).size(), 50);
}

FFF_TEST(TestHands)
#include "tst_hands.moc"
