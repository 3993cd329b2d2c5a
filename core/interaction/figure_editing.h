// Shapes by numbers: what adding one, or changing its numbers, makes of the document.
#pragma once

#include "core/interaction/camera.h"
#include "core/interaction/contour_target.h"
#include "core/interaction/section_edit.h"

namespace fff {

/// Where a section goes that is had by numbers: before whoever looks.
struct FigurePlace
{
    Camera camera;
    Vec2 viewport = Vec2(1280.0, 800.0); // px
    /// In whose plane; null: in that of the section drawn last, and where there is none in one that
    /// the view faces, upright unless it looks down.
    const Section *section = nullptr;
};
/// A new section with the figure as its contour, in that plane where the view's middle is, or to
/// the right of what is there; x to the right and y up, as seen. In an upright plane it stands on
/// the ground. It is selected. The figure's centre does not count.
SectionEdit addedFigure(const Model &model, Figure figure, const FigurePlace &place,
                        const DrawingRules &rules);
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

} // namespace fff
