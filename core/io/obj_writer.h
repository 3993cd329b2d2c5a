// The model as solids in place, or its skin: Wavefront OBJ in millimetres, Y up.
#pragma once

#include "core/assembly/body.h"
#include "core/io/formats.h"
#include "core/model/model.h"
#include "core/templates/triangle_mesh.h"

#include <string>
#include <vector>

namespace fff::io {

/// Every part as a closed slab with its slits cut, as designed (no kerf), in world coordinates.
///
///   groups    "o NAME" and "g NAME" a part; NAME is the section's, blanks and signs that end names
///             made _, a number added where two would be alike
///   faces     triangles on both faces, quads along the edge, seen counter-clockwise from outside;
///             every edge belongs to two of them. Curves are chords of kCutChord.
///   vertices  none twice in a part, but where its outline touches itself in a point: there each
///             side has one, or four walls would meet in one edge
///   numbers   to 1e-7 mm, a tenth of the grid that outlines are cut on, so that none fall together
///
/// Stocks stand in comments: OBJ knows no thickness, and looks are not the model's. `bodies` belong
/// to the model. UTF-8, same bytes for same input. Errors  as haveSolids().
Result<std::string> writeObj(const Model &model, const Bodies &bodies);

/// The mesh as it is, one object of triangles, mm; numbers as above.
std::string writeObj(const TriangleMesh &mesh);

const Format &objFormat();

} // namespace fff::io
