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
        Vec3 slide;
        double heldFrom; // squared sine: ways that turn from the slide by more move both
        double length;   // mm that they are held
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
    bool isIgnored(int a, int b) const;
    /// Of all parts, there or not.
    Obstacles &obstaclesOf(int part, int direction);
    bool isInTheWay(Obstacle &obstacle, int part, int direction);
    /// The first one that is in the way.
    std::optional<int> firstObstacle(int part, int direction);
    /// Calls visit(part) for those that cannot but move with it in this direction.
    template <class Visit>
    void forEachHeld(int part, const Vec3 &along, Visit visit) const;
    /// Which of those there the slits hold together in this direction: of each part the number of
    /// its heap, that of the last part first; and how many heaps there are.
    std::pair<std::vector<int>, int> heaps(const Group &parts, int direction) const;
    /// Of those that nothing is in the way of, the smallest; of equal ones that of the last part.
    std::optional<Group> smallestOff(const Group &parts, int direction, std::size_t fewerThan);
    std::optional<Removal> bentOff(int part, int direction, double held);
    /// Whether nothing that is there is in its way from `by` on.
    bool comesFree(int part, const Vec3 &by, const Vec3 &direction);
    /// Across the part to both sides, and along the axes of the world.
    std::vector<Vec3> turnsOf(int part) const;

    Collisions &m_collisions;
    const PlanOptions &m_options;
    std::vector<Way> m_ways;
    std::multimap<double, int> m_waysAlong; // by how far they reach along one odd direction
    int m_freeWays = 0;                     // so many of them, the first ones, are the world's
    std::vector<std::vector<Mate>> m_mates; // of each part
    BoxTree m_boxes;                        // of all parts
    std::vector<std::map<int, Obstacles>> m_obstacles; // of each part, by direction

    Group m_group; // of which some are there
    std::vector<char> m_isThere;
    std::size_t m_count = 0;
    int m_run = 0;
    std::vector<Holding> m_holding;
    std::vector<std::vector<int>> m_waiting; // for each part to go
    bool m_isOutOfTime = false;
};

} // namespace fff
