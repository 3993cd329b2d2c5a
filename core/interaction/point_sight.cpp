#include "core/interaction/point_sight.h"

#include "core/base/tolerances.h"
#include "core/model/origin.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace fff {

namespace {

/// px. The line's is less, or strokes could hardly begin on a small section.
constexpr double kReach = 10.0, kLineReach = 6.0;
/// Nothing is seen so far off, px: in perspective a place beside the eye.
constexpr double kFarOff = 1e6;
/// A handle this near to its anchor cannot be told from it, px.
constexpr double kSeparate = 6.0;

bool isSeenOnEdge(const Frame &frame, const Vec2 &middle, const Sight &sight)
{
    const Vec3 towards = sight.camera.towardsEye(frame.toWorld(middle), sight.viewport);
    return std::abs(towards.dot(frame.normal())) < std::sin(kMinDrawAngle);
}

/// The contour's or a hole's place nearest to the cursor.
std::optional<PointTarget> lineAt(const Sight &sight, int index, const Section &section,
                                  const Vec2 &position)
{
    const auto local = placeOnPlane(section.frame, sight.camera, sight.viewport, position);
    if (!local)
        return std::nullopt;
    PointTarget target;
    target.kind = PointTarget::Kind::Line;
    double nearest = std::numeric_limits<double>::infinity();
    for (int b = 0; b < boundaryCount(*section.shape); ++b) {
        const NearestPlace place = nearestPlace(boundary(*section.shape, b), *local);
        if (place.distance < nearest) {
            nearest = place.distance;
            target.point = {b, place.at.segment};
            target.t = place.at.t;
            target.place = place.position;
        }
    }
    const Vec3 world = section.frame.toWorld(target.place);
    if ((sight.camera.toScreen(world, sight.viewport) - position).norm() > kLineReach)
        return std::nullopt;
    const std::vector<Hit> hits = sight.hitsAt(position);
    if (hits.empty() || hits.front().section == index)
        return target;
    const Ray ray = sight.camera.rayThrough(position, sight.viewport);
    const double distance = (world - ray.origin).dot(ray.direction);
    return hits.front().distance < distance ? std::nullopt : std::optional(target);
}

} // namespace

std::optional<SectionRef> sectionWithPoints(const Sight &sight, const Selection &selection)
{
    if (selection.sections().size() != 1)
        return std::nullopt;
    const SectionRef &ref = selection.sections().front();
    if (!sight.view.isPicked(ref))
        return std::nullopt;
    const SectionPointer section = editedSection(sight.model, ref);
    if (!section || isSeenOnEdge(section->frame, section->shape->bounds().center(), sight))
        return std::nullopt;
    return ref;
}

std::vector<PointAddress> shownPoints(const Section &section,
                                      const std::vector<PointAddress> &selected,
                                      const Camera &camera, const Vec2 &viewport)
{
    const Shape &shape = *section.shape;
    std::vector<PointAddress> corners, others;
    for (int b = 0; b < boundaryCount(shape); ++b) {
        const Contour &contour = boundary(shape, b);
        for (int i = 0; i < contour.segmentCount(); ++i)
            (kindOf(contour, i) == PointKind::Corner ? corners : others).push_back({b, i});
    }
    // In cells as wide as points are apart, each looks at the few around it.
    std::map<std::pair<int, int>, std::vector<Vec2>> taken;
    const auto cellOf = [](const Vec2 &p) {
        return std::pair(static_cast<int>(std::floor(p.x() / kPointsApart)),
                         static_cast<int>(std::floor(p.y() / kPointsApart)));
    };
    const auto isFree = [&](const Vec2 &p) {
        const auto [x, y] = cellOf(p);
        for (int dx = -1; dx <= 1; ++dx)
            for (int dy = -1; dy <= 1; ++dy)
                if (const auto cell = taken.find({x + dx, y + dy}); cell != taken.end())
                    for (const Vec2 &other : cell->second)
                        if ((other - p).norm() < kPointsApart)
                            return false;
        return true;
    };
    std::vector<PointAddress> shown;
    const auto offer = [&](const PointAddress &point, bool always) {
        const Vec2 place = anchor(boundary(shape, point.boundary), point.index);
        const Vec2 at = camera.toScreen(section.frame.toWorld(place), viewport);
        if (!(at.cwiseAbs().maxCoeff() < kFarOff) || (!always && !isFree(at)))
            return;
        taken[cellOf(at)].push_back(at);
        shown.push_back(point);
    };
    for (const PointAddress &point : selected)
        if (isPoint(shape, point))
            offer(point, true);
    for (const std::vector<PointAddress> *points : {&corners, &others})
        for (const PointAddress &point : *points)
            if (std::find(selected.begin(), selected.end(), point) == selected.end())
                offer(point, false);
    std::sort(shown.begin(), shown.end());
    return shown;
}

std::optional<PointTarget> pointTargetAt(const Sight &sight, const SectionRef &ref,
                                         const PointSelection &selected, const Vec2 &position)
{
    const SectionPointer edited = editedSection(sight.model, ref);
    if (!edited)
        return std::nullopt;
    const Section &section = *edited;
    const Shape &shape = *section.shape;
    const auto screen = [&](const Vec2 &p) {
        return sight.camera.toScreen(section.frame.toWorld(p), sight.viewport);
    };
    std::optional<PointTarget> best;
    double nearest = kReach;
    const bool isOfSelected = selected.section() == section.id;
    for (const PointAddress &address :
         shownPoints(section, isOfSelected ? selected.points() : std::vector<PointAddress>(),
                     sight.camera, sight.viewport)) {
        const Vec2 place = anchor(boundary(shape, address.boundary), address.index);
        if (const double d = (screen(place) - position).norm(); d <= nearest) {
            nearest = d;
            best = PointTarget{PointTarget::Kind::Anchor, address, HandleSide::In, 0.0, place};
        }
    }
    if (isOfSelected) {
        for (const PointAddress &point : selected.points()) {
            if (!isPoint(shape, point))
                continue;
            const Contour &contour = boundary(shape, point.boundary);
            for (const HandleSide side : {HandleSide::In, HandleSide::Out}) {
                const Vec2 place = handle(contour, point.index, side);
                const Vec2 at = screen(place);
                const double d = (at - position).norm();
                if (d <= nearest &&
                    (at - screen(anchor(contour, point.index))).norm() > kSeparate) {
                    nearest = d;
                    best = PointTarget{PointTarget::Kind::Handle, point, side, 0.0, place};
                }
            }
        }
    }
    return best ? best : lineAt(sight, sight.model.indexOf(ref), section, position);
}

std::optional<Vec2> placeOnPlane(const Frame &frame, const Camera &camera, const Vec2 &viewport,
                                 const Vec2 &position)
{
    const Ray ray = camera.rayThrough(position, viewport);
    const double slope = frame.normal().dot(ray.direction);
    if (std::abs(slope) < std::sin(kMinDrawAngle) * ray.direction.norm())
        return std::nullopt;
    const double along = -frame.height(ray.origin) / slope;
    return frame.toLocal(ray.origin + along * ray.direction);
}

} // namespace fff
