// Sections that are made wider where they would break, and given a second foot.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/findings/second_foot.h"
#include "core/analysis/findings/strength_findings.h"
#include "core/analysis/findings/wider_neck.h"
#include "core/analysis/holding.h"
#include "core/analysis/mends.h"
#include "core/io/document_file.h"
#include "core/model/edits.h"
#include "core/model/load_edits.h"
#include "core/model/symmetric_section.h"
#include "core/session/check_list.h"
#include "core/session/finding_text.h"
#include "core/session/message_text.h"
#include "core/session/session.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <cmath>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kGravity = 9.81; // m/s²

/// From below: the plane z = 0 seen from the front, and x = 0 seen from the right.
Frame facingFront()
{
    return {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()};
}
Frame facingRight()
{
    return {Vec3::Zero(), -Vec3::UnitZ(), Vec3::UnitY()};
}

/// Two plates that cross at the ground, and what is to be tried stands on the first one.
class Stand
{
public:
    Document document;
    SectionId post;

    explicit Stand(Contour contour, std::vector<Contour> holes = {},
                   std::optional<MirrorAxis> symmetry = {})
        : document(newDocument())
    {
        Stock stock = flatfabAcrylic();
        stock.id = document.stocks.front()->id;
        document = *setStock(std::move(document), stock);
        post = add(std::move(contour), std::move(holes), facingFront(), symmetry);
        add(polygonContour(rectangleAt(-70, 0, 140, 30)), {}, facingRight(), {});
    }
    const Stock &stock() const { return *document.stocks.front(); }
    void hang(const Vec2 &at, double mass)
    {
        Load weight;
        weight.section = post;
        weight.position = at;
        weight.mass = mass;
        document = *addLoad(std::move(document), weight);
    }

private:
    SectionId add(Contour contour, std::vector<Contour> holes, const Frame &frame,
                  std::optional<MirrorAxis> symmetry)
    {
        NewSection section;
        section.shape = *Shape::make(std::move(contour), std::move(holes));
        section.frame = frame;
        section.symmetry = symmetry;
        document = *addSection(std::move(document), std::move(section));
        return document.sections.back()->id;
    }
};

/// A broad foot, a shank between two smooth sides and a head: its waist, of so many mm, is at a
/// height and beside the middle by so much.
Contour shank(double waist, double height, double beside)
{
    const auto side = [&](double sign) {
        const double x = beside + sign * 0.5 * waist;
        const Vec2 low(sign * 24.0, 40.0), neck(x, height), top(sign * 22.0, 150.0);
        const double down = 0.5 * (height - 40.0), up = 0.5 * (150.0 - height);
        return std::vector<CubicBezier>{
            {low, low + Vec2(0, 0.6 * down), neck - Vec2(0, down), neck},
            {neck, neck + Vec2(0, up), top - Vec2(0, 0.6 * up), top}};
    };
    std::vector<CubicBezier> segments;
    const auto line = [&](const Vec2 &to) {
        segments.push_back(CubicBezier::line(segments.back().p3, to));
    };
    segments.push_back(CubicBezier::line({-70, 0}, {70, 0}));
    line({70, 40});
    line({24, 40});
    for (const CubicBezier &curve : side(1.0))
        segments.push_back(curve);
    line({22, 190});
    line({-22, 190});
    line({-22, 150});
    const auto left = side(-1.0);
    segments.push_back(left[1].reversed());
    segments.push_back(left[0].reversed());
    line({-70, 40});
    line({-70, 0});
    return Contour::fromSegments(segments).value();
}

/// Verdict and what is offered about it.
struct Verdict
{
    Session session;
    CheckList list{session};

    explicit Verdict(const Document &document)
    {
        session.reset(document);
        list.finish();
    }
    std::optional<Finding> verdict() const
    {
        for (const Finding &finding : list.all())
            if (finding.details<Held>())
                return finding;
        return {};
    }
    std::optional<Mend> offered(const ActionKind &kind) const
    {
        const auto finding = verdict();
        if (finding)
            for (const Mend &mend : list.mendsOf(*finding))
                if (mend.action.kind == &kind)
                    return mend;
        return {};
    }
    HoldVerdict holds() const { return session.scheduler().result(kHolding)->strength.verdict; }
};

