#include "core/skin/outline_meetings.h"

#include "core/assembly/crossing.h"
#include "core/assembly/intervals.h"
#include "core/base/groups.h"
#include "core/base/tolerances.h"
#include "core/skin/skin_measures.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace fff {

namespace {

/// Crossings of two outlines with each other's plane that may be one corner.
struct Match
{
    double apart = 0.0; // mm
    double at = 0.0;    // of the axis, to tell alike ones apart
    std::size_t a = 0, b = 0;
};

bool runAlike(const SkinOutline &a, double alongA, const SkinOutline &b, double alongB)
{
    const auto way = [](const SkinOutline &outline, double along) {
        const double reach = std::min(kSkinReach, 0.1 * outline.length());
        return outline.frame().directionToWorld(outline.tangentAt(along, reach));
    };
    return way(a, alongA).cross(way(b, alongB)).norm() < std::sin(kSkinTouch);
}

/// Nearest first, each crossing in one of them.
void meet(int i, int j, const std::vector<SectionPointer> &sections,
          const std::vector<SkinOutline> &outlines, std::vector<OutlineMeeting> &meetings)
{
    const auto first = static_cast<std::size_t>(i), second = static_cast<std::size_t>(j);
    const auto axis = intersectionAxis(sections[first]->frame, sections[second]->frame);
    if (!axis)
        return;
    const std::vector<PlaneCrossing> a = outlines[first].crossings(sections[second]->frame, *axis);
    const std::vector<PlaneCrossing> b =
        a.empty() ? std::vector<PlaneCrossing>()
                  : outlines[second].crossings(sections[first]->frame, *axis);
    std::vector<Match> matches;
    for (std::size_t x = 0; x < a.size(); ++x)
        for (std::size_t y = 0; y < b.size(); ++y)
            if (const double apart = std::abs(a[x].at - b[y].at);
                a[x].leaves == b[y].leaves && apart <= kSkinReach)
                matches.push_back({apart, a[x].at + b[y].at, x, y});
    std::sort(matches.begin(), matches.end(), [](const Match &p, const Match &q) {
        return std::pair(p.apart, p.at) < std::pair(q.apart, q.at);
    });
    std::vector<bool> isTakenA(a.size(), false), isTakenB(b.size(), false);
    const std::size_t before = meetings.size();
    for (const Match &match : matches) {
        if (isTakenA[match.a] || isTakenB[match.b] ||
            runAlike(outlines[first], a[match.a].along, outlines[second], b[match.b].along))
            continue;
        isTakenA[match.a] = isTakenB[match.b] = true;
        meetings.push_back({{{{i, a[match.a].along}, {j, b[match.b].along}}}, 0});
    }
    // Which of them is nearer by rounding must not be seen.
    std::sort(meetings.begin() + static_cast<std::ptrdiff_t>(before), meetings.end(),
              [](const OutlineMeeting &p, const OutlineMeeting &q) {
                  return p.places[0].along < q.places[0].along;
              });
}

/// Along a closed line.
double distanceAlong(const SkinOutline &outline, double a, double b)
{
    const double apart = std::abs(a - b);
    return std::min(apart, outline.length() - apart);
}

/// Where three sections or more cross in one place, each two of them have a meeting there. Two that
/// run beside each other do not meet, however near they are, so their corners stay two.
void joinMeetings(std::vector<OutlineMeeting> &meetings, const std::vector<SkinOutline> &outlines)
{
    struct Place
    {
        double along;
        std::size_t meeting;
        int other;
    };
    std::set<std::pair<int, int>> met;
    std::vector<std::vector<Place>> onOutline(outlines.size());
    for (std::size_t m = 0; m < meetings.size(); ++m) {
        const auto &[a, b] = meetings[m].places;
        met.insert(std::minmax(a.outline, b.outline));
        onOutline[static_cast<std::size_t>(a.outline)].push_back({a.along, m, b.outline});
        onOutline[static_cast<std::size_t>(b.outline)].push_back({b.along, m, a.outline});
    }
    Groups corners(meetings.size());
    for (std::size_t o = 0; o < outlines.size(); ++o)
        for (const Place &p : onOutline[o])
            for (const Place &q : onOutline[o]) {
                const double apart = distanceAlong(outlines[o], p.along, q.along);
                if (p.meeting < q.meeting &&
                    (apart < kSkinShort ||
                     (apart < kSkinReach && met.contains(std::minmax(p.other, q.other)))))
                    corners.join(p.meeting, q.meeting);
            }
    int count = 0;
    for (const std::vector<std::size_t> &group : corners.all()) {
        for (const std::size_t meeting : group)
            meetings[meeting].corner = count;
        ++count;
    }
}

} // namespace

Result<std::vector<OutlineMeeting>> outlineMeetings(const std::vector<SectionPointer> &sections,
                                                    const std::vector<SkinOutline> &outlines,
                                                    const LongWork &work)
{
    std::vector<Box3> boxes;
    for (const SectionPointer &section : sections) {
        Box3 box = worldBounds(*section->shape, section->frame);
        box.min.array() -= kSkinReach;
        box.max.array() += kSkinReach;
        boxes.push_back(box);
    }
    std::vector<OutlineMeeting> meetings;
    const auto pairs = meetingPairs(boxes);
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        if (work.isStopped())
            return failure(ErrorCode::Cancelled);
        meet(pairs[p].first, pairs[p].second, sections, outlines, meetings);
        work.tell(static_cast<double>(p) / static_cast<double>(pairs.size()));
    }
    joinMeetings(meetings, outlines);
    return meetings;
}

} // namespace fff
