// Whether the hand waits while the view turns, or goes on drawing.
//
// A patient hand overshoots the edge by some way, nearly straight, slows down and rests, or wanders
// a little. A hasty one goes on as fast as it came, into the curve of its outline. What tells them
// apart is known only after some way; so the way is kept, and counts from where the hand rested
// last.
#pragma once

#include "core/geometry/vector.h"

#include <vector>

namespace fff {

class HandInTurn
{
public:
    struct Sample
    {
        double time = 0.0;         // ms
        Vec2 place = Vec2::Zero(); // px
    };

    /// Slower is no haste, px a ms: in a bend, which tells much, and straight on.
    static constexpr double kHasteInBend = 0.15, kHaste = 0.25;
    /// At rest: no farther than this (px) for this long (ms).
    static constexpr double kStill = 6.0, kRest = 150.0;
    /// So many slips away, and so fast, it did not overshoot the edge: it draws, straight as it is,
    /// and may rest where it has come to.
    static constexpr double kFar = 3.0;

    /// slip: how far a hand strays that draws nothing, px.
    HandInTurn(const Sample &leaving, double slip);

    void follow(const Sample &sample);

    /// It is fast and has left the straight way, or come far on it: this is an outline.
    bool isDrawing() const;
    /// At the end of the turn: it is fast, and on its way still.
    bool isUnderWay(double time) const;
    /// Since it left the section or rested last; there it was when it left or rested.
    const std::vector<Sample> &way() const { return m_way; }

private:
    bool isFast(double time, double haste) const;

    double m_slip;
    std::vector<Sample> m_way;
    Sample m_still;        // it has not gone far from there since
    double m_length = 0.0; // of the way, px
};

} // namespace fff
