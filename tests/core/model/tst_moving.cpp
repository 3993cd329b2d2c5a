#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/units.h"
#include "core/model/edits.h"
#include "core/model/load_edits.h"
#include "core/model/moving.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <random>

using namespace fff;
using namespace fff::test;

namespace {

/// mm; axes have no unit.
constexpr double kSameMove = 1e-12;

Frame crossing(const Frame &parent, const Vec2 &from, const Vec2 &to)
{
    const Vec3 along = parent.directionToWorld((to - from).normalized());
    return {parent.toWorld(from), along, parent.normal()};
}

/// A body, a rib across it, a fin across the rib and a tail across the body; a weight on the rib.
struct Animal
{
    Document document = newDocument();
    SectionId body, rib, fin, tail;

    Animal()
    {
        body = add("Body", {{3.0, 90.0, -2.0}, Vec3::UnitX(), Vec3::UnitY()}, std::nullopt);
        rib = add("Rib", {}, Parent{body, {10, 5}, {12, 40}});
        fin = add("Fin", {}, Parent{rib, {2, -3}, {30, 4}});
        tail = add("Tail", {}, Parent{body, {-20, 0}, {-60, 1}});
        Load weight;
        weight.section = rib;
        weight.position = {4, 7};
        document = addLoad(document, weight).value();
    }
    SectionId add(const char *name, Frame frame, const std::optional<Parent> &parent)
    {
        if (parent)
            frame =
                crossing(section(parent->section.drawn).frame, parent->slitFrom, parent->slitTo);
        const ShapePointer shape =
            Shape::make(circle({3, -2}, 50.0), {circle({0, 0}, 10.0)}).value();
        document = addSection(document, {name, parent, shape, frame, {}}).value();
        return document.sections.back()->id;
    }
    const Section &section(SectionId id) const { return *document.find(id); }
};

double difference(const Document &a, const Document &b)
{
    double most = 0.0;
    const auto compare = [&most](const auto &p, const auto &q) {
        most = std::max(most, (p - q).cwiseAbs().maxCoeff());
    };
    for (std::size_t i = 0; i < a.sections.size(); ++i) {
        const Section &p = *a.sections[i], &q = *b.sections[i];
        compare(p.frame.origin, q.frame.origin);
        compare(p.frame.x, q.frame.x);
        compare(p.frame.y, q.frame.y);
        for (std::size_t k = 0; k < p.shape->contour().points().size(); ++k)
            compare(p.shape->contour().points()[k], q.shape->contour().points()[k]);
        if (p.parent) {
            compare(p.parent->slitFrom, q.parent->slitFrom);
            compare(p.parent->slitTo, q.parent->slitTo);
        }
    }
    for (std::size_t i = 0; i < a.loads.size(); ++i)
        compare(a.loads[i].position, b.loads[i].position);
    return most;
}

class Dice
{
public:
    double between(double least, double most)
    {
        return least + (most - least) * double(m_generator() % 100000) / 99999.0;
    }
    int below(int count) { return int(m_generator() % std::uint32_t(count)); }
    Vec3 point(double reach)
    {
        return {between(-reach, reach), between(-reach, reach), between(-reach, reach)};
    }
    Similarity placement(bool scales)
    {
        const Vec3 axis = point(1.0).normalized();
        const Eigen::Matrix3d turn = Eigen::AngleAxisd(between(-3.0, 3.0), axis).toRotationMatrix();
        const double scale = scales ? between(0.5, 2.0) : 1.0;
        const Vec3 about = point(100.0);
        return {turn, scale, about - scale * (turn * about) + point(100.0)};
    }

private:
    std::mt19937 m_generator{7};
};

Document moved(const Document &document, SectionId id, const Similarity &placement,
               bool takesChildren = true)
{
    const SectionMove move{id, placement};
    return movedSections(document, {&move, 1}, {.takesChildren = takesChildren}).value();
}

/// Largest cosine between the normals of a section and of what it is on.
double skew(const Document &document)
{
    double most = 0.0;
    for (const SectionPointer &section : document.sections) {
        const Section *parent =
            section->parent ? document.find(section->parent->section.drawn) : nullptr;
        if (parent && !section->parent->isFree)
            most = std::max(most, std::abs(section->frame.normal().dot(parent->frame.normal())));
    }
    return most;
}

/// How far slits are off the section that they hold, mm.
double slitError(const Document &document)
{
    double most = 0.0;
    for (const SectionPointer &section : document.sections) {
        const Section *parent =
            section->parent ? document.find(section->parent->section.drawn) : nullptr;
        if (!parent)
            continue;
        for (const Vec2 &end : {section->parent->slitFrom, section->parent->slitTo})
            most = std::max(most, std::abs(section->frame.height(parent->frame.toWorld(end))));
    }
    return most;
}

} // namespace

