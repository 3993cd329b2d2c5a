// What is wrong with a layout, found without the code that made or proved it: overlaps by the area
// that two outlines share, distances of all edges to all others.
#pragma once

#include "core/nesting/problem.h"

#include <QString>

#include <polyclipping/clipper.hpp>

#include <algorithm>
#include <cmath>

namespace fff::test {

using OracleRings = std::vector<std::vector<Vec2>>;

/// The rings of a piece where it lies.
inline OracleRings lyingRings(const Region &outline, const Vec2 &turn, const Vec2 &offset)
{
    OracleRings rings{outline.outer};
    rings.insert(rings.end(), outline.holes.begin(), outline.holes.end());
    for (auto &ring : rings)
        for (Vec2 &p : ring)
            p = Vec2(turn.x() * p.x() - turn.y() * p.y(), turn.y() * p.x() + turn.x() * p.y()) +
                offset;
    return rings;
}

inline ClipperLib::Paths oraclePaths(const OracleRings &rings)
{
    constexpr double kSteps = 1e6; // a mm
    ClipperLib::Paths paths;
    for (const auto &ring : rings) {
        paths.emplace_back();
        for (const Vec2 &p : ring)
            paths.back().emplace_back(std::llround(p.x() * kSteps), std::llround(p.y() * kSteps));
    }
    return paths;
}

/// mm², of what is in `a` and, by `type`, in or not in `b`.
inline double oracleArea(const OracleRings &a, const OracleRings &b, ClipperLib::ClipType type)
{
    ClipperLib::Clipper clipper;
    clipper.AddPaths(oraclePaths(a), ClipperLib::ptSubject, true);
    clipper.AddPaths(oraclePaths(b), ClipperLib::ptClip, true);
    ClipperLib::Paths result;
    clipper.Execute(type, result, ClipperLib::pftEvenOdd, ClipperLib::pftEvenOdd);
    double area = 0.0;
    for (const ClipperLib::Path &path : result)
        area += ClipperLib::Area(path) * 1e-12;
    return area;
}

inline double oracleDistance(const Vec2 &p, const Vec2 &a, const Vec2 &b)
{
    const Vec2 way = b - a;
    const double length = way.squaredNorm();
    const double share = length > 0.0 ? std::min(1.0, std::max(0.0, way.dot(p - a) / length)) : 0.0;
    return (a + share * way - p).norm();
}

/// Of boundaries that do not cross.
inline double oracleDistance(const OracleRings &a, const OracleRings &b)
{
    double least = std::numeric_limits<double>::infinity();
    const auto cornersToEdges = [&least](const OracleRings &from, const OracleRings &to) {
        for (const auto &ring : from)
            for (const Vec2 &p : ring)
                for (const auto &other : to)
                    for (std::size_t i = 0; i < other.size(); ++i)
                        least = std::min(
                            least, oracleDistance(p, other[i], other[(i + 1) % other.size()]));
    };
    cornersToEdges(a, b);
    cornersToEdges(b, a);
    return least;
}

inline OracleRings oracleContainer(const nest::Problem &problem, const nest::Solution &solution,
                                   int sheet)
{
    if (!(problem.stripHeight > 0.0)) {
        const auto kind = solution.sheets.at(static_cast<std::size_t>(sheet));
        return lyingRings(problem.sheets.at(static_cast<std::size_t>(kind)).outline, Vec2::UnitX(),
                          Vec2::Zero());
    }
    const double far = solution.length, high = problem.stripHeight;
    return {{{0.0, 0.0}, {far, 0.0}, {far, high}, {0.0, high}}};
}

/// Empty where all is as it has to be.
inline QString whatIsWrong(const nest::Problem &problem, const nest::Solution &solution)
{
    constexpr double kNoArea = 1e-4, kRounding = 1e-5; // mm², mm
    std::vector<int> counts(problem.pieces.size(), 0), sheets(problem.sheets.size(), 0);
    std::vector<OracleRings> lying;
    for (const nest::Place &place : solution.places) {
        const nest::Piece &piece = problem.pieces.at(static_cast<std::size_t>(place.piece));
        ++counts[static_cast<std::size_t>(place.piece)];
        lying.push_back(lyingRings(piece.outline, place.turn, place.offset));
        if (std::abs(place.turn.norm() - 1.0) > 1e-9)
            return QStringLiteral("a turn that is none");
        if (!piece.turnsFreely && std::none_of(piece.turns.begin(), piece.turns.end(),
                                               [&](const Vec2 &t) { return t == place.turn; }))
            return QStringLiteral("piece %1 is turned").arg(place.piece);
        const OracleRings container = oracleContainer(problem, solution, place.sheet);
        if (oracleArea(lying.back(), container, ClipperLib::ctDifference) > kNoArea)
            return QStringLiteral("piece %1 is beyond the edge").arg(place.piece);
        if (oracleDistance(lying.back(), container) < problem.margin - kRounding)
            return QStringLiteral("piece %1 is in the margin").arg(place.piece);
    }
    for (std::size_t i = 0; i < lying.size(); ++i)
        for (std::size_t j = i + 1; j < lying.size(); ++j) {
            if (solution.places[i].sheet != solution.places[j].sheet)
                continue;
            const QString pair = QStringLiteral("pieces %1 and %2 ")
                                     .arg(solution.places[i].piece)
                                     .arg(solution.places[j].piece);
            if (oracleArea(lying[i], lying[j], ClipperLib::ctIntersection) > kNoArea)
                return pair + QStringLiteral("overlap");
            if (oracleDistance(lying[i], lying[j]) < problem.spacing - kRounding)
                return pair + QStringLiteral("are too near");
        }
    for (const int piece : solution.left)
        ++counts[static_cast<std::size_t>(piece)];
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (counts[i] != problem.pieces[i].demand)
            return QStringLiteral("%1 of piece %2").arg(counts[i]).arg(i);
    for (const int kind : solution.sheets)
        ++sheets[static_cast<std::size_t>(kind)];
    for (std::size_t i = 0; i < sheets.size(); ++i)
        if (problem.sheets[i].count >= 0 && sheets[i] > problem.sheets[i].count)
            return QStringLiteral("%1 sheets of kind %2").arg(sheets[i]).arg(i);
    return {};
}

} // namespace fff::test
