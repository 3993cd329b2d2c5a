#include "core/physics/equilibrium.h"
#include "tests/core/physics/force_method.h"
#include "tests/core/physics/structures.h"
#include "tests/test_program.h"

#include <QTest>

#include <numeric>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kSame = 1e-8;     // share of the largest force
constexpr double kBalanced = 1e-9; // share
constexpr unsigned kSeeds = 25;

/// A turn or a mirror image, then a shift.
struct Placement
{
    Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
    Vec3 shift = Vec3::Zero();

    Vec3 point(const Vec3 &p) const { return linear * p + shift; }
    Vec3 direction(const Vec3 &v) const { return linear * v; }
    /// A mirror turns moments round.
    Vec3 moment(const Vec3 &m) const { return linear.determinant() * (linear * m); }
};

Structure placed(Structure structure, const Placement &placement)
{
    for (Member &member : structure.members)
        member.centroid = placement.point(member.centroid);
    for (Link &link : structure.links) {
        link.point = placement.point(link.point);
        for (Vec3 *direction : {&link.axis, &link.normalA, &link.normalB})
            *direction = placement.direction(*direction);
    }
    for (Foot &foot : structure.feet)
        foot.point = placement.point(foot.point);
    for (MemberLoad &load : structure.loads) {
        load.point = placement.point(load.point);
        load.force = placement.direction(load.force);
        load.moment = placement.moment(load.moment);
    }
    structure.gravity = placement.direction(structure.gravity);
    structure.up = placement.direction(structure.up);
    return structure;
}

Equilibrium placed(Equilibrium found, const Placement &placement)
{
    for (LinkForce &link : found.links)
        link.onA = {placement.direction(link.onA.force), placement.moment(link.onA.moment)};
    for (FootForce &foot : found.feet)
        foot.force = placement.direction(foot.force);
    return found;
}

/// Members, links and feet in another order; `from` of each: what was at that place.
struct Order
{
    std::vector<int> members, links, feet;
};

std::vector<int> shuffled(std::size_t count, std::mt19937 &random)
{
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    return order;
}

Structure ordered(const Structure &given, const Order &order)
{
    Structure structure = given;
    std::vector<int> to(order.members.size());
    for (std::size_t i = 0; i < to.size(); ++i) {
        to[order.members[i]] = static_cast<int>(i);
        structure.members[i] = given.members[order.members[i]];
    }
    for (std::size_t i = 0; i < order.links.size(); ++i) {
        structure.links[i] = given.links[order.links[i]];
        structure.links[i].a = to[structure.links[i].a];
        structure.links[i].b = to[structure.links[i].b];
    }
    for (std::size_t i = 0; i < order.feet.size(); ++i) {
        structure.feet[i] = given.feet[order.feet[i]];
        structure.feet[i].member = to[structure.feet[i].member];
    }
    for (MemberLoad &load : structure.loads)
        load.member = to[load.member];
    return structure;
}

/// The lengths of a structure in another unit, forces in the same.
Structure inUnit(Structure structure, double perMillimetre)
{
    const double area = perMillimetre * perMillimetre;
    for (Member &member : structure.members)
        member.centroid *= perMillimetre;
    for (Link &link : structure.links) {
        link.point *= perMillimetre;
        for (double *length : {&link.depthA, &link.depthB, &link.thicknessA, &link.thicknessB})
            *length *= perMillimetre;
        link.modulusA /= area;
        link.modulusB /= area;
    }
    for (Foot &foot : structure.feet) {
        foot.point *= perMillimetre;
        foot.stiffness /= perMillimetre;
    }
    for (MemberLoad &load : structure.loads) {
        load.point *= perMillimetre;
        load.moment *= perMillimetre;
    }
    structure.size *= perMillimetre;
    structure.thickness *= perMillimetre;
    return structure;
}

/// Stands, with feet that lift now and then, joints at any angle and grips that are used up.
Structure anyStand(unsigned seed)
{
    StructureSource source(seed);
    Structure stand = source.stand(2 + source.upTo(5), source.upTo(4), 3 + source.upTo(4), 2);
    for (Link &link : stand.links) {
        if (source.upTo(2) == 0) // plates at an angle
            link.normalB = (link.normalB + source.between(-0.7, 0.7) * link.normalA).normalized();
        link.grip = source.between(2.0, 30.0);
    }
    stand.loads.push_back({0, source.point(40.0), {0, -40, 0}, {0, 0, source.between(-9, 9)}});
    return stand;
}

