// Stiffness of one triangle of a plate, in its plane and across it.
#pragma once

#include "core/geometry/vector.h"

#include <Eigen/Core>
#include <array>

namespace fff {

/// Corners of a triangle, counter-clockwise, mm.
using PlateCorners = std::array<Vec2, 3>;
/// Of a point in a triangle: its shares of the corners, together 1.
using Barycentric = Eigen::Vector3d;

using PlaneElasticity = Eigen::Matrix3d;
using MembraneStiffness = Eigen::Matrix<double, 12, 12>;
using BendingStiffness = Eigen::Matrix<double, 9, 9>;

/// Stress of strain (xx, yy, twice xy) in plane stress. MPa
PlaneElasticity planeStress(double modulus, double poisson);

/// Of the six points of a quadratic triangle, in the order of PlateMesh.
Eigen::Matrix<double, 6, 1> quadraticShape(const Barycentric &at);

/// Strain of displacements (u, v of the six points), 1/mm.
/// Source  O. Zienkiewicz, R. Taylor, The finite element method, the linear strain triangle.
Eigen::Matrix<double, 3, 12> membraneStrain(const PlateCorners &corners, const Barycentric &at);

/// N/mm
MembraneStiffness membraneStiffness(const PlateCorners &corners, const PlaneElasticity &elasticity,
                                    double thickness);

/// Slopes (dw/dx, dw/dy) at the six points of (w, rotation about x, about y) at the corners. Along
/// a side w is cubic and the slope across it linear; the slopes are quadratic in the triangle.
/// Source  J.-L. Batoz, K.-J. Bathe, L.-W. Ho 1980, A study of three-node triangular plate bending
///         elements: the discrete Kirchhoff triangle.
Eigen::Matrix<double, 12, 9> plateSlopes(const PlateCorners &corners);

/// N/mm, N, N·mm
BendingStiffness bendingStiffness(const PlateCorners &corners, const PlaneElasticity &elasticity,
                                  double thickness);

} // namespace fff
