// Pairs of pieces that something says hold each other, before the judge.
#pragma once

#include "core/analysis/analysis.h"
#include "tests/core/session/held_judge.h"

#include <QByteArray>

namespace fff::test {

/// As the judge sees them, in the order of the bodies.
std::vector<JudgedPiece> judgedPieces(const Bodies &bodies);

struct HeldPair
{
    int piece = 0, other = 0; // in the list of pieces
    std::vector<Vec3> ways;   // unit, in which the piece may come off the other one
    Slack slack;
    QByteArray name;
};

/// What a pair is in truth.
struct JudgedPair
{
    HeldPair pair;
    Freedom freedom;

    /// The piece can move along its ways only: what a pair that is called held must be.
    bool isHeld() const { return freedom.isHeldBut(pair.ways); }
    /// Along one of them at least: out of a mortise, often.
    bool comesOff() const;
    /// It gets away square to its ways; else, where it is not held, on a slant or by a turn.
    bool goesSideways() const;
};

/// Each pair by itself, whatever else is there.
std::vector<JudgedPair> judged(const std::vector<JudgedPiece> &pieces,
                               const std::vector<HeldPair> &pairs);

/// One line: name | held, or how many moves are free besides the ways | the first of them.
QByteArray toText(const JudgedPair &pair);

/// Of a piece among all others: where it is called loose, it must get away.
Freedom judgedAmongAll(const std::vector<JudgedPiece> &pieces, int piece,
                       std::span<const Vec3> ways = {});

/// A piece of the joint's b and one of its a, as the slits are cut.
HeldPair pairOf(const Analysis &analysis, const Joint &joint, int bodyOfB, int bodyOfA);
/// Of all joints but those without slits, if both sections are one piece each.
std::vector<HeldPair> pairsOfWholeSections(const Analysis &analysis);
/// The same pair, seen from the other piece.
HeldPair turnedRound(HeldPair pair);

} // namespace fff::test
