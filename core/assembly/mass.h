// What something weighs and where its weight is.
#pragma once

#include "core/geometry/vector.h"

namespace fff {

struct MassProperties
{
    double mass = 0.0;          // kg
    Vec3 centre = Vec3::Zero(); // world, mm; the origin for a mass of 0

    MassProperties &operator+=(const MassProperties &other)
    {
        const double sum = mass + other.mass;
        if (sum > 0.0)
            centre = (mass * centre + other.mass * other.centre) / sum;
        mass = sum;
        return *this;
    }
};

} // namespace fff
