// Reads the `.txt` models of FlatFab: planes with closed chains of cubic Béziers, in units of the
// user's choice (one inch unless said otherwise). The format stores neither stock nor weights nor
// parents, so sections get acrylic of an eighth of an inch and no parent.
#pragma once

#include "core/base/units.h"
#include "core/io/formats.h"

namespace fff::io {

struct FlatfabOptions
{
    double unitMm = kPaperUnit; // mm a unit of the file; positive
    Naming naming = {};         // of its sections, which have no names in the file
};

/// Reads a whole file; every world point P + uT + vB of the file stays where it is, whatever the
/// file's axes are.
///
/// name      how errors call the file; empty: places are the line only
/// Errors    NotAModel; at name:line  Truncated, BadSyntax, BadValue, NonFinite, BadCount,
///           DegenerateFrame, BadContour, EmptyContour
/// Warnings  SkewFrame: T, N, B off by more than kFrameRounding from three orthonormal axes; the
///           plane is that of T and B. Those of core/model/mended_shape.h. TrailingLines.
/// Takes     both header words, files without BoundaryCurves, CR LF, blank lines, several blanks
///           between numbers, curves of any winding, axes that are not orthonormal.
/// Nothing is allocated because of a count alone: memory follows the bytes that are there.
Result<LoadedDocument> readFlatfab(std::string_view bytes, const std::string &name = {},
                                   const FlatfabOptions &options = {});

/// The first line is that of such a file.
bool looksLikeFlatfab(std::string_view bytes);

/// Its option "unit-mm" is FlatfabOptions::unitMm.
const Format &flatfabFormat();

} // namespace fff::io
