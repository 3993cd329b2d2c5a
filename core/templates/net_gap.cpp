#include "core/templates/net_gap.h"

#include "core/geometry/segment_distance.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// mm: an edge so near to the fold all along is on it.
constexpr double kOnFold = kCoplanarDepth;

struct Piece
{
    Vec2 from, to;
};

/// Parts of a segment that are farther than `reach` from a place.
std::vector<Piece> beyond(const Piece &piece, const Vec2 &place, double reach)
{
    const Vec2 way = piece.to - piece.from;
    const double length = way.norm();
    if (!(length > 0.0))
        return {};
    const Vec2 along = way / length;
    const double at = along.dot(place - piece.from);
    const double aside = (piece.from + at * along - place).norm();
    if (aside >= reach)
        return {piece};
    const double half = std::sqrt(reach * reach - aside * aside);
    std::vector<Piece> left;
    if (at - half > 0.0)
        left.push_back({piece.from, piece.from + std::min(at - half, length) * along});
    if (at + half < length)
        left.push_back({piece.from + std::max(at + half, 0.0) * along, piece.to});
    return left;
}

/// Edges of the loops away from the fold and its ends.
std::vector<Piece> piecesOf(const std::vector<Polygon> &loops, const NetLine &fold, double near)
{
    std::vector<Piece> all;
    const auto isOnFold = [&fold](const Vec2 &p) {
        return distanceToSegment(p, fold.from, fold.to) <= kOnFold;
    };
    for (const Polygon &loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Piece edge{loop[i], loop[(i + 1) % loop.size()]};
            // Of an edge that is longer than the fold what goes on beyond it counts.
            const bool isFold =
                isOnFold(0.5 * (edge.from + edge.to)) && (isOnFold(edge.from) || isOnFold(edge.to));
            if (isFold)
                continue;
            for (const Piece &first : beyond(edge, fold.from, near))
                for (const Piece &second : beyond(first, fold.to, near))
                    if (!isOnFold(0.5 * (second.from + second.to)))
                        all.push_back(second);
        }
    return all;
}

/// Of two that do not cross.
double distanceOf(const Piece &a, const Piece &b)
{
    return std::min({distanceToSegment(a.from, b.from, b.to), distanceToSegment(a.to, b.from, b.to),
                     distanceToSegment(b.from, a.from, a.to),
                     distanceToSegment(b.to, a.from, a.to)});
}

} // namespace

bool keepsGap(const std::vector<Polygon> &placed, const std::vector<Polygon> &added,
              const NetLine &fold, double gap)
{
    if (!(gap > 0.0))
        return true;
    const double near = kNearFold * gap;
    const std::vector<Piece> there = piecesOf(placed, fold, near),
                             next = piecesOf(added, fold, near);
    return std::none_of(next.begin(), next.end(), [&](const Piece &a) {
        const Vec2 low = a.from.cwiseMin(a.to).array() - gap,
                   high = a.from.cwiseMax(a.to).array() + gap;
        return std::any_of(there.begin(), there.end(), [&](const Piece &b) {
            const Vec2 from = b.from.cwiseMin(b.to), to = b.from.cwiseMax(b.to);
            return (from.array() <= high.array()).all() && (to.array() >= low.array()).all() &&
                   distanceOf(a, b) < gap;
        });
    });
}

} // namespace fff
