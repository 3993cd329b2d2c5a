// The judge itself, on solids whose freedom a hand tells.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "tests/core/session/held_judge.h"
#include "tests/test_program.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kRight = 0.5 * std::numbers::pi;

PlainRing box(double x0, double y0, double x1, double y1)
{
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

/// 60 x 40 with a slit in the middle, down to y = 0.
PlainRing slitFromAbove(double width, double left = -30.0)
{
    const double w = 0.5 * width;
    return {{left, -20}, {30, -20}, {30, 20}, {w, 20}, {w, 0}, {-w, 0}, {-w, 20}, {left, 20}};
}

PlainRing slitFromBelow(double width)
{
    PlainRing ring = slitFromAbove(width);
    for (Vec2 &p : ring)
        p = -p;
    return ring;
}

/// Standing, turned about the vertical: at 0 seen from the front.
Frame standing(double angle, const Vec3 &origin = Vec3::Zero())
{
    return {origin, Vec3(std::cos(angle), 0.0, -std::sin(angle)), Vec3::UnitY()};
}

JudgedPiece piece(PlainRing outer, const Frame &frame, std::vector<PlainRing> holes = {},
                  double thickness = 3.0)
{
    return JudgedPiece({std::move(outer), std::move(holes), frame, thickness});
}

Freedom judgedUp(const JudgedPiece &guest, const JudgedPiece &host, const Slack &slack = {})
{
    const Vec3 up = Vec3::UnitY();
    return judge(guest, host, slack, std::span(&up, 1));
}

/// Of the ways that are free those that are shifts along one of these.
bool canShift(const Freedom &freedom, const Vec3 &way)
{
    return std::any_of(freedom.free.begin(), freedom.free.end(),
                       [&](const SmallMove &move) { return move.isShiftAlong(way); });
}

bool isHeldBut(const Freedom &freedom, const std::vector<Vec3> &ways)
{
    return freedom.isHeldBut(ways) && std::all_of(ways.begin(), ways.end(), [&](const Vec3 &way) {
               return canShift(freedom, way);
           });
}

int turnsOf(const Freedom &freedom)
{
    return static_cast<int>(
        std::count_if(freedom.free.begin(), freedom.free.end(),
                      [](const SmallMove &move) { return move.kind == SmallMove::Kind::Turn; }));
}

/// For a test that fails.
QByteArray toText(const Freedom &freedom)
{
    QByteArray text = "free of " + QByteArray::number(freedom.tried) + ":";
    for (const SmallMove &move : freedom.free)
        text += " [" + QByteArray::fromStdString(move.name) + ']';
    return text;
}

double obliqueWidth(double angle)
{
    return 3.0 * (1.0 + std::cos(angle)) / std::sin(angle);
}

/// Everything turned and shifted as one.
JudgedPiece moved(const JudgedPiece &piece, const Eigen::Quaterniond &turn, const Vec3 &by)
{
    Prism prism = piece.prism();
    prism.frame = {turn * prism.frame.origin + by, turn * prism.frame.x, turn * prism.frame.y};
    return JudgedPiece(std::move(prism));
}

std::set<std::string> namesOf(const Freedom &freedom)
{
    std::set<std::string> names;
    for (const SmallMove &move : freedom.free)
        names.insert(move.name);
    return names;
}

} // namespace

class TestHeldJudge : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void depthsOfPoints();
    void depthsAreThoseOfAllEdges();
    void crossLap();
    void crossLapsOfAllThicknesses_data();
    void crossLapsOfAllThicknesses();
    void slitWithoutOneWall();
    void oneWalledStep();
    void wallOfHalfAMillimetre();
    void shallowSlit();
    void buttContact();
    void equalPlatesOnEachOther();
    void farAway();
    void mortise();
    void tooLongMortise();
    void widerSlit();
    void obliqueLap_data();
    void obliqueLap();
    void stripBetweenTwoGuests();
    void chip();
    void chipThatIsLockedIn();
    void inEachOther();
    void whatBlocksOneBlocksTheOther();
    void turnedAsOne();
};

