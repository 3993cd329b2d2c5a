// What a tool is too wide for.
#pragma once

#include "core/geometry/boolean.h"

namespace fff {

/// Whether the middle of a tool on `path` comes within `reach` mm of every corner of the part's
/// boundary (of its chords, kDrawChord), and into every hole. Where it does not, a hole or a notch
/// stays uncut.
bool comesEverywhere(const CurvedRegion &part, const CurvedRegion &path, double reach);

} // namespace fff
