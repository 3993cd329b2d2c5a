// The planes among which suggested sections are chosen.
#pragma once

#include "core/analysis/suggesting/form_samples.h"

#include <cstdint>
#include <vector>

namespace fff {

struct SuggestedPlane
{
    Vec3 normal = Vec3::UnitX(); // unit
    double offset = 0.0;         // of n · p, mm
    double preference = 1.0;     // what it shows counts so many times: planes of symmetry and those
                                 // across axes are what people look for
};

/// Planes across the axes of the world and those of the form (of its surface, seen from above and
/// in space), at angles between these, and those about which it is symmetric; of each direction
/// several, spread evenly from end to end; and those just within main faces, whose edges are what
/// is seen of them. The seed shifts them and turns what is at no axis. positions  of the mesh's
/// vertices, world, mm; not empty within     mm, from a main face, so that there is material beside
/// a slit Source     that planes of symmetry and across axes tell people what a form is: J. McCrae,
/// K.
///            Singh, N. Mitra 2011, Slices: a shape-proxy based on planar sections.
std::vector<SuggestedPlane> suggestedPlanes(const std::vector<Vec3> &positions,
                                            const FormSamples &samples, double within,
                                            bool allowsAskew, std::uint64_t seed);

/// Many across one direction, `step` mm apart, from end to end; the first one at this share of a
/// step from there.
std::vector<SuggestedPlane> planesAcross(const Vec3 &normal, const std::vector<Vec3> &positions,
                                         double step, double share, double preference);

/// Whether the form is the same on both sides of the plane, as far as its samples can tell.
bool isSymmetricAbout(const Vec3 &normal, double offset, const FormSamples &samples);

} // namespace fff
