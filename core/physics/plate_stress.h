// Stresses in a plate: at the points of its mesh, and what they come to over a cut.
#pragma once

#include "core/physics/plate_model.h"

namespace fff {

/// Averages at the points of the mesh of what the triangles round them have, weighted by area.
struct PlateStress
{
    Eigen::Matrix3Xd membrane; // xx, yy, xy: MPa
    Eigen::Matrix3Xd moment;   // ∫ σ z dz of xx, yy, xy: N
    Eigen::Matrix2Xd shear;    // across the plate, of sections square to x and to y: N/mm
    double thickness = 0.0;    // mm

    /// xx, yy, xy on a face: side +1 that to which n points, −1 the other. MPa
    Vec3 face(int point, int side) const;
};

PlateStress plateStress(const PlateModel &model, const PlateField &displacements);

struct PrincipalStress
{
    double first = 0.0, second = 0.0; // MPa, first ≥ second
    Vec2 direction = Vec2::UnitX();   // unit, of the first
};
/// Of xx, yy, xy.
PrincipalStress principalStress(const Vec3 &stress);

struct LargestStress
{
    double value = 0.0; // MPa, the largest tension on either face; 0 where there is none
    int point = -1;     // of the mesh
    int side = 1;
};
/// Farther than half the thickness from re-entrant corners, whose peak says only how fine the mesh
/// is.
LargestStress largestStress(const PlateModel &model, const PlateStress &stress);

/// What a cut from p0 to p1 carries, about its middle. m: the way from p0 to p1 turned by −90°.
struct PlateCutForces
{
    double N = 0.0, V = 0.0, Q = 0.0;   // N: along m, along the cut, across the plate
    double Mn = 0.0, Mv = 0.0, T = 0.0; // N·mm: about n, about the cut, about m
    double length = 0.0;                // mm
    double linear = 0.0;                // MPa: |N| / A + |Mn| / Zn + |Mv| / Zv
    double peak = 0.0;                  // MPa: the largest stress normal to the cut on either face
};
/// Integrals of the averaged stresses.
PlateCutForces plateCut(const PlateModel &model, const PlateStress &stress, const Vec2 &p0,
                        const Vec2 &p1);

} // namespace fff