/// Of what of the section is at this height: from, to.
std::pair<double, double> acrossAt(const Shape &shape, double height)
{
    double least = 1e9, most = -1e9;
    const Polygon &ring = shape.region().outer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 &p = ring[i], &q = ring[(i + 1) % ring.size()];
        if ((p.y() < height) == (q.y() < height))
            continue;
        const double x = p.x() + (height - p.y()) / (q.y() - p.y()) * (q.x() - p.x());
        least = std::min(least, x);
        most = std::max(most, x);
    }
    return {least, most};
}

} // namespace

class TestWiderNecks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void randomNecksBearByTheFormulaOfBeams();
    void whatIsUndoneIsAsItWas();
    void symmetricStaysSymmetric();
    void noRoomBetweenSlits();
    void beneathAHole();
    void fineAsAHair();
    void ofCopiesTheSource();
    void aFootUnderWhatHangsOver();
    void noFootInTheWay();
};

/// The oracle: N/(l t) + 6 M/(t l²) at all heights of the shank, with M of the weight and of what
/// is above.
// Wrong: a link after which it breaks all the same, or that makes it far wider than it has to be.
void TestWiderNecks::randomNecksBearByTheFormulaOfBeams()
{
    std::mt19937 random(20251125);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    int offered = 0;
    double widest = 0.0; // of what the formula asks for
    for (int trial = 0; trial < 60; ++trial) {
        const double waist = between(3.0, 12.0), height = between(75.0, 115.0);
        Stand stand(shank(waist, height, between(-6.0, 6.0)));
        const double x = between(-20.0, 20.0), mass = between(2.0, 12.0);
        stand.hang({x, 180.0}, mass);
        Verdict looked(stand.document);
        const auto verdict = looked.verdict();
        if (!verdict || verdict->severity <= Severity::Good)
            continue;
        const auto mend = looked.offered(kWiderNeck);
        QVERIFY2(mend, qPrintable(QStringLiteral("%1: waist %2 at %3, %4 kg at %5")
                                      .arg(trial)
                                      .arg(waist)
                                      .arg(height)
                                      .arg(mass)
                                      .arg(x)));
        ++offered;
        Verdict after(mend->edit->document);
        QCOMPARE(after.holds(), HoldVerdict::Holds);
        const Shape &shape = *mend->edit->document.find(stand.post)->shape;
        const Stock &stock = stand.stock();
        const double bears = *stock.tensileStrength / 2.0; // the safety factor
        double worst = 0.0;
        for (double y = 60.0; y < 140.0; y += 0.5) {
            const auto [from, to] = acrossAt(shape, y);
            const double l = to - from, middle = 0.5 * (from + to);
            double force = kGravity * mass, moment = kGravity * mass * (x - middle);
            for (double above = y + 0.5; above < 190.0; above += 1.0) {
                const auto [a, b] = acrossAt(shape, above);
                const double weight = kGravity * stock.density * 1e-9 * stock.thickness * (b - a);
                force += weight;
                moment += weight * (0.5 * (a + b) - middle);
            }
            const double t = stock.thickness;
            worst = std::max(worst, force / (l * t) + 6.0 * std::abs(moment) / (t * l * l));
        }
        QVERIFY2(worst < 1.03 * bears, qPrintable(QString::number(worst / bears)));
        widest = std::max(widest, bears / worst);
    }
    QVERIFY(offered >= 20);
    QVERIFY2(widest < 1.15, qPrintable(QString::number(widest)));
}

