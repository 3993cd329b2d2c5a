#include "core/assembly/edge_room.h"

#include "core/base/tolerances.h"

#include <algorithm>

namespace fff {

PlaneLine shifted(const PlaneLine &line, double across)
{
    return {line.point + across * perpendicular(line.direction), line.direction};
}

std::vector<Stretch> stretchesIn(const PlaneLine &line, const Shape &shape)
{
    std::vector<Stretch> stretches;
    for (const Interval &interval : intervalsOn(line, shape))
        stretches.push_back({interval.from.at, interval.to.at});
    return stretches;
}

std::vector<Stretch> common(const std::vector<Stretch> &a, const std::vector<Stretch> &b)
{
    std::vector<Stretch> both;
    for (const Stretch &p : a)
        for (const Stretch &q : b)
            if (std::min(p.to, q.to) - std::max(p.from, q.from) >= kMinOverlap)
                both.push_back({std::max(p.from, q.from), std::min(p.to, q.to)});
    return both;
}

} // namespace fff
