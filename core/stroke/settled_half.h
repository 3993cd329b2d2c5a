// The mirrored half of a stroke of which most is settled.
#pragma once

#include "core/geometry/settled_fit.h"
#include "core/stroke/symmetry.h"

namespace fff {

/// mirroredHalf() of a long stroke (symmetry.h).
///
/// samples  all of them looked at (SampledLine::usable)
/// settled  pieces of the stroke's own fit; what of them lies in the half, away from its ends, is
///          part of it as it is
/// work     as in FitOptions
std::optional<MirroredHalf> mirroredHalf(const std::vector<Vec2> &samples, const MirrorAxis &axis,
                                         const SymmetryVerdict &verdict, double tolerance,
                                         const std::vector<FittedPiece> &settled,
                                         std::size_t *work);

} // namespace fff
