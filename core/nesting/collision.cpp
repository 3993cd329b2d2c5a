#include "core/nesting/collision.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

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

/// Where the edge is, along the way, at that height across; it is not parallel to the way there.
double whereAt(const Edge &edge, double height, Axis axis)
{
    const double low = across(edge.from, axis), high = across(edge.to, axis);
    if (low == high)
        return along(edge.from, axis);
    const double share = std::clamp((height - low) / (high - low), 0.0, 1.0);
    return along(edge.from, axis) + share * (along(edge.to, axis) - along(edge.from, axis));
}

/// By how much `a`, moved, has to go on for it to meet `b`: from … to.
Stretch meeting(const Edge &a, const Edge &b, const Vec2 &by, Axis axis)
{
    const double offset = along(by, axis), lift = across(by, axis);
    const double low = std::max(across(a.box.min, axis) + lift, across(b.box.min, axis));
    const double high = std::min(across(a.box.max, axis) + lift, across(b.box.max, axis));
    Stretch stretch{std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
    const auto take = [&](double gap) {
        stretch.from = std::min(stretch.from, gap);
        stretch.to = std::max(stretch.to, gap);
    };
    const bool isLevelA = across(a.from, axis) == across(a.to, axis);
    const bool isLevelB = across(b.from, axis) == across(b.to, axis);
    for (const double height : {low, high}) {
        const double ofA = whereAt(a, height - lift, axis) + offset, ofB = whereAt(b, height, axis);
        take(ofB - ofA);
        // A level edge is everywhere between its ends at once.
        const double otherA = isLevelA ? along(a.to, axis) + offset : ofA;
        const double otherB = isLevelB ? along(b.to, axis) : ofB;
        take(otherB - ofA);
        take(ofB - otherA);
        take(otherB - otherA);
    }
    return stretch;
}

/// Calls visit(stretch) for all pairs of edges that can meet along the way.
template <class Visit>
void eachMeeting(const Posed &a, const Posed &b, const Vec2 &by, Axis axis, Steps &steps,
                 Visit visit)
{
    const double lift = across(by, axis);
    const double low =
        std::max(across(a.box.min, axis) + lift, across(b.box.min, axis)) - kRounding;
    const double high =
        std::min(across(a.box.max, axis) + lift, across(b.box.max, axis)) + kRounding;
    const auto reaches = [axis](const Box2 &box, double from, double to) {
        return across(box.max, axis) >= from && across(box.min, axis) <= to;
    };
    for (std::size_t runA = 0; runA < a.runs.size(); ++runA) {
        if (!reaches(a.runs[runA], low - lift, high - lift))
            continue;
        for (std::size_t i = runA * Posed::kRun;
             i < std::min((runA + 1) * Posed::kRun, a.edges.size()); ++i) {
            const Edge &edge = a.edges[i];
            if (!reaches(edge.box, low - lift, high - lift))
                continue;
            const double from = across(edge.box.min, axis) + lift,
                         to = across(edge.box.max, axis) + lift;
            for (std::size_t runB = 0; runB < b.runs.size(); ++runB) {
                if (!reaches(b.runs[runB], from, to))
                    continue;
                steps += static_cast<Steps>(Posed::kRun);
                const std::size_t end = std::min((runB + 1) * Posed::kRun, b.edges.size());
                for (std::size_t j = runB * Posed::kRun; j < end; ++j)
                    if (reaches(b.edges[j].box, from, to))
                        visit(meeting(edge, b.edges[j], by, axis));
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
    thread_local std::vector<Stretch> stretches;
    stretches.clear();
    eachMeeting(a, b, by, axis, steps, [&](const Stretch &stretch) {
        if (stretch.to >= 0.0)
            stretches.push_back(stretch);
    });
    std::sort(stretches.begin(), stretches.end(),
              [](const Stretch &p, const Stretch &q) { return p.from < q.from; });
    const double apart = kApart * (1.0 + a.box.size().maxCoeff() + b.box.size().maxCoeff() +
                                   by.cwiseAbs().maxCoeff());
    double way = 0.0;
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
    eachMeeting(a, b, by, axis, steps, [&](const Stretch &stretch) {
        if (stretch.from <= 0.0)
            way = std::min(way, std::max(0.0, -stretch.to));
    });
    return way;
}

} // namespace fff::nest
