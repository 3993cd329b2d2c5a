// A drawn section that numbers stretch, in agreement with all other numbers of it.
#pragma once

#include "core/geometry/plane_map.h"
#include "core/model/document.h"

#include <optional>

namespace fff {

/// As stretchedSection() (core/model/moving.h); but holes that are figures and words keep their
/// numbers, as far as there is room for them, and go along as their places do.
Result<Document> stretchedByNumbers(Document document, const Section &section, const PlaneMap &map);

/// The middle of its slit in its own plane, mm, which stays where it is however it is stretched;
/// nothing where it is on no drawn section.
std::optional<Vec2> slitMiddleOn(const Document &document, const Section &section);

} // namespace fff
