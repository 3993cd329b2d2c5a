// How the faces of a mesh meet along their edges, and which way they look. Internal to templates.
#pragma once

#include "core/base/long_work.h"
#include "core/templates/mesh_report.h"
#include "core/templates/triangle_mesh.h"

#include <span>

namespace fff {

/// Turns over, of each shell, the faces that look the other way than most of it, and counts into
/// the report: open, crowded and one-sided edges, flipped faces, shells. Faces that meet at a
/// crowded edge are of one shell, but none says how another has to look.
/// Cost  O(n) for vertices with few faces each. False when it was stopped.
bool lookTheSameWay(std::span<Triangle> triangles, std::size_t vertices, MeshReport &report,
                    const LongWork &work = {});

} // namespace fff