class TestMoving : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aMoveAndItsInverse_data();
    void aMoveAndItsInverse();
    void orthogonalAfterAnyMoves();
    void whatIsOnItGoesAlong();
    void whatIsFreeStays();
    void aloneItTurnsAboutItsParentsNormal();
    void itDoesNotLieDownInItsParent();
    void othersKeepTheirObjects();
    void shapesAreSharedUnlessScaled();
    void scaledWithAllThatIsOnIt();
    void stretchedInItsPlane();
    void turnedToAnAngle();
    void turnedToANormal();
    void freedAndHeldAgain();
    void badMovesAreRefused();
};

void TestMoving::aMoveAndItsInverse_data()
{
    QTest::addColumn<bool>("scales");
    QTest::newRow("moved and turned") << false;
    QTest::newRow("scaled by f and 1/f, too") << true;
}

// Wrong: a section would not come back to where it was, and drift with every move.
void TestMoving::aMoveAndItsInverse()
{
    QFETCH(bool, scales);
    Dice dice;
    const Animal animal;
    for (int i = 0; i < 100; ++i) {
        const Similarity there = dice.placement(scales);
        const Document once = moved(animal.document, animal.body, there);
        QVERIFY(difference(once, animal.document) > 1.0);
        const Document back = moved(once, animal.body, there.inverse());
        QVERIFY2(difference(back, animal.document) <= kSameMove,
                 qPrintable(QString::number(difference(back, animal.document))));
    }
    // A child by itself, in the ways that are left to it.
    const Vec3 normal = animal.section(animal.body).frame.normal();
    for (int i = 0; i < 100; ++i) {
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(dice.between(-3.0, 3.0), normal).toRotationMatrix();
        const Similarity there =
            Similarity::moved(dice.point(50.0)) * Similarity::turned(turn, dice.point(50.0));
        const Document back =
            moved(moved(animal.document, animal.rib, there), animal.rib, there.inverse());
        QVERIFY(difference(back, animal.document) <= kSameMove);
    }
}

// Wrong: what was drawn across a section would not fit it at a right angle any more.
void TestMoving::orthogonalAfterAnyMoves()
{
    Dice dice;
    for (int run = 0; run < 20; ++run) {
        Document document = Animal().document;
        for (int i = 0; i < 100; ++i) {
            const SectionId id = document.sections[std::size_t(dice.below(4))]->id;
            document = moved(document, id, dice.placement(false), dice.below(3) > 0);
            QVERIFY2(skew(document) <= 1e-9, qPrintable(QString::number(skew(document))));
            QVERIFY(slitError(document) <= 1e-6);
        }
        for (const SectionPointer &section : document.sections) {
            QVERIFY(std::abs(section->frame.x.norm() - 1.0) <= 1e-14);
            QVERIFY(std::abs(section->frame.x.dot(section->frame.y)) <= 1e-14);
        }
    }
}

// Wrong: a rib would hang in the air where its body was.
void TestMoving::whatIsOnItGoesAlong()
{
    const Animal animal;
    const Vec3 way(10, 20, 30);
    const Document next = moved(animal.document, animal.body, Similarity::moved(way));
    for (const SectionPointer &section : next.sections) {
        const Section &before = *animal.document.find(section->id);
        QVERIFY((section->frame.origin - before.frame.origin - way).norm() <= 1e-12);
        QCOMPARE(section->parent, before.parent);
    }
    const Document alone = moved(animal.document, animal.body, Similarity::moved(way), false);
    QCOMPARE(alone.find(animal.rib)->frame, animal.section(animal.rib).frame);
    QVERIFY(slitError(alone) <= 1e-9);
}

