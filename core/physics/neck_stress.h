// The stress on one neck, for those who made its cut: shared by samples, refinement and questions.
#pragma once

#include "core/physics/section_stress.h"

namespace fff {

/// What acts on both sides of a slit's net cut, without its own partner; about the outline's base.
struct NetForce
{
    SideForce plus, minus;
};

/// plus  of each slit's net cut; nothing where it has none
std::vector<NetForce> netForces(const PieceShape &shape, const SummedForces &forces,
                                const std::vector<PlusSites> &plus, const Vec3 &arealWeight);
/// Of each slit's net cut.
std::vector<PlusSites> onNetCuts(const PieceShape &shape, const ForceSites &sites);

struct LoadedPiece
{
    const PieceShape &shape;
    const SummedForces &forces;
    const SheetMaterial &sheet;
    const NotchRule &notch;
    std::vector<NetForce> nets; // of the shape's slits
};

/// sites  on the plus side of this cut
/// plus   what they and the weight come to
NeckStress neckStress(const LoadedPiece &piece, const LineCut &cut, int chord, const Neck &neck,
                      SampleKind kind, const PlusSitesView &sites, const SideForce &plus);

/// The two halves of it: the stress; and how far to trust it, and whether it is one of a member,
/// which takes longer.
NeckStress undoubted(const LoadedPiece &piece, const LineCut &cut, int chord, const Neck &neck,
                     SampleKind kind, const PlusSitesView &sites, const SideForce &plus);
/// Of a stress without doubts whether it is one of a member.
bool isLocal(const LoadedPiece &piece, const Neck &neck, const PlusSitesView &sites,
             const NeckStress &stress);
void addDoubts(const LoadedPiece &piece, const LineCut &cut, const Neck &neck,
               const PlusSitesView &sites, NeckStress &stress);

/// The worst cut square to a member, along it by golden section, `spacing` mm to both sides of
/// where `seed` is. Nothing if there is no neck there.
std::optional<NeckStress> refined(const LoadedPiece &piece, const Neck &seed, double spacing);

} // namespace fff
