// Meshes as PLY, binary: what a document keeps of one that came in several files.
#pragma once

#include "core/templates/triangle_mesh.h"

#include <string>

namespace fff::io {

/// Positions bit for bit, triangles in their order: reading it gives the same mesh, but for the
/// unit, which PLY does not know.
std::string plyBytes(const TriangleMesh &mesh);

} // namespace fff::io
