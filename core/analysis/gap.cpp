#include "core/analysis/gap.h"

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
                                    const Bodies &bodies)
{
    std::vector<Candidate> candidates;
    for (const int section : sections) {
        const Box3 own = bodies.boxOf(section);
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
void measure(const Bodies &bodies, int section, int other, CheckCaches::OfGroup &gap)
{
    for (const BodyPointer &body : bodies.of(section)) {
        for (const BodyPointer &mate : bodies.of(other)) {
            if (distanceBetween(body->box(), mate->box()) >= gap.distance)
                continue;
            const Nearest found = nearestPoints(body->slab(), mate->slab(), gap.distance);
            if (found.distance < gap.distance) {
                gap.distance = found.distance;
                gap.at = found.onA;
                gap.other = other;
            }
        }
    }
}

} // namespace

CheckCaches::OfGroup measuredGap(const Bodies &bodies, const std::vector<int> &group)
{
    CheckCaches::OfGroup gap;
    gap.group = group;
    for (const int section : group)
        gap.box.extend(bodies.boxOf(section));
    const std::vector<int> others = othersOf(group, bodies.sectionCount());
    for (const Candidate &other : nearestFirst(others, gap.box, gap.distance, bodies)) {
        if (other.distance >= gap.distance)
            break;
        const Box3 box = bodies.boxOf(other.section);
        for (const Candidate &own : nearestFirst(group, box, gap.distance, bodies)) {
            if (own.distance >= gap.distance)
                break;
            measure(bodies, own.section, other.section, gap);
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
