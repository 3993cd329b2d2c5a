// Whether a piece can move against others: an oracle for what joints hold. It knows pieces as
// solids only, no slits, joints or plans, and finds out by trying: the piece is moved a little in
// many ways, and where points of one solid come to lie within another one, it cannot.
#pragma once

#include "tests/core/session/judged_piece.h"

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace fff::test {

/// In each other by less, two pieces only touch: chords are off by half of that. mm
inline constexpr double kFreeDepth = 0.02;
/// What a piece must be able to move beyond all play to be free. mm
inline constexpr double kTellingMove = 0.25;

/// What a joint that holds still leaves.
struct Slack
{
    double play = 0.1; // mm, clearance included
    /// Radians about the line that both planes have. The walls of an oblique slit are square to the
    /// sheet, so that it is wider than what is in it, which turns up to the same angle on the
    /// other side: π − 2 × the angle between the planes.
    double turn = 0.0;
    /// Radians about this unit vector, the normal of what is in a mortise. That is as long as
    /// leaning sides need to pass through its sheet, so that they turn until they lean as much the
    /// other way.
    double lean = 0.0;
    Vec3 leanAbout = Vec3::Zero();
    /// mm, of the walls that are said to hold: the play lets a piece turn between them until its
    /// ends are at both walls.
    double depth = std::numeric_limits<double>::infinity();
};

struct SmallMove
{
    enum class Kind { Shift, Turn };

    Kind kind = Kind::Shift;
    Vec3 direction = Vec3::UnitY(); // unit; of a turn its axis
    Vec3 through = Vec3::Zero();    // of a turn: a point of its axis
    double amount = 0.0;            // mm, of a turn radians
    std::string name;               // "shift +axis-across": see judge()

    /// The same the other way round.
    SmallMove back() const;
    /// Where a share of it (0 … 1) takes a point.
    Vec3 applied(const Vec3 &p, double share) const;
    bool isShiftAlong(const Vec3 &way) const;
};

struct Freedom
{
    std::vector<SmallMove> free; // of all that were tried
    int tried = 0;
    bool touches = false; // there is another piece within the play
    /// How deep pieces are in each other where they are, mm. What is in another one already by
    /// kFreeDepth blocks nothing.
    double inEachOther = 0.0;

    bool getsAway() const { return !touches || !free.empty(); }
    /// It touches another piece, and no move is free but shifts along these ways.
    bool isHeldBut(std::span<const Vec3> ways) const;
};

/// Tried for each other piece that this one touches, along the line that both planes have (axis),
/// the normal of each of the two, and across these: shifts in the 26 directions to the faces, edges
/// and corners of a cube, and along the ways given; turns through the middle of where the two
/// touch. A shift is by the play and what tells. A turn moves the farthest point of where they
/// touch by as much, beyond what the slack leaves. All of the way must be free, in steps of 0.2 mm.
Freedom judge(const JudgedPiece &piece, std::span<const JudgedPiece *const> others,
              const Slack &slack = {}, std::span<const Vec3> ways = {});
inline Freedom judge(const JudgedPiece &piece, const JudgedPiece &other, const Slack &slack = {},
                     std::span<const Vec3> ways = {})
{
    const JudgedPiece *only = &other;
    return judge(piece, std::span(&only, 1), slack, ways);
}

/// Pieces moved as one against all others, in more ways than judge() has: beside these `more`
/// shifts in random directions, and turns, about the same axes and random ones, through random
/// points near where they touch and through the corners of their box. What gets away so is loose;
/// what does not may be all the same.
Freedom judgeTogether(std::span<const JudgedPiece *const> group,
                      std::span<const JudgedPiece *const> others, int more,
                      const Slack &slack = {});

} // namespace fff::test
