// How a joint is named from elsewhere.
#pragma once

#include "core/model/section.h"

#include <utility>

namespace fff {

/// The joint of two sections, whether they meet now or not (dormant). a < b.
struct JointRef
{
    SectionRef a, b;

    JointRef() = default;
    JointRef(SectionRef one, SectionRef other) : a(std::move(one)), b(std::move(other))
    {
        if (b < a)
            std::swap(a, b);
    }
    auto operator<=>(const JointRef &) const = default;
};

} // namespace fff
