// What a stroke was meant to be, offered once it is there: a chip beside what was drawn, and a key
// that takes it.
#pragma once

#include "core/interaction/contour_target.h"
#include "core/interaction/overlay.h"
#include "core/stroke/slit_neck.h"

#include <optional>

namespace fff {

struct ShapeOffer
{
    Step step;         // of taking it
    Document document; // that it makes
    Signs signs;       // the chip
    Hint done;         // what is said when it was taken
};

/// What an offered section looks like, with the chip below it.
Signs offerSigns(Text words, const DrawnContour &made);

/// Of a contour as it was drawn, before the ground cut it. What is offered is judged like a drawn
/// one: none where that would be refused, or where nothing better was meant.
///
/// before     the document that the stroke began with
/// tolerance  that the contour was fitted to, mm
/// slit       that is to hold it, too; none: nothing is
std::optional<ShapeOffer> shapeOffer(const Document &before, const ContourTarget &target,
                                     const Contour &drawn, double tolerance,
                                     const DrawingRules &rules,
                                     const std::optional<SlitToReach> &slit);

} // namespace fff
