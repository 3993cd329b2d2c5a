// Which parts are in whose way. Internal to assembly.
#pragma once

#include "core/assembly/planning.h"

#include <optional>
#include <vector>

namespace fff {

using Group = std::vector<int>; // of parts, ascending

/// Of the first group what is not in the second one.
Group without(const Group &group, const Group &parts);

/// Which part is in whose way, in each direction that something may move in. A pair is looked at
/// when somebody asks; pairs that their slits hold are told without a look.
///
/// Source  R. Wilson, J. Latombe 1994 (directional blocking graphs).
class Blocking
{
public:
    Blocking(Collisions &collisions, const std::vector<Slide> &slides, const PlanOptions &options);

    /// Parts that come off others.
    struct Removal
    {
        Group parts;
        std::vector<Move> moves; // out of their place; of the last one no distance
    };
    enum class Path { Straight, Bent };

    /// A part off all the others.
    std::optional<Removal> partOff(int part, const Group &others, Path path);
    /// The smallest group that comes off the rest of these, straight.
    std::optional<Removal> smallestOff(const Group &parts);
    /// The moves until what comes off is clear of the rest.
    std::vector<Move> measured(const Removal &removal, const Group &rest);

    /// Once the time is over everything is in everything's way.
    bool isOutOfTime();

private:
    /// A solid as seen along a direction: across it and along it, mm.
    struct Shadow
    {
        double uMin, uMax, vMin, vMax, first, last;

        /// Whether it may share more than `depth` with the other when it is moved on.
        bool meetsOnItsWay(const Shadow &other, double depth) const
        {
            return uMax > other.uMin + depth && other.uMax > uMin + depth &&
                   vMax > other.vMin + depth && other.vMax > vMin + depth &&
                   other.last > first + depth;
        }
    };
    /// Another part that one may run into.
    struct Obstacle
    {
        int part;
        std::optional<bool> isInTheWay; // once somebody has looked
    };
    struct Way
    {
        Vec3 along;
        int number;                  // Collisions::way()
        std::vector<Shadow> shadows; // of each solid; empty until somebody asks
        std::vector<std::optional<std::vector<Obstacle>>> obstacles; // of each part, ascending
        std::vector<std::vector<int>> held; // of each part those that cannot but move with it
    };
    struct Mate
    {
        int part;
        double length;               // mm that they are held
        std::vector<int> directions; // in which one comes off it
    };

    std::size_t partCount() const { return m_mates.size(); }
    int indexOf(const Vec3 &direction);
    /// Makes the direction ready to be asked about.
    Way &opened(int direction);
    std::vector<int> waysOff(int part, const Group &others) const;
    std::vector<int> waysApart(const Group &parts) const;
    bool isIgnored(int a, int b) const;
    std::vector<Obstacle> &obstaclesOf(int part, Way &way);
    bool isInTheWay(Obstacle &obstacle, int part, const Way &way);
    /// Which of these the slits hold together: of each its heap's number, at its index in `parts`;
    /// and how many heaps there are.
    std::pair<std::vector<int>, int> heaps(const Group &parts, int direction);
    /// The part and all that is in its way, and in the way of these; nothing once they are not
    /// fewer than `fewerThan`.
    std::optional<Group> movedWith(int part, const Group &parts, int direction,
                                   std::size_t fewerThan);
    /// Out of the slits that hold it in these, and on from there; nothing when it does not come
    /// off.
    std::optional<Removal> bent(int part, const Group &others, int direction);
    /// Across the part to both sides, and along the axes of the world.
    std::vector<Vec3> turnsOf(int part) const;

    Collisions &m_collisions;
    const std::vector<Slide> &m_slides;
    const PlanOptions &m_options;
    std::vector<Way> m_ways;
    int m_freeWays = 0;                     // so many of them, the first ones, are the world's
    std::vector<std::vector<Mate>> m_mates; // of each part
    bool m_isOutOfTime = false;
};

} // namespace fff
