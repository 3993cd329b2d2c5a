// Sections elsewhere, larger, or stretched in their plane, with all that lies on them: shape,
// figures and marks; and what a document keeps at places of a section. Whoever moves, copies or
// scales sections maps them here.
#pragma once

#include "core/geometry/plane_map.h"
#include "core/geometry/similarity.h"
#include "core/model/document.h"

#include <functional>

namespace fff {

/// Contour and holes as the map has them (core/geometry/mapped_contour.h, stretch_band.h); the very
/// object for the identity. Errors  as Contour::fromPoints(); EmptyContour where next to nothing is
/// left.
Result<ShapePointer> mappedShape(const ShapePointer &shape, const PlaneMap &map);
/// The same, for those who keep shapes that they made before; not asked for the identity.
using ShapeMap = std::function<Result<ShapePointer>(const ShapePointer &, const PlaneMap &)>;

/// What lies on the section goes where the map puts it, its frame and its slit stay. Figures that
/// would be none of their kind and marks that would leave all bounds are left out. Errors  as
/// `shapeOf`, place = the section's name.
Result<Section> stretched(Section section, const PlaneMap &map,
                          const ShapeMap &shapeOf = mappedShape);
/// The section where the placement puts it: its frame is turned, mirrored and moved, what lies on
/// it is scaled with it. The slit, in the frame of what it is on, stays. Errors  as stretched().
Result<Section> transformed(Section section, const Similarity &placement,
                            const ShapeMap &shapeOf = mappedShape);
/// A copy of a section for an operation to make something of: wherever the functions above bring
/// it, it knows what it is a copy of.
Section asCopy(Section section);
/// The slit of a section that goes along with what it is on.
Parent transformed(Parent parent, const Similarity &placement);

/// What the document keeps at places of these sections, as the map of their planes puts it:
/// weights, ends of dimensions, which keep their height above it, shares of joints, and templates
/// that lie on them.
void mapPlaces(Document &document, const std::function<bool(const SectionRef &)> &isMapped,
               const PlaneMap &map);

} // namespace fff
