#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/model/dimensions.h"
#include "core/model/edits.h"
#include "core/model/figures.h"
#include "core/model/lettering.h"
#include "core/model/point_edits.h"
#include "core/model/transformed.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <random>

using namespace fff;
using namespace fff::test;

namespace {

/// Of rounding only: mm over sections of a metre, and axes, which have no unit.
constexpr double kRounding = 1e-9;

constexpr int kRounds = 200;

class Dice
{
public:
    explicit Dice(unsigned seed) : m_random(seed) {}

    double between(double least, double most)
    {
        return std::uniform_real_distribution<double>(least, most)(m_random);
    }
    Vec2 point() { return {between(-60, 60), between(-60, 60)}; }
    Vec3 place() { return {between(-300, 300), between(-300, 300), between(-300, 300)}; }
    Eigen::Matrix3d turn()
    {
        const Eigen::Quaterniond q(between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1));
        return q.normalized().toRotationMatrix();
    }
    /// Every other one mirrors, too.
    Similarity similarity()
    {
        Similarity placement{turn(), between(0.4, 2.5), place()};
        if (between(0, 1) < 0.5)
            placement.turn = placement.turn * Vec3(-1, 1, 1).asDiagonal();
        return placement;
    }
    Frame frame()
    {
        const Eigen::Matrix3d axes = turn();
        return {place(), axes.col(0), axes.col(1)};
    }
    std::mt19937 &random() { return m_random; }

private:
    std::mt19937 m_random;
};

/// A blob with a hole that is a figure, a line, words, and a slit in something else.
Section drawn(Dice &dice)
{
    Figure hole = newFigure(*figureKind("polygon"));
    hole.numbers = {12.0, 5.0};
    hole.centre = 0.1 * dice.point();
    hole.turn = dice.between(-3, 3);
    Section section;
    section.id = SectionId{1};
    section.name = "Rib";
    section.shape = Shape::make(blob(dice.random(), 7, 90.0), {contourOf(hole).value()}).value();
    section.frame = dice.frame();
    section.parent = Parent{SectionId{7}, dice.point(), dice.point()};
    section.figures = {hole};
    section.marks = {
        std::make_shared<const Mark>(
            Mark{Mark::Kind::Scored,
                 {CurvePath::fromLine({dice.point(), dice.point(), dice.point()}).value()}}),
        letteredMark({"Rib 3", 8.0, 0.2 * dice.point(), dice.between(-3, 3)}, Mark::Kind::Engraved)
            .value()};
    return section;
}

/// The control points of all that lies on it, in the world.
std::vector<Vec3> placesOn(const Section &section)
{
    std::vector<Vec3> places;
    const auto add = [&](const Vec2 &p) { places.push_back(section.frame.toWorld(p)); };
    for (int i = 0; i < boundaryCount(*section.shape); ++i)
        for (const Vec2 &p : boundary(*section.shape, i).points())
            add(p);
    for (const MarkPointer &mark : section.marks) {
        for (const CurvePath &path : mark->paths)
            for (const Vec2 &p : path.points())
                add(p);
        if (mark->lettering) {
            add(mark->lettering->at);
            const double turn = mark->lettering->turn;
            add(mark->lettering->at +
                mark->lettering->height * Vec2(std::cos(turn), std::sin(turn)));
        }
    }
    for (const Figure &figure : section.figures)
        add(figure.centre);
    return places;
}

double difference(const std::vector<Vec3> &a, const std::vector<Vec3> &b)
{
    if (a.size() != b.size())
        return std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, (a[i] - b[i]).cwiseAbs().maxCoeff());
    return most;
}

bool isSame(const Section &a, const Section &b)
{
    return difference(placesOn(a), placesOn(b)) < kRounding &&
           (a.frame.origin - b.frame.origin).norm() < kRounding &&
           (a.frame.x - b.frame.x).norm() < kRounding &&
           (a.frame.y - b.frame.y).norm() < kRounding && a.name == b.name && a.parent == b.parent &&
           a.figures.size() == b.figures.size();
}

