// Which boundaries of a section are figures still: made of numbers, and not edited since.
#pragma once

#include "core/model/document.h"

namespace fff {

/// The boundary (0 the contour, 1 … the holes) that is as the figure makes it; −1: none is.
int boundaryOf(const Shape &shape, const Figure &figure);
/// The figure that a boundary is as; null: it is none.
const Figure *figureOf(const Section &section, int boundary);

/// The section with this figure as one of its own, if one of its boundaries is as it makes it.
/// Errors  UnknownReference.
Result<Document> addFigure(Document document, SectionId id, Figure figure);
/// Another figure in place of the one that a boundary is as; the boundary follows. Errors also:
/// those of contourOf() and of core/model/point_edits.h; BadValue, place "boundary", where it is
/// none.
Result<Document> setFigure(Document document, SectionId id, int boundary, const Figure &figure);

} // namespace fff
