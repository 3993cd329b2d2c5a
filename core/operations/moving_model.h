// Moving sections of a model, drawn ones and images, with all that is on them: also what was drawn
// on sections that operations make, which follow those.
#pragma once

#include "core/model/model.h"
#include "core/model/moving.h"

#include <set>
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

/// All sections of the model that would move with these: they themselves, what is on them, and what
/// operations make of all that. Sections without an origin count as none.
std::set<SectionRef> movingWith(const Model &model, std::span<const SectionRef> sections,
                                bool takesChildren = true);

/// The section that it is on and keeps its angle to, as it is shown; null: none
/// (core/model/moving.h).
const Section *holderOf(const Model &model, const Section &section);

} // namespace fff
