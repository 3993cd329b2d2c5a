// Equilibrium of elastic sections: what the joints and feet carry where statics alone leaves a
// choice.
#pragma once

#include "core/base/result.h"
#include "core/physics/elastic_energy.h"
#include "core/base/long_work.h"
#include "core/physics/structure.h"

#include <optional>
#include <vector>

namespace fff {

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

/// A structure whose members give as told (empty: rigid), links as in link_compliance.h, feet as
/// stiff as they say. What it carries is where the complementary energy is least:
///
///     minimise ½ x'Hx + c'x  over wrenches and feet x,   equilibrium of every member,
///     feet ≥ 0, force of a link along its axis ≤ grip
///     H = joints + feet + Σ P'CP,   c = Σ P'd
///
/// Unique, since joints give. x are the wrenches of chains of links (link_chains.h): what follows
/// from statics is no unknown, and of models of ribs a third is left. A hundred members take some
/// passes of a few milliseconds. What does not hang on how feet are held is worked out once.
/// Source  the product's mechanics, section 1; S. Timoshenko, D. Young 1965, Theory of structures
///         (complementary energy).
class ElasticStructure
{
public:
    /// Errors  NonFinite for numbers that are none, BadCount for flexibilities that do not fit.
    static Result<ElasticStructure> make(const Structure &structure,
                                         const std::vector<MemberFlexibility> &members);

    /// Errors  Cancelled.
    Result<ElasticEquilibrium> solve(FootHold hold, const LongWork &work = {});

private:
    ElasticStructure(const Structure &structure, const std::vector<MemberFlexibility> &members);

    ElasticEquilibrium told(const LeastEnergy &least) const;

    Structure m_structure;
    LinkChains m_chains;
    std::vector<int> m_boundOf; // of each link, its bound; −1: none
    std::optional<LeastEnergySearch> m_search;
    double m_loads = 0.0; // N: of all that drives it
    bool m_isFinite = true;
};

/// The same for one hold.
Result<ElasticEquilibrium> elasticEquilibrium(const Structure &structure,
                                              const std::vector<MemberFlexibility> &members,
                                              FootHold hold = FootHold::Frictionless,
                                              const LongWork &work = {});

} // namespace fff
