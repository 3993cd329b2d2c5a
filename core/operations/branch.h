// A section with its children, again and again in place of children of it.
#pragma once

#include "core/operations/operation_kind.h"

namespace fff {

/// Inputs      "root"; "children", those of the sections on it whose place is taken; "where", the
///             section that holds the root: by its slit there copies are held. Without "where" it
///             is what the root was drawn on, else the root's lower end.
/// Hierarchy   the root with all that is attached to it, without what holds it.
/// Iterations  in each, every chosen child gives its place to a copy of the hierarchy, which brings
///             its own chosen children for the next one. The copy's root is as deep in as the child
///             was, lies in its plane and grows where it grew.
/// Variation   scale and angle, in the plane, of each copy by itself: from the seed and the copy's
///             path alone, so the same everywhere and whatever else changes.
/// Stops       where a copy's root would be smaller than `smallest`, the child stays; where more
///             than `most` sections would be made, everything does.
/// Keys        the path of the children whose place was taken, "12/14", and below it "0" for the
///             root and the keys of the others.
/// Source      J. McCrae et al. 2014, FlatFitFab, "Branching operation", figure 13.
extern const OperationKind kBranch;

} // namespace fff
