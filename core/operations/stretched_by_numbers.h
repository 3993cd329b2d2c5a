// A drawn section that numbers stretch, in agreement with all other numbers of it.
#pragma once

#include "core/geometry/plane_map.h"
#include "core/model/document.h"

#include <optional>

namespace fff {

/// As stretchedSection() (core/model/moving.h); but holes that are figures and words keep their
/// numbers, as far as there is room for them, and go along as their places do.
Result<Document> stretchedByNumbers(Document document, const Section &section, const PlaneMap &map);

/// Cosine of the angle within which a way is upright enough to stand on, and a slit lies along it:
/// 30 degrees.
inline constexpr double kUpright = 0.866;

/// The middle of its slit in its own plane, mm, which stays where it is when it is stretched along
/// this way (a direction of its plane). Nothing where it is on no drawn section, or where the way
/// is upright and the slit lies along it: then it stays in the slit, and its feet where they are.
std::optional<Vec2> slitHolding(const Document &document, const Section &section,
                                const Vec2 &along);

} // namespace fff
