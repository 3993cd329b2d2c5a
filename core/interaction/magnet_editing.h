// What comes of letting sections pull templates: shared by commands and the fields of the window.
#pragma once

#include "core/interaction/section_edit.h"
#include "core/model/model.h"

namespace fff {

/// The sections pull all meshes that are not locked from so far (mm), or none of them.
SectionEdit magnetsChanged(const Model &model, const std::vector<SectionRef> &sections,
                           std::optional<double> radius);

} // namespace fff
