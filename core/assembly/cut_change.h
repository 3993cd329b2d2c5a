// What of a cut section an edit elsewhere has left alone.
#pragma once

#include "core/assembly/cut_section.h"
#include "core/geometry/box_runs.h"

#include <vector>

namespace fff {

/// Where the material of a section differs from what it was, as far as one can say without
/// comparing outlines: beside slits that are the same and beside no other there is the same.
class CutChange
{
public:
    /// Two cuts of the same shape with their slits; those of now outlive this. Where slits changed
    /// what is a piece, or a chip fell off, it may differ everywhere. O(slits).
    CutChange(const CutSection &now, const std::vector<Slit> &slitsNow, const CutSection &before,
              const std::vector<Slit> &slitsBefore);

    bool isEverywhere() const { return m_isEverywhere; }
    /// Whether it may reach what lies `beside` mm or nearer to the axis of a slit of now, by its
    /// index, however far along that. In the time of what changed near there.
    bool isNear(std::size_t slit, double beside) const;

private:
    void add(const Slit &slit);

    bool m_isEverywhere = true;
    const std::vector<Slit> &m_slits;
    std::vector<char> m_isChanged; // of each of them
    std::vector<Box2> m_boxes;     // of slits that came, went or changed
    BoxRuns m_runs;                // of these
};

} // namespace fff
