// Loops of a cut that run over into each other, as the outline of what they enclose. Internal to
// templates.
#pragma once

#include "core/templates/plane_cut.h"

namespace fff {

/// Where loops, oriented as nestLoops() leaves them and without bridges, cross or touch themselves
/// or each other, or one lies in what another encloses anyway: the boundary of all that they wind
/// round instead, with no loop in another one's material. Else they stay as they are, bit for bit;
/// and so do loops with bridges, and with such ones all where there are holes. Largest first.
///
/// frame  on the plane
/// Cost   O(points · log points), and that of the union where there is one
void uniteLoops(std::vector<CutLoop> &loops, const Frame &frame);

} // namespace fff
