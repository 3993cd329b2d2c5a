#include "core/analysis/findings/strength_judge.h"

#include <algorithm>

namespace fff {

bool meetAsBefore(const Analysis &before, const Analysis &after)
{
    if (before.assembly.joints.size() != after.assembly.joints.size())
        return false;
    return std::equal(before.assembly.joints.begin(), before.assembly.joints.end(),
                      after.assembly.joints.begin(), [](const Joint &a, const Joint &b) {
                          return a.a == b.a && a.b == b.b && a.kind == b.kind &&
                                 a.crossing->overlaps.size() == b.crossing->overlaps.size();
                      });
}

} // namespace fff
