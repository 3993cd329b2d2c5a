// What a drawing is of, for people: a list of its parts, and how far the machine cuts.
#pragma once

#include "core/fabrication/cutting_drawing.h"
#include "core/fabrication/listed_part.h"

#include <vector>

namespace fff {

/// In the order of their first numbers. The same is what is of one stock and has the same points to
/// kClipGrid, where they were drawn: copies made by operations are, and what was pasted.
///
/// parts  of the model, as designed
/// O(points) where few parts are as large as another.
std::vector<ListedPart> partList(const std::vector<Part> &parts, const Model &model);

/// Of all cuts, outsides and holes, mm; along chords within kCutChord. What is engraved is not in
/// it.
double cutLength(const CuttingDrawing &drawing);

} // namespace fff
