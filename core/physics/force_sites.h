// Where the forces on a piece act, in their order along its boundary, so that a cut tells in a few
// steps which of them are on its plus side.
#pragma once

#include "core/geometry/box_runs.h"
#include "core/physics/cut_sides.h"

#include <span>
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
    std::vector<Run> runs;  // apart, ascending
    std::vector<Near> near; // ascending

    void setNear(int place, const PlusShare &plus);
};

/// The same, which others keep.
struct PlusSitesView
{
    PlusSitesView(const PlusSites &sites) : runs(sites.runs), near(sites.near) {}
    PlusSitesView(std::span<const PlusSites::Run> ofRuns, std::span<const PlusSites::Near> ofNear)
        : runs(ofRuns), near(ofNear)
    {
    }

    std::span<const PlusSites::Run> runs;
    std::span<const PlusSites::Near> near;

    /// As one that is wholly on one side has none here.
    const PlusSites::Near *nearAt(int place) const;
};

/// Those of many cuts, one behind the other.
class PlusSitesList
{
public:
    void add(const PlusSites &sites);
    std::size_t size() const { return m_ends.size() - 1; }
    PlusSitesView operator[](std::size_t i) const
    {
        const End &begin = m_ends[i], &end = m_ends[i + 1];
        return {std::span(m_runs).subspan(begin.runs, end.runs - begin.runs),
                std::span(m_near).subspan(begin.near, end.near - begin.near)};
    }

private:
    struct End
    {
        std::size_t runs = 0, near = 0;
    };
    std::vector<End> m_ends{{}};
    std::vector<PlusSites::Run> m_runs;
    std::vector<PlusSites::Near> m_near;
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
    /// The same for those who ask often: `plus` is filled anew.
    void onPlusSide(const LineCut &cut, PlusSites &plus) const;

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
