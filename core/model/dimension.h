// A length between two places of the model, shown for as long as it is wanted.
#pragma once

#include "core/model/section.h"

namespace fff {

/// A place that goes along with its section.
struct Anchor
{
    SectionRef section = {}; // empty: `at` is in the world
    Vec3 at = Vec3::Zero();  // mm: in the section's frame x, y and above its plane, or in the world

    bool operator==(const Anchor &other) const
    {
        return section == other.section && at == other.at;
    }
};

struct Dimension
{
    DimensionId id;
    Anchor from, to;

    bool operator==(const Dimension &) const = default;
};

} // namespace fff
