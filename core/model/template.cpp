#include "core/model/template.h"

#include <algorithm>

namespace fff {

Similarity Template::placement() const
{
    Similarity placement = placementOf(frame);
    placement.scale = scale;
    if (isFlipped)
        placement.turn.col(0) *= -1.0;
    return placement;
}

void settleMagnets(Template &one)
{
    std::stable_sort(one.magnets.begin(), one.magnets.end(),
                     [](const Magnet &a, const Magnet &b) { return a.section < b.section; });
    const auto last =
        std::unique(one.magnets.begin(), one.magnets.end(),
                    [](const Magnet &a, const Magnet &b) { return a.section == b.section; });
    one.magnets.erase(last, one.magnets.end());
}

bool Template::operator==(const Template &other) const
{
    return id == other.id && kind == other.kind && name == other.name && blob == other.blob &&
           file == other.file && frame == other.frame && on == other.on && scale == other.scale &&
           isFlipped == other.isFlipped && opacity == other.opacity && isHidden == other.isHidden &&
           isLocked == other.isLocked && magnets == other.magnets;
}

} // namespace fff
