// What stands on the ground as mechanics sees it: rigid members, the links between them, feet,
// loads. Units of the product: mm, kg, N, N·mm, MPa; gravity in m/s², so that kg · m/s² is N.
#pragma once

#include "core/geometry/vector.h"

#include <vector>

namespace fff {

/// One piece of a section that is cut, without what hangs on it.
struct Member
{
    double mass = 0.0;            // kg
    Vec3 centroid = Vec3::Zero(); // world, mm
};

/// What one link is made of: what holds and how it comes apart.
enum class LinkKind {
    Slits,   // two slits, each around the other's plate
    Slot,    // a mortise or tabs: one plate in a slot of the other, walls all round
    Fingers, // one of the two ways apart of plates whose fingers take turns: a joint has two such
             // links. They turn freely about their edge, which is square to both normals
};

/// One overlap of a joint. A wrench on it acts on `a` about `point`, its opposite on `b`.
struct Link
{
    int a = 0, b = 0; // members
    LinkKind kind = LinkKind::Slits;
    Vec3 point = Vec3::Zero(); // where the two slits meet, mm
    Vec3 axis = Vec3::UnitZ(); // unit: the way in which the slit of a opens; that of b opens along
                               // −axis. Of others: against the way in which a comes out. A force
                               // on a along +axis pulls the link apart
    Vec3 normalA = Vec3::UnitX(), normalB = Vec3::UnitY(); // unit, of the plates
    double depthA = 0.0, depthB = 0.0;         // mm, of their slits; of others its length
    double thicknessA = 0.0, thicknessB = 0.0; // mm, of the plates
    double modulusA = 0.0, modulusB = 0.0;     // MPa
    bool isTight = true;                       // both walls of a slit press; false: it has play
    double grip = 0.0; // N that friction or glue holds against being pulled apart

    bool operator==(const Link &) const = default;
};

/// A point at which a member stands on the ground.
struct Foot
{
    int member = 0;
    Vec3 point = Vec3::Zero(); // mm
    double stiffness = 1e4;    // N/mm
    bool isPinned = false;     // held horizontally, whatever the others are

    bool operator==(const Foot &) const = default;
};

/// A force, and a moment about its point, on a member.
struct MemberLoad
{
    int member = 0;
    Vec3 point = Vec3::Zero();  // mm
    Vec3 force = Vec3::Zero();  // N
    Vec3 moment = Vec3::Zero(); // N·mm
};

struct Structure
{
    std::vector<Member> members;
    std::vector<Link> links;
    std::vector<Foot> feet;
    std::vector<MemberLoad> loads;
    Vec3 gravity{0.0, -9.81, 0.0}; // m/s²
    Vec3 up = Vec3::UnitY();       // unit, of the ground
    double size = 100.0;           // mm, of all of it: the scale of moments and of what is a line
    double thickness = 3.0;        // mm, of the thinnest member
};

} // namespace fff
