// A drawn line that follows guides where it comes near them: curves on the canvas, such as those in
// which its plane cuts a mesh (paper, "Template 3D objects").
#pragma once

#include "core/geometry/path_locator.h"
#include "core/geometry/settled_fit.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace fff {

/// The curves, in canvas coordinates, and how near a line comes before one catches it.
struct Guides
{
    std::vector<PathLocator> lines;
    double reach = 0.0; // mm

    /// How much further it must go to get away.
    static constexpr double kRelease = 1.3;
    bool isEmpty() const { return lines.empty() || !(reach > 0.0); }
};

/// Samples of a line by which it goes free, whatever is near: [from, to).
struct FreeSamples
{
    std::size_t from = 0, to = 0;
};

/// What is caught lies on the guide, exactly: `pieces` are cut from it. Between a free stretch and
/// a guide the line passes from one to the other over a way of a few times their distance. What
/// was caught for less than that, as a line that crosses a guide is, stays free.
struct GuidedLine
{
    std::vector<Vec2> points;         // no two equal in a row
    std::vector<FittedPiece> pieces;  // of the points what lies on guides
    std::vector<Vec2> turnouts;       // where it leaves a guide, or comes to one
    std::optional<std::size_t> whole; // the guide that it goes all round
    /// It begins and ends on one guide and goes on there: the last point is the first.
    bool isLoop = false;
    bool isCaughtAtEnd = false;
    double length = 0.0, onGuides = 0.0; // mm
    double farthest = 0.0;               // mm, of where it is free from the nearest guide
    std::optional<Vec2> mostOn;          // in the middle of the longest way along one
};

/// samples  all of them looked at (SampledLine::usable), canvas coordinates, mm
/// free     ascending, apart from each other
GuidedLine guided(const std::vector<Vec2> &samples, const std::vector<FreeSamples> &free,
                  const Guides &guides);

} // namespace fff
