// How the bodies of a model give under what holds and loads them, as finite elements.
#pragma once

#include "core/analysis/body_plate.h"
#include "core/physics/elastic_equilibrium.h"

#include <map>
#include <memory>
#include <vector>

namespace fff {

struct BendingBody;

/// Bodies as plates. Immutable.
class BendingBodies
{
public:
    /// What was worked out for bodies that are still there, where the same holds them. Not for
    /// several threads at once.
    using Cache = std::map<BodyPointer, std::shared_ptr<const BendingBody>>;

    /// Errors  Cancelled.
    static Result<BendingBodies> of(const Analysis &analysis, const ModelStructure &made,
                                    Cache &cache, PlateMeshes &meshes, const LongWork &work = {});

    /// Under their own weight and `scale` times the loads of the structure.
    std::vector<MemberFlexibility> under(double scale) const;
    /// Those that are no plates to speak of, and are taken for rigid.
    const std::vector<int> &stiff() const { return m_stiff; }

private:
    std::vector<std::shared_ptr<const BendingBody>> m_bodies; // null: rigid
    std::vector<int> m_stiff;
};

} // namespace fff
