// Pieces of a cut, one after the other. Internal to templates.
#pragma once

#include "core/templates/cut_segments.h"

namespace fff {

struct CutChain
{
    std::vector<Vec3> points; // no two neighbours equal; of a closed one the first not repeated
    bool isClosed = false;
    /// All its triangles look to the same side of it: what is enclosed lies to the left.
    bool isOriented = false;
};

/// Every piece is in one chain. Where more than two meet, in an edge of more than two triangles,
/// those are joined that have what the mesh encloses between them, so that solids that touch there
/// are apart; what does not look the same way is joined with what is beside it. A chain runs as
/// most of its triangles have it. A closed one that is a point only is none.
std::vector<CutChain> cutChains(const TriangleMesh &mesh, const CutPlane &plane,
                                const std::vector<CutSegment> &segments);

} // namespace fff