/// A document of that section with something at places of it, and of another one and the world.
Document held(const Section &section, Dice &dice)
{
    Document document = newDocument();
    document.sections = {std::make_shared<const Section>(section)};
    for (const SectionId on : {section.id, SectionId{9}}) {
        Load weight;
        weight.section = on;
        weight.position = dice.point();
        document.loads.push_back(weight);
        const Vec2 from = dice.point();
        document.dimensions.push_back({{}, {on, {from.x(), from.y(), 1.5}}, {{}, dice.place()}});
        JointOverride joint;
        joint.a = on;
        joint.b = SectionId{20};
        joint.shares = {{dice.point(), 0.4}};
        document.jointOverrides.push_back(std::make_shared<const JointOverride>(joint));
    }
    return document;
}

/// In the frame of what they are on; the ends in the world last.
std::vector<Vec3> heldPlaces(const Document &document, SectionId on)
{
    std::vector<Vec3> places;
    const auto add = [&](const Vec2 &p) { places.emplace_back(p.x(), p.y(), 0.0); };
    for (const Load &weight : document.loads)
        if (weight.section == SectionRef(on))
            add(weight.position);
    for (const JointOverridePointer &joint : document.jointOverrides)
        if (joint->a == SectionRef(on))
            add(joint->shares.front().at);
    for (const Dimension &dimension : document.dimensions)
        if (dimension.from.section == SectionRef(on)) {
            places.push_back(dimension.from.at);
            places.push_back(dimension.to.at);
        }
    return places;
}

} // namespace

class TestTransformed : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init() { m_dice = Dice(20260731); }

    void nothingHappensByTheIdentity();
    void oneAfterTheOtherIsBothAtOnce();
    void theInverseGoesBack();
    void allThatLiesOnItLiesWhereItLay();
    void aStretchKeepsTheFrame();
    void aMarkBeyondAllBoundsIsLeftOut();
    void aShapeOfNothingIsRefusedByTheSectionsName();
    void shapesComeFromWhoeverKeepsThem();
    void whatADocumentKeepsOnItGoesAlong();
    void aSlitGrowsWithWhatItIsOn();

private:
    Dice m_dice{0};
};

void TestTransformed::nothingHappensByTheIdentity()
{
    const Section section = drawn(m_dice);
    const Section same = transformed(section, {}).value();
    QVERIFY(same == section);
    QVERIFY(same.shape == section.shape);
    QVERIFY(same.marks == section.marks); // the very objects
    // Neither by a turn alone, but for the frame.
    const Section turned = transformed(section, Similarity::moved({1, 2, 3})).value();
    QVERIFY(turned.shape == section.shape && turned.marks == section.marks);
    QVERIFY(turned.frame.origin == section.frame.origin + Vec3(1, 2, 3));
}

void TestTransformed::oneAfterTheOtherIsBothAtOnce()
{
    for (int i = 0; i < kRounds; ++i) {
        const Section section = drawn(m_dice);
        const Similarity a = m_dice.similarity(), b = m_dice.similarity();
        const Section after = transformed(transformed(section, a).value(), b).value();
        QVERIFY2(isSame(after, transformed(section, b * a).value()),
                 qPrintable(QString::number(i)));
    }
}

void TestTransformed::theInverseGoesBack()
{
    for (int i = 0; i < kRounds; ++i) {
        const Section section = drawn(m_dice);
        const Similarity a = m_dice.similarity();
        const Section back = transformed(transformed(section, a).value(), a.inverse()).value();
        QVERIFY2(isSame(back, section), qPrintable(QString::number(i)));
    }
}

void TestTransformed::allThatLiesOnItLiesWhereItLay()
{
    for (int i = 0; i < kRounds; ++i) {
        const Section section = drawn(m_dice);
        const Similarity a = m_dice.similarity();
        const Section there = transformed(section, a).value();
        std::vector<Vec3> expected;
        for (const Vec3 &p : placesOn(section))
            expected.push_back(a(p));
        QVERIFY(difference(placesOn(there), expected) < kRounding);
        QCOMPARE(there.figures.size(), std::size_t(1));
        QCOMPARE(boundaryOf(*there.shape, there.figures.front()), 1); // the hole is one still
        QCOMPARE(there.marks.size(), section.marks.size());
        const Mark &words = *there.marks.back();
        const MarkPointer anew = letteredMark(*words.lettering, words.kind).value();
        Section written = there;
        written.marks.back() = anew;
        QVERIFY(difference(placesOn(written), expected) < 1e-6);
    }
}

