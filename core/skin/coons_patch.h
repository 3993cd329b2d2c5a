// Surfaces between curves, and their triangles.
#pragma once

#include "core/skin/skin_curve.h"

#include <array>

namespace fff {

/// Four curves round a patch, seen from outside: south and north run to the right, west and east
/// upwards; ends that meet are the same vertex. West and east may be points.
struct PatchSides
{
    SkinCurve south, east, north, west;
};

/// Triangles of the Coons patch over the sides: it contains all points of them, and leaves each at
/// a right angle to the normals that the curve has, so that neighbours go on smoothly. What leads
/// away from a side is as fast as the sides beside it, and no faster than an arc across the patch.
/// Source  S. Coons 1967, Surfaces for computer-aided design of space forms; G. Farin 2002, Curves
/// and surfaces for CAGD, 22.4 (bicubically blended; here without twists).
void fillPatch(GrowingMesh &mesh, const PatchSides &sides);

/// The same between two curves that begin and end in the same two points.
void fillLune(GrowingMesh &mesh, const SkinCurve &south, const SkinCurve &north);

} // namespace fff
