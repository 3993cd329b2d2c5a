// What stays of a section between its slits, and between them and its boundary.
#pragma once

#include "core/assembly/joint.h"

namespace fff {

struct Web
{
    enum class Between { Slits, SlitAndHole, SlitAndContour };

    Between between = Between::Slits;
    double width = 0.0;      // mm, at its narrowest; 0: they run into each other
    Vec2 at = Vec2::Zero();  // there, frame coordinates
    int slit = 0, other = 0; // indices of slits, or of a hole; slit < other of two slits
};

/// Those narrower than `limit` (mm), each pair once, by `slit`. Slits of one joint may run into
/// each other: then one slides through the other's. So may those along one line from one mouth, of
/// sections that cross in one axis. At its mouth a slit parts the contour: what
/// runs out there is no web, as far as it takes a contour that slants by 30°, nor is what its
/// lead-ins leave. A slit that runs into a hole, or out of the contour beside its mouth, leaves
/// nothing between them; where only the relief of its end does, that is a web of width 0. Tabs and
/// shoulders, which are part of the outline, are none.
///
/// region   of the section's shape, without slits
/// O(n log n + pairs that are near each other).
std::vector<Web> thinWebs(const Region &region, const std::vector<Slit> &slits, double limit);

} // namespace fff
