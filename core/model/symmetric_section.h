// Sections that stay the same on both sides of a line when their points are edited.
#pragma once

#include "core/model/document.h"

namespace fff {

/// The line to which the section is symmetric and is to stay so; null: it is not, or no more, since
/// something was done to one side of it (a hole, a cut at the ground).
const MirrorAxis *symmetryOf(const Section &section);

bool isSymmetric(const Shape &shape, const MirrorAxis &axis);

/// What an edit of `before` came to, made the same on both sides: the side on which most of its
/// control points changed has the say. Errors  as withImage() (mirrored_boundaries.h); SelfCrossing
/// and BoundariesMeet where the image meets what it is the image of.
Result<ShapePointer> symmetrised(const Shape &before, const ShapePointer &after,
                                 const MirrorAxis &axis);

/// That it stays so, or (none) that it need not. Errors  UnknownReference; BadValue, place
/// "symmetry", where it is not symmetric to that line.
Result<Document> setSymmetry(Document document, SectionId id, std::optional<MirrorAxis> axis);

} // namespace fff
