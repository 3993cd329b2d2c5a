// A template as a box of flat sheets, in its place, or as nets to fold.
#pragma once

#include "core/operations/facet_model.h"
#include "core/operations/net_model.h"

#include <optional>

namespace fff {

inline constexpr std::size_t kFewestFaces = 4; // of what encloses anything

/// The template stays as it is. Sheets stand on the ground where the mesh's lowest corner stood on
/// it: their own corners end before those of the mesh.
///
/// faces   the mesh is simplified to this many triangles first, stood on the face that it leans on
///         then (stood_mesh.h), and made as large again; none: it is taken as it is
/// Errors  those of simplified() and facetModel(); UnknownReference for a template that is not
///         there or has no mesh.
Result<FacetModel> facetted(const Document &document, TemplateId of,
                            std::optional<std::size_t> faces = {}, const LongWork &work = {});

/// The same as nets to fold, beside the template.
///
/// flap    mm, width of the flaps to glue; 0: none
/// Errors  those of simplified() and netModel(); UnknownReference as above.
Result<NetModel> unfolded(const Document &document, TemplateId of, std::optional<std::size_t> faces,
                          double flap, const LongWork &work = {});

} // namespace fff
