#include "core/analysis/dropping.h"

#include "core/base/tolerances.h"
#include "core/model/edits.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// Y of the lowest point of the slabs and of their mid-planes, mm; none without sections.
struct Lowest
{
    double slab = 0.0, middle = 0.0;
};

std::optional<Lowest> lowestOf(const Model &model)
{
    std::optional<Lowest> lowest;
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        const Section &section = *model.section(i);
        const double half = 0.5 * model.document.stockOf(section).thickness;
        const double below = half * std::abs(section.frame.normal().y());
        for (const Vec2 &p : section.shape->region().outer) {
            const double y = section.frame.toWorld(p).y();
            lowest = lowest ? Lowest{std::min(lowest->slab, y - below), std::min(lowest->middle, y)}
                            : Lowest{y - below, y};
        }
    }
    return lowest;
}

} // namespace

std::optional<double> lowestPoint(const Model &model)
{
    const std::optional<Lowest> lowest = lowestOf(model);
    return lowest ? std::optional(lowest->slab) : std::nullopt;
}

std::optional<Document> droppedToGround(const Model &model)
{
    const std::optional<Lowest> lowest = lowestOf(model);
    if (!lowest || (lowest->slab <= kGroundContact && lowest->middle >= -kGroundSunk))
        return {};
    return moveAll(model.document, Vec3(0.0, -lowest->slab, 0.0));
}

} // namespace fff
