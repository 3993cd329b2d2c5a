#include "core/assembly/joint.h"

namespace fff {

Polygon Slit::outline() const
{
    const Vec2 half = 0.5 * width * perpendicular((mouth - inner).normalized());
    return {inner - half, mouth - half, mouth + half, inner + half};
}

bool Slit::operator==(const Slit &other) const
{
    return inner == other.inner && mouth == other.mouth && width == other.width &&
           isOpen == other.isOpen && joint == other.joint && overlap == other.overlap &&
           guest == other.guest;
}

} // namespace fff
