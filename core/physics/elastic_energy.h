// The energy of a structure whose members give, in terms of what its chains of links and its feet
// carry.
#pragma once

#include "core/physics/least_energy.h"
#include "core/physics/link_chains.h"
#include "core/physics/plate_flexibility.h"

#include <vector>

namespace fff {

/// Where a member is held: at a link or at a foot of the structure.
struct MemberAttachment
{
    enum class Kind { Link, Foot };

    Kind kind = Kind::Link;
    int index = 0;

    bool operator==(const MemberAttachment &) const = default;
};

/// How a member gives. Without attachments it is rigid.
struct MemberFlexibility
{
    std::vector<MemberAttachment> attachments; // in the order of the flexibility's blocks
    PlateFlexibility flexibility;              // vectors of the world, moments about the link's
                                               // point, or the foot's; under weight and loads
};

/// Its unknowns: a block of six for each chain, of force and moment over the size, in the world,
/// then one of three for each foot, of the force along footAxes(). Without bounds.
EnergyProblem elasticEnergy(const Structure &structure, const LinkChains &chains,
                            const std::vector<MemberFlexibility> &members);
bool isFinite(const EnergyProblem &problem);

/// Columns: up, and two ways across.
Eigen::Matrix3d footAxes(const Structure &structure);
/// Of its three unknowns.
int firstOfFoot(const LinkChains &chains, int foot);
/// On its a, about its point.
WrenchVector wrenchOf(const Structure &structure, const LinkChains &chains, int link,
                      const Eigen::VectorXd &unknowns);

/// It presses only.
EnergyBound footBound(const LinkChains &chains, int foot);
/// Of a link of a chain: it pulls no more than its grip.
EnergyBound gripBound(const Link &link, const LinkChains::Link &chained);

} // namespace fff
