// The joint of one pair of sections, by itself.
#pragma once

#include "core/assembly/tabs.h"

#include <optional>
#include <vector>

namespace fff {

/// A joint before it has a number: its id, and that in its slits, is 0.
struct FoundJoint
{
    Joint joint;
    std::vector<Slit> slitsOfA, slitsOfB;
};

JointSide sideOf(const Model &model, int section);

/// Of two sections (indices into the model, a < b), as the document wants it; nothing where they do
/// not meet. Tabs are only had where they are wanted, instead of anything else. The same as
/// assemble() has it.
std::optional<FoundJoint> findJoint(const Model &model, int a, int b);

/// The tabs that they could have, whatever is wanted of them.
tl::expected<TabJoint, NoTabs> tabsOf(const Model &model, int a, int b);

/// What the two are cut by when this is wanted of them. The crossing is theirs and has an overlap;
/// it is told where their slits meet.
JointSlits slitsOf(const Model &model, int a, int b, Crossing &crossing, const JointWish &wish);

/// Of a joint of the model that has none.
NoSlit whyNoSlit(const Model &model, const Joint &joint);

} // namespace fff
