#include "core/analysis/dropping.h"

#include "core/model/edits.h"

#include <cmath>

namespace fff {

namespace {

/// What stands this near to the ground needs no dropping, mm.
constexpr double kDropped = 1e-6;

} // namespace

std::optional<double> lowestPoint(const Model &model)
{
    std::optional<double> lowest;
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        const Section &section = *model.section(i);
        const double half = 0.5 * model.document.stockOf(section).thickness;
        const double below = half * std::abs(section.frame.normal().y());
        for (const Vec2 &p : section.shape->region().outer) {
            const double y = section.frame.toWorld(p).y() - below;
            if (!lowest || y < *lowest)
                lowest = y;
        }
    }
    return lowest;
}

std::optional<Document> droppedToGround(const Model &model)
{
    const std::optional<double> lowest = lowestPoint(model);
    if (!lowest || std::abs(*lowest) <= kDropped)
        return {};
    return moveAll(model.document, Vec3(0.0, -*lowest, 0.0));
}

} // namespace fff
