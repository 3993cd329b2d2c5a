// Edits of dimensions that stay, and where their ends are now.
#pragma once

#include "core/model/model.h"

namespace fff {

/// Appends a dimension (its id is given). Errors  UnknownReference of a drawn section; BadValue,
/// place "to", where both ends are the same place.
Result<Document> addDimension(Document document, const Anchor &from, const Anchor &to);
/// Errors  UnknownReference, place = the id.
Result<Document> removeDimension(Document document, DimensionId id);

/// In the world, mm; nothing where its section is not shown.
std::optional<Vec3> placeOf(const Model &model, const Anchor &anchor);
/// The place in the world as one of the section; without a section as it is.
Anchor anchorOn(const Section *section, const Vec3 &place);

/// Anchors at control points of the section go along with those, as long as it has as many.
void followPoints(Document &document, SectionId id, const Shape &before, const Shape &after);

} // namespace fff
