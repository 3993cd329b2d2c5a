// The parts of a model, or its skin, for printers and other programs: STL, binary.
#pragma once

#include "core/io/formats.h"
#include "core/io/solids.h"
#include "core/templates/triangle_mesh.h"

#include <string>

namespace fff::io {

/// Millimetres, and Z up, as programs for printers take such files: (x, y, z) is written as (x, −z,
/// y). Each triangle with its normal, in their order; same bytes for same input. At most 2³² − 1
/// triangles. Source  3D Systems 1989, StereoLithography Interface Specification.
std::string stlBytes(const TriangleMesh &mesh);

/// The parts as closed solids (solids.h), one behind the other. Triangles that have no area in the
/// file's seven digits are left out. Errors  as partSolids().
Result<std::string> writeStl(const Model &model, const Bodies &bodies, Lying lying = {});

const Format &stlFormat();

} // namespace fff::io