// Wrong: an edit that takes two steps back, or loses what hangs there.
void TestWiderNecks::whatIsUndoneIsAsItWas()
{
    Stand stand(shank(5.0, 95.0, 0.0));
    stand.hang({18.0, 180.0}, 4.0);
    Verdict looked(stand.document);
    const auto mend = looked.offered(kWiderNeck);
    QVERIFY(mend);
    QVERIFY2(messageText(mend->changes).contains(QStringLiteral("then: Holds")),
             qPrintable(messageText(mend->changes)));
    QCOMPARE(mend->edit->document.loads, stand.document.loads);
    looked.session.commit(QStringLiteral("Wider"), mend->edit->document);
    looked.session.history()->undo();
    QVERIFY(looked.session.committed().document.isSame(stand.document));
}

// Wrong: a mirrored contour that is so no more.
void TestWiderNecks::symmetricStaysSymmetric()
{
    const MirrorAxis axis{Vec2::Zero(), Vec2::UnitY()};
    Stand stand(shank(5.0, 95.0, 0.0), {}, axis);
    stand.hang({15.0, 180.0}, 4.0);
    Verdict looked(stand.document);
    QVERIFY(symmetryOf(*stand.document.find(stand.post)));
    const auto mend = looked.offered(kWiderNeck);
    QVERIFY(mend);
    QVERIFY(symmetryOf(*mend->edit->document.find(stand.post)));
    QCOMPARE(Verdict(mend->edit->document).holds(), HoldVerdict::Holds);
}

// Wrong: a contour that is pushed into a slit, or a slit that moves.
void TestWiderNecks::noRoomBetweenSlits()
{
    // Three plates through one arm: what is left between two of their slits is weak.
    Stand stand(polygonContour(
        {{-70, 0}, {70, 0}, {70, 30}, {9, 30}, {9, 190}, {-9, 190}, {-9, 30}, {-70, 30}}));
    for (const double height : {92.0, 99.0}) {
        NewSection shelf;
        shelf.shape = *Shape::make(polygonContour(rectangleAt(-40, -5, 80, 60)));
        shelf.frame = {Vec3(0.0, height, 0.0), Vec3::UnitX(), -Vec3::UnitZ()};
        stand.document = *addSection(std::move(stand.document), std::move(shelf));
    }
    stand.hang({8.0, 180.0}, 30.0);
    Verdict looked(stand.document);
    const auto verdict = looked.verdict();
    QVERIFY(verdict && verdict->severity > Severity::Good);
    if (const auto mend = looked.offered(kWiderNeck)) {
        Verdict after(mend->edit->document);
        QVERIFY(after.holds() == HoldVerdict::Holds || after.holds() == HoldVerdict::BarelyHolds);
        const auto &before = looked.list.model(), &now = after.list.model();
        QCOMPARE(now.sectionCount(), before.sectionCount());
        const auto is = after.session.scheduler().result(kHolding)->analysis;
        const auto was = looked.session.scheduler().result(kHolding)->analysis;
        QCOMPARE(is->assembly.joints.size(), was->assembly.joints.size());
        for (std::size_t i = 0; i < was->assembly.joints.size(); ++i) {
            const Joint &a = was->assembly.joints[i], &b = is->assembly.joints[i];
            QVERIFY((a.crossing->axis.at(a.crossing->overlaps[0].meet) -
                     b.crossing->axis.at(b.crossing->overlaps[0].meet))
                        .norm() < 0.06);
        }
    }
}

// Wrong: the material beside a hole is made wider on the far side of the section.
void TestWiderNecks::beneathAHole()
{
    Stand stand(
        polygonContour(
            {{-70, 0}, {70, 0}, {70, 30}, {16, 30}, {16, 190}, {-16, 190}, {-16, 30}, {-70, 30}}),
        {circle({0, 100}, 13.5)});
    stand.hang({12.0, 180.0}, 8.0);
    Verdict looked(stand.document);
    const auto verdict = looked.verdict();
    QVERIFY(verdict && verdict->severity > Severity::Good);
    const auto mend = looked.offered(kWiderNeck);
    QVERIFY(mend);
    const Shape &shape = *mend->edit->document.find(stand.post)->shape;
    QVERIFY(shape.isPlain());
    QCOMPARE(shape.holes().size(), std::size_t(1));
    // Wider where the hole is, on the outside or within.
    const auto [from, to] = acrossAt(shape, 100.0);
    QVERIFY(to - from > 32.0 + 0.1 ||
            !(shape.holes().front() == circle({0, 100}, 13.5).reversed()));
    QCOMPARE(Verdict(mend->edit->document).holds(), HoldVerdict::Holds);
}