QByteArray named(unsigned seed, double off)
{
    return QByteArray("seed ") + QByteArray::number(seed) + ": " + QByteArray::number(off);
}

} // namespace

class TestEquilibriumLaws : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void placing_data();
    void placing();
    void orderOfParts();
    void swappedPair();
    void anotherUnit();
    void aLoadInTwo();
    void twiceTheLoad();
    void whatIsHeldUp();
    void indeterminacyIsTheNullSpace();
};

void TestEquilibriumLaws::placing_data()
{
    QTest::addColumn<int>("which");
    QTest::newRow("turned about the vertical") << 0;
    QTest::newRow("another way up") << 1;
    QTest::newRow("z up") << 2;
    QTest::newRow("mirrored") << 3;
    QTest::newRow("moved along the ground") << 4;
}

// Wrong: something depends on axes of the world, or on which way is up.
void TestEquilibriumLaws::placing()
{
    QFETCH(int, which);
    int compared = 0;
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
        StructureSource source(seed + 1000);
        Placement placement;
        const Eigen::AngleAxisd quarter(0.5 * std::numbers::pi, Vec3::UnitX());
        if (which == 0)
            placement.linear =
                Eigen::AngleAxisd(source.between(-3, 3), Vec3::UnitY()).toRotationMatrix();
        else if (which == 1)
            placement.linear = source.turn();
        else if (which == 2)
            placement.linear = quarter.toRotationMatrix();
        else if (which == 3)
            placement.linear = Vec3(-1, 1, 1).asDiagonal();
        else
            placement.shift = {source.between(-500, 500), 0, source.between(-500, 500)};
        const Structure stand = anyStand(seed);
        const Equilibrium before = solveEquilibrium(stand);
        const Equilibrium after = solveEquilibrium(placed(stand, placement));
        QCOMPARE(after.balance(), before.balance());
        QCOMPARE(after.indeterminacy(), before.indeterminacy());
        const BodyBalance &body = before.components[0].body, &moved = after.components[0].body;
        QVERIFY(std::abs(body.margin - moved.margin) < kSame * stand.size);
        QVERIFY((placement.point(body.onGround) - moved.onGround).norm() < kSame * stand.size);
        const double off = difference(stand, placed(before, placement), after);
        QVERIFY2(off < kSame, named(seed, off).constData());
        compared += largest(stand, before) > 0.0;
    }
    QVERIFY(compared > static_cast<int>(kSeeds) / 2);
}

// Wrong: who comes first makes a difference.
void TestEquilibriumLaws::orderOfParts()
{
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
        std::mt19937 random(seed);
        const Structure stand = anyStand(seed);
        const Order order{shuffled(stand.members.size(), random),
                          shuffled(stand.links.size(), random),
                          shuffled(stand.feet.size(), random)};
        const Equilibrium before = solveEquilibrium(stand);
        const Equilibrium after = solveEquilibrium(ordered(stand, order));
        QCOMPARE(after.balance(), before.balance());
        Equilibrium expected = before;
        for (std::size_t i = 0; i < order.links.size(); ++i)
            expected.links[i] = before.links[order.links[i]];
        for (std::size_t i = 0; i < order.feet.size(); ++i)
            expected.feet[i] = before.feet[order.feet[i]];
        const double off = difference(stand, expected, after);
        QVERIFY2(off < kSame, named(seed, off).constData());
    }
}

// Wrong: the two of a pair are not alike.
void TestEquilibriumLaws::swappedPair()
{
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
        const Structure stand = anyStand(seed);
        Structure swapped = stand;
        for (Link &link : swapped.links) {
            std::swap(link.a, link.b);
            std::swap(link.normalA, link.normalB);
            std::swap(link.depthA, link.depthB);
            std::swap(link.thicknessA, link.thicknessB);
            std::swap(link.modulusA, link.modulusB);
            link.axis = -link.axis;
        }
        const Equilibrium before = solveEquilibrium(stand);
        Equilibrium after = solveEquilibrium(swapped);
        QCOMPARE(after.balance(), before.balance());
        for (std::size_t i = 0; i < after.links.size(); ++i) {
            QVERIFY(std::abs(after.links[i].pull - before.links[i].pull) <=
                    kSame * largest(stand, before));
            after.links[i].onA = {-after.links[i].onA.force, -after.links[i].onA.moment};
        }
        const double off = difference(stand, before, after);
        QVERIFY2(off < kSame, named(seed, off).constData());
    }
}

