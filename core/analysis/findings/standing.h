// Whether the model, or each loose group of it, stands on the ground.
#pragma once

#include "core/analysis/finder.h"
#include "core/analysis/footing.h"
#include "core/analysis/stretching.h"

namespace fff {

/// As seen in the front view: the front is +Z, the right +X.
enum class Towards { Front, Back, Left, Right };

/// Of all of them.
struct Footing
{
    MassProperties mass;      // of what stands or falls: kg, and its centre
    double margin = 0.0;      // mm from the centre of mass to the support's nearest edge, negative
                              // outside
    double tipAngle = 0.0;    // radians up to which it can be tilted
    Polygon support;          // (x, z); see stability.h
    Vec2 edge = Vec2::Zero(); // (x, z), of its boundary nearest to the centre of mass
    Towards side = Towards::Front; // where to it falls, or would first
    double lean = 0.0;             // radians, before all its feet that carry touch
    Towards leans = Towards::Front;
    double rocking = 0.0; // radians, by which it leans besides when it is pushed a little
    double height = 0.0;  // kNoContact: above the ground, kBelowGround: below it, mm; both positive
    std::vector<HighFoot> feet; // kTopples, kLineSupport: who would hold it up on the ground
    int sections = 0;           // that stand
    Text provided = {};         // kWouldStand: what keeps it from standing, "if it did not fold"
};

extern const FindingKind kStands;
extern const FindingKind kUnsteady;   // stands, but tips when tilted by less than kSteadyTilt; an
                                      // error below kLeastTilt
extern const FindingKind kLeans;      // stands, but aslant by more than anybody overlooks, or so at
                                      // a push
extern const FindingKind kWouldStand; // as one piece, which something else says it is not
extern const FindingKind kTopples;
extern const FindingKind kLineSupport; // falls to either side
extern const FindingKind kNoContact;   // hangs above the ground
extern const FindingKind kBelowGround; // reaches below it: those of its sections that do

extern const ActionKind kStretchToGround; // its feet
extern const ActionKind kDropToGround;    // the whole model

/// What hangs in the air because nothing holds it is not named a second time.
void findStanding(const Looked &at, std::vector<Finding> &found);

} // namespace fff
