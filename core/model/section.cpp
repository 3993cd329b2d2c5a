#include "core/model/section.h"

#include "core/model/instance_key.h"

#include <algorithm>

namespace fff {

std::strong_ordering SectionRef::operator<=>(const SectionRef &other) const
{
    if (drawn.isValid() != other.drawn.isValid())
        return drawn.isValid() ? std::strong_ordering::less : std::strong_ordering::greater;
    if (const auto order = drawn <=> other.drawn; order != 0)
        return order;
    if (const auto order = operation <=> other.operation; order != 0)
        return order;
    if (key == other.key)
        return std::strong_ordering::equal;
    return isKeyBefore(key, other.key) ? std::strong_ordering::less : std::strong_ordering::greater;
}

bool Section::operator==(const Section &other) const
{
    return id == other.id && made == other.made && name == other.name && parent == other.parent &&
           frame == other.frame && stock == other.stock && isLocked == other.isLocked &&
           figures == other.figures && symmetry == other.symmetry && copyOf == other.copyOf &&
           std::equal(
               marks.begin(), marks.end(), other.marks.begin(), other.marks.end(),
               [](const MarkPointer &a, const MarkPointer &b) { return a == b || *a == *b; }) &&
           (shape == other.shape || *shape == *other.shape);
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
