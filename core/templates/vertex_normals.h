// Which way a mesh looks at its vertices.
#pragma once

#include "core/templates/triangle_mesh.h"

namespace fff {

/// n × 3, of length 1; 0 where all faces at a vertex cancel or have no area. Each face counts by
/// its angle there, so that it does not matter how a surface is cut into triangles. Source  G.
/// Thürmer, C. Wüthrich 1998, Computing Vertex Normals from Polygonal Facets, Journal of
///         Graphics Tools 3(1).
std::vector<Vec3> vertexNormals(const TriangleMesh &mesh);

} // namespace fff
