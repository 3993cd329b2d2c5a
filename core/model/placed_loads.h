// The loads of a model where they act: on the sections that they were put on, and on the copies
// that operations made of these.
#pragma once

#include "core/model/model.h"

#include <optional>
#include <vector>

namespace fff {

struct PlacedLoad
{
    int load = 0;                 // its place in the document's list
    int section = 0;              // index in the model
    Vec2 position = Vec2::Zero(); // frame coordinates of that section, mm
    Vec3 push = Vec3::Zero();     // N, along x, y and the normal of that section's frame
    bool isCopy = false;          // on a copy of the section that it was put on
};

/// By their places in the document, then by sections; those on sections that are not there now are
/// left out. A copy carries what its source carries where it has material at that place: of what an
/// operation cut up each piece has its own. O(sections) where there are loads.
std::vector<PlacedLoad> placedLoads(const Model &model);

/// How many copies of its section carry it, too.
int copiesCarrying(const Model &model, const Load &load);

/// What a copy carries of what is on its sources, as loads that were put on the copy itself; with
/// the ids of the loads that they are of.
std::vector<Load> carriedLoads(const Document &document, const Section &copy);

/// The load as it has to be on the section that it was put on, to be at `position` and push by
/// `push` (frame coordinates) on a copy of that; so on that section itself. Nothing where `on` is
/// neither.
std::optional<Load> asOnCopy(const Model &model, const Load &load, const SectionRef &on,
                             const Vec2 &position, const Vec3 &push);

} // namespace fff
