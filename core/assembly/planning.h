// In which order, from where and how far the parts of a model are put together.
#pragma once

#include "core/assembly/collisions.h"
#include "core/assembly/joined_parts.h"

#include <functional>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace fff {

/// Two parts that hold each other: b comes off a along `direction` (unit), and a off b against it;
/// of a mortise both ways.
struct Slide
{
    int a = 0, b = 0; // indices of the solids, a < b
    Vec3 direction = Vec3::UnitY();
    bool goesBothWays = false;
    /// Radians: along directions that turn from both ways of this one by more, they cannot but move
    /// together. From a right angle on, none of them is known to hold.
    double play = std::numbers::pi;
    /// mm of its way after which nothing holds them any more; endless: not known.
    double length = std::numeric_limits<double>::infinity();
};

/// Along a straight line.
struct Move
{
    Vec3 direction = -Vec3::UnitY(); // unit
    double distance = 0.0;           // mm

    bool operator==(const Move &other) const
    {
        return direction == other.direction && distance == other.distance;
    }
};

struct AssemblyStep
{
    std::vector<int> parts; // that are moved as one, ascending
    JoinedParts onto;       // what they are brought to; empty: put down first
    /// From clear of the others to their place, the last one into the slits; of what is put down
    /// first none.
    std::vector<Move> moves;

    bool operator==(const AssemblyStep &) const = default;
};

struct AssemblyPlan
{
    enum class Verdict {
        Possible,
        Impossible, // with these slits, by such moves
        NotFound,   // within the time
    };

    Verdict verdict = Verdict::NotFound;
    /// In their order. What is moved as one has been put together by earlier steps. Of an
    /// impossible model none.
    std::vector<AssemblyStep> steps;
    /// Impossible: parts of which no group comes off the others in any direction, as few of them as
    /// were found, ascending.
    std::vector<int> locked;
};

struct PlanOptions
{
    /// Pairs (lower first) that are in each other where they end up, and no deeper on their way
    /// than Collisions says; ascending. Their slits tell nothing about them.
    std::vector<std::pair<int, int>> inEachOther;
    std::function<bool()> isOutOfTime; // asked again and again; empty: never
};

/// Takes the model apart and turns that round: single parts first, groups of them where no single
/// one comes off. Moves are along straight lines, with the true solids against all others that are
/// there: one line, or, where that ends in another part, a short one out of the slits and then
/// another one, along the world's axes or a part's own.
///
/// A group that comes off cuts at least one joint in two, so that it begins to move the way in
/// which that one slides: looking at the slides' directions is enough, and what comes off at some
/// time comes off at any later one. So the verdict is right for moves of this kind, whatever the
/// order in which parts are tried. Parts and groups that nothing holds may also come off along the
/// axes of the world.
///
/// collisions  of the parts; how deep they may be in each other on their way is said there
/// slides   those of all joints; parts that no slide connects are brought together last
/// Result   deterministic: parts that come later in the list are taken off first, so that the
///          first one is mostly what is begun with. Each pair is looked at once for each direction
///          at most, and only where one is in the sweep of the other; pairs that slits hold are not
///          looked at for what moves as one. Who does not come off is not tried again before
///          what was in its way has gone.
/// Source   R. Wilson, J. Latombe 1994, Geometric reasoning about mechanical assembly (blocking
///          graphs; a group comes off where they are not strongly connected).
AssemblyPlan planAssembly(Collisions &collisions, const std::vector<Slide> &slides,
                          const PlanOptions &options = {});

} // namespace fff
