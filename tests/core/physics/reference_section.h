// One section of a reference case, and all that acts on it: the input of the stresses within it.
#pragma once

#include "core/physics/elastic_equilibrium.h"
#include "core/physics/section_stress.h"
#include "tests/core/physics/reference_case.h"

#include <optional>
#include <vector>

namespace fff::test {

/// What feet and links of a case carry, as its structure numbers them; world, N and N·mm.
struct ReferenceForces
{
    std::vector<Vec3> feet;
    std::vector<Wrench> links; // on a, about the link's point
};

/// As a solver found them; nothing where it leaves a foot or a joint out.
std::optional<ReferenceForces> forcesOf(const ReferenceCase &found, const ReferenceTruth &truth);
ReferenceForces forcesOf(const Equilibrium &found);
ReferenceForces forcesOf(const ElasticEquilibrium &found);

/// In a section's frame: (u, v, n).
Vec3 inFrameOf(const ReferenceSection &section, const Vec3 &world);
/// N/mm² that it weighs, in its frame.
Vec3 arealWeightOf(const ReferenceCase &found, int section);

struct ReferencePiece
{
    std::vector<PieceShape> shapes; // what slits leave of it: mostly one
    std::vector<AppliedForce> forces;
    SheetMaterial sheet;
    bool isClampedOnce = true; // else statics does not tell what each clamp carries
};

/// With what its clamp has to carry.
ReferencePiece pieceOf(const ReferenceCase &found, int section, const ReferenceForces &carried);

} // namespace fff::test
