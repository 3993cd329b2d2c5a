#include "core/assembly/crossing.h"

#include "core/assembly/intervals.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fff {

namespace {

/// Steps of a mm. Two slits meet in the middle of their overlap to half of a µm: where is a matter
/// of choice, and so an edit of one section leaves slits of many equal mates alike, which are cut
/// once.
constexpr double kMeetingSteps = 1e3;

/// The middle of an overlap, a whole number of steps from where b ends.
double meetingPoint(double from, double to, const Interval &b)
{
    const double middle = 0.5 * (from + to);
    return b.to.at - std::round(kMeetingSteps * (b.to.at - middle)) / kMeetingSteps;
}

} // namespace

Crossing findCrossing(const Shape &shapeA, const Frame &frameA, const Shape &shapeB,
                      const Frame &frameB)
{
    Crossing crossing;
    const std::optional<Axis> axis = intersectionAxis(frameA, frameB);
    if (!axis)
        return crossing;
    crossing.axis = *axis;
    const Vec3 na = frameA.normal(), nb = frameB.normal();
    crossing.angle = std::atan2(na.cross(nb).norm(), std::abs(na.dot(nb)));

    const auto inA = intervalsOn(lineInFrame(*axis, frameA), shapeA);
    if (inA.empty())
        return crossing;
    const auto inB = intervalsOn(lineInFrame(*axis, frameB), shapeB);
    for (std::size_t i = 0, j = 0; i < inA.size() && j < inB.size();) {
        const double from = std::max(inA[i].from.at, inB[j].from.at);
        const double to = std::min(inA[i].to.at, inB[j].to.at);
        if (to - from >= kMinOverlap)
            crossing.overlaps.push_back({from, to, meetingPoint(from, to, inB[j]), inA[i], inB[j]});
        (inA[i].to.at < inB[j].to.at) ? ++i : ++j;
    }
    return crossing;
}

bool meetsInMiddle(const Overlap &overlap)
{
    const double middle = 0.5 * (overlap.from + overlap.to);
    return std::abs(overlap.meet - middle) <= 0.5 / kMeetingSteps + kClipGrid;
}

std::vector<std::pair<int, int>> meetingPairs(const std::vector<Box3> &boxes)
{
    Box3 all;
    for (const Box3 &box : boxes)
        all.extend(box);
    std::vector<std::pair<int, int>> pairs;
    if (all.isEmpty())
        return pairs;
    Eigen::Index sweep = 0;
    all.size().maxCoeff(&sweep);

    std::vector<int> order(boxes.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int i, int j) {
        return std::pair(boxes[i].min[sweep], i) < std::pair(boxes[j].min[sweep], j);
    });
    for (std::size_t k = 0; k < order.size(); ++k) {
        const Box3 &box = boxes[order[k]];
        for (std::size_t l = k + 1; l < order.size(); ++l) {
            const Box3 &other = boxes[order[l]];
            if (other.min[sweep] > box.max[sweep])
                break;
            if (box.intersects(other))
                pairs.push_back(std::minmax(order[k], order[l]));
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

} // namespace fff
