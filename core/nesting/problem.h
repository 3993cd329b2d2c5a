// What is to be laid close together, on what, and how it came to lie: true outlines, lengths in mm.
#pragma once

#include "core/base/long_work.h"
#include "core/geometry/polygon.h"

#include <cstdint>
#include <vector>

namespace fff::nest {

/// How a piece may be turned from how it is drawn.
enum class Turning { None, Half, Quarter, Free };

/// The turns of one of the first three, as cosine and sine; of Free the quarter turns.
std::vector<Vec2> turnsOf(Turning turning);

struct Piece
{
    Region outline; // its true outline goes no further beyond these chords than Problem::chord
    int demand = 1; // how many of it
    std::vector<Vec2> turns{Vec2::UnitX()}; // (cosine, sine), counter-clockwise; at least one
    bool turnsFreely = false; // at any other angle as well; then `turns` are only tried first
};

/// Sheets of one outline: a rectangle, or an offcut with whatever holes it has.
struct SheetKind
{
    Region outline;
    int count = 1;                   // how many of it there are; kUnlimited: as many as it takes
    std::vector<Polygon> taken = {}; // outlines that lie there already, off which others are laid
    bool isFree = false;             // costs nothing: what is left of others, to be used up

    static constexpr int kUnlimited = -1;
};

/// Either a strip of that height and any length (from x = 0 on, y from 0), or sheets. Of those as
/// few are taken as it goes that cost something; only where that is none, as few of the others.
struct Problem
{
    std::vector<Piece> pieces;
    double stripHeight = 0.0; // 0: sheets
    std::vector<SheetKind> sheets;
    double margin = 0.0;  // from the container's edge to the nearest outline
    double spacing = 0.0; // between outlines
    double chord = 0.0;   // see Piece::outline
};

/// A piece in its container: coordinates there = turned(p, turn) + offset.
struct Place
{
    int piece = 0;
    int sheet = 0; // index into Solution::sheets; 0 on a strip
    Vec2 turn = Vec2::UnitX();
    Vec2 offset = Vec2::Zero();
};

struct Solution
{
    std::vector<Place> places; // by piece, as many of each as fit
    std::vector<int> sheets;   // used ones, by the index of their kind; none on a strip
    std::vector<int> left;     // pieces that fit nowhere, once for each that is left
    double length = 0.0;       // of the strip; on the last sheet the height that is used
    double density = 0.0;      // area of pieces over that of the strip's length, or of the sheets
    std::int64_t work = 0;     // what it took, see Options
};

/// How long to search. Work is counted, not timed, so that the same seed gives the same solution on
/// every machine, under any load and by any number of threads.
struct Options
{
    std::uint64_t seed = 1;
    std::int64_t work = 0; // 0: the first solution stands
    bool usesThreads = true;
};

/// What a second of one core does on the machine where this was measured. By this many seconds of
/// a person's time become work.
inline constexpr double kWorkPerSecond = 100e6;
std::int64_t workOf(double seconds);

} // namespace fff::nest
