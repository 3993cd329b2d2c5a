// What a joint does to the prongs beside its slit, against finite elements and by its laws.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/physics/plate_attachment.h"
#include "core/physics/plate_stress.h"
#include "core/physics/wall_pressure.h"
#include "tests/core/physics/loaded_section.h"
#include "tests/test_program.h"

#include <Eigen/LU>

#include <numeric>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

/// A leg with a slit in its left end, held on the right: y from 0 to `low + high + 6`, prongs `low`
/// and `high` mm deep and 30 long.
Sample slitLeg(double low, double high, const Vec3 &force, double turning)
{
    const double top = low + 6.0 + high;
    Sample s;
    s.region.outer = {{0, 0},         {90, 0},         {90, top}, {0, top},
                      {0, low + 6.0}, {30, low + 6.0}, {30, low}, {0, low}};
    s.slits = {{{30, low + 3.0}, {-1, 0}, 30.0, 6.0}};
    AppliedForce link = forceAt({30, low + 3.0}, force, {0, 0, turning});
    link.kind = ForceKind::Link;
    link.slit = s.slits.front();
    s.forces = heldAt({90, 0.5 * top}, {link});
    s.sheet.thickness = 6.0;
    return s;
}

/// Pressing points of a wall, or of both, and what they feel of each other.
class Walls
{
public:
    explicit Walls(const Sample &s)
        : m_model(PlateModel::make(plateMesh(s.region).value(), {6.0, 3200.0, 0.37, 1.19e-6},
                                   {{{90, 0}, {90, s.region.outer[2].y()}}})
                      .value())
    {
        const SlitLine &slit = s.slits.front();
        for (int i = 0; i < 2 * kAlong; ++i) {
            const bool isLeft = i < kAlong;
            const Vec2 e = (isLeft ? 1.0 : -1.0) * perpendicular(slit.opening);
            const double along = (i % kAlong + 0.5) / kAlong * slit.depth;
            m_along.push_back(along);
            m_ways.push_back(e);
            m_places.push_back(
                m_model.place(slit.root + along * slit.opening + 0.5 * slit.width * e));
        }
    }

    static constexpr int kAlong = 24;
    const PlateModel &model() const { return m_model; }
    double along(int i) const { return m_along[static_cast<std::size_t>(i)]; }
    static bool isLeft(int i) { return i < kAlong; }

    PlateField forces(const Eigen::VectorXd &pressed) const
    {
        PlateField field = m_model.noField();
        for (int i = 0; i < 2 * kAlong; ++i) {
            const auto k = static_cast<std::size_t>(i);
            m_model.addForce(field, m_places[k],
                             pressed[i] * Vec3(m_ways[k].x(), m_ways[k].y(), 0.0));
        }
        return field;
    }

    /// What a stiff partner with its faces on both walls presses, pushed across by F and turned by
    /// M: least strain energy of walls that can only be pressed.
    Eigen::VectorXd contact(double across, double turning) const
    {
        constexpr int kCount = 2 * kAlong;
        Eigen::MatrixXd gives(kCount, kCount);
        for (int i = 0; i < kCount; ++i) {
            const PlateField moved = m_model.solve(forces(Eigen::VectorXd::Unit(kCount, i)));
            for (int k = 0; k < kCount; ++k) {
                const auto at = static_cast<std::size_t>(k);
                gives(k, i) = m_ways[at].dot(m_model.displacement(moved, m_places[at]).head<2>());
            }
        }
        std::vector<int> touching(kCount);
        std::iota(touching.begin(), touching.end(), 0);
        for (;;) {
            const auto n = static_cast<Eigen::Index>(touching.size());
            Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 2, n + 2);
            Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 2);
            right.tail<2>() << across, turning;
            for (Eigen::Index i = 0; i < n; ++i) {
                const int a = touching[static_cast<std::size_t>(i)];
                const double sign = isLeft(a) ? 1.0 : -1.0;
                system(i, n) = system(n, i) = sign;
                system(i, n + 1) = system(n + 1, i) = sign * along(a);
                for (Eigen::Index k = 0; k < n; ++k)
                    system(i, k) = gives(a, touching[static_cast<std::size_t>(k)]);
            }
            const Eigen::VectorXd found = system.fullPivLu().solve(right).head(n);
            Eigen::Index least = 0;
            if (found.minCoeff(&least) >= -1e-9) {
                Eigen::VectorXd all = Eigen::VectorXd::Zero(kCount);
                for (Eigen::Index i = 0; i < n; ++i)
                    all[touching[static_cast<std::size_t>(i)]] = found[i];
                return all;
            }
            touching.erase(touching.begin() + least);
        }
    }

