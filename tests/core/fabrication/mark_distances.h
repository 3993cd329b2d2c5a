// How far the strokes of a part's number are from those of its joints' numbers, by brute force.
#pragma once

#include "core/fabrication/marks.h"
#include "tests/core/geometry/curve_distance.h"

#include <QString>

#include <algorithm>
#include <limits>

namespace fff::test {

struct StrokedMark
{
    std::vector<Polygon> strokes; // open
    double height = 0.0;          // of its digits, mm
};

/// Joints' numbers first, as in the engraving.
inline std::vector<StrokedMark> marksOf(const Engraving &engraving)
{
    constexpr double kRounding = 1e-9;
    std::vector<StrokedMark> marks(engraving.boxes.size());
    for (std::size_t i = 0; i < engraving.strokes.size(); ++i) {
        const auto stroke = engraving.strokes[i];
        const auto box =
            std::find_if(engraving.boxes.begin(), engraving.boxes.end(), [&](const Box2 &b) {
                return std::all_of(stroke.begin(), stroke.end(), [&](const Vec2 &p) {
                    return std::min((p - b.min).minCoeff(), (b.max - p).minCoeff()) > -kRounding;
                });
            });
        if (box == engraving.boxes.end())
            continue; // of no mark: found by whoever counts them
        StrokedMark &mark = marks[static_cast<std::size_t>(box - engraving.boxes.begin())];
        mark.strokes.emplace_back(stroke.begin(), stroke.end());
        // Every digit has a stroke over its whole height.
        const auto [low, high] =
            std::minmax_element(stroke.begin(), stroke.end(),
                                [](const Vec2 &a, const Vec2 &b) { return a.y() < b.y(); });
        mark.height = std::max(mark.height, high->y() - low->y());
    }
    return marks;
}

inline double distanceToEdge(const Vec2 &p, const Vec2 &a, const Vec2 &b)
{
    const Vec2 way = b - a;
    const double square = way.squaredNorm();
    const double share = square > 0.0 ? std::clamp(way.dot(p - a) / square, 0.0, 1.0) : 0.0;
    return (p - a - share * way).norm();
}

/// Strokes of two marks never cross, since their boxes lie apart: corners are enough.
inline double distanceOf(const StrokedMark &a, const StrokedMark &b)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto *from : {&a, &b})
        for (const Polygon &stroke : from->strokes)
            for (const Vec2 &p : stroke)
                for (const Polygon &other : (from == &a ? b : a).strokes)
                    for (std::size_t i = 1; i < other.size(); ++i)
                        nearest = std::min(nearest, distanceToEdge(p, other[i - 1], other[i]));
    return nearest;
}

/// Empty when all marks lie wholly on the part and none can be read together with another one.
inline QString misread(const Engraving &engraving, const Part &part)
{
    constexpr double kRounding = 1e-6;
    const MarkOptions options;
    const std::vector<StrokedMark> marks = marksOf(engraving);
    std::size_t count = 0;
    for (const StrokedMark &mark : marks) {
        count += mark.strokes.size();
        if (mark.height < options.minHeight - kRounding)
            return QStringLiteral("a number of %1 mm").arg(mark.height);
        for (const Polygon &stroke : mark.strokes) {
            for (const Vec2 &p : stroke)
                if (locate(p, part.outline.region) != Side::Inside)
                    return QStringLiteral("a stroke is beside the part");
            const auto crosses = [&](const Polygon &ring) {
                double nearest = std::numeric_limits<double>::infinity();
                for (const Vec2 &corner : ring)
                    for (std::size_t i = 1; i < stroke.size(); ++i)
                        nearest =
                            std::min(nearest, distanceToEdge(corner, stroke[i - 1], stroke[i]));
                for (const Vec2 &p : stroke)
                    nearest = std::min(nearest, distanceTo(p, ring));
                return nearest < 0.5 * options.clearance;
            };
            bool isCut = crosses(part.outline.region.outer);
            for (const Polygon &hole : part.outline.region.holes)
                isCut = isCut || crosses(hole);
            if (isCut)
                return QStringLiteral("a stroke is cut through");
        }
    }
    if (count != engraving.strokes.size())
        return QStringLiteral("a stroke belongs to no mark");
    const std::size_t joints = marks.size() - (engraving.hasNumber ? 1 : 0);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const double distance = distanceOf(marks[i], marks[k]);
            const double larger = std::max(marks[i].height, marks[k].height);
            const double smaller = std::min(marks[i].height, marks[k].height);
            if (i == joints && distance < 2.0 * larger - kRounding)
                return QStringLiteral("the part's number is %1 mm from a joint's, heights %2, %3")
                    .arg(distance)
                    .arg(larger)
                    .arg(smaller);
            if (i < joints && distance < smaller - kRounding)
                return QStringLiteral("two joints' numbers are %1 mm apart").arg(distance);
        }
    }
    return {};
}

} // namespace fff::test
