// What the view shows of problems beside red sections and numbers: who blocks whom, and how the
// centre of mass lies over the feet. Pure data, drawn over the model.
#pragma once

#include "core/geometry/polygon.h"

#include <vector>

namespace fff {

/// Two sections that are in each other's way: a line from one to the other through the place.
struct ProblemLink
{
    Vec3 fromA = Vec3::Zero(), at = Vec3::Zero(), fromB = Vec3::Zero(); // world, mm
    Vec3 way = Vec3::Zero(); // in which they slide there, unit; zero: none

    bool operator==(const ProblemLink &other) const
    {
        return fromA == other.fromA && at == other.at && fromB == other.fromB && way == other.way;
    }
};

/// What stands or falls as one body.
struct GroundMark
{
    Polygon support;                  // (x, z), mm: hull of what is on the ground; may be empty
    Vec3 centreOfMass = Vec3::Zero(); // world, mm
    Vec2 edge = Vec2::Zero();         // (x, z) of the support's boundary, nearest to it
    double margin = 0.0;              // mm between them, negative: outside
    bool isProblem = true;
    bool isWarning = false; // one that stands all the same

    bool operator==(const GroundMark &other) const
    {
        return support == other.support && centreOfMass == other.centreOfMass &&
               edge == other.edge && margin == other.margin && isProblem == other.isProblem &&
               isWarning == other.isWarning;
    }
};

/// Where something ends above the ground that ought to stand on it.
struct HighMark
{
    Vec3 at = Vec3::Zero(); // its lowest point, world, mm
    double height = 0.0;    // of it, mm

    bool operator==(const HighMark &other) const
    {
        return at == other.at && height == other.height;
    }
};

struct ProblemLook
{
    std::vector<ProblemLink> links;
    std::vector<GroundMark> grounds;
    std::vector<HighMark> feet;

    bool isEmpty() const { return links.empty() && grounds.empty() && feet.empty(); }
    bool operator==(const ProblemLook &other) const = default;
};

} // namespace fff