/// What would be wrong: a depth that is not the way to the nearest face or wall.
void TestHeldJudge::depthsOfPoints()
{
    const JudgedPiece plate =
        piece(box(-20, -10, 20, 10), standing(0.0, {0, 0, 5}), {box(-2, -2, 2, 2)});
    QCOMPARE(plate.depth({10, 0, 5}), 1.5);     // the middle
    QCOMPARE(plate.depth({10, 0, 6}), 0.5);     // towards a face
    QCOMPARE(plate.depth({19.75, 0, 5}), 0.25); // a wall
    QCOMPARE(plate.depth({2.25, 0, 5}), 0.25);  // of the hole
    QCOMPARE(plate.depth({0, 0, 5}), 0.0);      // in the hole
    QCOMPARE(plate.depth({10, 0, 6.75}), 0.0);
    QCOMPARE(plate.depth({21, 0, 5}), 0.0);
    QCOMPARE(plate.distance({10, 0, 7}, 9.0), 0.5);
    QCOMPARE(plate.distance({23, 0, 10.5}, 9.0), 5.0);
    QCOMPARE(plate.distance({0, 0, 5}, 9.0), 2.0);
    QCOMPARE(plate.distance({10, 0, 50}, 9.0), 9.0);
}

/// What would be wrong: an edge that the grid does not find.
void TestHeldJudge::depthsAreThoseOfAllEdges()
{
    std::mt19937 random(7);
    const auto number = [&](double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) / 4294967295.0);
    };
    PlainRing star;
    for (int i = 0; i < 90; ++i)
        star.push_back(number(8.0, 30.0) * Vec2(std::cos(i * std::numbers::pi / 45.0),
                                                std::sin(i * std::numbers::pi / 45.0)));
    const JudgedPiece plate = piece(star, standing(0.0), {}, 4.0);
    int inside = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec3 p(number(-32, 32), number(-32, 32), number(-3, 3));
        double beside = 1e9, turns = 0.0;
        for (std::size_t k = 0; k < star.size(); ++k) {
            const Vec2 a = star[k] - p.head<2>(), b = star[(k + 1) % star.size()] - p.head<2>();
            turns += std::atan2(cross(a, b), a.dot(b));
            const double share = std::clamp(a.dot(a - b) / (b - a).squaredNorm(), 0.0, 1.0);
            beside = std::min(beside, (a + share * (b - a)).norm());
        }
        const bool isIn = std::abs(turns) > std::numbers::pi;
        const double wanted = isIn ? std::max(0.0, std::min(2.0 - std::abs(p.z()), beside)) : 0.0;
        QVERIFY(std::abs(plate.depth(p) - wanted) < 1e-9);
        QCOMPARE(plate.isWithin(p, 0.5), wanted >= 0.5);
        inside += wanted > 0.0;
    }
    QVERIFY(inside > 500);
}

/// What would be wrong: two plates in each other's slits are not held, or do not come apart.
void TestHeldJudge::crossLap()
{
    const JudgedPiece host = piece(slitFromAbove(3.0), standing(0.0)),
                      guest = piece(slitFromBelow(3.0), standing(kRight));
    const Freedom up = judgedUp(guest, host);
    QVERIFY2(isHeldBut(up, {Vec3::UnitY()}), toText(up));
    QCOMPARE(up.inEachOther, 0.0);
    const Freedom down = judge(host, guest);
    QVERIFY2(isHeldBut(down, {-Vec3::UnitY()}), toText(down));
}

void TestHeldJudge::crossLapsOfAllThicknesses_data()
{
    QTest::addColumn<double>("host");
    QTest::addColumn<double>("guest");
    for (const double host : {1.0, 2.0, 6.0})
        for (const double guest : {1.0, 3.0, 6.0})
            QTest::addRow("%g in %g mm", guest, host) << host << guest;
}

/// What would be wrong: thin or thick sheets are judged otherwise.
void TestHeldJudge::crossLapsOfAllThicknesses()
{
    QFETCH(double, host);
    QFETCH(double, guest);
    for (const double clearance : {0.0, 0.1, 0.2}) {
        const Freedom freedom =
            judgedUp(piece(slitFromBelow(host + clearance), standing(kRight), {}, guest),
                     piece(slitFromAbove(guest + clearance), standing(0.0), {}, host),
                     {0.1 + clearance, 0.0});
        QVERIFY2(isHeldBut(freedom, {Vec3::UnitY()}), toText(freedom));
    }
}