private:
    PlateModel m_model;
    std::vector<double> m_along;
    std::vector<Vec2> m_ways;
    std::vector<PlateLocator::Place> m_places;
};

} // namespace

class TestWallPressure : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void wrenchIsAllThere();
    void prongsBearAsInFiniteElements_data();
    void prongsBearAsInFiniteElements();
    void prongRootIsAmongTheCuts();
    void bothSidesAgree();
    void wallThatIsNotThereBearsNothing();
};

void TestWallPressure::wrenchIsAllThere()
{
    // Wrong: walls bear more or less than the joint gives them, or one with play is pulled.
    std::mt19937 random(4);
    std::uniform_real_distribution<double> any(-50, 50), share(0, 1);
    for (int i = 0; i < 200; ++i) {
        AppliedForce link = forceAt({0, 0}, {any(random), any(random), 0}, {0, 0, any(random)});
        link.slit = {{0, 0}, Vec2(any(random), any(random)).normalized(), 1.0 + share(random), 3.0};
        const WallPressure pressure(link);
        const double at = share(random);
        const SlitFit fit = i % 2 == 0 ? SlitFit::Loose : SlitFit::Tight;
        double force = 0.0, moment = 0.0;
        for (const bool isLeft : {true, false}) {
            for (const WallForce &part :
                 {pressure.on(isLeft, 0.0, at, fit), pressure.on(isLeft, at, 1.0, fit)}) {
                QVERIFY(fit == SlitFit::Tight || (isLeft ? part.force >= 0.0 : part.force <= 0.0));
                force += part.force;
                moment += part.moment;
            }
        }
        const double across = perpendicular(link.slit.opening).dot(link.force.head<2>());
        QVERIFY(std::abs(force - across) < 1e-9);
        QVERIFY(std::abs(moment - link.moment.z()) < 1e-9);
    }
}

void TestWallPressure::prongsBearAsInFiniteElements_data()
{
    QTest::addColumn<double>("low"); // mm: depth of the prongs
    QTest::addColumn<double>("high");
    QTest::addColumn<double>("across");  // N
    QTest::addColumn<double>("turning"); // N·mm
    for (const auto &[low, high] : {std::pair{12.0, 12.0}, {17.0, 17.0}, {8.0, 20.0}})
        for (const auto &[across, turning] : {std::pair{0.0, 100.0},
                                              {0.0, -100.0},
                                              {10.0, 0.0},
                                              {5.0, 150.0},
                                              {5.0, -150.0},
                                              {10.0, 150.0}})
            QTest::addRow("prongs of %g and %g under %g N and %g N·mm", low, high, across, turning)
                << low << high << across << turning;
}

void TestWallPressure::prongsBearAsInFiniteElements()
{
    // Wrong: a prong beside a slit bears less than where a stiff partner presses on its wall, or is
    // glued to both, or much more of a moment than in the worse of these.
    QFETCH(double, low);
    QFETCH(double, high);
    QFETCH(double, across);
    QFETCH(double, turning);
    const Sample s = slitLeg(low, high, {0, -across, 0}, turning); // its left wall is the lower
    const PieceShape shape(s.region, s.slits);
    const Walls walls(s);
    const auto stressUnder = [&walls](const PlateField &field) {
        return plateStress(walls.model(), walls.model().solve(field));
    };
    const PlateStress contact = stressUnder(walls.forces(walls.contact(across, turning)));
    Eigen::VectorXd linear(2 * Walls::kAlong);
    const WallPressure pressure(s.forces.front());
    for (int i = 0; i < 2 * Walls::kAlong; ++i) {
        const double from = static_cast<double>(i % Walls::kAlong) / Walls::kAlong;
        linear[i] = std::abs(pressure.on(Walls::isLeft(i), from, from + 1.0 / Walls::kAlong).force);
    }
    const PlateStress same = stressUnder(walls.forces(linear));
    PlateField glued = walls.model().noField();
    WrenchVector wrench;
    wrench << 0, -across, 0, 0, 0, turning;
    addWrench(glued, walls.model(),
              slitAttachment(walls.model(), {{30, low + 3.0}, {-1, 0}, 30.0, 6.0, 30.0, 6.0}),
              wrench);
    const PlateStress bonded = stressUnder(glued);
    const double top = s.region.outer[2].y();
    for (const double x : {29.0, 25.0}) {
        double worst = 0.0, worstPressed = 0.0;
        for (const auto &[from, to] :
             {std::pair{Vec2(x, 0), Vec2(x, low)}, std::pair{Vec2(x, low + 6.0), Vec2(x, top)}}) {
            const auto found = stressOnLine(shape, s.forces, s.sheet, from, to);
            QVERIFY(found.has_value());
            const auto in = [&walls, from = from, to = to](const PlateStress &stress) {
                return plateCut(walls.model(), stress, from, to).linear;
            };
            const double here = found->stress.linear(), pressed = in(contact), held = in(bonded);
            const QString said = QStringLiteral("%1: %2, pressed %3, bonded %4")
                                     .arg(x)
                                     .arg(here)
                                     .arg(pressed)
                                     .arg(held);
            QVERIFY2(found->stress.neck >= 0.95 * std::max(pressed, held) - 0.01, qPrintable(said));
            QVERIFY2(here <= 1.03 * std::max(in(same), held) + 0.01, qPrintable(said));
            worst = std::max(worst, here);
            worstPressed = std::max(worstPressed, std::max(pressed, held));
        }
        if (across == 0.0 && x == 29.0)
            QVERIFY2(worst <= 1.3 * worstPressed, qPrintable(QString::number(worst)));
    }
}

