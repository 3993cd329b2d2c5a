#include "core/nesting/collision.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fff::nest {

namespace {

/// More than coordinates are off by, less than shapes are larger than they have to be, mm.
constexpr double kRounding = 1e-7;

/// Edges that reach into a window.
using Near = std::array<const Edge *, 256>;

std::size_t edgesIn(const Posed &posed, const Box2 &window, Near &near, std::size_t &from)
{
    std::size_t count = 0;
    for (; from < posed.edges.size() && count + Posed::kRun <= near.size(); from += Posed::kRun) {
        if (!posed.runs[from / Posed::kRun].intersects(window))
            continue;
        const std::size_t end = std::min(from + Posed::kRun, posed.edges.size());
        for (std::size_t i = from; i < end; ++i)
            if (posed.edges[i].box.intersects(window))
                near[count++] = &posed.edges[i];
    }
    return count;
}

bool edgesMeet(const Edge &a, const Edge &b, const Vec2 &by)
{
    const Vec2 p = a.from + by, q = a.to + by;
    const Vec2 along = b.to - b.from;
    const double fromSide = cross(along, p - b.from), toSide = cross(along, q - b.from);
    if ((fromSide > 0.0 && toSide > 0.0) || (fromSide < 0.0 && toSide < 0.0))
        return false;
    const Vec2 way = q - p;
    const double startSide = cross(way, b.from - p), endSide = cross(way, b.to - p);
    return !((startSide > 0.0 && endSide > 0.0) || (startSide < 0.0 && endSide < 0.0));
}

Box2 moved(const Box2 &box, const Vec2 &by)
{
    return {box.min + by, box.max + by};
}

bool boundariesMeet(const Posed &a, const Posed &b, const Vec2 &by, const Box2 &window,
                    Steps &steps)
{
    Near ofA, ofB;
    const Box2 windowOfA = moved(window, -by);
    for (std::size_t fromA = 0; fromA < a.edges.size();) {
        const std::size_t countA = edgesIn(a, windowOfA, ofA, fromA);
        if (countA == 0)
            continue;
        for (std::size_t fromB = 0; fromB < b.edges.size();) {
            const std::size_t countB = edgesIn(b, window, ofB, fromB);
            steps += static_cast<Steps>(countA * countB);
            for (std::size_t i = 0; i < countA; ++i) {
                const Box2 box = moved(ofA[i]->box, by);
                for (std::size_t j = 0; j < countB; ++j)
                    if (box.intersects(ofB[j]->box) && edgesMeet(*ofA[i], *ofB[j], by))
                        return true;
            }
        }
    }
    return false;
}

/// Of a point that is on none of its edges.
bool isInside(const Vec2 &point, const Posed &posed)
{
    bool inside = false;
    for (const Edge &edge : posed.edges) {
        if ((edge.from.y() > point.y()) == (edge.to.y() > point.y()))
            continue;
        const double side = cross(edge.to - edge.from, point - edge.from);
        inside ^= (side > 0.0) == (edge.to.y() > edge.from.y());
    }
    return inside;
}

bool holds(const Box2 &outer, const Box2 &inner)
{
    return outer.contains(inner.min) && outer.contains(inner.max);
}

/// Of two whose boundaries do not meet.
bool isOneInOther(const Posed &a, const Posed &b, const Vec2 &by)
{
    const Box2 box = moved(a.box, by);
    return (holds(b.box, box) && isInside(a.edges.front().from + by, b)) ||
           (holds(box, b.box) && isInside(b.edges.front().from - by, a));
}

} // namespace

bool collide(const Posed &a, const Posed &b, const Vec2 &by, Steps &steps)
{
    ++steps;
    const Box2 box = moved(a.box, by);
    if (!box.intersects(b.box))
        return false;
    // An edge along the window's side is in it, however that side is rounded.
    const Vec2 rounding = Vec2::Constant(kRounding);
    const Box2 window{box.min.cwiseMax(b.box.min) - rounding,
                      box.max.cwiseMin(b.box.max) + rounding};
    return boundariesMeet(a, b, by, window, steps) || isOneInOther(a, b, by);
}

