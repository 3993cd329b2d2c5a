// A mesh of few faces as nets: pieces that are cut flat, of thin sheet, and folded.
#pragma once

#include "core/base/long_work.h"
#include "core/base/result.h"
#include "core/geometry/contour.h"
#include "core/templates/mesh_facets.h"

#include <optional>
#include <vector>

namespace fff {

/// Narrower than this, mm, a flap holds no glue.
inline constexpr double kLeastFlap = 3.0;

/// A line of a net, in its own plane, mm; the net lies to the left of a seam.
struct NetLine
{
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();
};

struct NetFold
{
    NetLine line;
    bool isValley = false; // seen from outside, where the net is seen: folded towards the eye
};

/// Where a net is joined to another one, or to itself.
struct NetSeam
{
    NetLine line;
    int number = 0; // 1 …, the same at both of its edges
};

struct MeshNet
{
    Contour outline; // counter-clockwise
    std::vector<Contour> holes;
    std::vector<NetFold> folds;
    std::vector<NetSeam> seams;
    int facets = 0;
};

struct NetOptions
{
    Vec2 room = Vec2(600.0, 400.0); // mm, what a net has to lie in, this way or the other way round
    double flap = 0.0;              // mm, width of the flaps to glue; 0: none
    double gap = 0.0; // mm, that parts of a net keep from each other: what a cut takes away
};

/// The facets of a mesh, unfolded: beginning with the largest, each is laid beside one that is
/// there already, over the longest edge that they share, as long as nothing comes to lie on, or
/// along, something else and the net keeps to the room; what has no place begins another net. A
/// facet that is too large for the room is a net by itself. One of the two edges of a seam has a
/// flap where there is room for it. Parts of a net keep the gap from each other (net_gap.h), as the
/// cut between them takes so much away. Facets are within kCoplanarDepth of flat, and so are edges
/// that are laid together.
///
/// mesh    coordinates in mm, outwards as its triangles are wound; facets are its meshFacets()
/// Errors  Cancelled; NotWorkedOut when Clipper fails
/// Source  D. Shephard 1975, Convex polytopes with convex nets; the order by edge lengths is ours.
Result<std::vector<MeshNet>> meshNets(const TriangleMesh &mesh,
                                      const std::vector<MeshFacet> &facets,
                                      const NetOptions &options, const LongWork &work = {});

} // namespace fff
