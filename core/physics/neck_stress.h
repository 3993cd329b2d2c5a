// The stress on one neck, for those who made its cut: shared by samples, refinement and questions.
#pragma once

#include "core/physics/section_stress.h"

namespace fff {

/// What acts on both sides of a slit's net cut, without its own partner; about the outline's base.
struct NetForce
{
    SideForce plus, minus;
};

std::vector<NetForce> netForces(const PieceShape &shape, const std::vector<ForceSite> &sites,
                                const std::vector<AppliedForce> &forces, const Vec3 &arealWeight);

struct LoadedPiece
{
    const PieceShape &shape;
    const std::vector<AppliedForce> &forces;
    const SheetMaterial &sheet;
    const NotchRule &notch;
    std::vector<NetForce> nets; // of the shape's slits
};

/// `shares`: of the forces, on this cut.
NeckStress neckStress(const LoadedPiece &piece, const LineCut &cut, int chord, const Neck &neck,
                      SampleKind kind, std::span<const PlusShare> shares, const SideForce &plus);

/// The worst cut square to a member, along it by golden section, `spacing` mm to both sides of
/// where `seed` is. Nothing if there is no neck there.
std::optional<NeckStress> refined(const LoadedPiece &piece, const std::vector<ForceSite> &sites,
                                  const Neck &seed, double spacing);

} // namespace fff
