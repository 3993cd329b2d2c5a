// Which pieces the joints of a model hold together. All that speaks of what is connected asks here,
// so that it speaks of the pieces that are cut.
#pragma once

#include "core/assembly/assembly.h"
#include "core/assembly/body.h"
#include "core/assembly/joint_grips.h"

#include <memory>
#include <optional>
#include <vector>

namespace fff {

/// What all joints of a model hold. Immutable; copies share what is the same.
class Grips
{
public:
    const JointGrips &of(const Joint &joint) const
    {
        return *m_all[static_cast<std::size_t>(joint.id) - 1];
    }

    /// What was found for another model.
    struct Before
    {
        const Model &model;
        const Assembly &assembly;
        const CutList &cuts;
        const Grips &grips;
    };
    /// cuts    belong to the model, one a section
    /// before  with the places of the sections in that model (placesBefore()): joints beside which
    ///         their sections are cut as they were are not looked at again
    static Grips find(const Model &model, const Assembly &assembly, const CutList &cuts,
                      const Before &before,
                      const std::optional<std::vector<int>> &places = std::nullopt);

private:
    using Pointer = std::shared_ptr<const JointGrips>;

    SharedList<Pointer> m_all; // one a joint
};

/// The sections of these bodies (indices into the list, ascending), each once, ascending.
std::vector<int> sectionsOf(const Bodies &bodies, const std::vector<int> &group);

/// Bodies that joints hold together, as indices into the list; the group with the most sections
/// first, then the one with the most bodies, then by the first of them.
std::vector<std::vector<int>> heldGroups(const Bodies &bodies, const JointList &joints,
                                         const Grips &grips);

} // namespace fff
