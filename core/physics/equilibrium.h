// Forces between rigid members that stand on the ground: what each link and each foot carries.
#pragma once

#include "core/physics/balance.h"
#include "core/physics/structure.h"

#include <map>
#include <memory>
#include <vector>

namespace fff {

struct Wrench
{
    Vec3 force = Vec3::Zero();  // N
    Vec3 moment = Vec3::Zero(); // N·mm, about the point it is said of
};

struct LinkForce
{
    Wrench onA;          // about the link's point; the opposite acts on b
    double pull = 0.0;   // N along the axis; positive pulls the link apart
    double asked = 0.0;  // N, the pull were the link never pulled apart: the grip that it takes
    bool isOpen = false; // pulled open: it is asked for more than its grip
};

struct FootForce
{
    Vec3 force = Vec3::Zero(); // N on the member; along the structure's `up` never negative
    bool isPressing = false;
};

/// Of a rigid body about a point: small, so that both simply add.
struct RigidMotion
{
    Vec3 translation = Vec3::Zero(); // mm
    Vec3 rotation = Vec3::Zero();    // radians
};

struct ComponentState
{
    Component parts;
    BodyBalance body;
    Balance balance = Balance::NoContact; // the verdict
    int indeterminacy = 0;                // 0: forces follow from statics alone
    bool hasForces = false;               // forces of its members, links and feet are given
    std::vector<int> offenders;           // members: those of what does not stand, or that move
    std::vector<int> openLinks;           // links that are asked for more than their grip
    std::vector<RigidMotion> motion;      // of a mechanism: of each of `parts.members` about its
                                          // centroid, the farthest of them 1 mm (rotations times
                                          // the structure's size)
    int passes = 0, factorisations = 0;   // of the search for the feet that press
};

struct Equilibrium
{
    std::vector<LinkForce> links;     // as in the structure; 0 where there are no forces
    std::vector<FootForce> feet;      // "
    std::vector<RigidMotion> members; // of each about its centroid
    std::vector<double> residuals;    // of each member: what forces and moments leave over, by the
                                      // largest force or moment / size of its component (no unit)
    double worstResidual = 0.0;       // above kTrustedResidual the numbers are not to be shown
    std::vector<ComponentState> components;
    bool isSound = true; // all of the structure was finite and sound; else the rest of it was
                         // taken, and worstResidual is 1

    /// The worst of the components', in the order of Balance's comment; NoContact without any.
    Balance balance() const;
    /// The largest of the components'.
    int indeterminacy() const;
};

/// Equilibrium of rigid members is shown when no more than this is left over (no unit).
inline constexpr double kTrustedResidual = 1e-6;

/// Factors of structures solved before: of one that only has other masses and loads all is used
/// again, of one that is bent (same pairs of members) the order of elimination. One for each place
/// that solves again and again; answers do not hang on it but for rounding.
class EquilibriumCache
{
public:
    EquilibriumCache();
    ~EquilibriumCache();
    EquilibriumCache(EquilibriumCache &&) noexcept;
    EquilibriumCache &operator=(EquilibriumCache &&) noexcept;

    struct Kept;
    /// Of a component (by its first member) and a kind of support.
    Kept &at(int firstMember, int variant);
    void clear();

private:
    std::map<std::pair<int, int>, std::unique_ptr<Kept>> m_kept;
};

/// What holds the structure up.
///
/// Members are rigid, links are springs (linkSprings), feet press only. In order: components; the
/// rigid body test of each (bodyBalance); of those that stand the forces, in displacements. Without
/// friction three horizontal anchors hold what no load moves. Where a link is asked for more than
/// its grip, it is solved again with links that give way at their grip; when that leaves a
/// mechanism, the forces stay those of links that hold, and the motion is given.
///
/// Exact where indeterminacy() is 0. Elsewhere the forces are those of rigid sections: they are in
/// equilibrium, but real sections bend and share loads otherwise.
/// Time    near O(members + links + feet) where the graph is a tree or nearly; of a lattice that of
///         its dense factors.
/// Errors  none: see Equilibrium::isSound.
/// Source  the product's mechanics, sections 1, 1.1, 1.5, 1.6.
Equilibrium solveEquilibrium(const Structure &structure, const Support &support,
                             EquilibriumCache &cache);
Equilibrium solveEquilibrium(const Structure &structure, const Support &support = {});

/// The solutions that stresses have to be taken from: of a determinate structure one; of others up
/// to four, feet sliding and pinned, slits tight and free to turn about their axes. The first is
/// that of the support as given; of the others those that are no mechanism.
/// Source  section 1.2: neither of the four is conservative by itself.
std::vector<Equilibrium> solveEnvelope(const Structure &structure, const Support &support,
                                       EquilibriumCache &cache);

} // namespace fff
