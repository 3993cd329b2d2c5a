// The skin of a model for printers and other programs: STL, binary.
#pragma once

#include "core/io/formats.h"
#include "core/templates/triangle_mesh.h"

#include <string>

namespace fff::io {

/// Millimetres, and Z up, as programs for printers take such files: (x, y, z) is written as (x, −z,
/// y). Each triangle with its normal, in their order; same bytes for same input. At most 2³² − 1
/// triangles. Source  3D Systems 1989, StereoLithography Interface Specification.
std::string stlBytes(const TriangleMesh &mesh);

const Format &stlFormat();

} // namespace fff::io
