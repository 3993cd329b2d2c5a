// How sections stand on the ground.
#pragma once

#include "core/analysis/check_caches.h"
#include "core/assembly/stability.h"

#include <vector>

namespace fff {

/// Tilted by less than this it falls by itself: tables lean, joints give, and an edge that was cut
/// is not straight. 2°, radians.
inline constexpr double kLeastTilt = 0.03490658503988659;

/// Leaning by less than this, what stands does so as it was drawn (1°, radians).
inline constexpr double kPlainLean = 0.017453292519943295;

/// The body of a section that something at this point, in frame coordinates, is on, or nearest to;
/// of a section that has bodies.
int bodyAt(const Bodies &bodies, int section, const Vec2 &point);

/// Of a group of bodies (indices into the list), with the weights that hang on them: on that of a
/// section's which is there, or nearest.
MassProperties loadedMass(const Analysis &analysis, const std::vector<int> &group);

/// Whether and how a group of bodies stands, taken as one rigid body with the weights that hang on
/// it. It stands on what is lowest of it; where that does not hold it up, on what it comes to lean
/// on (settling.h).
Stability stabilityOf(const Analysis &analysis, const std::vector<int> &group);
/// Without leaning, on what is lowest of it.
Stability asDrawn(const Analysis &analysis, const std::vector<int> &group);
/// The same, of their mass as above, with what is known of their contact with the ground: that is
/// worked out anew only where the contact of one of them changed.
Stability stabilityOf(const Analysis &analysis, const std::vector<int> &group,
                      const MassProperties &mass, const CheckCaches &caches,
                      CheckCaches::OfStance &stance);

} // namespace fff
