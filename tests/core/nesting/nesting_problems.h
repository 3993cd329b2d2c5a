// Problems to nest: of any seed, and by hand.
#pragma once

#include "core/nesting/problem.h"

#include <cmath>
#include <numbers>
#include <random>

namespace fff::test {

inline Polygon box(double left, double bottom, double width, double height)
{
    return {{left, bottom},
            {left + width, bottom},
            {left + width, bottom + height},
            {left, bottom + height}};
}

inline nest::Piece pieceOf(Polygon outer, int demand = 1,
                           nest::Turning turning = nest::Turning::Quarter)
{
    nest::Piece piece;
    piece.outline.outer = std::move(outer);
    piece.demand = demand;
    piece.turns = nest::turnsOf(turning);
    piece.turnsFreely = turning == nest::Turning::Free;
    return piece;
}

/// A star, clockwise or not, of radius 1 times `size`; with a hole where it is large enough.
inline nest::Piece star(std::mt19937 &random, double size, nest::Turning turning)
{
    std::uniform_real_distribution<double> radius(0.3, 1.0);
    std::uniform_int_distribution<int> corners(3, 12);
    const int count = corners(random);
    Polygon outer;
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / count;
        outer.emplace_back(size * radius(random) * Vec2(std::cos(angle), std::sin(angle)));
    }
    nest::Piece piece = pieceOf(std::move(outer), 1 + static_cast<int>(random() % 3), turning);
    if (count > 8 && size > 20.0)
        piece.outline.holes.push_back(
            {{-0.2 * size, 0.0}, {0.0, 0.2 * size}, {0.2 * size, 0.0}, {0.0, -0.2 * size}});
    return piece;
}

inline std::vector<nest::Piece> stars(unsigned seed, int kinds, nest::Turning turning)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> size(5.0, 40.0);
    std::vector<nest::Piece> pieces;
    for (int i = 0; i < kinds; ++i)
        pieces.push_back(star(random, size(random), turning));
    return pieces;
}

inline nest::SheetKind sheet(double width, double height, int count = nest::SheetKind::kUnlimited)
{
    return {{box(0, 0, width, height), {}}, count};
}

/// An L with a round hole: what is left of a sheet.
inline nest::SheetKind offcut(int count)
{
    nest::SheetKind kind;
    kind.count = count;
    kind.outline.outer = {{0, 0}, {200, 0}, {200, 80}, {90, 80}, {90, 180}, {0, 180}};
    Polygon hole;
    for (int i = 0; i < 24; ++i) {
        const double angle = -2.0 * std::numbers::pi * i / 24;
        hole.emplace_back(Vec2(45, 45) + 22.0 * Vec2(std::cos(angle), std::sin(angle)));
    }
    kind.outline.holes.push_back(hole);
    return kind;
}

} // namespace fff::test
