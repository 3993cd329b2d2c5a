#include "core/fabrication/summary.h"

namespace fff {

Box3 slabBounds(const Section &section, const Stock &stock)
{
    Box3 box;
    for (const Vec2 &p : section.shape->region().outer)
        box.extend(section.frame.toWorld(p));
    const Vec3 reach = 0.5 * stock.thickness * section.frame.normal().cwiseAbs();
    box.min -= reach;
    box.max += reach;
    return box;
}

Box3 slabBounds(const Model &model)
{
    Box3 box;
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        box.extend(slabBounds(*model.section(i), model.stockOf(i)));
    return box;
}

} // namespace fff
