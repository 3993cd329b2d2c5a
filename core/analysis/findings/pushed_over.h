// What would stand, but for a push.
#pragma once

#include "core/analysis/finding.h"
#include "core/analysis/strength.h"

namespace fff {

extern const FindingKind kPushedOver;

/// Of what its feet do not hold against a push, over the ground, (x, z).
struct PushedOver
{
    Vec2 onGround = Vec2::Zero(); // where all weights and pushes together meet it
    Vec2 centre = Vec2::Zero();   // below the centre of the weights alone
    Polygon support = {};         // hull of its feet
};

/// What its feet do not hold against a push; masses alone are looked at where it is said whether it
/// stands.
void findPushedOver(const Strength &strength, std::vector<Finding> &found);

} // namespace fff
