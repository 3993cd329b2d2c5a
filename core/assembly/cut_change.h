// What of a cut section an edit elsewhere has left alone.
#pragma once

#include "core/assembly/cut_section.h"

#include <vector>

namespace fff {

/// Where the material of a section differs from what it was, as far as one can say without
/// comparing outlines: beside slits that are the same and beside no other there is the same.
class CutChange
{
public:
    /// Two cuts of the same shape with their slits. Where slits changed what is a piece, or a chip
    /// fell off, it may differ everywhere.
    CutChange(const CutSection &now, const std::vector<Slit> &slitsNow, const CutSection &before,
              const std::vector<Slit> &slitsBefore);

    bool isEverywhere() const { return m_isEverywhere; }
    /// Whether it may reach what lies `beside` mm or nearer to the slit's axis, however far along
    /// that.
    bool isNear(const Slit &slit, double beside) const;

private:
    bool m_isEverywhere = true;
    std::vector<Box2> m_boxes; // of slits that came, went or changed
};

} // namespace fff
