// Plates as finite elements: even strain and bending, beams of books, what they weigh.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/physics/plate_element.h"
#include "core/physics/plate_stress.h"
#include "tests/core/physics/plate_samples.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

std::vector<bool> isOnBoundary(const PlateMesh &mesh)
{
    std::vector<int> uses(mesh.points.size(), 0);
    for (const auto &triangle : mesh.triangles) {
        for (std::size_t k = 3; k < 6; ++k)
            ++uses[static_cast<std::size_t>(triangle[k])];
    }
    std::vector<bool> result(mesh.points.size(), false);
    for (const auto &triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (uses[static_cast<std::size_t>(triangle[3 + k])] > 1)
                continue;
            for (const std::size_t at : {3 + k, (k + 1) % 3, (k + 2) % 3})
                result[static_cast<std::size_t>(triangle[at])] = true;
        }
    }
    return result;
}

} // namespace

class TestPlateModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void patchTestOfTheMembrane();
    void patchTestOfBending();
    void cantileverInItsPlane();
    void cantileverAcross();
    void weightIsAllThere();
};

void TestPlateModel::patchTestOfTheMembrane()
{
    const PlateMesh mesh = plateMesh(slitPlate()).value();
    const PlaneElasticity elasticity = planeStress(3200.0, 0.37);
    Eigen::Matrix2d gradient;
    gradient << 1e-3, 2e-3, -5e-4, 3e-3;
    Eigen::VectorXd forces =
        Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(mesh.points.size()));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        Eigen::Matrix<double, 12, 1> moved;
        for (std::size_t k = 0; k < 6; ++k)
            moved.segment<2>(2 * static_cast<Eigen::Index>(k)) =
                gradient * mesh.points[static_cast<std::size_t>(mesh.triangles[i][k])];
        const Eigen::Matrix<double, 12, 1> held =
            membraneStiffness(cornersOf(mesh, i), elasticity, 6.0) * moved;
        for (std::size_t k = 0; k < 6; ++k)
            forces.segment<2>(2 * mesh.triangles[i][k]) +=
                held.segment<2>(2 * static_cast<Eigen::Index>(k));
    }
    // Wrong: even strain needs forces inside the plate: the triangles do not pass the patch test.
    const std::vector<bool> isOutside = isOnBoundary(mesh);
    double worst = 0.0;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        if (!isOutside[i])
            worst = std::max(worst, forces.segment<2>(2 * static_cast<Eigen::Index>(i)).norm());
    }
    QVERIFY(worst < 1e-10 * forces.cwiseAbs().maxCoeff());
    QVERIFY(forces.cwiseAbs().maxCoeff() > 1.0);
}

void TestPlateModel::patchTestOfBending()
{
    // w = x² / 2 a + x y b + y² / 2 c: even curvature.
    const PlateModel model = modelOf(slitPlate(), kSixMillimetres);
    const PlateMesh &mesh = model.mesh();
    const double a = 1e-4, b = 3e-5, c = -2e-4;
    PlateField field = model.noField();
    Eigen::VectorXd forces = field.bending;
    for (int i = 0; i < mesh.corners; ++i) {
        const Vec2 &p = mesh.points[static_cast<std::size_t>(i)];
        field.bending.segment<3>(3 * i)
            << 0.5 * a * p.x() * p.x() + b * p.x() * p.y() + 0.5 * c * p.y() * p.y(),
            b * p.x() + c * p.y(), -(a * p.x() + b * p.y());
    }
    const PlaneElasticity elasticity = planeStress(3200.0, 0.37);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        Eigen::Matrix<double, 9, 1> bent;
        for (int k = 0; k < 3; ++k)
            bent.segment<3>(3 * k) =
                field.bending.segment<3>(3 * mesh.triangles[i][static_cast<std::size_t>(k)]);
        const Eigen::Matrix<double, 9, 1> held =
            bendingStiffness(cornersOf(mesh, i), elasticity, 6.0) * bent;
        for (int k = 0; k < 3; ++k)
            forces.segment<3>(3 * mesh.triangles[i][static_cast<std::size_t>(k)]) +=
                held.segment<3>(3 * k);
    }
    // Wrong: even bending needs forces inside the plate, or gives uneven moments.
    const std::vector<bool> isOutside = isOnBoundary(mesh);
    double worst = 0.0;
    for (int i = 0; i < mesh.corners; ++i) {
        if (!isOutside[static_cast<std::size_t>(i)])
            worst = std::max(worst, forces.segment<3>(3 * i).norm());
    }
    QVERIFY(worst < 1e-9 * forces.cwiseAbs().maxCoeff());
    const Vec3 expected = -18.0 * (elasticity * Vec3(a, c, 2.0 * b)); // t³ / 12
    const PlateStress stress = plateStress(model, field);
    for (Eigen::Index i = 0; i < stress.moment.cols(); ++i)
        QVERIFY((stress.moment.col(i) - expected).norm() < 1e-8 * expected.norm());
    QVERIFY(stress.shear.cwiseAbs().maxCoeff() < 1e-8 * expected.norm());
}

