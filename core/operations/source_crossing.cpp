#include "core/operations/source_crossing.h"

#include "core/assembly/crossing.h"
#include "core/base/tolerances.h"

#include <algorithm>

namespace fff {

namespace {

/// Where on the axis the section was drawn on the root; nothing when it was not.
std::optional<double> drawnAt(const Section &root, const Section &section, const PlaneLine &line)
{
    if (!section.parent || section.parent->section != root.ref())
        return std::nullopt;
    return line.along(0.5 * (section.parent->slitFrom + section.parent->slitTo));
}

const Overlap &chosen(const std::vector<Overlap> &overlaps, const std::optional<double> &at)
{
    const auto distance = [&](const Overlap &overlap) {
        return std::max({overlap.from - *at, *at - overlap.to, 0.0});
    };
    return *std::min_element(
        overlaps.begin(), overlaps.end(), [&](const Overlap &a, const Overlap &b) {
            return at ? distance(a) < distance(b) : a.to - a.from > b.to - b.from;
        });
}

SourceCrossing::Hold holdOf(const Overlap &overlap)
{
    using Hold = SourceCrossing::Hold;
    // Ends of sections that stand on the same ground are equal: then the other end says.
    const double low = overlap.a.from.at - overlap.b.from.at; // above 0: the root ends first
    const double high = overlap.b.to.at - overlap.a.to.at;
    const bool leavesLow = low > kEqualEnds, leavesHigh = high > kEqualEnds;
    const bool endsLow = low < -kEqualEnds, endsHigh = high < -kEqualEnds;
    if ((leavesLow && !leavesHigh) || (endsHigh && !endsLow && !leavesHigh))
        return Hold::Low;
    if ((leavesHigh && !leavesLow) || (endsLow && !endsHigh && !leavesLow))
        return Hold::High;
    return Hold::Middle;
}

} // namespace

std::optional<SourceCrossing> sourceCrossing(const Section &root, const Section &section)
{
    const std::optional<Axis> axis = intersectionAxis(root.frame, section.frame);
    if (!axis)
        return std::nullopt;
    SourceCrossing source;
    source.axis = *axis;
    source.line = lineInFrame(*axis, root.frame);
    const Crossing crossing = findCrossing(*root.shape, root.frame, *section.shape, section.frame);
    if (crossing.overlaps.empty())
        return source;
    source.isMeeting = true;
    source.overlap = chosen(crossing.overlaps, drawnAt(root, section, source.line));
    source.hold = holdOf(source.overlap);
    return source;
}

std::optional<Interval> continued(const std::vector<Interval> &intervals, const Interval &before)
{
    if (intervals.empty())
        return std::nullopt;
    // Negative: so far apart.
    const auto shared = [&before](const Interval &interval) {
        return std::min(interval.to.at, before.to.at) - std::max(interval.from.at, before.from.at);
    };
    return *std::max_element(
        intervals.begin(), intervals.end(),
        [&](const Interval &a, const Interval &b) { return shared(a) < shared(b); });
}

double scaleFor(const OperationContext &context, double ratio)
{
    const double scale = 1.0 + context.number("strength") * (ratio - 1.0);
    return std::max(scale, context.number("notBelow"));
}

} // namespace fff