// Wrong: a length is hidden in it.
void TestEquilibriumLaws::anotherUnit()
{
    constexpr double kInch = 1.0 / 25.4;
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
        const Structure stand = anyStand(seed);
        const Equilibrium before = solveEquilibrium(stand);
        Equilibrium after = solveEquilibrium(inUnit(stand, kInch));
        QCOMPARE(after.balance(), before.balance());
        for (LinkForce &link : after.links)
            link.onA.moment /= kInch;
        const double off = difference(stand, before, after);
        QVERIFY2(off < kSame, named(seed, off).constData());
    }
}

// Wrong: a load counts by how it is written down.
void TestEquilibriumLaws::aLoadInTwo()
{
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
        const Structure stand = anyStand(seed);
        Structure split = stand;
        for (const MemberLoad &load : stand.loads) {
            // A third and two thirds, at places whose mean is where it was.
            MemberLoad &first = split.loads[&load - stand.loads.data()];
            MemberLoad second = load;
            first.force = load.force / 3.0;
            first.moment = load.moment;
            first.point += Vec3(20, 4, -6);
            second.force = load.force - first.force;
            second.moment.setZero();
            second.point -= 0.5 * Vec3(20, 4, -6);
            split.loads.push_back(second);
        }
        const Equilibrium before = solveEquilibrium(stand);
        const Equilibrium after = solveEquilibrium(split);
        QCOMPARE(after.balance(), before.balance());
        const double off = difference(stand, before, after);
        QVERIFY2(off < kSame, named(seed, off).constData());
    }
}

// Wrong: forces are not in proportion while the same feet press.
void TestEquilibriumLaws::twiceTheLoad()
{
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
        Structure stand = anyStand(seed);
        Structure twice = stand;
        for (Member &member : twice.members)
            member.mass *= 2.0;
        for (MemberLoad &load : twice.loads) {
            load.force *= 2.0;
            load.moment *= 2.0;
        }
        for (Link &link : twice.links)
            link.grip *= 2.0;
        Equilibrium before = solveEquilibrium(stand);
        const Equilibrium after = solveEquilibrium(twice);
        QCOMPARE(after.balance(), before.balance());
        for (LinkForce &link : before.links)
            link.onA = {2.0 * link.onA.force, 2.0 * link.onA.moment};
        for (std::size_t i = 0; i < before.feet.size(); ++i) {
            before.feet[i].force *= 2.0;
            QCOMPARE(after.feet[i].isPressing, before.feet[i].isPressing);
        }
        const double off = difference(stand, before, after);
        QVERIFY2(off < kSame, named(seed, off).constData());
    }
}

// Wrong: the ground gives more or less than there is.
void TestEquilibriumLaws::whatIsHeldUp()
{
    int standing = 0;
    for (unsigned seed = 1; seed <= 4 * kSeeds; ++seed) {
        const Structure stand = anyStand(seed);
        for (bool arePinned : {false, true}) {
            Support support;
            support.arePinned = arePinned;
            const Equilibrium found = solveEquilibrium(stand, support);
            if (!found.components[0].hasForces)
                continue;
            ++standing;
            Vec3 sum = Vec3::Zero(), load = Vec3::Zero();
            for (const FootForce &foot : found.feet)
                sum += foot.force;
            for (const Member &member : stand.members)
                load += member.mass * stand.gravity;
            for (const MemberLoad &one : stand.loads)
                load += one.force;
            QVERIFY2((sum + load).norm() < kBalanced * load.norm(),
                     named(seed, (sum + load).norm()).constData());
            QVERIFY(found.worstResidual < kBalanced);
        }
    }
    QVERIFY(standing > 100);
}

// Wrong: a model is called determinate that is not, or the other way round.
void TestEquilibriumLaws::indeterminacyIsTheNullSpace()
{
    for (unsigned seed = 1; seed <= 2 * kSeeds; ++seed) {
        Structure stand = anyStand(seed);
        if (seed % 5 == 0) // feet in a line
            stand.feet.resize(2);
        const Eigen::MatrixXd matrix = equilibriumMatrix(stand);
        Eigen::FullPivLU<Eigen::MatrixXd> factors(matrix);
        factors.setThreshold(1e-9);
        QCOMPARE(solveEquilibrium(stand).indeterminacy(),
                 static_cast<int>(matrix.cols() - factors.rank()));
    }
}

FFF_TEST(TestEquilibriumLaws)
#include "tst_equilibrium_laws.moc"