/// What would be wrong: a slit with one wall missing is taken to hold.
void TestHeldJudge::slitWithoutOneWall()
{
    // What of the host was left of the slit is gone, down to its bottom; the guest has both walls
    // of its own slit, so that it only leaves to the left.
    const PlainRing step{{-30, -20}, {30, -20}, {30, 20}, {1.5, 20}, {1.5, 0}, {-30, 0}};
    const Freedom freedom =
        judgedUp(piece(slitFromBelow(3.0), standing(kRight)), piece(step, standing(0.0)));
    QVERIFY2(canShift(freedom, -Vec3::UnitX()), toText(freedom));
    QVERIFY2(canShift(freedom, Vec3::UnitY()), toText(freedom));
    QVERIFY2(!canShift(freedom, Vec3::UnitX()), toText(freedom));
    QVERIFY2(!canShift(freedom, Vec3::UnitZ()), toText(freedom));
    QVERIFY2(!canShift(freedom, -Vec3::UnitY()), toText(freedom));
}

/// What would be wrong: what only rests on a step is taken to be held.
void TestHeldJudge::oneWalledStep()
{
    const PlainRing step{{-30, -20}, {30, -20}, {30, 20}, {1.5, 20}, {1.5, 0}, {-30, 0}};
    const Freedom freedom =
        judgedUp(piece(box(-30, 0, 30, 40), standing(kRight)), piece(step, standing(0.0)));
    for (const Vec3 &way :
         {Vec3(-Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ()), Vec3(-Vec3::UnitZ())})
        QVERIFY2(canShift(freedom, way), toText(freedom));
    QVERIFY2(!canShift(freedom, Vec3::UnitX()), toText(freedom));
    QVERIFY2(!canShift(freedom, -Vec3::UnitY()), toText(freedom));
}

/// What would be wrong: a thin wall is not seen, whichever of the two has it.
void TestHeldJudge::wallOfHalfAMillimetre()
{
    const JudgedPiece thin = piece(slitFromAbove(3.0, -2.0), standing(0.0)),
                      plain = piece(slitFromBelow(3.0), standing(kRight));
    const Freedom guest = judgedUp(plain, thin), host = judge(thin, plain);
    QVERIFY2(isHeldBut(guest, {Vec3::UnitY()}), toText(guest));
    QVERIFY2(isHeldBut(host, {-Vec3::UnitY()}), toText(host));
}

/// What would be wrong: slits of a few millimetres hold no less straight, but are not seen.
void TestHeldJudge::shallowSlit()
{
    const double w = 1.5;
    const PlainRing shallow{{-30, -20}, {30, -20}, {30, 3}, {w, 3},
                            {w, 0},     {-w, 0},   {-w, 3}, {-30, 3}};
    PlainRing mate;
    for (const Vec2 &p : shallow)
        mate.push_back(-p);
    const Freedom freedom = judgedUp(piece(mate, standing(kRight)), piece(shallow, standing(0.0)));
    QVERIFY2(isHeldBut(freedom, {Vec3::UnitY()}), toText(freedom));
}

/// What would be wrong: what ends on a face is held by it.
void TestHeldJudge::buttContact()
{
    const Freedom freedom = judgedUp(piece(box(1.5, -20, 30, 20), standing(kRight)),
                                     piece(box(-30, -20, 30, 20), standing(0.0)));
    // The guest lies behind the host, at negative z.
    QVERIFY2(freedom.touches, toText(freedom));
    QVERIFY2(!canShift(freedom, Vec3::UnitZ()), toText(freedom));
    for (const Vec3 &way : {Vec3(-Vec3::UnitZ()), Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitX()),
                            Vec3(Vec3::UnitY()), Vec3(-Vec3::UnitY())})
        QVERIFY2(canShift(freedom, way), toText(freedom));
}

/// What would be wrong: faces are not looked at where no edge of one comes to lie in the other.
void TestHeldJudge::equalPlatesOnEachOther()
{
    const Freedom freedom = judge(piece(box(-20, -20, 20, 20), standing(0.0, {0, 0, 3})),
                                  piece(box(-20, -20, 20, 20), standing(0.0)));
    QVERIFY2(!canShift(freedom, -Vec3::UnitZ()), toText(freedom));
    for (const Vec3 &way : {Vec3(Vec3::UnitZ()), Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitY())})
        QVERIFY2(canShift(freedom, way), toText(freedom));
}

/// What would be wrong: pieces that do not touch are held, since nothing was tried.
void TestHeldJudge::farAway()
{
    const Freedom freedom = judge(piece(box(5, -20, 30, 20), standing(kRight)),
                                  piece(box(-30, -20, 30, 20), standing(0.0)));
    QVERIFY(!freedom.touches);
    QVERIFY(freedom.getsAway());
    QVERIFY(!freedom.isHeldBut({}));
}

