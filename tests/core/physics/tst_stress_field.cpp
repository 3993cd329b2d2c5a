// Stress all over a plate: at points that are known, and at corners, where a mesh knows none.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/physics/plate_attachment.h"
#include "core/physics/stress_field.h"
#include "tests/core/physics/reference_plates.h"
#include "tests/test_program.h"
#include "tests/told.h"

#include <cmath>

using namespace fff;
using namespace fff::test;

namespace {

/// Of a face of the field at a point, by going through all triangles.
double useAt(const StressField &field, std::size_t face, const Vec2 &point)
{
    double best = -1e9, use = 0.0;
    for (const auto &t : field.triangles) {
        std::array<Vec2, 3> p;
        for (std::size_t k = 0; k < 3; ++k)
            p[k] = field.points[static_cast<std::size_t>(t[k])];
        const double whole = cross(p[1] - p[0], p[2] - p[0]);
        std::array<double, 3> share;
        for (std::size_t k = 0; k < 3; ++k)
            share[k] = cross(p[(k + 1) % 3] - point, p[(k + 2) % 3] - point) / whole;
        const double inside = *std::min_element(share.begin(), share.end());
        if (inside > best) {
            best = inside;
            use = 0.0;
            for (std::size_t k = 0; k < 3; ++k)
                use +=
                    share[k] * static_cast<double>(field.use[face][static_cast<std::size_t>(t[k])]);
        }
    }
    return use;
}

/// A bracket whose inner corner is sharp, at (30, 30): pulled at its foot, built in at its top.
PlateModel bracket(double fineness)
{
    const Region region{{{0, 0}, {90, 0}, {90, 30}, {30, 30}, {30, 120}, {0, 120}}, {}};
    PlateMeshOptions options;
    options.fineness = fineness;
    return PlateModel::make(*plateMesh(region, options), {4.0, 3200.0, 0.37, 1.19e-6},
                            {{{0, 120}, {30, 120}}})
        .value();
}

StressField bracketField(const PlateModel &model, double cornerUse, double newtons = 20.0)
{
    PlateField forces = model.noField();
    addWrench(forces, model, discAttachment(model, {82, 15}, 6.0),
              WrenchVector::Unit(1) * -newtons);
    const std::vector<PlateField> cases{model.solve(forces)};
    const std::vector<double> corners(model.mesh().sharp.size(), cornerUse);
    return stressField(model, cases, 25.0, corners);
}

} // namespace

class TestStressField : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatSolversInSpaceFind_data();
    void whatSolversInSpaceFind();
    void bentAcrossItIsThatOfABeam();
    void aCornerIsWhatIsSaidOfIt();
    void aCornerIsNoneOfTheMeshsMatter();
    void theWorstOfSeveralCases();
    void sagsAsThePlateDoes();
};

void TestStressField::whatSolversInSpaceFind_data()
{
    QTest::addColumn<QString>("file");
    for (const char *name :
         {"c01_cantilever_inplane", "c02_cantilever_outofplane", "c08_tapered_cantilever"})
        QTest::newRow(name)
            << QStringLiteral(FFF_SHARED "/mechanics/cases/%1.json").arg(QLatin1String(name));
}

// Wrong: another colour at the edge of a cut than its stress has.
void TestStressField::whatSolversInSpaceFind()
{
    QFETCH(QString, file);
    QString error;
    const auto found = readReferenceCase(file, &error);
    if (!found)
        FFF_WITHOUT_SHARED();
    const auto plate = plateOf(*found, 0);
    QVERIFY(plate.has_value());
    const std::vector<PlateField> cases{plate->model.solve(plate->loads)};
    const double strength = 30.0;
    const StressField field = stressField(plate->model, cases, strength, {});
    int compared = 0;
    for (const ReferenceCut &cut : found->truth.cuts) {
        if (cut.name.starts_with("skew"))
            continue; // not square to the member: what is normal to it is not the largest
        double worst = 0.0;
        for (const std::size_t face : {0u, 1u})
            for (const double share : {0.0, 0.5, 1.0})
                worst = std::max(worst, useAt(field, face, cut.from + share * (cut.to - cut.from)));
        const double truth = cut.said("sigma_lin").value() / strength;
        QVERIFY2(std::abs(worst / truth - 1.0) < 0.05,
                 qPrintable(QString::fromStdString(cut.name) +
                            QStringLiteral(": %1").arg(worst / truth)));
        ++compared;
    }
    QVERIFY(compared >= 2);
}

// Wrong: half or twice the stress on a face, or on one of them none.
void TestStressField::bentAcrossItIsThatOfABeam()
{
    const double l = 200.0, b = 20.0, t = 5.0, force = 1.5, strength = 40.0;
    const Region region{{{0, 0}, {l, 0}, {l, b}, {0, b}}, {}};
    const PlateModel model =
        PlateModel::make(*plateMesh(region), {t, 3200.0, 0.3, 1.19e-6}, {{{0, 0}, {0, b}}}).value();
    PlateField forces = model.noField();
    addWrench(forces, model, discAttachment(model, {l - 5.0, b / 2}, 5.0),
              WrenchVector::Unit(2) * force);
    const std::vector<PlateField> cases{model.solve(forces)};
    const StressField field = stressField(model, cases, strength, {});
    for (const double x : {40.0, 80.0, 120.0, 150.0}) {
        const double beam = 6.0 * force * (l - 5.0 - x) / (b * t * t) / strength;
        for (const std::size_t face : {0u, 1u}) {
            const double ours = useAt(field, face, {x, b / 2});
            QVERIFY2(std::abs(ours / beam - 1.0) < 0.04, qPrintable(QString::number(ours / beam)));
        }
    }
}

