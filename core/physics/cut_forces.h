// What one side of a cut does to the other: statics alone.
#pragma once

#include "core/physics/force_sites.h"
#include "core/physics/nominal_stress.h"
#include "core/physics/wall_pressure.h"

#include <span>

namespace fff {

/// lever × f of a lever in the plane.
inline Vec3 momentOf(const Vec2 &lever, const Vec3 &f)
{
    return Vec3(lever.x(), lever.y(), 0.0).cross(f);
}

/// Force and moment of what is on the plus side of a cut, its own weight included; the moment about
/// the outline's base. N, N·mm, (u, v, n).
struct SideForce
{
    Vec3 force = Vec3::Zero();
    Vec3 moment = Vec3::Zero();

    /// About another point of the mid-plane.
    Vec3 momentAbout(const Vec2 &point, const Vec2 &base) const
    {
        return moment + momentOf(base - point, force);
    }

    SideForce &operator+=(const SideForce &other)
    {
        force += other.force;
        moment += other.moment;
        return *this;
    }
    SideForce &operator-=(const SideForce &other)
    {
        force -= other.force;
        moment -= other.moment;
        return *this;
    }
};

/// The forces at their sites, summed along the boundary. Both outlive it.
class SummedForces
{
public:
    SummedForces(const SectionOutline &outline, const ForceSites &sites,
                 const std::vector<AppliedForce> &forces);

    const ForceSites &sites() const { return m_sites; }
    const AppliedForce &at(int place) const
    {
        return m_forces[static_cast<std::size_t>(m_sites.forceAt(place))];
    }
    /// Of these places.
    SideForce sum(int begin, int end) const
    {
        SideForce sum = m_sums[static_cast<std::size_t>(end)];
        return sum -= m_sums[static_cast<std::size_t>(begin)];
    }
    /// How many of these are not zero.
    int loaded(int begin, int end) const
    {
        return m_loaded[static_cast<std::size_t>(end)] - m_loaded[static_cast<std::size_t>(begin)];
    }
    bool isLoaded(int place) const { return loaded(place, place + 1) > 0; }

    /// What the force of a link comes to: what presses on the walls of its slit, and the rest.
    struct LinkParts
    {
        WallPressure pressure;
        Vec3 across = Vec3::Zero(); // unit, normal to the walls
        Vec3 rest = Vec3::Zero();   // N
    };
    /// Of a place whose site has walls.
    const LinkParts &linkAt(int place) const { return m_links[static_cast<std::size_t>(place)]; }

private:
    const ForceSites &m_sites;
    const std::vector<AppliedForce> &m_forces;
    std::vector<SideForce> m_sums;  // before each place, and behind the last one
    std::vector<int> m_loaded;      // as these
    std::vector<LinkParts> m_links; // by places
};

/// O(runs + what is near).
SideForce plusForce(const SectionOutline &outline, const LineCut &cut, const SummedForces &forces,
                    const PlusSitesView &plus, const Vec3 &arealWeight,
                    SlitFit fit = SlitFit::Loose);

/// All that acts on the piece: zero if it is in equilibrium. About the outline's base.
SideForce allForce(const SectionOutline &outline, const std::vector<AppliedForce> &forces,
                   const Vec3 &arealWeight);

/// The parts of it in directions across the neck (`across`, its `normal`) and across the sheet, at
/// a point.
CutForces resolved(const SideForce &side, const Vec2 &base, const Vec2 &middle, const Vec2 &across);

/// Of one chord of a cut that crosses holes: a share of the forces by which all of its chords
/// together act as one section.
///
///     A_k = t l_k,  s̄ = ΣA_k s_k / ΣA_k,  I = Σ t l_k³/12 + A_k (s_k − s̄)²,  N, V, M at s̄
///     N_k = N A_k/A − M A_k (s_k − s̄)/I,   M_k = M t l_k³ / (12 I) + |V_k| e
///     V_k = V max(l_k³/Σl³, l_k/Σl);  the others in proportion to l_k
///
/// with e half of what the holes at the chord reach over normal to the cut (as in a Vierendeel
/// girder). M is about n, positive as in CutForces. A cut of one chord has it all.
/// Source  the product's mechanics, 2.8.
CutForces forcesOn(const SectionOutline &outline, const LineCut &cut, int chord, const Neck &neck,
                   const SideForce &side);

} // namespace fff
