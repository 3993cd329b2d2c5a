#include "core/geometry/mirrored_boundaries.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace fff {

namespace {

/// An anchor this near to the axis is on it to rounding, and stays to the bit.
constexpr double kRounded = 1e-12;

bool isOnAxis(const MirrorAxis &axis, const Vec2 &p)
{
    return std::abs(axis.height(p)) <= kOnLine;
}

/// The segment runs along the axis: that is where the half was opened.
bool runsAlong(const MirrorAxis &axis, const CubicBezier &segment)
{
    return isOnAxis(axis, segment.p0) && isOnAxis(axis, segment.p1) && isOnAxis(axis, segment.p2) &&
           isOnAxis(axis, segment.p3);
}

Vec2 ontoAxis(const MirrorAxis &axis, const Vec2 &p)
{
    const double height = axis.height(p);
    return std::abs(height) <= kRounded ? p : Vec2(p - height * perpendicular(axis.direction));
}

CubicBezier imageOf(const CubicBezier &s, const MirrorAxis &axis)
{
    return {axis.mirrored(s.p3), axis.mirrored(s.p2), axis.mirrored(s.p1), axis.mirrored(s.p0)};
}

/// A chain from the axis to the axis, closed by its image.
Result<Contour> closedByImage(std::vector<CubicBezier> chain, const MirrorAxis &axis)
{
    chain.front().p0 = ontoAxis(axis, chain.front().p0);
    chain.back().p3 = ontoAxis(axis, chain.back().p3);
    const std::size_t count = chain.size();
    for (std::size_t i = count; i-- > 0;)
        chain.push_back(imageOf(chain[i], axis));
    chain[count].p0 = chain[count - 1].p3;
    chain.back().p3 = chain.front().p0;
    return Contour::fromSegments(chain);
}

/// Adds what becomes of a boundary of the half: closed beside the axis, itself and its image;
/// else each of its chains with its image. True when it reaches the axis.
Result<bool> addWithImage(const Contour &boundary, const MirrorAxis &axis,
                          std::vector<Contour> &all)
{
    const int count = boundary.segmentCount();
    std::optional<int> first; // of a chain
    for (int i = 0; i < count && !first; ++i)
        if (runsAlong(axis, boundary.segment((i + count - 1) % count)) &&
            !runsAlong(axis, boundary.segment(i)))
            first = i;
    if (!first) {
        std::vector<CubicBezier> image;
        for (int i = count; i-- > 0;)
            image.push_back(imageOf(boundary.segment(i), axis));
        Result<Contour> other = Contour::fromSegments(image);
        if (!other)
            return tl::unexpected(other.error());
        all.push_back(boundary);
        all.push_back(*std::move(other));
        return false;
    }
    std::vector<CubicBezier> chain;
    for (int k = 0; k <= count; ++k) {
        const CubicBezier segment = boundary.segment((*first + k) % count);
        if (k < count && !runsAlong(axis, segment)) {
            chain.push_back(segment);
            continue;
        }
        if (chain.empty())
            continue;
        Result<Contour> closed = closedByImage(std::move(chain), axis);
        chain.clear();
        if (!closed)
            return tl::unexpected(closed.error());
        all.push_back(*std::move(closed));
    }
    return true;
}

} // namespace

bool isMirrored(const Contour &contour, const std::vector<Contour> &holes, const MirrorAxis &axis)
{
    struct Place
    {
        double along, height;
    };
    std::vector<Place> places;
    const auto add = [&](const Contour &boundary) {
        for (const Vec2 &p : boundary.points())
            places.push_back({axis.direction.dot(p - axis.point), axis.height(p)});
    };
    add(contour);
    for (const Contour &hole : holes)
        add(hole);
    const auto isBefore = [](const Place &a, const Place &b) { return a.along < b.along; };
    std::sort(places.begin(), places.end(), isBefore);
    return std::all_of(places.begin(), places.end(), [&](const Place &place) {
        auto at = std::lower_bound(places.begin(), places.end(),
                                   Place{place.along - kSameImage, 0.0}, isBefore);
        for (; at != places.end() && at->along <= place.along + kSameImage; ++at)
            if (std::abs(at->height + place.height) <= kSameImage)
                return true;
        return false;
    });
}

Result<ClippedPiece> withImage(const Contour &contour, const std::vector<Contour> &holes,
                               const MirrorAxis &axis, bool isLeft)
{
    const Vec2 left = perpendicular(axis.direction);
    const Result<std::vector<ClippedPiece>> pieces =
        clip(contour, holes, {axis.point, isLeft ? left : Vec2(-left)});
    if (!pieces)
        return tl::unexpected(pieces.error());
    if (pieces->empty())
        return failure(ErrorCode::EmptyContour);
    const ClippedPiece &half = pieces->front();
    std::vector<Contour> all;
    const Result<bool> reaches = addWithImage(half.outer, axis, all);
    if (!reaches)
        return tl::unexpected(reaches.error());
    if (!*reaches)
        return failure(ErrorCode::EmptyContour);
    // Of several chains, the outermost is the contour and what the others enclose are holes.
    const auto isSmaller = [](const Contour &a, const Contour &b) {
        return std::abs(a.signedArea()) < std::abs(b.signedArea());
    };
    std::iter_swap(all.begin(), std::max_element(all.begin(), all.end(), isSmaller));
    for (const Contour &hole : half.holes)
        if (const Result<bool> added = addWithImage(hole, axis, all); !added)
            return tl::unexpected(added.error());
    ClippedPiece whole;
    whole.outer = std::move(all.front());
    whole.holes.assign(std::make_move_iterator(all.begin() + 1),
                       std::make_move_iterator(all.end()));
    return whole;
}

} // namespace fff