/// What would be wrong: a mortise holds more, or less, than across the way through it.
void TestHeldJudge::mortise()
{
    const Freedom freedom =
        judge(piece(box(-30, -10, 30, 10), standing(kRight)),
              piece(box(-30, -20, 30, 20), standing(0.0), {box(-1.5, -10, 1.5, 10)}));
    QVERIFY2(isHeldBut(freedom, {Vec3::UnitZ(), -Vec3::UnitZ()}), toText(freedom));
}

/// What would be wrong: play along the slot is not seen.
void TestHeldJudge::tooLongMortise()
{
    const JudgedPiece guest = piece(box(-30, -10, 30, 10), standing(kRight)),
                      host = piece(box(-30, -20, 30, 20), standing(0.0), {box(-1.5, -11, 1.5, 10)});
    const Freedom freedom = judge(guest, host);
    QVERIFY2(canShift(freedom, -Vec3::UnitY()), toText(freedom));
    QVERIFY2(!canShift(freedom, Vec3::UnitY()), toText(freedom));
    QVERIFY2(!canShift(freedom, Vec3::UnitX()), toText(freedom));
}

/// What would be wrong: play that was not granted counts as held, or play that was as free.
void TestHeldJudge::widerSlit()
{
    const JudgedPiece host = piece(slitFromAbove(4.0), standing(0.0)),
                      guest = piece(slitFromBelow(4.0), standing(kRight));
    const Freedom loose = judgedUp(guest, host);
    for (const Vec3 &way : {Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitX()), Vec3(Vec3::UnitZ())})
        QVERIFY2(canShift(loose, way), toText(loose));
    const Freedom held = judgedUp(guest, host, {1.1, 0.0});
    QVERIFY2(isHeldBut(held, {Vec3::UnitY()}), toText(held));
}

void TestHeldJudge::obliqueLap_data()
{
    QTest::addColumn<double>("degrees");
    for (const double degrees : {20.0, 30.0, 45.0, 60.0, 80.0, 120.0, 150.0})
        QTest::addRow("%g degrees", degrees) << degrees;
}

/// What would be wrong: the wider slits of plates that are oblique to each other, which let them
/// turn up and over to the same angle, count as free beyond that; or that turn is not seen.
void TestHeldJudge::obliqueLap()
{
    QFETCH(double, degrees);
    const double angle = degrees * std::numbers::pi / 180.0,
                 acute = std::min(angle, 2.0 * kRight - angle);
    const double width = obliqueWidth(acute);
    const JudgedPiece host = piece(slitFromAbove(width), standing(0.0)),
                      guest = piece(slitFromBelow(width), standing(angle));
    const Freedom granted = judgedUp(guest, host, {0.1, std::numbers::pi - 2.0 * acute});
    QVERIFY2(isHeldBut(granted, {Vec3::UnitY()}), toText(granted));
    QVERIFY(granted.inEachOther < 1e-9);
    const Freedom asked = judgedUp(guest, host);
    QVERIFY2(canShift(asked, Vec3::UnitY()), toText(asked));
    QCOMPARE(turnsOf(asked), 1);
    QCOMPARE(asked.free.size(), std::size_t(2));
}

/// What would be wrong: what two guests cut off on both sides is held by them.
void TestHeldJudge::stripBetweenTwoGuests()
{
    const JudgedPiece strip = piece(box(-10, -3, 10, 3), standing(0.0)),
                      left = piece(box(-20, -20, 20, 20), standing(kRight, {-11.5, 0, 0})),
                      right = piece(box(-20, -20, 20, 20), standing(kRight, {11.5, 0, 0}));
    const JudgedPiece *guests[] = {&left, &right};
    const Freedom freedom = judge(strip, guests);
    QVERIFY2(freedom.getsAway(), toText(freedom));
    for (const Vec3 &way : {Vec3(Vec3::UnitY()), Vec3(-Vec3::UnitY()), Vec3(Vec3::UnitZ())})
        QVERIFY2(canShift(freedom, way), toText(freedom));
    QVERIFY2(!canShift(freedom, Vec3::UnitX()), toText(freedom));
    QVERIFY2(!canShift(freedom, -Vec3::UnitX()), toText(freedom));
}