// Wrong: steps that are shares of nothing, and never get anywhere.
void TestWiderNecks::fineAsAHair()
{
    Stand stand(shank(0.2, 95.0, 0.0));
    stand.hang({10.0, 180.0}, 1.0);
    Verdict looked(stand.document);
    const auto mend = looked.offered(kWiderNeck);
    QVERIFY(mend);
    QCOMPARE(Verdict(mend->edit->document).holds(), HoldVerdict::Holds);
}

// Wrong: a leg that is a copy cannot be mended, or becomes a section of its own.
void TestWiderNecks::ofCopiesTheSource()
{
    const auto loaded = io::readDocument(QStringLiteral(FFF_SAMPLES "/acrylic_thin_three.fff"));
    QVERIFY(loaded);
    Verdict looked(loaded->document);
    const auto mend = looked.offered(kWiderNeck);
    QVERIFY(mend);
    QCOMPARE(mend->edit->document.sections.size(), loaded->document.sections.size());
    QCOMPARE(mend->edit->document.operations, loaded->document.operations);
    QVERIFY(Verdict(mend->edit->document).holds() != HoldVerdict::Breaks);
}

namespace {

/// A crane: an arm, so high, that reaches out from a mast at its end.
Contour crane(double thick)
{
    return polygonContour({{-70, 0},
                           {40, 0},
                           {40, 30},
                           {15, 30},
                           {15, 120 - thick},
                           {160, 120 - thick},
                           {160, 120},
                           {-15, 120},
                           {-15, 30},
                           {-70, 30}});
}

} // namespace

// Wrong: a leg that does not reach the ground, or under which it breaks all the same.
void TestWiderNecks::aFootUnderWhatHangsOver()
{
    Stand stand(crane(9.0));
    stand.hang({30.0, 118.0}, 0.05);
    stand.hang({100.0, 115.0}, 0.9);
    // Against its falling over.
    stand.hang({-20.0, 15.0}, 2.0);
    Verdict looked(stand.document);
    const auto verdict = looked.verdict();
    QVERIFY(verdict && verdict->severity > Severity::Good);
    const auto mend = looked.offered(kSecondFoot);
    QVERIFY(mend);
    const Shape &shape = *mend->edit->document.find(stand.post)->shape;
    double farthest = 0.0;
    for (const Vec2 &p : shape.region().outer)
        if (std::abs(p.y()) < 1e-5)
            farthest = std::max(farthest, p.x());
    QVERIFY2(farthest > 60.0, qPrintable(QString::number(farthest)));
    QCOMPARE(Verdict(mend->edit->document).holds(), HoldVerdict::Holds);
}

// Wrong: a leg through another section.
void TestWiderNecks::noFootInTheWay()
{
    Stand stand(crane(9.0));
    stand.hang({100.0, 115.0}, 0.9);
    stand.hang({-60.0, 15.0}, 4.0);
    NewSection floor; // under all of the arm, and through the mast
    floor.shape = *Shape::make(polygonContour(rectangleAt(-14, -60, 200, 120)));
    floor.frame = {Vec3(0.0, 60.0, 0.0), Vec3::UnitX(), -Vec3::UnitZ()};
    stand.document = *addSection(std::move(stand.document), std::move(floor));
    Verdict looked(stand.document);
    QVERIFY(!looked.offered(kSecondFoot));
}

FFF_TEST(TestWiderNecks)
#include "tst_wider_necks.moc"
