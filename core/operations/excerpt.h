// A part of a model as a document of its own: what is copied, and what comes back from elsewhere.
#pragma once

#include "core/model/model.h"

#include <vector>

namespace fff {

/// These sections, as they stand, with the stocks that they are of. What is between them stays:
/// parents, weights on them, what is wanted of their joints, and operations that are wholly among
/// them, with all that they read and all that they made; symmetries of the whole model become those
/// of these sections. Templates stay, and with them what is made of them. A section that an operation
/// made and that is here without it becomes a drawn one. Ids stay what they are. The current stock
/// is that of the first section.
Document excerpt(const Model &model, const std::vector<SectionRef> &sections);
/// The same on its way back into this very document: parents that are not among the sections stay
/// theirs. It is none that could stand by itself.
Document attachedExcerpt(const Model &model, const std::vector<SectionRef> &sections);

/// The whole document, in which symmetries of the whole model are such of what it has now: so that
/// it changes nothing but itself where it goes.
Document selfContained(const Model &model);

} // namespace fff
