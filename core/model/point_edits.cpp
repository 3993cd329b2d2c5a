#include "core/model/point_edits.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"

#include <algorithm>

namespace fff {

namespace {

/// A boundary that an edit made, and which.
struct Changed
{
    int boundary = 0;
    Contour contour;
};

tl::unexpected<Error> unknownPoint(const PointAddress &point)
{
    return failure(ErrorCode::UnknownReference,
                   std::to_string(point.boundary) + "/" + std::to_string(point.index));
}

/// Each hole lies inside the contour and none inside another one, given that none meet.
bool isNested(const Shape &shape)
{
    const auto inside = [](const Polygon &ring, const Polygon &other) {
        return locate(ring.front(), other) == Side::Inside;
    };
    const Region &region = shape.region();
    for (std::size_t i = 0; i < region.holes.size(); ++i) {
        if (!inside(region.holes[i], region.outer))
            return false;
        for (std::size_t j = 0; j < region.holes.size(); ++j)
            if (i != j && inside(region.holes[i], region.holes[j]))
                return false;
    }
    return true;
}

/// Errors  SelfCrossing: a ring that only touches itself is not said to; as resolveCrossings().
Result<void> isUncrossed(const Contour &contour)
{
    const auto resolved = resolveCrossings(contour);
    if (!resolved && resolved.error().code != ErrorCode::EmptyContour)
        return tl::unexpected(resolved.error());
    if (!resolved || resolved->wasCrossing)
        return failure(ErrorCode::SelfCrossing);
    return {};
}

/// The two lie to each other as they must; where they touched before, they may.
bool areApart(const Shape &now, const Shape &before, int a, int b)
{
    const auto how = [&](const Shape &shape) {
        return nesting(boundary(shape, a), boundary(shape, b), kCutChord);
    };
    const Nesting wanted = a == 0 ? Nesting::SecondInside : Nesting::Apart;
    const Nesting found = how(now);
    return found == wanted || (found == Nesting::Meeting && how(before) == Nesting::Meeting);
}

Result<ShapePointer> whole(const Shape &before, ShapePointer shape,
                           const std::vector<Changed> &changed)
{
    if (shape->isPlain()) { // nearly always, and the cut section asks for it anyway
        if (!isNested(*shape))
            return failure(ErrorCode::BoundariesMeet);
        return shape;
    }
    const auto isChanged = [&](int index) {
        return std::any_of(changed.begin(), changed.end(),
                           [index](const Changed &item) { return item.boundary == index; });
    };
    for (const Changed &item : changed)
        if (const auto uncrossed = isUncrossed(boundary(*shape, item.boundary)); !uncrossed)
            return tl::unexpected(uncrossed.error());
    for (int a = 0; a < boundaryCount(*shape); ++a)
        for (int b = a + 1; b < boundaryCount(*shape); ++b)
            if ((isChanged(a) || isChanged(b)) && !areApart(*shape, before, a, b))
                return failure(ErrorCode::BoundariesMeet);
    return shape;
}

Result<ShapePointer> withBoundaries(const Shape &before, std::vector<Changed> changed)
{
    Contour contour = before.contour();
    std::vector<Contour> holes = before.holes();
    for (const Changed &item : changed)
        (item.boundary == 0 ? contour : holes[static_cast<std::size_t>(item.boundary) - 1]) =
            item.contour;
    Result<ShapePointer> shape = Shape::make(std::move(contour), std::move(holes));
    if (!shape)
        return shape;
    return whole(before, *std::move(shape), changed);
}

/// Of those of the points that are of this boundary.
std::vector<int> indicesOf(std::span<const PointAddress> points, int boundary)
{
    std::vector<int> indices;
    for (const PointAddress &point : points)
        if (point.boundary == boundary)
            indices.push_back(point.index);
    return indices;
}

using EditContour = std::function<Result<Contour>(const Contour &, std::span<const int> indices)>;

/// Edits each boundary that has some of the points.
Result<ShapePointer> edited(const Shape &shape, std::span<const PointAddress> points,
                            const EditContour &edit)
{
    std::vector<Changed> changed;
    for (int b = 0; b < boundaryCount(shape); ++b) {
        const std::vector<int> indices = indicesOf(points, b);
        if (indices.empty())
            continue;
        Result<Contour> contour = edit(boundary(shape, b), indices);
        if (!contour)
            return tl::unexpected(contour.error());
        changed.push_back({b, *std::move(contour)});
    }
    return withBoundaries(shape, std::move(changed));
}

const PointAddress *firstUnknown(const Shape &shape, std::span<const PointAddress> points)
{
    const auto it = std::find_if(points.begin(), points.end(),
                                 [&](const PointAddress &p) { return !isPoint(shape, p); });
    return it == points.end() ? nullptr : &*it;
}

} // namespace

int boundaryCount(const Shape &shape)
{
    return 1 + static_cast<int>(shape.holes().size());
}

const Contour &boundary(const Shape &shape, int index)
{
    return index == 0 ? shape.contour() : shape.holes()[static_cast<std::size_t>(index) - 1];
}

bool isPoint(const Shape &shape, const PointAddress &address)
{
    return address.boundary >= 0 && address.boundary < boundaryCount(shape) && address.index >= 0 &&
           address.index < boundary(shape, address.boundary).segmentCount();
}

Vec2 position(const Shape &shape, const PointAddress &point)
{
    return anchor(boundary(shape, point.boundary), point.index);
}

std::vector<PointAddress> pointsAt(const Shape &shape, std::span<const Vec2> places)
{
    std::vector<PointAddress> found;
    for (int b = 0; b < boundaryCount(shape); ++b) {
        const Contour &contour = boundary(shape, b);
        for (int i = 0; i < contour.segmentCount(); ++i)
            if (std::find(places.begin(), places.end(), anchor(contour, i)) != places.end())
                found.push_back({b, i});
    }
    return found;
}

Result<ShapePointer> movedPoints(const Shape &shape, std::span<const PointAddress> points,
                                 const Vec2 &by, bool breaks)
{
    if (const PointAddress *unknown = firstUnknown(shape, points))
        return unknownPoint(*unknown);
    return edited(shape, points, [&](const Contour &contour, std::span<const int> indices) {
        return movedAnchors(contour, indices, by, breaks);
    });
}

Result<ShapePointer>
withEach(const Shape &shape, std::span<const PointAddress> points,
         const std::function<Result<Contour>(const Contour &, int index)> &edit)
{
    if (const PointAddress *unknown = firstUnknown(shape, points))
        return unknownPoint(*unknown);
    return edited(shape, points, [&](const Contour &contour, std::span<const int> indices) {
        Result<Contour> next = contour;
        for (const int index : indices)
            if (next)
                next = edit(*next, index);
        return next;
    });
}

Result<ShapePointer> movedPoint(const Shape &shape, const PointAddress &point, const Vec2 &to)
{
    if (!isPoint(shape, point))
        return unknownPoint(point);
    return edited(shape, {&point, 1}, [&](const Contour &contour, std::span<const int> indices) {
        return movedAnchor(contour, indices.front(), to);
    });
}

Result<ShapePointer> movedHandle(const Shape &shape, const PointAddress &point, HandleSide side,
                                 const Vec2 &to, bool breaks)
{
    if (!isPoint(shape, point))
        return unknownPoint(point);
    return edited(shape, {&point, 1}, [&](const Contour &contour, std::span<const int> indices) {
        return movedHandle(contour, indices.front(), side, to, breaks);
    });
}

Result<ShapePointer> movedSegment(const Shape &shape, int boundary, const CurvePoint &at,
                                  const Vec2 &by, bool breaks)
{
    const PointAddress start{boundary, at.segment};
    if (!isPoint(shape, start))
        return unknownPoint(start);
    return edited(shape, {&start, 1}, [&](const Contour &contour, std::span<const int>) {
        return movedSegment(contour, at.segment, at.t, by, breaks);
    });
}

Result<ShapePointer> insertedPoint(const Shape &shape, int boundary, const CurvePoint &at)
{
    const PointAddress start{boundary, at.segment};
    if (!isPoint(shape, start))
        return unknownPoint(start);
    return edited(shape, {&start, 1}, [&](const Contour &contour, std::span<const int>) {
        return insertedPoint(contour, at.segment, at.t);
    });
}

Result<ShapePointer> withoutPoints(const Shape &shape, std::span<const PointAddress> points)
{
    if (const PointAddress *unknown = firstUnknown(shape, points))
        return unknownPoint(*unknown);
    std::vector<Changed> changed;
    std::vector<int> gone; // holes
    for (int b = 0; b < boundaryCount(shape); ++b) {
        const std::vector<int> indices = indicesOf(points, b);
        if (indices.empty())
            continue;
        Result<Contour> contour = withoutPoints(boundary(shape, b), indices);
        if (contour)
            changed.push_back({b, *std::move(contour)});
        else if (b == 0 || contour.error().code != ErrorCode::TooFewPoints)
            return tl::unexpected(contour.error());
        else
            gone.push_back(b);
    }
    if (gone.empty())
        return withBoundaries(shape, std::move(changed));
    std::vector<Contour> holes;
    std::vector<int> nowAt(static_cast<std::size_t>(boundaryCount(shape)), 0);
    for (int b = 1; b < boundaryCount(shape); ++b) {
        if (std::find(gone.begin(), gone.end(), b) != gone.end())
            continue;
        holes.push_back(boundary(shape, b));
        nowAt[static_cast<std::size_t>(b)] = static_cast<int>(holes.size());
    }
    const Result<ShapePointer> kept = Shape::make(shape.contour(), std::move(holes));
    if (!kept || changed.empty())
        return kept;
    for (Changed &item : changed)
        item.boundary = nowAt[static_cast<std::size_t>(item.boundary)];
    return withBoundaries(**kept, std::move(changed));
}

Result<ShapePointer> withKind(const Shape &shape, std::span<const PointAddress> points,
                              PointKind kind)
{
    return withEach(shape, points, [kind](const Contour &contour, int index) {
        return withKind(contour, index, kind);
    });
}

Result<ShapePointer> withBoundary(const Shape &shape, int boundary, Contour contour)
{
    if (boundary < 0 || boundary >= boundaryCount(shape))
        return unknownPoint({boundary, 0});
    return withBoundaries(shape, {{boundary, std::move(contour)}});
}

Result<ShapePointer> withoutHoles(const Shape &shape)
{
    return Shape::make(shape.contour());
}

} // namespace fff
