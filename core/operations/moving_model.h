// Moving sections of a model, drawn ones and images, with all that is on them: also what was drawn
// on sections that operations make, which follow those.
#pragma once

#include "core/model/model.h"
#include "core/model/moving.h"

#include <span>

namespace fff {

/// As SectionMove, of any section that has an origin (core/model/origin.h): of an image the drawn
/// section is moved, so that the image goes there.
struct RefMove
{
    SectionRef section;
    Similarity placement = {};
    bool breaksAngle = false;
};

/// Of a section and its image the first one counts. Errors  as movedSections(); UnknownReference,
/// place = the name, of one that an operation made in its own way.
Result<Document> movedSections(const Model &model, std::span<const RefMove> moves,
                               bool takesChildren = true);
/// As stretchedSection(), of a section that has an origin.
Result<Document> stretchedSection(const Model &model, const SectionRef &section,
                                  const Eigen::Matrix2d &matrix, const Vec2 &about,
                                  bool takesChildren = true);

} // namespace fff