// Wrong: "Free from its parent" would free nothing.
void TestMoving::whatIsFreeStays()
{
    Animal animal;
    animal.document = setFree(animal.document, animal.rib, true).value();
    Dice dice;
    const Similarity there = dice.placement(false);
    const Document next = moved(animal.document, animal.body, there);
    QCOMPARE(next.find(animal.rib)->frame, animal.section(animal.rib).frame);
    QCOMPARE(next.find(animal.fin)->frame, animal.section(animal.fin).frame);
    QVERIFY(!(next.find(animal.tail)->frame == animal.section(animal.tail).frame));
    // And it goes where it is told.
    const Document tilted = moved(animal.document, animal.rib, there);
    const Frame wanted = placed(animal.section(animal.rib).frame, there);
    QVERIFY((tilted.find(animal.rib)->frame.normal() - wanted.normal()).norm() <= 1e-12);
}

// Wrong: turning a child would tilt it, or not turn it.
void TestMoving::aloneItTurnsAboutItsParentsNormal()
{
    const Animal animal;
    const Section &rib = animal.section(animal.rib);
    const Vec3 middle = animal.section(animal.body)
                            .frame.toWorld(0.5 * (rib.parent->slitFrom + rib.parent->slitTo));
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.4, animal.section(animal.body).frame.normal()).toRotationMatrix();
    const Document next = moved(animal.document, animal.rib, Similarity::turned(turn, middle));
    const Vec3 wanted = turn * rib.frame.normal();
    QVERIFY((next.find(animal.rib)->frame.normal() - wanted).norm() <= 1e-12);
    // About any other axis it goes as far as it may.
    const Eigen::Matrix3d tilt = Eigen::AngleAxisd(0.4, rib.frame.x).toRotationMatrix();
    const Document tilted = moved(animal.document, animal.rib, Similarity::turned(tilt, middle));
    QVERIFY((tilted.find(animal.rib)->frame.normal() - rib.frame.normal()).norm() <= 1e-12);
}

// Wrong: the least turn out of the parent's plane has no direction, and frames would be NaN.
void TestMoving::itDoesNotLieDownInItsParent()
{
    const Animal animal;
    const Section &rib = animal.section(animal.rib);
    const Eigen::Matrix3d down =
        Eigen::AngleAxisd(std::numbers::pi / 2, rib.frame.x).toRotationMatrix();
    const Document next =
        moved(animal.document, animal.rib, Similarity::turned(down, rib.frame.origin));
    QVERIFY(next.find(animal.rib)->frame.origin.allFinite());
    QVERIFY(skew(next) <= 1e-12);
}

// Wrong: an edit would cost the work of the whole model.
void TestMoving::othersKeepTheirObjects()
{
    const Animal animal;
    const Document next = moved(animal.document, animal.rib, Similarity::moved(Vec3(0, 0, 5)));
    QCOMPARE(next.sections[0], animal.document.sections[0]);
    QCOMPARE(next.sections[3], animal.document.sections[3]);
    QVERIFY(moved(animal.document, animal.rib, {}).isSame(animal.document));
}

// Wrong: meshes, areas and chords would be worked out anew for a move.
void TestMoving::shapesAreSharedUnlessScaled()
{
    const Animal animal;
    Dice dice;
    const Document next = moved(animal.document, animal.body, dice.placement(false));
    for (std::size_t i = 0; i < next.sections.size(); ++i)
        QCOMPARE(next.sections[i]->shape, animal.document.sections[i]->shape);
}

// Wrong: a scaled rib would not fit its scaled body, or lose its weight.
void TestMoving::scaledWithAllThatIsOnIt()
{
    const Animal animal;
    const Similarity twice = Similarity::scaled(2.0, {10, 20, 30});
    const Document next = moved(animal.document, animal.body, twice);
    for (const SectionPointer &section : next.sections) {
        const Section &before = *animal.document.find(section->id);
        QVERIFY(std::abs(section->shape->area() - 4.0 * before.shape->area()) <= 1e-6);
        QVERIFY((section->frame.toWorld(section->shape->centroid()) -
                 twice(before.frame.toWorld(before.shape->centroid())))
                    .norm() <= 1e-9);
        if (section->parent)
            QVERIFY((section->parent->slitTo - 2.0 * before.parent->slitTo).norm() <= 1e-9);
    }
    QCOMPARE(next.loads.front().position, Vec2(8, 14));
}

