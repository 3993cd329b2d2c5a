#include "core/analysis/gap.h"

#include <algorithm>

namespace fff {

namespace {

/// Distances between boxes may be wrong by less, mm.
constexpr double kRounding = 1e-6;

/// A body, and how far away it is by its box.
struct Candidate
{
    double distance = 0.0; // mm
    int body = 0;

    bool operator<(const Candidate &other) const
    {
        return distance != other.distance ? distance < other.distance : body < other.body;
    }
};

/// Bodies that are nearer to the box than the limit, the nearest first.
std::vector<Candidate> nearestFirst(const std::vector<int> &of, const Box3 &box, double limit,
                                    const Bodies &bodies)
{
    std::vector<Candidate> candidates;
    for (const int body : of)
        if (const double distance = distanceBetween(bodies.at(body).box(), box); distance < limit)
            candidates.push_back({distance, body});
    std::sort(candidates.begin(), candidates.end());
    return candidates;
}

/// All bodies that are not in the group.
std::vector<int> othersOf(const std::vector<int> &group, std::size_t count)
{
    std::vector<char> isInside(count, 0);
    for (const int body : group)
        isInside[static_cast<std::size_t>(body)] = 1;
    std::vector<int> others;
    for (std::size_t i = 0; i < count; ++i)
        if (!isInside[i])
            others.push_back(static_cast<int>(i));
    return others;
}

} // namespace

CheckCaches::OfGroup measuredGap(const Bodies &bodies, const std::vector<int> &group)
{
    CheckCaches::OfGroup gap;
    gap.group = group;
    for (const int body : group)
        gap.box.extend(bodies.at(body).box());
    const std::vector<int> others = othersOf(group, bodies.size());
    for (const Candidate &other : nearestFirst(others, gap.box, gap.distance, bodies)) {
        if (other.distance >= gap.distance)
            break;
        const Body &mate = bodies.at(other.body);
        for (const Candidate &own : nearestFirst(group, mate.box(), gap.distance, bodies)) {
            if (own.distance >= gap.distance)
                break;
            const Nearest found =
                nearestPoints(bodies.at(own.body).slab(), mate.slab(), gap.distance);
            if (found.distance < gap.distance) {
                gap.distance = found.distance;
                gap.at = found.onA;
                gap.other = bodies.sectionOf(other.body);
            }
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
