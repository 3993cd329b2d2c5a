// Which of some rigid things can move at all, when none may go into another one.
#pragma once

#include "core/assembly/contacts.h"

#include <vector>

namespace fff {

/// A thing that must not go into what it touches, itself a thing or at rest.
struct RigidContact
{
    static constexpr int kAtRest = -1;

    int thing = 0, other = kAtRest;
    Contact contact; // a point of the thing before the other one; of either, it is the same
};

/// From where on a thing is loose.
struct Looseness
{
    double play = 0.0;  // mm: what is taken off at every contact, beyond the gap there
    double limit = 0.5; // mm: what may move by no more is held
};

/// Of each thing whether it can be moved by more than the limit, in whatever way, turns included,
/// the others moving as they like: along an axis of the world, or, where it touches, by a turn
/// about one. Told to first order, for which the limit has to be small against what it touches;
/// what is held by the curve of a surface alone counts as movable. Nothing rubs.
///
/// A thing is kept from moving one way where pressing at the contacts can push it back, at no net
/// push on the others; the gaps there say how far it comes before. Where rounding leaves that open
/// it counts as movable. Least squares of 6 rows a thing, up to 12 a thing.
/// Source  Z. Wang, P. Song, M. Pauly 2018, DESIA, 4.1: what is interlocked can balance every
/// force.
std::vector<char> movable(const std::vector<RigidContact> &contacts, int things,
                          const Looseness &looseness);

} // namespace fff
