// What a person wants of the verdict whether a model holds.
#pragma once

#include "core/physics/applied_force.h"
#include "core/physics/balance.h"

namespace fff {

struct StrengthRules
{
    double safety = 2.0; // factor on every stress, for the verdict only
    NotchRule notch;
    bool isLasting = false; // what acts stays for months (Stock::lastingShare)
    Support support;
    /// Of feet on what they stand on, where something pushes sideways; else they need none. Plywood
    /// and acrylic on a table have 0.3 and more.
    double footFriction = 0.3;
    /// N: what a slit without play holds by friction against being pulled apart, about the weight
    /// of 10 g. No more is counted on; with play it is nothing.
    double snugGrip = 0.1;
    /// Bodies bend when joints share a load in more than one way; else they are rigid. Takes
    /// finite elements of each body.
    bool isElastic = false;

    bool operator==(const StrengthRules &) const = default;
};

} // namespace fff
