#include "core/geometry/symmetrised.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/mapped_contour.h"

#include <cmath>
#include <numbers>

namespace fff {

namespace {

/// Halves and sectors reach over each other by this, so that what touches becomes one. mm.
constexpr double kOverlap = 8.0 * kClipGrid;

/// Outer ones counter-clockwise, holes clockwise, so that windings add up.
void append(std::vector<Contour> &all, const ClippedPiece &piece)
{
    const auto wound = [](const Contour &contour, bool isOuter) {
        return (contour.signedArea() > 0.0) == isOuter ? contour : contour.reversed();
    };
    all.push_back(wound(piece.outer, true));
    for (const Contour &hole : piece.holes)
        all.push_back(wound(hole, false));
}

ClippedPiece mapped(const ClippedPiece &piece, const Eigen::Matrix2d &matrix, const Vec2 &about)
{
    // It stays within what a document may hold, or nothing of it is left.
    ClippedPiece result{mapped(piece.outer, matrix, about).value_or(Contour()), {}};
    for (const Contour &hole : piece.holes)
        result.holes.push_back(mapped(hole, matrix, about).value_or(Contour()));
    return result;
}

std::vector<ClippedPiece> together(const std::vector<Contour> &all)
{
    std::vector<ClippedPiece> pieces;
    for (CurvedRegion &region : windingRegions(all, WindingRule::Positive, kCutChord))
        pieces.push_back({std::move(region.outer), std::move(region.holes)});
    return pieces;
}

} // namespace

std::vector<ClippedPiece> mirroredHalf(const Contour &contour, const std::vector<Contour> &holes,
                                       const Halfplane &half)
{
    const Vec2 along = half.along();
    const Eigen::Matrix2d mirror = 2.0 * along * along.transpose() - Eigen::Matrix2d::Identity();
    std::vector<Contour> all;
    for (const ClippedPiece &piece :
         clip(contour, holes, {half.point - kOverlap * half.inward, half.inward})) {
        append(all, piece);
        append(all, mapped(piece, mirror, half.point));
    }
    return together(all);
}

std::vector<ClippedPiece> repeatedSector(const Contour &contour, const std::vector<Contour> &holes,
                                         const Vec2 &centre, int count, double direction)
{
    const double width = 2.0 * std::numbers::pi / count;
    std::vector<ClippedPiece> sector{{contour, holes}};
    if (count < 2)
        return sector;
    for (const double side : {-1.0, 1.0}) {
        const double ray = direction + 0.5 * side * width;
        const Vec2 inward = -side * Vec2(-std::sin(ray), std::cos(ray));
        std::vector<ClippedPiece> next;
        for (const ClippedPiece &piece : sector)
            for (ClippedPiece &part :
                 clip(piece.outer, piece.holes, {centre - kOverlap * inward, inward}))
                next.push_back(std::move(part));
        sector = std::move(next);
        if (count == 2)
            break; // a half has one line
    }
    std::vector<Contour> all;
    for (int i = 0; i < count; ++i) {
        const Eigen::Matrix2d turn = Eigen::Rotation2Dd(width * i).toRotationMatrix();
        for (const ClippedPiece &piece : sector)
            append(all, mapped(piece, turn, centre));
    }
    return together(all);
}

} // namespace fff