// Wrong: a corner that cracks in the colour of what is around it; or a wide spot of it.
void TestStressField::aCornerIsWhatIsSaidOfIt()
{
    const PlateModel model = bracket(1.0);
    QCOMPARE(model.mesh().sharp.size(), std::size_t(1));
    const StressField plain = bracketField(model, 0.0), said = bracketField(model, 1.7);
    QVERIFY(plain.most < 1.0f);
    QVERIFY(std::abs(said.most - 1.7f) < 1e-5f);
    for (const std::size_t face : {0u, 1u}) {
        QVERIFY(std::abs(useAt(said, face, {30, 30}) - 1.7) < 1e-5);
        for (std::size_t i = 0; i < plain.points.size(); ++i)
            if ((plain.points[i] - Vec2(30, 30)).norm() >= 2.0) // half of the thickness
                QCOMPARE(said.use[face][i], plain.use[face][i]);
    }
}

// Wrong: redder the finer the mesh. The bare stress at the corner has no bound: it goes on rising.
void TestStressField::aCornerIsNoneOfTheMeshsMatter()
{
    const PlateModel plain = bracket(1.0), fine = bracket(4.0);
    const auto ours = [](const PlateModel &model) {
        return static_cast<double>(bracketField(model, 0.0).most);
    };
    const auto bare = [](const PlateModel &model) {
        PlateField forces = model.noField();
        addWrench(forces, model, discAttachment(model, {82, 15}, 6.0),
                  WrenchVector::Unit(1) * -20.0);
        const PlateStress stress = plateStress(model, model.solve(forces));
        double worst = 0.0;
        for (int i = 0; i < static_cast<int>(model.mesh().points.size()); ++i)
            worst = std::max(worst, principalStress(stress.face(i, 1)).first);
        return worst;
    };
    const double grown = ours(fine) / ours(plain), bareGrown = bare(fine) / bare(plain);
    QVERIFY2(grown < 1.4 && bareGrown > 1.15 * grown,
             qPrintable(QStringLiteral("%1, bare %2").arg(grown).arg(bareGrown)));
}

// Wrong: a case that is left out, or one that hides another.
void TestStressField::theWorstOfSeveralCases()
{
    const PlateModel model = bracket(1.0);
    std::vector<PlateField> cases;
    std::vector<StressField> alone;
    for (const int way : {0, 1, 2}) {
        PlateField forces = model.noField();
        addWrench(forces, model, discAttachment(model, {82, 15}, 6.0),
                  WrenchVector::Unit(way) * (way == 2 ? 2.0 : 20.0));
        cases.push_back(model.solve(forces));
        alone.push_back(stressField(model, {&cases.back(), 1}, 25.0, {}));
    }
    const StressField all = stressField(model, cases, 25.0, {});
    for (const std::size_t face : {0u, 1u})
        for (std::size_t i = 0; i < all.points.size(); ++i)
            QCOMPARE(all.use[face][i], std::max({alone[0].use[face][i], alone[1].use[face][i],
                                                 alone[2].use[face][i]}));
    QVERIFY(all.moved == alone[0].moved);
    const StressField none = stressField(model, {}, 25.0, {});
    QCOMPARE(none.most, 0.0f);
}

// Wrong: a plate that is drawn to bend in kinks, or another way than its model.
void TestStressField::sagsAsThePlateDoes()
{
    const double l = 200.0, b = 20.0, t = 6.0, e = 3200.0, force = 2.0;
    const Region region{{{0, 0}, {l, 0}, {l, b}, {0, b}}, {}};
    const PlateModel model =
        PlateModel::make(*plateMesh(region), {t, e, 0.0, 1.19e-6}, {{{0, 0}, {0, b}}}).value();
    PlateField forces = model.noField();
    addWrench(forces, model, discAttachment(model, {l - 5.0, b / 2}, 5.0),
              WrenchVector::Unit(2) * force);
    const std::vector<PlateField> cases{model.solve(forces)};
    const StressField field = stressField(model, cases, 25.0, {});
    const double arm = l - 5.0, stiff = e * b * t * t * t / 12.0;
    for (std::size_t i = 0; i < field.points.size(); ++i) {
        const double x = field.points[i].x();
        if (x > arm - 10.0)
            continue;
        const double beam = force * x * x * (3.0 * arm - x) / (6.0 * stiff);
        QVERIFY(std::abs(static_cast<double>(field.moved[i].z()) - beam) <
                0.01 * force * arm * arm * arm / (3.0 * stiff));
    }
}

FFF_TEST(TestStressField)
#include "tst_stress_field.moc"