Depth depth(const Poles &a, const Poles &b, const Vec2 &by, float soft)
{
    using Four = Eigen::Array4f;
    const Four square = Four::Constant(soft * soft), limit = Four::Constant(soft),
               twice = Four::Constant(2.0f * soft);
    Four sum = Four::Zero(), deepest = Four::Constant(-1e30f);
    for (std::size_t i = 0; i < a.count; ++i) {
        const Four x = Four::Constant(a.x[i] + static_cast<float>(by.x()));
        const Four y = Four::Constant(a.y[i] + static_cast<float>(by.y()));
        const Four r = Four::Constant(a.r[i]);
        for (std::size_t j = 0; j < b.padded; j += 4) {
            const Four otherRadius = Four::Map(&b.r[j]);
            const Four dx = x - Four::Map(&b.x[j]), dy = y - Four::Map(&b.y[j]);
            const Four deep = r + otherRadius - (dx * dx + dy * dy).sqrt();
            const Four fading =
                square / (twice - deep.min(limit)) + (deep - limit).max(Four::Zero());
            sum += fading * r.min(otherRadius);
            deepest = deepest.max(deep);
        }
    }
    return {deepest.maxCoeff(), sum.sum()};
}

namespace {

/// Of the coordinates: more than rounding, less than what shapes are larger than they have to be.
constexpr double kApart = 1e-12;

/// Where along the way two edges meet.
struct Stretch
{
    double from, to;
};

double along(const Vec2 &p, Axis axis)
{
    return axis == Axis::X ? p.x() : p.y();
}

double across(const Vec2 &p, Axis axis)
{
    return axis == Axis::X ? p.y() : p.x();
}

/// An edge as it is met by what comes along the way: where it is, at a height across.
struct Met
{
    double low, high;         // across
    double across, slope;     // at `start`; along for each mm across
    double start;             // along
    double nearest, farthest; // along
    bool isLevel;             // everywhere between its ends at once

