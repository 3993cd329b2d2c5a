#include "core/physics/plate_element.h"

namespace fff {

namespace {

/// Rows: d/dx, d/dy of the shares of the three corners.
Eigen::Matrix<double, 2, 3> shareGradients(const PlateCorners &corners)
{
    const double twice = cross(corners[1] - corners[0], corners[2] - corners[0]);
    Eigen::Matrix<double, 2, 3> gradients;
    for (int i = 0; i < 3; ++i) {
        const Vec2 opposite = corners[static_cast<std::size_t>((i + 2) % 3)] -
                              corners[static_cast<std::size_t>((i + 1) % 3)];
        gradients.col(i) = perpendicular(opposite) / twice;
    }
    return gradients;
}

/// Strain is linear, so that three points integrate its square exactly.
MembraneStiffness integrated(const PlateCorners &corners, const PlaneElasticity &elasticity,
                             double perArea)
{
    const double area = 0.5 * cross(corners[1] - corners[0], corners[2] - corners[0]);
    MembraneStiffness stiffness = MembraneStiffness::Zero();
    for (int i = 0; i < 3; ++i) {
        Barycentric at = Barycentric::Constant(1.0 / 6.0);
        at[i] = 2.0 / 3.0;
        const Eigen::Matrix<double, 3, 12> strain = membraneStrain(corners, at);
        stiffness += (area * perArea / 3.0) * strain.transpose() * elasticity * strain;
    }
    return stiffness;
}

} // namespace

PlaneElasticity planeStress(double modulus, double poisson)
{
    PlaneElasticity elasticity;
    elasticity << 1.0, poisson, 0.0, poisson, 1.0, 0.0, 0.0, 0.0, 0.5 * (1.0 - poisson);
    return elasticity * (modulus / (1.0 - poisson * poisson));
}

Eigen::Matrix<double, 6, 1> quadraticShape(const Barycentric &at)
{
    Eigen::Matrix<double, 6, 1> shape;
    for (int i = 0; i < 3; ++i) {
        shape[i] = at[i] * (2.0 * at[i] - 1.0);
        shape[3 + i] = 4.0 * at[(i + 1) % 3] * at[(i + 2) % 3];
    }
    return shape;
}

Eigen::Matrix<double, 3, 12> membraneStrain(const PlateCorners &corners, const Barycentric &at)
{
    const Eigen::Matrix<double, 2, 3> share = shareGradients(corners);
    Eigen::Matrix<double, 3, 12> strain = Eigen::Matrix<double, 3, 12>::Zero();
    for (int i = 0; i < 6; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const Vec2 gradient = i < 3 ? Vec2((4.0 * at[i] - 1.0) * share.col(i))
                                    : Vec2(4.0 * (at[j] * share.col(k) + at[k] * share.col(j)));
        strain(0, 2 * i) = gradient.x();
        strain(1, 2 * i + 1) = gradient.y();
        strain(2, 2 * i) = gradient.y();
        strain(2, 2 * i + 1) = gradient.x();
    }
    return strain;
}

MembraneStiffness membraneStiffness(const PlateCorners &corners, const PlaneElasticity &elasticity,
                                    double thickness)
{
    return integrated(corners, elasticity, thickness);
}

Eigen::Matrix<double, 12, 9> plateSlopes(const PlateCorners &corners)
{
    Eigen::Matrix<double, 12, 9> slopes = Eigen::Matrix<double, 12, 9>::Zero();
    for (int i = 0; i < 3; ++i) {
        slopes(2 * i, 3 * i + 2) = -1.0;    // dw/dx is the rotation about −y
        slopes(2 * i + 1, 3 * i + 1) = 1.0; // dw/dy that about x
    }
    for (int side = 0; side < 3; ++side) {
        const int from = (side + 1) % 3, to = (side + 2) % 3;
        const Vec2 along =
            corners[static_cast<std::size_t>(to)] - corners[static_cast<std::size_t>(from)];
        const double length = along.norm();
        const Vec2 s = along / length, n = perpendicular(s);
        const Eigen::Matrix<double, 2, 9> ends =
            slopes.middleRows<2>(2 * from) + slopes.middleRows<2>(2 * to);
        Eigen::Matrix<double, 1, 9> alongSide = -0.25 * s.transpose() * ends;
        alongSide[3 * to] += 1.5 / length;
        alongSide[3 * from] -= 1.5 / length;
        slopes.middleRows<2>(6 + 2 * side) = s * alongSide + 0.5 * n * (n.transpose() * ends);
    }
    return slopes;
}

BendingStiffness bendingStiffness(const PlateCorners &corners, const PlaneElasticity &elasticity,
                                  double thickness)
{
    const Eigen::Matrix<double, 12, 9> slopes = plateSlopes(corners);
    const double perArea = thickness * thickness * thickness / 12.0;
    return slopes.transpose() * integrated(corners, elasticity, perArea) * slopes;
}

} // namespace fff
