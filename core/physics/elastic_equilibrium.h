// Equilibrium of elastic sections: what the joints and feet carry where statics alone leaves a
// choice.
#pragma once

#include "core/base/result.h"
#include "core/physics/long_work.h"
#include "core/physics/plate_flexibility.h"
#include "core/physics/structure.h"

#include <vector>

namespace fff {

/// Where a member is held: at a link or at a foot of the structure.
struct MemberAttachment
{
    enum class Kind { Link, Foot };

    Kind kind = Kind::Link;
    int index = 0;
};

/// How a member gives. Without attachments it is rigid.
struct MemberFlexibility
{
    std::vector<MemberAttachment> attachments; // in the order of the flexibility's blocks
    PlateFlexibility flexibility;              // vectors of the world, moments about the link's
                                               // point, or the foot's; under weight and loads
};

enum class FootHold {
    Frictionless, // vertical forces only, but for feet that are pinned each
    Pinned,       // all are held sideways while they carry
};

struct ElasticEquilibrium
{
    std::vector<WrenchVector> links; // on a, about the link's point; world, N and N·mm
    std::vector<Vec3> feet;          // on the member, N
    std::vector<bool> isLifted;      // of each foot: it stands off the ground
    std::vector<bool> isParted;      // of each link: it would come apart but for its grip
    std::vector<double> residual; // of each member: what is left of its equilibrium, of the weight
                                  // and loads on all (moments over the size)
    double worstResidual = 0.0;
    int passes = 0;         // of the active set
    bool isSettled = false; // false: no set of feet and joints was found that agrees

    /// Nothing of the balance is missing: below, it is a mechanism, or needs friction.
    bool isBalanced() const { return isSettled && worstResidual < kBalanced; }
    static constexpr double kBalanced = 1e-6;
};

/// The least complementary energy of members that give as told (empty: rigid), links as in
/// link_compliance.h, feet as stiff as they say:
///
///     minimise ½ x'Hx + c'x  over wrenches and feet x,   equilibrium of every member,
///     feet ≥ 0, force of a link along its axis ≤ grip
///     H = joints + feet + Σ P'CP,   c = Σ P'd
///
/// Unique, since joints give. Sparse: a hundred members take some passes of a few milliseconds.
/// Errors  NonFinite for numbers that are none, BadCount for flexibilities that do not fit;
///         Cancelled.
/// Source  the product's mechanics, section 1; S. Timoshenko, D. Young 1965, Theory of structures
///         (complementary energy).
Result<ElasticEquilibrium> elasticEquilibrium(const Structure &structure,
                                              const std::vector<MemberFlexibility> &members,
                                              FootHold hold = FootHold::Frictionless,
                                              const LongWork &work = {});

} // namespace fff
