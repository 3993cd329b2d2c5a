// Whether sections stay symmetric when their points are edited.
#pragma once

#include "core/interaction/section_edit.h"
#include "core/model/model.h"

#include <optional>
#include <vector>

namespace fff {

/// The line to which it is symmetric as it is now: the one that it stays so to, that of its slit,
/// or one through the middle of its box. None: to none of them.
std::optional<MirrorAxis> symmetryAxis(const Section &section, const Document &document);

/// All of them stay symmetric, or need not any more. Refused for one that is not symmetric now, and
/// for one that an operation made.
SectionEdit keptSymmetric(const Model &model, const std::vector<SectionRef> &sections, bool isKept);

} // namespace fff
