// Letters as single lines, which a laser follows in one go: a plain upright alphabet of our own.
#pragma once

#include "core/base/result.h"
#include "core/model/mark.h"

namespace fff {

/// The lines of the words; lines of text are centred under each other, and all of it about
/// `lettering.at`. Letters are those of Latin 1 and what European languages add to it.
/// Errors  BadValue, place "text": there is nothing to be seen in it, or one of its letters is none
/// of the alphabet (args: that letter); place "height": not above 0.
Result<std::vector<CurvePath>> letterPaths(const Lettering &lettering);

/// A mark of these words. Errors  as letterPaths().
Result<MarkPointer> letteredMark(const Lettering &lettering, Mark::Kind kind);

/// From one line of text to the next, in heights of a capital.
inline constexpr double kLineSpacing = 1.7;

} // namespace fff