void TestPlateModel::cantileverInItsPlane()
{
    const double l = 200.0, h = 30.0, t = 6.0, e = 3200.0, nu = 0.37, force = 10.0;
    const PlateModel model =
        modelOf({rectangle(0, 0, l, h), {}}, {t, e, nu, 1.19e-6}, {{{0, 0}, {0, h}}});
    PlateField forces = model.noField();
    addWrench(forces, model, discAttachment(model, {l - 5, h / 2}, 5.0),
              WrenchVector::Unit(1) * force);
    const double tip = model.displacement(model.solve(forces), model.place({l - 5, h / 2})).y();
    const double arm = l - 5, inertia = t * h * h * h / 12.0, g = e / (2.0 * (1.0 + nu));
    const double closed =
        force * arm * arm * arm / (3.0 * e * inertia) + 1.2 * force * arm / (g * t * h);
    // Wrong: a shelf bracket gives more or less than a beam of its measures.
    QVERIFY(std::abs(tip / closed - 1.0) < 0.01);
}

void TestPlateModel::cantileverAcross()
{
    const double l = 200.0, b = 20.0, t = 6.0, e = 3200.0, force = 2.0;
    const PlateModel model =
        modelOf({rectangle(0, 0, l, b), {}}, {t, e, 0.37, 1.19e-6}, {{{0, 0}, {0, b}}});
    PlateField forces = model.noField();
    addWrench(forces, model, discAttachment(model, {l - 5, b / 2}, 5.0),
              WrenchVector::Unit(2) * force);
    const double tip = model.displacement(model.solve(forces), model.place({l - 5, b / 2})).z();
    const double arm = l - 5, inertia = b * t * t * t / 12.0;
    // Wrong: a shelf sags by more or less than a beam of its measures; one built in at its whole
    // width by a little less.
    QVERIFY(std::abs(tip * 3.0 * e * inertia / (force * arm * arm * arm) - 0.99) < 0.015);
}

void TestPlateModel::weightIsAllThere()
{
    const PlateModel model = modelOf(slitPlate(), kSixMillimetres);
    PlateField forces = model.noField();
    model.addWeight(forces, {1.0, -9.81, 2.0});
    const double mass = area(slitPlate()) * 6.0 * 1.19e-6;
    double x = 0.0, y = 0.0, z = 0.0;
    for (Eigen::Index i = 0; i < forces.membrane.size(); i += 2) {
        x += forces.membrane[i];
        y += forces.membrane[i + 1];
    }
    for (Eigen::Index i = 0; i < forces.bending.size(); i += 3)
        z += forces.bending[i];
    // Wrong: a plate weighs something else than its mass.
    QVERIFY(std::abs(x - mass) < 1e-9 * mass);
    QVERIFY(std::abs(y + 9.81 * mass) < 1e-8 * mass);
    QVERIFY(std::abs(z - 2.0 * mass) < 1e-8 * mass);
}

FFF_TEST(TestPlateModel)
#include "tst_plate_model.moc"
