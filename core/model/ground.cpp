#include "core/model/ground.h"

#include "core/base/tolerances.h"

namespace fff {

namespace {

bool isBelow(const Frame &levelFrame)
{
    return levelFrame.origin.y() < -kOnLine;
}

} // namespace

std::optional<Halfplane> groundLine(const Frame &frame)
{
    // Height above the ground rises along this by its length a mm.
    const Vec2 upwards(frame.x.y(), frame.y.y());
    const double rise = upwards.norm();
    if (rise <= kSameDirection)
        return {};
    const Vec2 inward = upwards / rise;
    return Halfplane{-(frame.origin.y() / rise) * inward, inward};
}

Result<std::vector<ClippedPiece>> clippedAtGround(const Contour &contour, const Frame &frame)
{
    if (const std::optional<Halfplane> above = groundLine(frame))
        return clip(contour, {}, *above);
    if (isBelow(frame))
        return std::vector<ClippedPiece>{};
    return std::vector<ClippedPiece>{{contour, {}}};
}

Result<std::vector<ShapePointer>> clippedAtGround(const ShapePointer &shape, const Frame &frame)
{
    const std::optional<Halfplane> above = groundLine(frame);
    if (above ? isInside(shape->contour(), *above) : !isBelow(frame))
        return std::vector<ShapePointer>{shape};
    std::vector<ShapePointer> shapes;
    if (!above)
        return shapes;
    Result<std::vector<ClippedPiece>> pieces = clip(shape->contour(), shape->holes(), *above);
    if (!pieces)
        return tl::unexpected(pieces.error());
    for (ClippedPiece &piece : *pieces) {
        // What is dust is not kept.
        if (Result<ShapePointer> made = Shape::make(std::move(piece.outer), std::move(piece.holes)))
            shapes.push_back(std::move(*made));
    }
    return shapes;
}

} // namespace fff
