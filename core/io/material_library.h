// Sheet materials from JSON: those that come with the program, and one's own.
#pragma once

#include "core/base/result.h"
#include "core/model/materials.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fff::io {

/// {"materials": [{...}]}, each with
///
///   name, density kg/m³, sheet [width, height] mm, and thicknesses [{...}] in which it is sold:
///     sold        mm, by which it is asked for
///     real        mm, how thick such sheets are as a rule; as sold where not said
///     kerf        mm, full width
///     kerfs       {KEY: mm} of machines (machine_library.h); none where not said
///   and what is not said of these is not rated, not known, or as in a new stock: tensile,
///   flexural, modulus (MPa), ductile, lastingShare, clearance (mm), price of a sheet
///
/// Members of other names are passed over. At most 1000 materials of 100 thicknesses.
/// name    how errors call the file
/// Errors  as parseJson(); BadValue, BadCount, DuplicateId (a name), with where in the file
Result<std::vector<Material>> readMaterials(std::string_view bytes, const std::string &name);

/// In the order in which they are offered; birchPlywood() and flatfabAcrylic() are not among them.
/// One's own come first.
std::span<const Material> materialLibrary();
/// For the rest of the time; one of a name that is there already comes in place of that.
void addOwnMaterials(std::vector<Material> own);

} // namespace fff::io
