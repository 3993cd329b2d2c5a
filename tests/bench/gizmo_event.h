// One move of the handles of the gizmo, from the event to the model that is shown.
#pragma once

#include "core/model/document.h"

namespace fff::bench {

/// Milliseconds of CPU time, the median of some moves of a dragged section with what is on it:
/// picking, snapping to what is level, the edit, operations. What follows of a model (slits, parts,
/// verdicts) is worked out beside the drag; `edit` and `point` measure that.
double gizmoMove(const Document &document, SectionId section);

} // namespace fff::bench
