#include "core/fabrication/summary.h"

namespace fff {

namespace {
constexpr double kCubicMillimetres = 1e-9; // m³
} // namespace

MassProperties &MassProperties::operator+=(const MassProperties &other)
{
    const double sum = mass + other.mass;
    if (sum > 0.0)
        centre = (mass * centre + other.mass * other.centre) / sum;
    mass = sum;
    return *this;
}

MassProperties massOf(const Section &section, const Stock &stock, const CutSection &cut)
{
    const Moments &total = cut.moments();
    if (!(total.area > 0.0))
        return {};
    return {total.area * stock.thickness * kCubicMillimetres * stock.density,
            section.frame.toWorld(total.centroid())};
}

MassProperties massOf(const Model &model, const std::vector<CutSectionPointer> &cuts)
{
    MassProperties sum;
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        sum += massOf(*model.section(i), model.stockOf(i), *cuts[i]);
    return sum;
}

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