void TestWallPressure::prongRootIsAmongTheCuts()
{
    // Wrong: the root of a prong, which breaks off first, is not looked at.
    const Sample s = slitLeg(8.0, 20.0, {0, 0, 0}, 150.0);
    const SectionStress stress = stressOfSample(s);
    const auto root = std::max_element(
        stress.necks.begin(), stress.necks.end(), [](const NeckStress &a, const NeckStress &b) {
            return (a.kind == SampleKind::ProngRoot ? a.neckUse : 0.0) <
                   (b.kind == SampleKind::ProngRoot ? b.neckUse : 0.0);
        });
    QVERIFY(root != stress.necks.end() && root->kind == SampleKind::ProngRoot);
    QVERIFY(std::abs(root->length - 8.0) < 1e-9);
    // The lower one, by 1.25 · 150 N·mm at 8 mm by 6 mm.
    QVERIFY2(std::abs(root->stress.inPlane - 2.93) < 0.01,
             qPrintable(QString::number(root->stress.inPlane)));
    QVERIFY(worstOf(stress) >= root->neckUse);
    QVERIFY(stress.imbalanceShare < 1e-12);
}

void TestWallPressure::bothSidesAgree()
{
    // Wrong: a cut through a prong, or from a wall, gives its two sides different forces.
    const Sample s = slitLeg(12.0, 14.0, {2, -5, 1}, 150.0);
    const PieceShape shape(s.region, s.slits);
    const std::pair<Vec2, Vec2> lines[] = {{{20, 0}, {20, 12}}, {{10, 0}, {18, 12}},
                                           {{15, 18}, {9, 32}}, {{29.9, 18}, {29.9, 32}},
                                           {{30, 12}, {40, 0}}, {{50, 0}, {50, 32}}};
    for (const auto &[from, to] : lines) {
        const auto there = stressOnLine(shape, s.forces, s.sheet, from, to);
        const auto back = stressOnLine(shape, s.forces, s.sheet, to, from);
        QVERIFY(there && back);
        QVERIFY(std::abs(there->forces.axial - back->forces.axial) < 1e-9);
        QVERIFY(std::abs(there->forces.shear - back->forces.shear) < 1e-9);
        QVERIFY(std::abs(there->forces.inPlane + back->forces.inPlane) < 1e-9);
        QVERIFY(std::abs(there->stress.neck - back->stress.neck) < 1e-9);
    }
}

void TestWallPressure::wallThatIsNotThereBearsNothing()
{
    // Wrong: what presses towards a prong that is not there is lost.
    Sample s = slitLeg(12.0, 12.0, {0, -5, 0}, 150.0);
    s.region.outer = {{30, 12}, {30, 0}, {90, 0}, {90, 30}, {0, 30}, {0, 18}, {30, 18}};
    const PieceShape shape(s.region, s.slits);
    const auto root = stressOnLine(shape, s.forces, s.sheet, {29.999, 18}, {29.999, 30});
    QVERIFY(root.has_value());
    QVERIFY(std::abs(std::abs(root->forces.shear) - 5.0) < 0.01);
    QVERIFY(std::abs(root->forces.inPlane) > 149.0);
    const auto leg = stressOnLine(shape, s.forces, s.sheet, {60, 0}, {60, 30});
    QVERIFY(leg.has_value());
    QVERIFY(std::abs(std::abs(leg->forces.shear) - 5.0) < 1e-9);
}

FFF_TEST(TestWallPressure)
#include "tst_wall_pressure.moc"
