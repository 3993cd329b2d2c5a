#include "core/model/spare_sheet.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <utility>

namespace fff {

namespace {

Contour moved(const Contour &contour, const Vec2 &by)
{
    std::vector<Vec2> points = contour.points();
    for (Vec2 &p : points)
        p += by;
    return Contour::ofPoints(std::move(points));
}

Result<ShapePointer> shapeInPlace(const ShapePointer &shape)
{
    const Vec2 way = -shape->bounds().min;
    if (way.isZero(0.0))
        return shape;
    std::vector<Contour> holes;
    for (const Contour &hole : shape->holes())
        holes.push_back(moved(hole, way));
    return Shape::make(moved(shape->contour(), way), std::move(holes));
}

} // namespace

bool SpareSheet::operator==(const SpareSheet &other) const
{
    return count == other.count &&
           (shape == other.shape || (shape && other.shape && *shape == *other.shape));
}

Result<SpareSheet> rectangularSheet(const Vec2 &size, int count)
{
    if (!(size.minCoeff() > 0.0))
        return failure(ErrorCode::EmptyContour);
    const Polygon corners{{0.0, 0.0}, {size.x(), 0.0}, size, {0.0, size.y()}};
    return Contour::fromPolygon(corners)
        .and_then([](const Contour &contour) { return Shape::make(contour); })
        .map([count](ShapePointer shape) {
            return SpareSheet{std::move(shape), count};
        });
}

Result<SpareSheet> spareSheet(const Outline &outline, int count)
{
    return Shape::make(outline.outer, outline.holes)
        .and_then(shapeInPlace)
        .and_then([count](ShapePointer shape) -> Result<SpareSheet> {
            if (!shape->isPlain())
                return failure(ErrorCode::BadContour);
            return SpareSheet{std::move(shape), count};
        });
}

std::optional<Vec2> rectangleOf(const SpareSheet &sheet)
{
    if (!sheet.shape->holes().empty())
        return std::nullopt;
    const Vec2 size = sheet.size();
    const Result<SpareSheet> same = rectangularSheet(size, sheet.count);
    return same && *same == sheet ? std::optional(size) : std::nullopt;
}

bool isUsable(const SpareSheet &sheet)
{
    return sheet.shape && sheet.count >= 1 && sheet.count <= kMostSpares &&
           sheet.shape->isPlain() && sheet.shape->bounds().min.cwiseAbs().maxCoeff() <= kClipGrid;
}

} // namespace fff
