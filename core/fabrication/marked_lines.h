// What is drawn on a section (core/model/mark.h), as far as it is on one of its parts.
#pragma once

#include "core/fabrication/part.h"
#include "core/model/mark.h"

#include <optional>

namespace fff {

struct MarkedLines
{
    std::vector<CurvePath> engraved, scored; // the part's coordinates, mm
    std::optional<Error> error; // of one that could not be cut off at the edge: it is whole

    bool isEmpty() const { return engraved.empty() && scored.empty(); }
};

/// Lines that are wholly on the part keep their curves; of others the pieces that are, as chords
/// within kDrawChord.
MarkedLines linesOn(const Part &part, const std::vector<MarkPointer> &marks);

} // namespace fff
