// Sections that end a little above the ground, drawn out down to it so that the model stands.
#pragma once

#include "core/analysis/analysis.h"

#include <optional>
#include <vector>

namespace fff {

/// A section that ends above the ground and would help to stand there.
struct HighFoot
{
    SectionRef section;
    double height = 0.0;    // of its lowest point above the ground, mm
    Vec3 at = Vec3::Zero(); // that point, world, mm
};

/// The section (index into the model) with its lowest point on the ground: what of it lies below
/// the lowest of its slits and joints, less a thickness, becomes longer, evenly, along its own
/// plane; all above that level stays as it is. Curves stay curves, and what did not cross itself
/// does not. Of one that would touch the ground with a point, as what is drawn by hand does, a
/// thickness more is drawn out and cut off there: it gets a level sole.
///
/// Nothing for a section that is on the ground or below it, that has nothing to stretch, that would
/// more than double what is stretched, that leans by more than 60° from upright, or that an
/// operation made. O(control points + slits + joints of the model).
std::optional<ShapePointer> stretchedToGround(const Analysis &analysis, int section);

/// Of a group of bodies (indices into the list) that falls over as one, the sections that make it
/// stand once they are stretched: one if one is enough, the one that is nearest to the ground
/// first, else of the lowest four as few as it takes; of more than 32 that end above the ground the
/// lowest are looked at. Empty when none of these help, see standingOn().
///
/// Taken for possible by what of them reaches the ground, then tried, of several together one set
/// alone. A trial costs an edit, weighing the group and a look at all sections' boxes: O(vertices).
std::vector<HighFoot> feetToStretch(const Analysis &analysis, const std::vector<int> &group);

/// The document with these stretched. Nothing unless the group then stands, all joints are as they
/// were, and none of them touches a section that it did not touch before.
std::optional<Document> standingOn(const Analysis &analysis, const std::vector<int> &group,
                                   const std::vector<HighFoot> &feet);

} // namespace fff
