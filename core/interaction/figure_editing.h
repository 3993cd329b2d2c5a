// Shapes by numbers: what adding one, or changing its numbers, makes of the document.
#pragma once

#include "core/interaction/contour_target.h"
#include "core/interaction/section_edit.h"

namespace fff {

/// A new section with the figure as its contour, upright in the front plane, on the ground and
/// beside what is there; it is selected. The figure's centre does not count.
SectionEdit addedFigure(const Model &model, Figure figure, const DrawingRules &rules);
/// The figure as a hole, at its centre (frame coordinates).
SectionEdit figureHole(const Model &model, const SectionRef &section, const Figure &figure);
/// The same as near to the middle of the section as it fits, at most a third as large as that, and
/// upright as the section stands. Refused where it fits nowhere (HoleOutside).
SectionEdit figureHoleInside(const Model &model, const SectionRef &section, Figure figure);
/// The figure in place of the contour, as large as that and where it is.
SectionEdit figureContour(const Model &model, const SectionRef &section, const FigureKind &kind);
/// Other numbers of the figure that a boundary is. Steps of the same one after the other are one.
/// Refused as an edit of its points would be.
SectionEdit changedFigure(const Model &model, const SectionRef &section, int boundary,
                          const Figure &figure);

/// Which way is up in the section's plane, as an angle from its x, radians; 0 for a level one.
double uprightTurn(const Frame &frame);

} // namespace fff