// Wrong: what is on a section that is made wider would stay behind, or be deformed.
void TestMoving::stretchedInItsPlane()
{
    const Animal animal;
    Eigen::Matrix2d wide;
    wide << 2.0, 0.0, 0.0, 1.0;
    const Vec2 about(1, 2);
    const Document next = stretchedSection(animal.document, animal.body, {wide, about}).value();
    QVERIFY(std::abs(next.find(animal.body)->shape->area() -
                     2.0 * animal.section(animal.body).shape->area()) <= 1e-6);
    const Section &rib = *next.find(animal.rib), &before = animal.section(animal.rib);
    QCOMPARE(rib.shape, before.shape);
    QVERIFY((rib.frame.normal() - before.frame.normal()).norm() <= 1e-12);
    const Vec2 middle = 0.5 * (rib.parent->slitFrom + rib.parent->slitTo);
    const Vec2 was = 0.5 * (before.parent->slitFrom + before.parent->slitTo);
    QVERIFY((middle - (about + wide * (was - about))).norm() <= 1e-9);
    QVERIFY(slitError(next) <= 1e-9);
    const Document back = stretchedSection(next, animal.body, {wide.inverse(), about}).value();
    QVERIFY(difference(back, animal.document) <= kSameMove);
    QVERIFY(stretchedSection(animal.document, animal.body, PlaneMap{})->isSame(animal.document));
}

// Wrong: the field "Angle to it" would not come to the angle that was typed.
void TestMoving::turnedToAnAngle()
{
    const Animal animal;
    const Frame &body = animal.section(animal.body).frame;
    QVERIFY(std::abs(angleToParent(animal.section(animal.rib), body) - radians(90)) <= 1e-12);
    Document document = animal.document;
    for (const double degrees : {10.0, 45.0, 90.0, 120.0, 170.0}) {
        const SectionMove move{
            animal.rib, turnToAngle(*document.find(animal.rib), body, radians(degrees)), true};
        document = movedSections(document, {&move, 1}).value();
        const Section &rib = *document.find(animal.rib);
        QVERIFY(std::abs(angleToParent(rib, body) - radians(degrees)) <= 1e-9);
        QVERIFY(slitError(document) <= 1e-9);
        // It is kept from then on.
        Dice dice;
        const Document after = moved(document, animal.rib, dice.placement(false));
        QVERIFY(std::abs(std::abs(std::cos(angleToParent(*after.find(animal.rib), body))) -
                         std::abs(std::cos(radians(degrees)))) <= 1e-9);
    }
}

// Wrong: "Align to nearest axis" would turn it the long way round, or move it.
void TestMoving::turnedToANormal()
{
    const Animal animal;
    const Section &body = animal.section(animal.body);
    const Vec3 normal = Vec3(0.1, 0.2, -1.0).normalized();
    const Similarity turn = turnToNormal(body, nullptr, normal);
    const Frame frame = placed(body.frame, turn);
    QVERIFY((frame.normal() + normal).norm() <= 1e-12); // the nearer of the two
    const Vec3 middle = body.frame.toWorld(body.shape->centroid());
    QVERIFY((turn(middle) - middle).norm() <= 1e-12);
}

// Wrong: a freed section could not be held again.
void TestMoving::freedAndHeldAgain()
{
    const Animal animal;
    const Document free = setFree(animal.document, animal.rib, true).value();
    QVERIFY(free.find(animal.rib)->parent->isFree);
    QVERIFY(setFree(free, animal.rib, true)->isSame(free));
    QCOMPARE(setFree(free, animal.rib, false).value(), animal.document);
    QCOMPARE(setFree(animal.document, animal.body, true).error().place, std::string("parent"));
}

// Wrong: a model would come to nothing, or beyond every number that a file can hold.
void TestMoving::badMovesAreRefused()
{
    const Animal animal;
    const auto errorOf = [&](SectionId id, const Similarity &placement) {
        const SectionMove move{id, placement};
        const Result<Document> next = movedSections(animal.document, {&move, 1});
        return next ? std::string() : next.error().place;
    };
    QCOMPARE(errorOf(SectionId{99}, {}), std::string("99"));
    QCOMPARE(errorOf(animal.fin, Similarity::scaled(1e-5, Vec3::Zero())), std::string("Fin"));
    QCOMPARE(errorOf(animal.fin, Similarity::moved(Vec3(1e9, 0, 0))), std::string("Fin"));
    QVERIFY(!stretchedSection(animal.document, animal.body, PlaneMap::scaled(1e-6)));
}

FFF_TEST(TestMoving)
#include "tst_moving.moc"
