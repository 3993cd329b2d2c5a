#include "core/physics/plate_stress.h"

#include <cmath>

namespace fff {

namespace {

constexpr int kCutSteps = 200;
constexpr double kSharpZone = 0.5; // of the thickness

/// Shares of the six points of a triangle.
std::array<Barycentric, 6> pointShares()
{
    return {Barycentric(1, 0, 0),     Barycentric(0, 1, 0),     Barycentric(0, 0, 1),
            Barycentric(0, 0.5, 0.5), Barycentric(0.5, 0, 0.5), Barycentric(0.5, 0.5, 0)};
}

struct TriangleStress
{
    std::array<Vec3, 6> membrane, moment;
};

TriangleStress triangleStress(const PlateModel &model, const PlateField &field,
                              std::size_t triangle, const PlaneElasticity &elasticity)
{
    const PlateCorners corners = cornersOf(model.mesh(), triangle);
    const auto &points = model.mesh().triangles[triangle];
    Eigen::Matrix<double, 12, 1> moved;
    Eigen::Matrix<double, 9, 1> bent;
    for (int i = 0; i < 6; ++i)
        moved.segment<2>(2 * i) =
            field.membrane.segment<2>(2 * points[static_cast<std::size_t>(i)]);
    for (int i = 0; i < 3; ++i)
        bent.segment<3>(3 * i) = field.bending.segment<3>(3 * points[static_cast<std::size_t>(i)]);
    const Eigen::Matrix<double, 12, 1> slopes = plateSlopes(corners) * bent;
    const double t = model.material().thickness;
    TriangleStress stress;
    const auto shares = pointShares();
    for (std::size_t i = 0; i < 6; ++i) {
        const Eigen::Matrix<double, 3, 12> strain = membraneStrain(corners, shares[i]);
        stress.membrane[i] = elasticity * (strain * moved);
        stress.moment[i] = -t * t * t / 12.0 * (elasticity * (strain * slopes));
    }
    return stress;
}

/// xx, yy, xy seen from axes m and v = m turned by 90°: mm, mv.
Vec2 across(const Vec3 &stress, const Vec2 &m)
{
    const Vec2 v = perpendicular(m);
    const Vec2 on(stress[0] * m.x() + stress[2] * m.y(), stress[2] * m.x() + stress[1] * m.y());
    return {on.dot(m), on.dot(v)};
}

/// The shear balances the moments: their divergence, of the averages, linear between corners.
void setShear(PlateStress &stress, const PlateMesh &mesh, const Eigen::VectorXd &weights)
{
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const PlateCorners corners = cornersOf(mesh, i);
        const auto &points = mesh.triangles[i];
        Eigen::Matrix2d sides;
        sides << (corners[1] - corners[0]).transpose(), (corners[2] - corners[0]).transpose();
        Eigen::Matrix<double, 2, 3> differences;
        differences << (stress.moment.col(points[1]) - stress.moment.col(points[0])).transpose(),
            (stress.moment.col(points[2]) - stress.moment.col(points[0])).transpose();
        const Eigen::Matrix<double, 2, 3> gradient = sides.inverse() * differences;
        const Vec2 shear(gradient(0, 0) + gradient(1, 2), gradient(0, 2) + gradient(1, 1));
        for (const int point : points)
            stress.shear.col(point) += 0.5 * sides.determinant() / weights[point] * shear;
    }
}

} // namespace

Vec3 PlateStress::face(int point, int side) const
{
    return membrane.col(point) + moment.col(point) * (side * 6.0 / (thickness * thickness));
}

