#include "core/geometry/symmetrised.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/mapped_contour.h"

#include <cmath>
#include <iterator>
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

/// The piece's image, as above.
Result<void> appendMapped(std::vector<Contour> &all, const ClippedPiece &piece,
                          const Eigen::Matrix2d &matrix, const Vec2 &about)
{
    ClippedPiece image;
    Result<Contour> outer = mapped(piece.outer, matrix, about);
    if (!outer)
        return tl::unexpected(outer.error());
    image.outer = *std::move(outer);
    for (const Contour &hole : piece.holes) {
        Result<Contour> other = mapped(hole, matrix, about);
        if (!other)
            return tl::unexpected(other.error());
        image.holes.push_back(*std::move(other));
    }
    append(all, image);
    return {};
}

Result<std::vector<ClippedPiece>> together(const std::vector<Contour> &all)
{
    Result<std::vector<CurvedRegion>> regions =
        windingRegions(all, WindingRule::Positive, kCutChord);
    if (!regions)
        return tl::unexpected(regions.error());
    std::vector<ClippedPiece> pieces;
    for (CurvedRegion &region : *regions)
        pieces.push_back({std::move(region.outer), std::move(region.holes)});
    return pieces;
}

} // namespace

Result<std::vector<ClippedPiece>>
mirroredHalf(const Contour &contour, const std::vector<Contour> &holes, const Halfplane &half)
{
    const Vec2 along = half.along();
    const Eigen::Matrix2d mirror = 2.0 * along * along.transpose() - Eigen::Matrix2d::Identity();
    const Result<std::vector<ClippedPiece>> pieces =
        clip(contour, holes, {half.point - kOverlap * half.inward, half.inward});
    if (!pieces)
        return pieces;
    std::vector<Contour> all;
    for (const ClippedPiece &piece : *pieces) {
        append(all, piece);
        if (const Result<void> added = appendMapped(all, piece, mirror, half.point); !added)
            return tl::unexpected(added.error());
    }
    return together(all);
}

Result<std::vector<ClippedPiece>> repeatedSector(const Contour &contour,
                                                 const std::vector<Contour> &holes,
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
        for (const ClippedPiece &piece : sector) {
            Result<std::vector<ClippedPiece>> parts =
                clip(piece.outer, piece.holes, {centre - kOverlap * inward, inward});
            if (!parts)
                return parts;
            std::move(parts->begin(), parts->end(), std::back_inserter(next));
        }
        sector = std::move(next);
        if (count == 2)
            break; // a half has one line
    }
    std::vector<Contour> all;
    for (int i = 0; i < count; ++i) {
        const Eigen::Matrix2d turn = Eigen::Rotation2Dd(width * i).toRotationMatrix();
        for (const ClippedPiece &piece : sector)
            if (const Result<void> added = appendMapped(all, piece, turn, centre); !added)
                return tl::unexpected(added.error());
    }
    return together(all);
}

} // namespace fff
