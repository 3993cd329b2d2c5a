// Outlines that meet no other: sections stacked along one that they cross inside of it. The skin
// runs from each to the next one, and ends flat.
#pragma once

#include "core/base/long_work.h"
#include "core/base/result.h"
#include "core/skin/contour_network.h"
#include "core/skin/patch_judge.h"
#include "core/skin/skin_curve.h"

#include <optional>
#include <vector>

namespace fff {

/// Two outlines of which each is the nearest to the other on one side of its section.
struct RingPair
{
    int a = 0, b = 0;       // sections
    bool isAhead = false;   // b lies where the normal of a points to
    bool isFrontal = false; // a lies where the normal of b points to
    Vec3 shift =
        Vec3::Zero(); // from the middle of what a shares with the one that both cross to b's
};

/// Of the loose outlines of the network: on each section that they cross, those beside each other
/// there, unless another section lies between. An outline has at most one on each of its sides.
/// Errors  Cancelled.
Result<std::vector<RingPair>> ringPairs(const std::vector<SectionPointer> &sections,
                                        const ContourNetwork &network, const LongWork &work);

/// Two outlines between which there is no patch.
struct OpenTube
{
    int a = 0, b = 0; // sections
    PatchFault fault = PatchFault::Folded;
};

struct FilledTubes
{
    int patches = 0; // between outlines, and over ends
    std::vector<OpenTube> open;
};

/// Triangles between the outlines of pairs, and over the ends.
FilledTubes fillTubes(GrowingMesh &mesh, const std::vector<RingPair> &pairs,
                      const ContourNetwork &network);

/// The flat region inside of a closed curve, whose first vertex is its last, in the plane of the
/// frame; seen from outside, the region is to the left of the curve. False where its triangles
/// cannot be told.
bool fillFlat(GrowingMesh &mesh, const SkinCurve &ring, const Frame &frame);

} // namespace fff