PlateStress plateStress(const PlateModel &model, const PlateField &displacements)
{
    const PlateMesh &mesh = model.mesh();
    const auto count = static_cast<Eigen::Index>(mesh.points.size());
    PlateStress stress{Eigen::Matrix3Xd::Zero(3, count), Eigen::Matrix3Xd::Zero(3, count),
                       Eigen::Matrix2Xd::Zero(2, count), model.material().thickness};
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(count);
    const PlaneElasticity elasticity =
        planeStress(model.material().modulus, model.material().poisson);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const TriangleStress there = triangleStress(model, displacements, i, elasticity);
        const PlateCorners corners = cornersOf(mesh, i);
        const double area = 0.5 * cross(corners[1] - corners[0], corners[2] - corners[0]);
        for (std::size_t k = 0; k < 6; ++k) {
            const int point = mesh.triangles[i][k];
            stress.membrane.col(point) += area * there.membrane[k];
            stress.moment.col(point) += area * there.moment[k];
            weights[point] += area;
        }
    }
    for (Eigen::Index i = 0; i < count; ++i) {
        stress.membrane.col(i) /= weights[i];
        stress.moment.col(i) /= weights[i];
    }
    setShear(stress, mesh, weights);
    return stress;
}

PrincipalStress principalStress(const Vec3 &stress)
{
    const double middle = 0.5 * (stress[0] + stress[1]);
    const double radius = std::hypot(0.5 * (stress[0] - stress[1]), stress[2]);
    const double turn = 0.5 * std::atan2(stress[2], 0.5 * (stress[0] - stress[1]));
    return {middle + radius, middle - radius, {std::cos(turn), std::sin(turn)}};
}

LargestStress largestStress(const PlateModel &model, const PlateStress &stress)
{
    const PlateMesh &mesh = model.mesh();
    const double zone = kSharpZone * model.material().thickness;
    LargestStress largest;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        bool isSharp = false;
        for (const Vec2 &corner : mesh.sharp)
            isSharp = isSharp || (corner - mesh.points[i]).norm() < zone;
        for (const int side : {1, -1}) {
            const double value = principalStress(stress.face(static_cast<int>(i), side)).first;
            if (!isSharp && value > largest.value)
                largest = {value, static_cast<int>(i), side};
        }
    }
    return largest;
}

PlateCutForces plateCut(const PlateModel &model, const PlateStress &stress, const Vec2 &p0,
                        const Vec2 &p1)
{
    PlateCutForces cut;
    cut.length = (p1 - p0).norm();
    if (!(cut.length > 0.0))
        return cut;
    const Vec2 v = (p1 - p0) / cut.length, m = -perpendicular(v);
    const double t = stress.thickness, step = cut.length / kCutSteps;
    double firstTwist = 0.0, lastTwist = 0.0;
    for (int k = 0; k < kCutSteps; ++k) {
        const double s = (k + 0.5) * step - 0.5 * cut.length;
        const PlateLocator::Place place = model.place(p0 + v * (k + 0.5) * step);
        const auto &points = model.mesh().triangles[place.triangle];
        const Eigen::Matrix<double, 6, 1> shape = quadraticShape(place.at);
        Vec3 membrane = Vec3::Zero(), moment = Vec3::Zero();
        Vec2 shear = Vec2::Zero();
        for (int i = 0; i < 6; ++i) {
            const int point = points[static_cast<std::size_t>(i)];
            membrane += shape[i] * stress.membrane.col(point);
            moment += shape[i] * stress.moment.col(point);
            shear += shape[i] * stress.shear.col(point);
        }
        const Vec2 force = across(membrane, m) * t * step, bend = across(moment, m) * step;
        const double through = shear.dot(m) * step;
        cut.N += force[0];
        cut.V += force[1];
        cut.Q += through;
        cut.Mn -= s * force[0];
        cut.Mv += bend[0];
        cut.T += s * through - bend[1];
        lastTwist = bend[1] / step;
        if (k == 0)
            firstTwist = lastTwist;
        const double normal = force[0] / (t * step), bending = 6.0 * bend[0] / (step * t * t);
        cut.peak = std::max({cut.peak, std::abs(normal + bending), std::abs(normal - bending)});
    }
    // Kirchhoff: at its ends a cut carries the twist there as forces across the plate.
    cut.Q += firstTwist - lastTwist;
    cut.T -= 0.5 * cut.length * (firstTwist + lastTwist);
    cut.linear = std::abs(cut.N) / (cut.length * t) +
                 6.0 * std::abs(cut.Mn) / (t * cut.length * cut.length) +
                 6.0 * std::abs(cut.Mv) / (cut.length * t * t);
    return cut;
}

} // namespace fff
