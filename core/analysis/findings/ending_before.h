// Where several sections cross at one place: one of them ends at another's face.
#pragma once

#include "core/analysis/finding_action.h"

namespace fff {

/// Of the finding's sections and those that cross them, the one, and the face, that leaves least
/// loose.
extern const ActionKind kEndBefore;

} // namespace fff
