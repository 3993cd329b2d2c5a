#include "core/interaction/view_fit.h"

#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/interaction/view_cube.h"
#include "core/templates/flat_template.h"
#include "core/templates/template_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fff {

namespace {

/// Part of the view that stays free at each side.
constexpr double kFitMargin = 0.08;
/// Between what stands over the view and the model, px.
constexpr double kBesideCover = 8.0;
/// Of the view at least, whatever stands over it.
constexpr double kLeastRoom = 0.3;
/// What is smaller is shown as if it had this size, mm: a point needs some scale.
constexpr double kSmallestFit = 1.0;
/// Width and depth of what an empty document shows, mm.
constexpr double kEmptyView = 200.0;

/// Ground of 20 cm with the middle of the first plane in its middle.
Box3 emptyBox()
{
    Box3 box;
    box.extend(Vec3(-0.5 * kEmptyView, 0.0, -0.5 * kEmptyView));
    box.extend(Vec3(0.5 * kEmptyView, 2.0 * kFirstPlaneHeight, 0.5 * kEmptyView));
    return box;
}

std::array<Vec3, 8> cornersOf(const Box3 &box)
{
    std::array<Vec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = {(i & 1U) != 0 ? box.max.x() : box.min.x(),
                      (i & 2U) != 0 ? box.max.y() : box.min.y(),
                      (i & 4U) != 0 ? box.max.z() : box.min.z()};
    return corners;
}

void addOutline(const Model &model, std::size_t index, std::vector<Vec3> &points)
{
    const Section &section = *model.section(index);
    const Vec3 half = 0.5 * model.stockOf(index).thickness * section.frame.normal();
    for (const Vec2 &p : section.shape->region().outer) {
        const Vec3 middle = section.frame.toWorld(p);
        points.push_back(middle + half);
        points.push_back(middle - half);
    }
}

/// By the corners that are drawn in motion: as many as an outline needs.
void addOutline(const Template &one, std::vector<Vec3> &points)
{
    const Similarity placement = one.placement();
    const MeshSurface &surface =
        one.mesh->coarse.corners.empty() ? one.mesh->surface : one.mesh->coarse;
    for (const MeshSurface::Corner &corner : surface.corners)
        points.push_back(placement({corner.position[0], corner.position[1], corner.position[2]}));
}

/// Along one direction of the screen, at a pixel's length of 1 in the camera's plane: how far the
/// points reach to its two sides, as the room's sides would have to be seen from the eye.
struct Reach
{
    double ahead = 0.0, back = 0.0; // mm, of p + tan · depth over all points, to either side
    double tanAhead = 0.0, tanBack = 0.0;

    /// From the eye to the depth that points are measured from, mm: so far that all are inside.
    double eye() const { return (ahead + back) / (tanAhead + tanBack); }
    /// The eye's place along the direction, when it stands at that depth: in the middle of those
    /// from which all points are inside.
    double place(double depth) const
    {
        return 0.5 * ((ahead - tanAhead * depth) + (tanBack * depth - back));
    }
};

/// What is seen at a place of the screen, px.
bool isAnyIn(const Box2 &box, std::span<const Vec3> points, const Camera &camera,
             const Vec2 &viewport)
{
    return std::any_of(points.begin(), points.end(), [&](const Vec3 &p) {
        const Vec2 at = camera.toScreen(p, viewport);
        return (at - box.min).minCoeff() > 0.0 && (box.max - at).minCoeff() > 0.0;
    });
}

/// Wider at the sides where something of the points would be under what stands upright there.
ViewMargins besideUpright(const Camera &camera, std::span<const Vec3> points, const Vec2 &viewport,
                          const ViewMargins &margins)
{
    ViewMargins clear = margins;
    for (const Box2 &box : margins.upright) {
        const bool isRight = box.center().x() > 0.5 * viewport.x();
        const double taken = kBesideCover + (isRight ? viewport.x() - box.min.x() : box.max.x());
        if (taken > (isRight ? clear.right : clear.left) &&
            taken + (isRight ? clear.left : clear.right) <= (1.0 - kLeastRoom) * viewport.x() &&
            isAnyIn(box, points, fitted(camera, points, viewport, clear), viewport))
            (isRight ? clear.right : clear.left) = taken;
    }
    return clear;
}

} // namespace

ViewMargins fitMargins(const Vec2 &viewport, std::span<const Box2> covered)
{
    const Vec2 free = kFitMargin * viewport;
    ViewMargins margins{free.x(), free.y(), free.x(), free.y(), {}};
    for (const Box2 &box : covered) {
        if (box.size().x() < box.size().y())
            margins.upright.push_back(box);
        else if (box.max.y() < 0.5 * viewport.y())
            margins.top = std::max(margins.top, box.max.y() + kBesideCover);
        else if (box.min.y() > 0.5 * viewport.y())
            margins.bottom = std::max(margins.bottom, viewport.y() - box.min.y() + kBesideCover);
    }
    const double most = (1.0 - kLeastRoom) * viewport.y();
    if (const double taken = margins.top + margins.bottom; taken > most) {
        margins.top *= most / taken;
        margins.bottom *= most / taken;
    }
    return margins;
}

