// One contour turned into another one, step by step.
#pragma once

#include "core/geometry/contour.h"

#include <vector>

namespace fff {

/// Which points of two contours belong together: uniform by arc length, from `offset` (a share of
/// the second one's length) at the first one's start, and back from there if reversed.
struct Correspondence
{
    double offset = 0.0; // 0 … 1
    bool isReversed = false;

    bool operator==(const Correspondence &) const = default;
};

/// Points at equal steps of arc length, the first at the start.
std::vector<Vec2> uniformSamples(const Contour &contour, int count);

/// The cyclic offset k, and the order, for which the sum of the distances ‖p[(k + i) mod n] − q[i]‖
/// (reversed: ‖p[(k − i) mod n] − q[i]‖) of uniform samples is least. Ties go to the smaller k, not
/// reversed. Returned of q as seen from p. Source  J. McCrae et al. 2014, FlatFitFab, "Blend
/// operation". O(n²), sums that grow too large are not finished.
inline constexpr int kBlendSamples = 256;
Correspondence bestCorrespondence(const Contour &p, const Contour &q);

/// Both contours are cut where either has an anchor, at places that belong together, and control
/// points go straight from one to the other: corners stay corners, lines lines, and nothing is
/// fitted. Anchors that nearly belong together, by kJoinedAnchors of the length, do.
class ContourBlend
{
public:
    ContourBlend(const Contour &p, const Contour &q, const Correspondence &correspondence);

    /// share 0: the curve of p, exactly; 1: that of q. Between, it may cross itself.
    Contour at(double share) const;

private:
    std::vector<CubicBezier> m_p, m_q; // as many
};
inline constexpr double kJoinedAnchors = 1.0 / kBlendSamples;

} // namespace fff
