// Where the outlines of sections cross, and their stretches between: the net that a skin is
// stretched over.
#pragma once

#include "core/base/long_work.h"
#include "core/base/result.h"
#include "core/skin/skin_outline.h"

#include <utility>
#include <vector>

namespace fff {

/// Where outlines of two sections or more meet.
struct NetCorner
{
    Vec3 point = Vec3::Zero();   // the middle of where they pass
    Vec3 normal = Vec3::UnitY(); // unit, at a right angle to them, outwards
};

/// A stretch of an outline from corner to corner, which may be the same one.
struct NetEdge
{
    int outline = 0;
    int from = 0, to = 0;          // corners
    double start = 0.0, end = 0.0; // along the outline, mm; start < end
    double length() const { return end - start; }
};

/// Half an edge: 2 e runs along edge e, 2 e + 1 the other way.
using HalfEdge = int;

struct ContourNetwork
{
    std::vector<SkinOutline> outlines; // of each section, in their order
    std::vector<NetCorner> corners;
    std::vector<NetEdge> edges;
    /// Of each corner the half-edges that leave it, counter-clockwise seen from outside.
    std::vector<std::vector<HalfEdge>> round;
    std::vector<int> loose; // outlines without a corner

    int startOf(HalfEdge half) const;
    /// Where it leads off from its start, in the world, unit.
    Vec3 directionOf(HalfEdge half) const;
};

/// Two outlines meet where both sections end on their axis, in the same direction and nearer to
/// each other than kSkinReach; not where one ends inside of the other. Errors  Cancelled.
Result<ContourNetwork> contourNetwork(const std::vector<SectionPointer> &sections,
                                      const LongWork &work = {});

/// The cycles of half-edges that have the form's outside on their face, each half-edge in one: from
/// each the walk goes on to the next one to the left. In the order of their first half-edges.
/// Source  J. Edmonds 1960, A combinatorial representation for polyhedral surfaces (rotations).
std::vector<std::vector<HalfEdge>> cyclesOf(const ContourNetwork &network);

} // namespace fff
