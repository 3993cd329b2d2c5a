// What acts on one piece, and what it is made of: the input of the stresses within a section.
// mm, N, N·mm, MPa; vectors of three are (u, v, n), in the section's frame, n across the sheet.
#pragma once

#include "core/geometry/vector.h"
#include "core/physics/neck.h"

#include <vector>

namespace fff {

enum class ForceKind { Link, Foot, Load, Clamp };

/// A force at a point of the mid-plane, and a moment about that point.
struct AppliedForce
{
    ForceKind kind = ForceKind::Load;
    Vec2 at = Vec2::Zero();
    Vec3 force = Vec3::Zero();
    Vec3 moment = Vec3::Zero();
    double radius = 0.0; // mm: it is spread over a disc around the point; 0 is a point
    SlitLine slit;       // of a link: where it holds. Its root is `at`
};

/// The sheet of a piece.
struct SheetMaterial
{
    double thickness = 3.0;          // mm
    Vec3 arealWeight = Vec3::Zero(); // density · thickness · gravity, N/mm²
    double strength = 60.0;          // MPa: tensile for what is brittle, yield for what is ductile
    double modulus = 3200.0;         // MPa
    bool isDuctile = false;
};

/// By how much sharp corners raise stresses: min(cap, 0.56 + 0.53 √(l / radius)).
struct NotchRule
{
    double radius = 0.25; // mm, of a corner that a laser cuts
    double cap = 5.0;

    bool operator==(const NotchRule &) const = default;
};

/// Area of a disc of radius 1 beyond a line at distance `h` (−1 … 1) from its centre, as a share of
/// all, and how far beyond the centre the centroid of that part lies (radii).
struct DiscPart
{
    double share = 0.0, away = 0.0;
};
DiscPart discBeyond(double h);

} // namespace fff
