// The native format `.fff`: JSON, lengths in mm, angles in radians, version 3.
//
//     { "format": "FlatFitFab", "version": 3, "nextId": 5, "currentStock": 1,
//       "opensForAdjusting": true,
//       "stocks":     [ { "id", "name", "thickness", "nominalThickness", "measured", "density",
//                         "tensileStrength", "flexuralStrength", "modulus", "kerf",
//                         "kerfs": [ { "machine", "kerf" } ], "clearance",
//                         "slitEnd": "square|round|dogbone|tBone", "toolDiameter", "leadIn",
//                         "bumps", "sheet": [w, h], "sheetCount",
//                         "offcuts": [ { "count", "shape": as in shapes } ], "price" } ],
//       "shapes":     [ { "contour": [[x, y], ...], "holes": [ [[x, y], ...], ... ] } ],
//       "sections":   [ { "id", "name", "stock": id, "shape": index in shapes, "locked",
//                         "parent": { "section": ref, "slitFrom": [x, y], "slitTo": [x, y],
//                                     "free", "holdsTo": "proportion|left|right|bottom|top" },
//                         "frame": { "origin": [x, y, z], "x": [...], "y": [...] },
//                         "symmetry": { "point": [x, y], "direction": [x, y] },
//                         "figures": [ { "kind", "centre": [x, y], "turn",
//                                        "numbers": { "key": number } } ],
//                         "marks": [ { "kind": "engraved|scored", "paths": [ [[x, y], ...], ... ],
//                                      "lettering": { "text", "height", "at": [x, y],
//                                                     "turn" } } ] } ],
//       "operations": [ { "id", "kind", "version", "name", "on", "template": id, "stock": id,
//                         "inputs": { "role": [ { "section": ref, "name" } ] },
//                         "parameters": { "key": number, true, false or "choice" },
//                         "exceptions": [ { "instance": "key", "state": "hidden|detached",
//                                           "stock": id } ] } ],
//       "weights":    [ { "id", "section": ref, "position": [x, y], "mass" } ],
//       "joints":     [ { "a": ref, "b": ref, "kind": "crossLap|mortise|tabs|none", "opens": [x,
//       y],
//                         "shares": [ { "at": [x, y], "ofA" } ] } ],
//       "dimensions": [ { "id", "from": { "section": ref, "at": [x, y, z] }, "to": … } ],
//       "pins":       [ { "section": ref, "body", "sheet", "offcut", "at": [x, y],
//                         "turn": [cos, sin] } ],
//       "turnings":   [ { "section": ref, "turning": "none|half|quarter|free" } ],
//       "numbers":    [ { "name", "expression", "value" } ],
//       "values":     [ { "id", "name", "kind": "number|length|angle|count|mass|ratio|text|choice|
//                         switch", "typed", "lengthUnit", "massUnit", "angleUnit", "commas":
//                         "decimals|groups", "least", "most", "step", "choices": ["text", ...],
//                         "note", "group", "shown" } ],
//       "presets":    [ { "name", "settings": [ { "value": id, "typed", "lengthUnit" … } ] } ],
//       "bindings":   [ { "of": "stock|operation|section|figure|lettering|load|joint", "id", "a":
//                         ref, "b": ref, "index", "field", "typed", "lengthUnit" …, "result" } ],
//       "templates":  [ { "id", "kind": "mesh|picture|curves", "name", "blob": its SHA-256, "file",
//                         "on": ref, "frame", "scale", "flipped", "opacity", "hidden", "locked",
//                         "magnets": [ { "section": ref, "radius" } ] } ],
//       "blobs":      [ { "sha256", "mediaType", "name" } ] }
//
// Strengths and modulus are null when not rated; "opensForAdjusting" (then false), "parent",
// "holes", "weights", "joints", and of a joint all but its two sections, may be missing; of a
// section "locked", and of a parent "free" (then false) and "holdsTo" (then proportion), of a
// section "figures" (core/geometry/figure.h), which say what boundaries were made of, as far as
// they are as those still, "symmetry", to which line it stays symmetric when its points are edited
// (core/model/symmetric_section.h), "marks" (core/model/mark.h), of a mark "lettering";
// "dimensions" and "numbers" (core/model/dimension.h, named_number.h), of an anchor "section";
// "pins" and "turnings" (core/model/sheet_wishes.h), of a pin "body" (then 0) and "turn" (then [1,
// 0]); "values" (core/values/values.h) and of one all but its id, name, kind and what was typed;
// "presets" (core/values/presets.h); "bindings" (core/model/binding.h), which say of numbers that
// stand elsewhere in the file of what they are made, and what that came to ("result", as the number
// is in the file; another number there is one by itself), of a joint by "a" and "b", of all else by
// "id"; "templates" (core/model/template.h), of one all that is not said of it by default, and
// "blob" or "file"; "blobs" (core/model/blob.h), whose bytes are beside the JSON
// (core/io/fff_file.h), of these "mediaType" and "name"; of a stock "slitEnd" (then square),
// "toolDiameter" (3.175), "leadIn" and "bumps" (0), "price" (then it is not known),
// "nominalThickness" (then it is sold by how thick it is), "measured" (false), "kerfs" (none),
// "sheetCount" (as many as it takes), "offcuts" (none; core/model/spare_sheet.h) and of one "count"
// (1); of a pin "offcut" (then "sheet" counts whole ones from 0 on, else offcuts); of an operation
// "on" (then true), "template" and "stock" (of kinds that make sections of one) and "exceptions".
// Kinds of operations, their roles and parameters: core/operations; a file keeps also those that do
// not count. `joints` are those of which something is wanted (core/model/joint_override.h). A
// contour has three control points a segment, p0 h h, a segment on each line; the last closes onto
// the first. A ref is the id of a drawn section, or { "operation": id, "instance": "key" } for one
// that an operation makes; the latter may name nothing now (dormant). `shapes` stand in the order
// of their first use; sections that name the same index share one Shape, as they did when written.
// Unknown keys are passed over: what changes the meaning of a file raises its version.
#pragma once

#include "core/io/blobs.h"
#include "core/io/loaded_document.h"

namespace fff::io {

inline constexpr int kFffVersion = 3;

/// The document as text; of blobs their names. Errors  NonFinite when a number of the document is
/// not finite.
Result<std::string> writeFff(const Document &document);

/// Reads a whole file. write and read again gives an equal document; numbers come back bit for bit,
/// but for the sign of zero. Shapes that another program or hand spoilt are mended.
///
/// name      how errors call the file; empty: places are without it
/// blobs     where their bytes are
/// Errors    BadSyntax, Truncated, NonFinite at name:line; NotAModel, NewerVersion; and at
///           name:$.json.path  BadValue, DuplicateId, UnknownReference, DegenerateFrame (axes off
///           by more than kFrameRounding), BadContour, EmptyContour, Unsupported (a kind of
///           operation, or a version of one, that is not known here).
/// Warnings  SkewFrame: axes off by more than rounding of a double, made orthonormal again.
///           Those of core/model/mended_shape.h. MissingBlob: what `blobs` does not have, or all
///           without it, is left out.
Result<LoadedDocument> readFff(std::string_view bytes, const std::string &name = {},
                               const BlobSource &blobs = {});

} // namespace fff::io
