#include "core/model/section.h"

namespace fff {

bool Section::operator==(const Section &other) const
{
    return id == other.id && name == other.name && parent == other.parent && frame == other.frame &&
           stock == other.stock && (shape == other.shape || *shape == *other.shape);
}

Box3 worldBounds(const Shape &shape, const Frame &frame)
{
    // The box of the four corners: looser than that of every vertex, and free of their number.
    const Box2 &b = shape.bounds();
    Box3 box;
    for (const Vec2 &corner :
         {b.min, b.max, Vec2(b.min.x(), b.max.y()), Vec2(b.max.x(), b.min.y())})
        box.extend(frame.toWorld(corner));
    return box;
}

} // namespace fff
