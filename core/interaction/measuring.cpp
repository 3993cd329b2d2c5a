#include "core/interaction/measuring.h"

#include "core/geometry/contour_points.h"
#include "core/interaction/pick.h"

#include <algorithm>

namespace fff {

namespace {

/// The nearest point so far, as seen.
class Nearest
{
public:
    Nearest(const Vec2 &position, const GestureContext &context)
        : m_position(position), m_context(context)
    {
    }

    void offer(const Vec3 &point, const Section &section)
    {
        const double away =
            (m_context.camera.toScreen(point, m_context.viewport) - m_position).norm();
        const double depth = m_context.camera.backward().dot(point);
        // Of those that are as near, the one before.
        const bool isBetter = away < m_away - kTie || (away <= m_away + kTie && depth > m_depth);
        if (away > kMeasureReach || !isBetter)
            return;
        m_away = std::min(away, m_away);
        m_depth = depth;
        m_found = MeasuredPlace{point, anchorOn(&section, point)};
    }
    const std::optional<MeasuredPlace> &found() const { return m_found; }

private:
    static constexpr double kTie = 0.5; // px

    Vec2 m_position;
    const GestureContext &m_context;
    std::optional<MeasuredPlace> m_found;
    double m_away = kMeasureReach, m_depth = -1e30;
};

template <class Visit>
void eachBoundary(const Section &section, Visit visit)
{
    visit(section.shape->contour());
    for (const Contour &hole : section.shape->holes())
        visit(hole);
}

void offerPoints(const Section &section, Nearest &nearest)
{
    eachBoundary(section, [&](const Contour &contour) {
        for (int i = 0; i < contour.segmentCount(); ++i)
            nearest.offer(section.frame.toWorld(anchor(contour, i)), section);
    });
}

bool isNear(const Section &section, const Vec2 &position, const GestureContext &context)
{
    const Box3 box = worldBounds(*section.shape, section.frame);
    Box2 seen;
    for (int corner = 0; corner < 8; ++corner)
        seen.extend(context.camera.toScreen({(corner & 1) != 0 ? box.max.x() : box.min.x(),
                                             (corner & 2) != 0 ? box.max.y() : box.min.y(),
                                             (corner & 4) != 0 ? box.max.z() : box.min.z()},
                                            context.viewport));
    const Vec2 reach = Vec2::Constant(kMeasureReach);
    return ((seen.min - reach).array() <= position.array()).all() &&
           ((seen.max + reach).array() >= position.array()).all();
}

} // namespace

std::optional<MeasuredPlace> measuredPlaceAt(const Vec2 &position, bool snaps,
                                             const GestureContext &context)
{
    const Model &model = context.model;
    std::vector<const Section *> near;
    for (std::size_t i = 0; snaps && i < model.sectionCount(); ++i) {
        const Section &section = *model.section(i);
        if (!context.view.isHidden(section.ref()) && !context.view.isGhost(section.ref()) &&
            isNear(section, position, context))
            near.push_back(&section);
    }
    Nearest points(position, context);
    for (const Section *section : near)
        offerPoints(*section, points);
    if (points.found())
        return points.found();
    Nearest places(position, context);
    for (const Section *section : near)
        if (const std::optional<Vec2> at =
                pointOnPlane(context.camera, context.viewport, section->frame, position))
            eachBoundary(*section, [&](const Contour &contour) {
                places.offer(section->frame.toWorld(nearestPlace(contour, *at).position), *section);
            });
    if (places.found())
        return places.found();
    const Ray ray = context.camera.rayThrough(position, context.viewport);
    const std::vector<Hit> hits = pick(model, ray, context.view);
    if (!hits.empty()) {
        const Section &section = *model.section(static_cast<std::size_t>(hits.front().section));
        return MeasuredPlace{hits.front().point, anchorOn(&section, hits.front().point)};
    }
    const Frame ground{Vec3::Zero(), Vec3::UnitX(), -Vec3::UnitZ()};
    const Frame facing{Vec3::Zero(), context.camera.right(), context.camera.up()};
    for (const Frame &plane : {ground, facing})
        if (const std::optional<Vec2> at =
                pointOnPlane(context.camera, context.viewport, plane, position)) {
            const Vec3 point = plane.toWorld(*at);
            return MeasuredPlace{point, anchorOn(nullptr, point)};
        }
    return std::nullopt;
}

DimensionId dimensionAt(const Vec2 &position, const GestureContext &context)
{
    DimensionId found;
    double least = kMeasureReach;
    for (const Dimension &dimension : context.model.document.dimensions) {
        const auto from = placeOf(context.model, dimension.from);
        const auto to = placeOf(context.model, dimension.to);
        if (!from || !to)
            continue;
        const Vec2 a = context.camera.toScreen(*from, context.viewport);
        const Vec2 way = context.camera.toScreen(*to, context.viewport) - a;
        const double length2 = way.squaredNorm();
        const double along =
            length2 > 0.0 ? std::clamp(way.dot(position - a) / length2, 0.0, 1.0) : 0.0;
        const double away = (a + along * way - position).norm();
        if (away >= least)
            continue;
        least = away;
        found = dimension.id;
    }
    return found;
}

} // namespace fff
