// What a plate goes through, all over it: how strained its two faces are, and how far it moves.
#pragma once

#include "core/physics/plate_stress.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace fff {

/// At the points of a plate's mesh, linear between them. Immutable; small beside the plate's
/// model, which need not be kept.
struct StressField
{
    std::vector<Vec2> points;                  // of the section's frame, mm
    std::vector<std::array<int, 3>> triangles; // counter-clockwise
    /// Of each point, on the face to which n points and on the other: the larger principal stress,
    /// pulled or pressed, over the strength (no unit).
    std::array<std::vector<float>, 2> use;
    std::vector<Eigen::Vector3f> moved; // (u, v, n) of each point, mm; of the first case, right but
                                        // for a motion of the whole
    float most = 0.0f;                  // the largest use
};
using StressFieldPointer = std::shared_ptr<const StressField>;

/// Of displacements under several ways to bear a load, everywhere the worst.
///
/// Nearer than half the thickness to a re-entrant corner the stress of an elastic plate says only
/// how fine the mesh is. There the field goes from what it is around the corner to what
/// `cornerUses` says of it, which is the notch factor's matter.
///
/// strength    MPa, positive
/// cornerUses  of each of the mesh's sharp corners; less than what is around it changes nothing
StressField stressField(const PlateModel &model, std::span<const PlateField> cases, double strength,
                        std::span<const double> cornerUses);

} // namespace fff
