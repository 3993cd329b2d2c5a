// Stresses that the formulas of beams give for a rectangular cross-section.
#pragma once

#include "core/physics/applied_force.h"

namespace fff {

/// What the plus side of a cut does to its minus side, at the middle of the neck. N and N·mm.
struct CutForces
{
    double axial = 0.0;   // N, along the outward normal m of the minus side: positive pulls
    double shear = 0.0;   // V, along the cut v, in the plane
    double plate = 0.0;   // Q, along n, across the sheet
    double inPlane = 0.0; // Mn, moment about n
    double bending = 0.0; // Mv, moment about the cut: bends the plate
    double torsion = 0.0; // T, moment about m
};

/// MPa, all of them magnitudes.
struct NominalStress
{
    double axial = 0.0;   // |N| / (l t)
    double inPlane = 0.0; // 6 |Mn| / (t l²), times Winkler's factor
    double plate = 0.0;   // 6 |Mv| / (l t²)
    double shear = 0.0;   // torsion, and the larger of the two shears
    double neck = 0.0;    // s₁, nominal
    double corner = 0.0;  // the same with the notch factor, where the neck ends at a corner
    double notch = 1.0;   // K

    double linear() const { return axial + inPlane + plate; }
};

/// Everything is added up at the worst corner of the rectangle: s of axial force and both bendings,
/// τ of torsion and the larger shear. What is brittle is judged by the first principal stress s/2 +
/// √(s²/4 + τ²), what is ductile by √(s² + 3 τ²).
///
/// The notch factor K = NotchRule acts on what varies in the plane; on plate bending with 1 + (K −
/// 1) / 2.
/// Source  the product's mechanics, 2.6 and 2.7; torsion of a rectangle a ≤ b: τ = T (3 + 1.8 a/b)
/// /
///         (b a²), W. Young 1989, Roark's Formulas for Stress and Strain, 6th ed., table 20.
NominalStress nominalStress(const CutForces &forces, const Neck &neck, const SheetMaterial &sheet,
                            const NotchRule &notch);

} // namespace fff
