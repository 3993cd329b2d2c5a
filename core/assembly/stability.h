// Whether something made of slabs stands on the ground, the plane Y = 0, by itself: what touches
// the ground, and where its centre of mass lies over that.
#pragma once

#include "core/assembly/ground.h"
#include "core/assembly/slab.h"

#include <span>
#include <vector>

namespace fff {

/// What of some slabs is on the ground.
struct GroundContact
{
    int stretches = 0;         // maximal stretches of outlines on the ground
    std::vector<Vec2> corners; // (x, z) of points whose convex hull is that of all contacts
    double lowest = 0.0;       // Y of the lowest point of the slabs
    Vec3 lowestPoint = Vec3::Zero();
    double lowestMiddle = 0.0; // Y of the lowest point of the mid-planes

    bool operator==(const GroundContact &) const = default;
};

/// Of one slab: what is low of it, whether or not something else hangs lower. Of its corners those
/// of their hull.
/// level  Y of the ground
GroundContact contactOf(const Slab &slab, double level = 0.0);
/// Points at which one slab stands on the ground: of each of its two faces that is there the ends
/// of each stretch of outline; of a face that is there with all of it those of its hull. World, mm,
/// on that ground.
std::vector<Vec3> feetOf(const Slab &slab, const Ground &ground = {});
/// What of several slabs counts when they are one body.
GroundContact together(std::span<const GroundContact *const> contacts);

/// The slabs' contacts with the ground.
///
/// A slab is on the ground where its material comes down to Y ≤ kGroundContact while no mid-plane
/// comes below −kGroundSunk: an upright plate on its whole edge, t wide; a lying one on all of
/// its outline, whether its lower face or, as FlatFab's models have it, its middle is drawn at Y =
/// 0; an oblique one on what of its bevel is there. Slabs that hang above the ground, or whose
/// mid-planes reach below it, have no contact: `lowest` and `lowestMiddle` say by how much.
/// Between −kGroundSunk and −kGroundContact it is neither a fault nor lost as a foot: what a person
/// drew onto the ground is off by that much, feet at Y = 0 and feet a tenth below it carry alike,
/// and nobody sees the difference on a table. Below −kGroundSunk it is in the ground, and then none
/// is a foot: nobody can tell where it would come to rest.
/// Holes are never lower than their contour and need not be looked at. O(vertices).
///
/// Errors  none; without slabs everything is 0.
GroundContact groundContact(const std::vector<Slab> &slabs);

enum class Standing {
    Stands,
    Topples,     // the centre of mass is not above the inside of the support polygon
    LineSupport, // the support polygon has no area to speak of: it falls to either side
    NoContact,   // it hangs above the ground
    BelowGround, // its mid-planes reach below the ground
};

struct Stability
{
    Standing standing = Standing::NoContact;
    int contacts = 0;    // stretches of outlines on the ground
    Polygon support;     // (x, z), counter-clockwise seen from below (x to the right, z up)
    double margin = 0.0; // mm from the projected centre of mass to the nearest edge of `support`;
                         // negative outside. 0 without a contact
    Vec2 nearest = Vec2::Zero(); // (x, z), of that edge, the point it is measured to
    double tipAngle = 0.0;    // radians: tilted by less, it falls back onto its feet. 0 unless it
                              // stands
    Vec2 fall = Vec2::Zero(); // (x, z), unit: over which edge it falls, or would fall first
    double height = 0.0;      // of its lowest point above the ground, mm; negative: below it, as
                              // deep as its mid-planes
    Vec3 lowestPoint = Vec3::Zero();
    Ground ground;        // on which it stands, or would
    double lean = 0.0;    // radians, of what comes to stand only when it leans
    double rocking = 0.0; // radians, by which it leans besides when it is pushed a little
};

/// Where the centre of mass lies over the contacts.
///
///     margin   = distance from the projected centre of mass to the support polygon's boundary
///     tipAngle = min over its edges of atan(distance to the edge / height of the centre of mass)
///
/// The side of an edge is decided exactly. A polygon whose area is below thickness · size / 100 is
/// a line: `thickness` (mm) of the thinnest slab and `size` (mm) of all of them together give the
/// scale.
/// Source  R. McGhee, A. Frank 1968, On the stability properties of quadruped creeping gaits (the
///         margin); the product's mechanics, rigid-body stage: contacts, hull, line support.
Stability stability(const GroundContact &contact, const Vec3 &centreOfMass, double thickness,
                    double size);

} // namespace fff
