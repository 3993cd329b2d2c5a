// What takes a contour that was drawn beside its slit into it.
#pragma once

#include "core/geometry/contour.h"

#include <limits>
#include <optional>

namespace fff {

/// Who draws a slit wants what comes next to be held there, but a leg is drawn where it is seen:
/// from the section's edge outwards. Canvas coordinates as those of Stroke, mm: the slit is the
/// segment from (0, 0) to (length, 0), and what it is in is about (0, 0).
struct SlitToReach
{
    double length = 0.0;
    double thickness = 0.0; // of what it is in
    double farthest = 0.0;  // from its end to a contour that is still meant to be held there
    /// How far the section that it is in goes on behind its start; a neck is not seen beyond.
    double behind = std::numeric_limits<double>::infinity();
};

/// The contour with a neck along the slit, as wide as is good for a sheet of that thickness, and as
/// far beyond the slit's start as that is long: so each of the two sections has half of the joint.
/// But what is small has no neck that is longer than itself; its joint is less deep.
/// Symmetric to the slit where the contour is. None where it fills the slit already, goes past its
/// start, is farther away, or would not be one piece.
std::optional<Contour> withNeck(const Contour &contour, const SlitToReach &slit);

/// How a contour comes to its slit.
struct SlitReach
{
    std::optional<Contour> withNeck;
    bool isApart = false; // not at all: nothing of it is in the section that the slit is in
};
SlitReach reached(const Contour &contour, const SlitToReach &slit);

} // namespace fff