    double at(double height) const
    {
        return std::clamp(start + (height - across) * slope, nearest, farthest);
    }
};

Met metAlong(const Edge &edge, Axis axis)
{
    const double from = across(edge.from, axis), to = across(edge.to, axis);
    const double start = along(edge.from, axis), end = along(edge.to, axis);
    const bool isLevel = from == to;
    return {across(edge.box.min, axis),
            across(edge.box.max, axis),
            from,
            isLevel ? 0.0 : (end - start) / (to - from),
            start,
            along(edge.box.min, axis),
            along(edge.box.max, axis),
            isLevel};
}

/// By how much `a`, moved, has to go on for it to meet `b`: from … to.
Stretch meeting(const Met &a, const Met &b, double offset, double lift)
{
    const double low = std::max(a.low + lift, b.low), high = std::min(a.high + lift, b.high);
    if (a.isLevel || b.isLevel) {
        const double ofA = a.at(low - lift), ofB = b.at(low);
        const double ofA2 = a.at(high - lift), ofB2 = b.at(high);
        return {(b.isLevel ? b.nearest : std::min(ofB, ofB2)) -
                    (a.isLevel ? a.farthest : std::max(ofA, ofA2)) - offset,
                (b.isLevel ? b.farthest : std::max(ofB, ofB2)) -
                    (a.isLevel ? a.nearest : std::min(ofA, ofA2)) - offset};
    }
    const double atLow = b.at(low) - a.at(low - lift), atHigh = b.at(high) - a.at(high - lift);
    return {std::min(atLow, atHigh) - offset, std::max(atLow, atHigh) - offset};
}

/// Calls visit(stretch) for all pairs of edges that can meet along the way, farther on than
/// `passed`, which it may change.
template <class Visit>
void eachMeeting(const Posed &a, const Posed &b, const Vec2 &by, Axis axis, const double &passed,
                 Steps &steps, Visit visit)
{
    const double offset = along(by, axis), lift = across(by, axis);
    const double low =
        std::max(across(a.box.min, axis) + lift, across(b.box.min, axis)) - kRounding;
    const double high =
        std::min(across(a.box.max, axis) + lift, across(b.box.max, axis)) + kRounding;
    const auto reaches = [axis](const Box2 &box, double from, double to) {
        return across(box.max, axis) >= from && across(box.min, axis) <= to;
    };
    // Those of b, once for all of a.
    thread_local std::vector<Met> ofB;
    ofB.clear();
    for (std::size_t run = 0; run < b.runs.size(); ++run) {
        if (!reaches(b.runs[run], low, high))
            continue;
        const std::size_t end = std::min((run + 1) * Posed::kRun, b.edges.size());
        for (std::size_t i = run * Posed::kRun; i < end; ++i)
            if (reaches(b.edges[i].box, low, high))
                ofB.push_back(metAlong(b.edges[i], axis));
    }
    std::sort(ofB.begin(), ofB.end(), [](const Met &p, const Met &q) { return p.low < q.low; });
    for (std::size_t run = 0; run < a.runs.size(); ++run) {
        if (!reaches(a.runs[run], low - lift, high - lift))
            continue;
        const std::size_t end = std::min((run + 1) * Posed::kRun, a.edges.size());
        for (std::size_t i = run * Posed::kRun; i < end; ++i) {
            if (!reaches(a.edges[i].box, low - lift, high - lift))
                continue;
            const Met edge = metAlong(a.edges[i], axis);
            const double from = edge.low + lift, to = edge.high + lift;
            const double behind = offset + edge.nearest;
            steps += static_cast<Steps>(ofB.size());
            for (const Met &other : ofB) {
                if (other.low > to)
                    break;
                if (other.high >= from && other.farthest - behind > passed)
                    visit(meeting(edge, other, offset, lift));
            }
        }
    }
}

Vec2 unit(Axis axis)
{
    return axis == Axis::X ? Vec2::UnitX() : Vec2::UnitY();
}

} // namespace

double wayOut(const Posed &a, const Posed &b, const Vec2 &by, Axis axis, Steps &steps)
{
    const double apart = kApart * (1.0 + a.box.size().maxCoeff() + b.box.size().maxCoeff() +
                                   by.cwiseAbs().maxCoeff());
    double way = 0.0;
    thread_local std::vector<Stretch> stretches; // that begin farther on than it goes already
    stretches.clear();
    double passed = -apart; // what ends there needs no way
    eachMeeting(a, b, by, axis, passed, steps, [&](const Stretch &stretch) {
        if (stretch.to + apart <= way || stretch.to < 0.0)
            return;
        if (stretch.from > way + apart) {
            stretches.push_back(stretch);
            return;
        }
        way = stretch.to + apart;
        passed = way - apart;
    });
    std::sort(stretches.begin(), stretches.end(),
              [](const Stretch &p, const Stretch &q) { return p.from < q.from; });
    for (const Stretch &stretch : stretches) {
        if (stretch.from > way + apart && !isOneInOther(a, b, by + way * unit(axis)))
            return way;
        way = std::max(way, stretch.to + apart);
    }
    return way;
}

double wayDown(const Posed &a, const Posed &b, const Vec2 &by, Axis axis, double most, Steps &steps)
{
    double way = most;
    constexpr double kNone = -std::numeric_limits<double>::infinity();
    eachMeeting(a, b, by, axis, kNone, steps, [&](const Stretch &stretch) {
        if (stretch.from <= 0.0)
            way = std::min(way, std::max(0.0, -stretch.to));
    });
    return way;
}

} // namespace fff::nest
