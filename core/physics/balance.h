// Whether something that hangs together stays where it is when it is as stiff as can be.
#pragma once

#include "core/physics/components.h"
#include "core/physics/structure.h"

#include <array>

namespace fff {

/// What becomes of a component. Of several that hold, the first that is found, in the order
/// Floating or NoContact, LineSupport, Topples, Slides, Mechanism.
enum class Balance {
    Stands,
    Topples,     // its resultant meets the ground outside the inside of the support polygon
    LineSupport, // the support polygon has no area to speak of
    Floating,    // it has no foot, or is lifted, while others are there
    NoContact,   // the same when it is the only one
    Slides,      // a horizontal force, or a turn about the vertical, is more than friction holds
    Mechanism,   // it moves within itself, or is pulled apart
};

/// How the ground holds feet, and what links are taken to do.
struct Support
{
    bool arePinned = false;  // every foot is held horizontally; else it slides but for friction
    double friction = 0.0;   // coefficient (no unit), of feet that slide
    bool isAxisFree = false; // links do not resist turning about their slits' axes
    bool isGripUnlimited = false; // links are not pulled apart, whatever their grip

    bool operator==(const Support &) const = default;
};

/// A component as one rigid body under its weight and loads.
struct BodyBalance
{
    Balance balance = Balance::NoContact;
    double pressing = 0.0;           // N, of all weights and loads, towards the ground
    Vec3 onGround = Vec3::Zero();    // where their resultant meets the plane of the feet, mm
    double margin = 0.0;             // mm from there to the nearest edge of the support polygon,
                                     // negative outside; of a line always ≤ 0. 0 without feet
    Vec3 nearest = Vec3::Zero();     // of that edge, the point that is nearest
    std::array<int, 2> edge{-1, -1}; // feet at the ends of that edge, over which it topples; −1
                                     // without feet
    double sliding = 0.0;            // N of friction that feet need which are not pinned; a turn
                                     // counts as a force at the feet's mean distance
    double scale = 0.0; // N, the sum of the sizes of all forces (moments by the structure's size)
    bool areAllHeld = false; // every foot takes horizontal forces: pinned, or by friction that is
                             // needed. Else those do that are pinned each
    bool canCarry = false;   // there are reactions in equilibrium: it stands, or is on its line
};

/// The rigid body test.
///
///     R   = −F·up,  F, M of all weights and loads, M about a point in the plane of the feet
///     r*  = point − up × M / R
///     hull of the feet, in that plane: a point or a line when its area < thickness · size / 100
///
/// The side of an edge is decided exactly on coordinates along two axes of the ground, which are
/// world axes when `up` is one. With feet at several heights their mean is the plane.
/// isOnly   there is no other component
/// Errors   none; what is not sound is not there.
/// Source  the product's mechanics, section 1.6, steps 1 to 3.
BodyBalance bodyBalance(const Structure &structure, const Component &component,
                        const Support &support, bool isOnly);

/// Two unit vectors square to `up` and each other, right-handed with it.
std::array<Vec3, 2> groundAxes(const Vec3 &up);

} // namespace fff