/// What would be wrong: a corner that a slit cuts off is held by its guest.
void TestHeldJudge::chip()
{
    const JudgedPiece chip = piece({{1.5, 15}, {6, 20}, {1.5, 20}}, standing(0.0)),
                      guest = piece(box(-30, -20, 30, 20), standing(kRight));
    const Freedom freedom = judge(chip, guest);
    QVERIFY2(freedom.touches && freedom.getsAway(), toText(freedom));
    QVERIFY2(canShift(freedom, Vec3::UnitX()), toText(freedom));
    QVERIFY2(!canShift(freedom, -Vec3::UnitX()), toText(freedom));
}

/// What would be wrong: what is enclosed gets away.
void TestHeldJudge::chipThatIsLockedIn()
{
    // A disc of a plate in its hole, between two plates that lie on it.
    const JudgedPiece chip = piece(box(-5, -5, 5, 5), standing(0.0)),
                      round = piece(box(-20, -20, 20, 20), standing(0.0), {box(-5, -5, 5, 5)}),
                      before = piece(box(-20, -20, 20, 20), standing(0.0, {0, 0, 3})),
                      behind = piece(box(-20, -20, 20, 20), standing(0.0, {0, 0, -3}));
    const JudgedPiece *all[] = {&round, &before, &behind};
    QVERIFY(!judge(chip, all).getsAway());
    const JudgedPiece *open[] = {&round, &before};
    const Freedom freedom = judge(chip, open);
    QVERIFY2(isHeldBut(freedom, {-Vec3::UnitZ()}), toText(freedom));
}

/// What would be wrong: that pieces are in each other is not said, or makes all else be held.
void TestHeldJudge::inEachOther()
{
    const Freedom freedom = judge(piece(box(1.0, -20, 30, 20), standing(kRight)),
                                  piece(box(-30, -20, 30, 20), standing(0.0)));
    QCOMPARE(freedom.inEachOther, 0.5);
    QVERIFY2(canShift(freedom, -Vec3::UnitZ()), toText(freedom));
}

/// What would be wrong: of two pieces, one is free to go where the other cannot give way.
void TestHeldJudge::whatBlocksOneBlocksTheOther()
{
    const PlainRing step{{-30, -20}, {30, -20}, {30, 20}, {1.5, 20}, {1.5, 0}, {-30, 0}};
    const std::vector<JudgedPiece> hosts{piece(step, standing(0.0)),
                                         piece(slitFromAbove(3.0), standing(0.0)),
                                         piece(slitFromAbove(5.0), standing(0.0))};
    const JudgedPiece guest = piece(slitFromBelow(3.0), standing(kRight));
    for (const JudgedPiece &host : hosts) {
        const Freedom one = judge(guest, host), other = judge(host, guest);
        QCOMPARE(one.free.size(), other.free.size());
        for (const SmallMove &move : one.free)
            if (move.kind == SmallMove::Kind::Shift)
                QVERIFY2(canShift(other, -move.direction), toText(one) + " / " + toText(other));
    }
}

/// What would be wrong: an answer that depends on where the world's axes are.
void TestHeldJudge::turnedAsOne()
{
    const PlainRing step{{-30, -20}, {30, -20}, {30, 20}, {1.5, 20}, {1.5, 0}, {-30, 0}};
    const double oblique = kRight / 3.0;
    const std::vector<std::pair<JudgedPiece, JudgedPiece>> pairs{
        {piece(slitFromBelow(3.0), standing(kRight)), piece(step, standing(0.0))},
        {piece(slitFromBelow(3.0), standing(kRight)), piece(slitFromAbove(3.0), standing(0.0))},
        {piece(slitFromBelow(obliqueWidth(oblique)), standing(oblique)),
         piece(slitFromAbove(obliqueWidth(oblique)), standing(0.0))}};
    std::mt19937 random(11);
    const auto number = [&] { return static_cast<double>(random()) / 4294967295.0 - 0.5; };
    for (const auto &[guest, host] : pairs) {
        const std::set<std::string> wanted = namesOf(judge(guest, host));
        for (int i = 0; i < 5; ++i) {
            const Eigen::Quaterniond turn =
                Eigen::Quaterniond(number(), number(), number(), number()).normalized();
            const Vec3 by(100 * number(), 100 * number(), 100 * number());
            const Freedom freedom = judge(moved(guest, turn, by), moved(host, turn, by));
            QVERIFY2(namesOf(freedom) == wanted, toText(freedom));
        }
    }
}

FFF_TEST(TestHeldJudge)
#include "tst_held_judge.moc"
