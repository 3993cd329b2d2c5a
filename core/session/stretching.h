// Sections that end a little above the ground, drawn out down to it so that the model stands.
#pragma once

#include "core/session/checks.h"

#include <optional>
#include <vector>

namespace fff {

/// The section (index into the model) with its lowest point on the ground: what of it lies below
/// the lowest of its slits and joints, less a thickness, becomes longer, evenly, along its own
/// plane; all above that level stays as it is. Curves stay curves, and what did not cross itself
/// does not.
///
/// Nothing for a section that is on the ground or below it, that has nothing to stretch, that would
/// more than double what is stretched, that leans by more than 60° from upright, or that an
/// operation made. O(control points + slits).
std::optional<ShapePointer> stretchedToGround(const Analysis &analysis, int section);

/// Of a group of sections that falls over as one body, those that make it stand once they are
/// stretched: one if one is enough, the one that is nearest to the ground first, else as few of the
/// lowest as it takes. Empty when there are none, or when what is new of them would come upon
/// another section.
///
/// Taken for possible by what of them reaches the ground, then tried: a trial costs an edit and
/// what the group takes to be weighed, O(its vertices).
std::vector<HighFoot> feetToStretch(const Analysis &analysis, const std::vector<int> &group);

/// The document with these stretched. Nothing when one of them cannot be, or not any more.
std::optional<Document> stretched(const Analysis &analysis, const std::vector<HighFoot> &feet);

} // namespace fff