ViewMargins withRoomAround(const ViewMargins &margins, const Vec2 &viewport, double share)
{
    const double rest = 0.5 * (1.0 - share);
    const double x = rest * std::max(0.0, viewport.x() - margins.left - margins.right);
    const double y = rest * std::max(0.0, viewport.y() - margins.top - margins.bottom);
    return {margins.left + x, margins.top + y, margins.right + x, margins.bottom + y,
            margins.upright};
}

std::vector<Vec3> outlinePoints(const Model &model, const ViewState &view)
{
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        if (!view.isHidden(model.ref(i)))
            addOutline(model, i, points);
    for (const TemplatePointer &one : model.document.templates)
        if (!one->isHidden && one->mesh) {
            addOutline(*one, points);
        } else if (const auto placement = worldPlacement(*one, model);
                   !one->isHidden && one->isRead() && placement) {
            const auto corners = cornersOf(*one, *placement);
            points.insert(points.end(), corners.begin(), corners.end());
        }
    return points;
}

std::vector<Vec3> outlinePoints(const Model &model, const std::vector<SectionRef> &sections)
{
    std::vector<Vec3> points;
    for (const SectionRef &ref : sections)
        if (const int index = model.indexOf(ref); index >= 0)
            addOutline(model, static_cast<std::size_t>(index), points);
    return points;
}

Camera fitted(const Camera &camera, std::span<const Vec3> points, const Vec2 &viewport,
              const ViewMargins &margins)
{
    if (points.empty()) {
        const std::array<Vec3, 8> corners = cornersOf(emptyBox());
        return fitted(camera, corners, viewport, margins);
    }
    const Vec2 size = viewport.cwiseMax(1.0);
    const Vec3 axes[] = {camera.right(), camera.up(), camera.backward()};
    Box3 seen; // in the camera's axes
    for (const Vec3 &p : points)
        seen.extend(Vec3(axes[0].dot(p), axes[1].dot(p), axes[2].dot(p)));
    const Vec3 middle = seen.center();

    // The room's sides from the view's middle, px: ahead is right and up.
    const Vec2 ahead = (0.5 * size - Vec2(margins.right, margins.top)).cwiseMax(1.0);
    const Vec2 back = (0.5 * size - Vec2(margins.left, margins.bottom)).cwiseMax(1.0);
    const double least = kSmallestFit / (ahead + back).minCoeff();
    Camera result = camera;
    Vec3 target = middle;
    if (!camera.isPerspective()) {
        const Vec2 scales = seen.size().head<2>().cwiseQuotient(ahead + back);
        const double scale =
            std::clamp(std::max(scales.maxCoeff(), least), kFinestScale, kCoarsestScale);
        target.head<2>() -= 0.5 * scale * (ahead - back);
        result.millimetresPerPixel = scale;
    } else {
        // All points are inside when each of the room's sides, a plane through the eye, has them on
        // its inner side: the eye's nearest depth from which both of a pair of sides do, and then
        // its place between them.
        const double perTan = 0.5 * size.y() / std::tan(0.5 * kFieldOfView); // px
        Reach reach[2];
        for (const int axis : {0, 1}) {
            Reach &of = reach[axis];
            of.tanAhead = ahead[axis] / perTan;
            of.tanBack = back[axis] / perTan;
            of.ahead = of.back = -std::numeric_limits<double>::infinity();
        }
        for (const Vec3 &p : points) {
            const double near = axes[2].dot(p) - middle.z();
            for (const int axis : {0, 1}) {
                const double off = axes[axis].dot(p) - middle[axis];
                Reach &of = reach[axis];
                of.ahead = std::max(of.ahead, off + of.tanAhead * near);
                of.back = std::max(of.back, of.tanBack * near - off);
            }
        }
        const double eye = std::clamp(std::max({reach[0].eye(), reach[1].eye(), least * perTan}),
                                      kFinestScale * perTan, kCoarsestScale * perTan);
        result.millimetresPerPixel = eye / perTan;
        target.x() += reach[0].place(eye);
        target.y() += reach[1].place(eye);
    }
    result.target = target.x() * axes[0] + target.y() * axes[1] + target.z() * axes[2];
    return result;
}

Camera fittedClear(const Camera &camera, std::span<const Vec3> points, const Vec2 &viewport,
                   const ViewMargins &margins)
{
    const ViewMargins clear = besideUpright(camera, points, viewport, margins);
    const Camera whole = fitted(camera, points, viewport, clear);
    const std::optional<Vec2> cube = cubeCentre(viewport);
    const Vec2 half = Vec2::Constant(0.5 * kCubeRoom);
    if (!cube || !isAnyIn({*cube - half, *cube + half}, points, whole, viewport))
        return whole;
    ViewMargins beside = clear, below = clear;
    beside.right = std::max(beside.right, viewport.x() - cube->x() + half.x());
    below.top = std::max(below.top, cube->y() + half.y());
    const Camera a = fitted(camera, points, viewport, beside),
                 b = fitted(camera, points, viewport, below);
    return a.millimetresPerPixel <= b.millimetresPerPixel ? a : b;
}

Camera fitted(const Camera &camera, const Box3 &box, const Vec2 &viewport)
{
    const std::array<Vec3, 8> corners = cornersOf(box.isEmpty() ? emptyBox() : box);
    return fitted(camera, corners, viewport, fitMargins(viewport, {}));
}

} // namespace fff
