#include "core/analysis/gap.h"

#include "core/assembly/slab.h"

#include <algorithm>

namespace fff {

namespace {

/// Distances between boxes may be wrong by less, mm.
constexpr double kRounding = 1e-6;

/// A section, and how far away it is by its box.
struct Candidate
{
    double distance = 0.0; // mm
    int section = 0;

    bool operator<(const Candidate &other) const
    {
        return distance != other.distance ? distance < other.distance : section < other.section;
    }
};

/// Sections that are nearer to the box than the limit, the nearest first.
std::vector<Candidate> nearestFirst(const std::vector<int> &sections, const Box3 &box, double limit,
                                    const CheckCaches &caches)
{
    std::vector<Candidate> candidates;
    for (const int section : sections) {
        const Box3 &own = caches.sections[static_cast<std::size_t>(section)].box;
        const double distance = distanceBetween(own, box);
        if (distance < limit)
            candidates.push_back({distance, section});
    }
    std::sort(candidates.begin(), candidates.end());
    return candidates;
}

/// All sections that are in no group.
std::vector<int> othersOf(const std::vector<int> &group, std::size_t count)
{
    std::vector<char> isInside(count, 0);
    for (const int section : group)
        isInside[static_cast<std::size_t>(section)] = 1;
    std::vector<int> others;
    for (std::size_t i = 0; i < count; ++i)
        if (!isInside[i])
            others.push_back(static_cast<int>(i));
    return others;
}

/// Keeps the nearest points of two sections where they are nearer than what is known.
void measure(const Analysis &analysis, int section, int other, CheckCaches::OfGroup &gap)
{
    for (const Slab &slab : slabsOf(analysis, section)) {
        const Box3 box = boundsOf(slab);
        for (const Slab &otherSlab : slabsOf(analysis, other)) {
            if (distanceBetween(box, boundsOf(otherSlab)) >= gap.distance)
                continue;
            const Nearest found = nearestPoints(slab, otherSlab, gap.distance);
            if (found.distance < gap.distance) {
                gap.distance = found.distance;
                gap.at = found.onA;
                gap.other = other;
            }
        }
    }
}

} // namespace

CheckCaches::OfGroup measuredGap(const Analysis &analysis, const std::vector<int> &group,
                                 const CheckCaches &caches)
{
    CheckCaches::OfGroup gap;
    gap.group = group;
    for (const int section : group)
        gap.box.extend(caches.sections[static_cast<std::size_t>(section)].box);
    const std::vector<int> others = othersOf(group, caches.sections.size());
    for (const Candidate &other : nearestFirst(others, gap.box, gap.distance, caches)) {
        if (other.distance >= gap.distance)
            break;
        const Box3 &box = caches.sections[static_cast<std::size_t>(other.section)].box;
        for (const Candidate &own : nearestFirst(group, box, gap.distance, caches)) {
            if (own.distance >= gap.distance)
                break;
            measure(analysis, own.section, other.section, gap);
        }
    }
    return gap;
}

bool isReached(const CheckCaches::OfGroup &gap, const Box3 &box)
{
    // What is further away than the nearest comes after it and is not looked at.
    return !(distanceBetween(gap.box, box) > gap.distance + kRounding);
}

} // namespace fff
