// Less and less room for the same shapes: the search for the best layout. Internal to nesting.
#pragma once

#include "core/nesting/separation.h"

#include <utility>

namespace fff::nest {

/// The sheets of a search, side by side along x, with what is not free on them.
struct Ground
{
    struct Obstacle
    {
        const Shape *shape = nullptr;
        Vec2 at = Vec2::Zero();
    };

    std::vector<Box2> sheets; // as of a state
    std::vector<Obstacle> obstacles;
};

/// Where everything lies, and what is used.
struct State
{
    std::vector<Pose> poses;
    std::vector<std::size_t> on; // the sheet of each
    std::vector<Box2> sheets;    // the last one as far as it is used
    std::size_t freeSheets = 0;  // the first ones; some may be empty while there are others
    double length = 0.0;         // that is used of the last sheet

    /// Those that cost nothing count where there are no others.
    bool takesFewerSheets(const State &other) const { return cost() < other.cost(); }
    bool isBetterThan(const State &other) const
    {
        return cost() != other.cost() ? takesFewerSheets(other) : length < other.length;
    }

private:
    std::pair<std::size_t, std::size_t> cost() const
    {
        const std::size_t paid = sheets.size() - freeSheets;
        return {paid, paid > 0 ? 0 : freeSheets};
    }
};

/// Makes the last sheet shorter, or does without it, and takes apart what overlaps then; where that
/// fails, shapes change places. Afterwards by smaller and smaller steps. Source  as Separation.
class Exploration
{
public:
    /// items  shape of each; `start` has its pose, and nothing overlaps there
    Exploration(std::span<const Shape> shapes, const std::vector<std::size_t> &items,
                const Ground &ground, const State &start, std::uint64_t seed);

    const State &best() const { return m_best; }
    Steps used() const { return m_meter.used; }
    /// Goes on from there.
    void adopt(const State &state);

    /// Both until so much has been done in all.
    void explore(Steps until, std::stop_token stop);
    void compress(Steps from, Steps until, std::stop_token stop);

private:
    struct Failed
    {
        std::vector<Pose> poses;
        double loss = 0.0;
    };

    Box2 &last() { return m_sheets.back(); }
    void restore(const State &state);
    void dropEmpty();
    void keep();
    bool shorten(double length, double split);
    bool squeeze(std::size_t item);
    void dropLast();
    double leastLength() const;
    bool isDropWorthTrying() const;
    void tryDrops(Steps until);
    void disrupt();
    void swap(std::size_t a, std::size_t b);

    std::span<const Shape> m_shapes;
    Board m_board;
    Random m_random;
    Separation m_separation;
    std::vector<Box2> m_sheets; // as they are on the board
    std::size_t m_freeSheets;   // the first ones
    State m_best;
    Meter m_meter;
    double m_step = 0.0;          // part of the length by which it becomes shorter next
    std::vector<Failed> m_failed; // at the present length, best first
};

} // namespace fff::nest
