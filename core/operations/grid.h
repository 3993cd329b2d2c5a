// A section too large for the machine, as cells that connectors hold together.
#pragma once

#include "core/operations/operation_kind.h"

namespace fff {

/// Input       "section", whose place its cells take.
/// Cells       of a grid along the section's axes, counted from its box's corner: of the given
/// size,
///             or as few and as equal as fit its stock's sheet. What of a cell is less than
///             `sliver` of a whole one goes to the neighbour with which it has most edge in common.
/// Connectors  are squares at a right angle to the section and to the seam, half in either cell;
///             their slits are those of any joint, which makes an H of each. Where a cell is too
///             narrow to hold half of one, there is none.
/// Jigsaw      in place of connectors: a knob a stretch of seam, by turns to either side, with
///             clearance round it.
/// Clearance   of seams: what is missing between two cells.
/// Keys        cells "c/column/row", connectors "x/…" across upright seams and "y/…" across level
///             ones, by seam, row, and number.
/// Source      J. McCrae et al. 2014, FlatFitFab, "Grid operation", figure 14.
extern const OperationKind kGrid;

} // namespace fff