void TestTransformed::aStretchKeepsTheFrame()
{
    for (int i = 0; i < kRounds; ++i) {
        const Section section = drawn(m_dice);
        PlaneMap map{Eigen::Matrix2d::Identity(), m_dice.point()};
        map.matrix(0, 0) = m_dice.between(0.5, 2.0);
        map.matrix(0, 1) = m_dice.between(-0.5, 0.5);
        const Section there = stretched(section, map).value();
        QVERIFY(there.frame == section.frame && there.parent == section.parent);
        const auto &before = section.shape->contour().points(),
                   &after = there.shape->contour().points();
        QCOMPARE(after.size(), before.size());
        for (std::size_t k = 0; k < before.size(); ++k)
            QVERIFY((map(before[k]) - after[k]).norm() < kRounding);
        // It leans: no figure and no words any more, but their lines.
        QVERIFY(there.figures.empty());
        QVERIFY(there.marks.back()->paths.size() == section.marks.back()->paths.size());
        QVERIFY(!there.marks.back()->lettering);
    }
}

void TestTransformed::aMarkBeyondAllBoundsIsLeftOut()
{
    Section section = drawn(m_dice);
    section.marks.push_back(std::make_shared<const Mark>(
        Mark{Mark::Kind::Engraved, {CurvePath::fromLine({{0, 0}, {9e5, 0}}).value()}}));
    const Section there = transformed(section, {.scale = 3.0}).value();
    QCOMPARE(there.marks.size(), std::size_t(2));
}

void TestTransformed::aShapeOfNothingIsRefusedByTheSectionsName()
{
    const Result<Section> none = transformed(drawn(m_dice), {.scale = 1e-9});
    QVERIFY(!none);
    QCOMPARE(QString::fromStdString(none.error().place), QStringLiteral("Rib"));
}

void TestTransformed::shapesComeFromWhoeverKeepsThem()
{
    const Section section = drawn(m_dice);
    const ShapePointer kept = Shape::make(circle({0, 0}, 70.0)).value();
    int asked = 0;
    const ShapeMap known = [&](const ShapePointer &shape, const PlaneMap &map) {
        ++asked;
        if (shape != section.shape || map.matrix(0, 0) != 2.0)
            return Result<ShapePointer>(failure(ErrorCode::BadValue));
        return Result<ShapePointer>(kept);
    };
    QVERIFY(transformed(section, {.scale = 2.0}, known).value().shape == kept);
    QCOMPARE(asked, 1);
    QVERIFY(transformed(section, {}, known).value().shape == section.shape);
    QCOMPARE(asked, 1); // as large as it was, it is the very one
}

void TestTransformed::whatADocumentKeepsOnItGoesAlong()
{
    for (int i = 0; i < kRounds; ++i) {
        const Section section = drawn(m_dice);
        const Document before = held(section, m_dice);
        const Similarity a = m_dice.similarity();
        const Section there = transformed(section, a).value();
        Document after = before;
        mapPlaces(
            after, [&](const SectionRef &ref) { return ref == section.ref(); },
            PlaneMap::scaled(a.scale));
        const auto mapped = heldPlaces(after, section.id), own = heldPlaces(before, section.id);
        QCOMPARE(mapped.size(), std::size_t(4));
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 was = section.frame.toWorld(own[k].head<2>());
            QVERIFY((there.frame.toWorld(mapped[k].head<2>()) - a(was)).norm() < kRounding);
            QCOMPARE(mapped[k].z(), own[k].z());
        }
        QVERIFY(mapped.back() == own.back()); // in the world
        QVERIFY(heldPlaces(after, SectionId{9}) == heldPlaces(before, SectionId{9}));
    }
}

void TestTransformed::aSlitGrowsWithWhatItIsOn()
{
    for (int i = 0; i < kRounds; ++i) {
        const Frame host = m_dice.frame();
        const Parent parent = *drawn(m_dice).parent;
        const Similarity a = m_dice.similarity();
        const Parent there = transformed(parent, a);
        const Frame hostThere = placed(host, a);
        QVERIFY((hostThere.toWorld(there.slitFrom) - a(host.toWorld(parent.slitFrom))).norm() <
                kRounding);
        QVERIFY((hostThere.toWorld(there.slitTo) - a(host.toWorld(parent.slitTo))).norm() <
                kRounding);
        QVERIFY(there.section == parent.section);
    }
}

FFF_TEST(TestTransformed)
#include "tst_transformed.moc"
