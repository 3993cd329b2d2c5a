// Where a mesh comes to lie when it is put into a document.
#pragma once

#include "core/templates/triangle_mesh.h"

namespace fff {

/// The size that templates have where nobody says another: ten of the paper's units, mm.
inline constexpr double kTemplateSize = 254.0;

/// Scaled so that its largest extent is `size` mm, centred about the Y axis, and standing on the
/// ground. A mesh without an extent is only moved. Its unit is mm then.
TriangleMeshPointer placedMesh(const TriangleMesh &mesh, double size = kTemplateSize);

} // namespace fff
