// Where the forces on a piece act, in their order along its boundary, so that a cut tells in a few
// steps which of them are on its plus side.
#pragma once

#include "core/base/few.h"
#include "core/geometry/box_runs.h"
#include "core/physics/cut_sides.h"

#include <vector>

namespace fff {

/// The forces on the plus side of a cut: in these runs of places all are, but for those that the
/// cut comes near to.
struct PlusSites
{
    struct Run
    {
        int begin = 0, end = 0; // of places
    };
    struct Near
    {
        int place = 0;
        PlusShare plus;
    };
    Few<Run, 2> runs;       // apart, ascending
    std::vector<Near> near; // ascending

    /// As one that is wholly on one side has none here.
    const Near *nearAt(int place) const;
    void setNear(int place, const PlusShare &plus);
};

/// The sites of the forces on a piece. A place is a site's number along the boundary.
class ForceSites
{
public:
    ForceSites() = default;
    /// See forceSites().
    ForceSites(const SectionOutline &outline, const std::vector<AppliedForce> &forces,
               double thickness);

    int size() const { return static_cast<int>(m_sites.size()); }
    const ForceSite &at(int place) const { return m_sites[static_cast<std::size_t>(place)]; }
    /// Which of the forces acts there.
    int forceAt(int place) const { return m_forces[static_cast<std::size_t>(place)]; }

    /// O(log sites + sites near the cut + rings with sites).
    PlusSites onPlusSide(const LineCut &cut) const;

    /// Boxes around all that a site takes up, by places.
    const BoxRuns &boxes() const { return m_boxes; }

private:
    void addRuns(const LineCut &cut, int ring, int begin, int end, PlusSites &plus) const;
    void addNear(const LineCut &cut, PlusSites &plus) const;

    std::vector<ForceSite> m_sites; // by places
    std::vector<int> m_forces;
    std::vector<Box2> m_siteBoxes;
    BoxRuns m_boxes;
};

} // namespace fff
