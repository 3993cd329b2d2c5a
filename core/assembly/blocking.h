// Which parts are in whose way. Internal to assembly.
#pragma once

#include "core/assembly/planning.h"
#include "core/geometry/box_tree.h"

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace fff {

using Group = std::vector<int>; // of parts, ascending

/// Which part is in whose way, in each direction that something may move in, while a group of them
/// is taken apart. A pair is looked at when somebody asks; pairs that their slits hold are told
/// without a look, and what is nowhere near the way of a part is not even a pair.
///
/// Source  R. Wilson, J. Latombe 1994 (directional blocking graphs).
class Blocking
{
public:
    Blocking(Collisions &collisions, const std::vector<Slide> &slides, const PlanOptions &options);

    /// From now on these are there, and no others. O(what holds them).
    void begin(const Group &parts);
    /// Takes away what is there. Appends those that did not come off straight and may do so now.
    void remove(const Group &parts, std::vector<int> &woken);
    bool has(int part) const { return m_isThere[static_cast<std::size_t>(part)]; }
    std::size_t count() const { return m_count; }
    Group there() const;

    /// Parts that come off others.
    struct Removal
    {
        Group parts;
        std::vector<Move> moves; // out of their place; of the last one no distance
    };

    /// A part off all that is there, along one line. One that does not come off is woken once that
    /// may have changed.
    std::optional<Removal> straightOff(int part);
    /// The same along two lines: out of the slits that hold it, and on from there.
    std::optional<Removal> bentOff(int part);
    /// The smallest group that comes off the rest, straight.
    std::optional<Removal> smallestOff();
    /// The moves until what comes off is clear of those that `isRest` says are the rest.
    std::vector<Move> measured(const Removal &removal, const std::function<bool(int)> &isRest);

    /// Once the time is over everything is in everything's way.
    bool isOutOfTime();

private:
    static constexpr int kNone = -1;

    /// Another part that one may run into.
    struct Obstacle
    {
        int part;
        std::optional<bool> isInTheWay; // once somebody has looked
    };
    struct Obstacles
    {
        std::vector<Obstacle> all; // ascending
        int run = -1;              // of begin(), for which
        std::size_t passed = 0;    // so many of the first ones are not in the way any more
    };
    struct Way
    {
        Vec3 along;
        int number, opposite; // Collisions::way()
    };
    struct Mate
    {
        int part;
        std::array<int, 2> directions; // in which one comes off it; −1: none
        std::array<int, 2> itsOwn;     // in which it comes off that one
        int slide;                     // which one holds them; −1: none does
        double length;                 // mm that they are held
    };
    /// Two parts that cannot but move together, unless along a way that hardly turns from this one.
    struct Hold
    {
        Vec3 slide;
        double from; // squared sine: ways that turn by more move both
    };
    /// What of a part's mates is there.
    struct Holding
    {
        int count = 0;
        std::size_t first = 0;                 // none before this one is there
        std::vector<std::pair<int, int>> ways; // a direction, how many let it go there; ascending
    };

    std::size_t partCount() const { return m_mates.size(); }
    int indexOf(const Vec3 &direction);
    const Way &way(int direction) const { return m_ways[static_cast<std::size_t>(direction)]; }
    std::vector<int> waysOff(int part);
    std::vector<int> waysApart() const;
    bool areInEachOther(int a, int b) const;
    /// Of all parts, there or not.
    Obstacles &obstaclesOf(int part, int direction);
    bool isInTheWay(Obstacle &obstacle, int part, int direction);
    /// The first one that is in the way.
    std::optional<int> firstObstacle(int part, int direction);
    /// The slides that hold nothing together in this direction.
    const std::vector<int> &looseSlides(int direction);
    /// What of the parts there the slits hold together, whichever way they go but one's own.
    struct HeldParts
    {
        struct Mate
        {
            int place, slide;
        };
        Group parts;                     // the last one first
        std::vector<std::size_t> begins; // of each one's mates, and behind the last ones
        std::vector<Mate> mates;
    };
    HeldParts heldParts();
    /// The same that move as one in some direction: heap by heap, that of the last part first.
    struct Heaps
    {
        std::vector<int> places;         // in HeldParts::parts
        std::vector<std::size_t> begins; // of each heap, and behind the last one
        std::vector<int> heapOf;         // of each place
        std::size_t count() const { return begins.size() - 1; }
        std::size_t size(std::size_t heap) const { return begins[heap + 1] - begins[heap]; }
    };
    /// None when all of them are one. O(parts and what holds them).
    std::optional<Heaps> heaps(const HeldParts &held, int direction);
    /// Of those that nothing is in the way of, the smallest; of equal ones that of the last part.
    std::optional<Group> smallestOff(const HeldParts &held, const Heaps &heaps, int direction,
                                     std::size_t fewerThan);
    /// Appends to `stops` who would have to go, one of them at least, before it does come off.
    std::optional<Removal> bentOff(int part, int direction, double held, Group &stops);
    /// One that is there and in its way from `by` on.
    std::optional<int> stopBeyond(int part, const Vec3 &by, const Vec3 &direction);
    /// Across the part to both sides, and along the axes of the world.
    std::vector<Vec3> turnsOf(int part) const;

    Collisions &m_collisions;
    const PlanOptions &m_options;
    std::vector<Way> m_ways;
    std::multimap<double, int> m_waysAlong;  // by how far they reach along one odd direction
    int m_freeWays = 0;                      // so many of them, the first ones, are the world's
    std::vector<std::vector<Mate>> m_mates;  // of each part
    std::vector<Hold> m_holds;               // by the slides that hold
    std::map<int, std::vector<int>> m_loose; // of them, by direction
    BoxTree m_boxes;                         // of all parts
    std::vector<std::map<int, Obstacles>> m_obstacles; // of each part, by direction

    Group m_group; // of which some are there
    std::vector<char> m_isThere;
    std::size_t m_count = 0;
    int m_run = 0;
    std::vector<Holding> m_holding;
    std::vector<std::vector<int>> m_waiting; // for each part to go
    std::vector<Group> m_stops;              // of each part that did not come off bent
    std::vector<int> m_placeOf;              // of each part in the last HeldParts
    std::vector<char> m_isLoose;             // of each slide, in the direction that is looked at
    bool m_isOutOfTime = false;
};

} // namespace fff
