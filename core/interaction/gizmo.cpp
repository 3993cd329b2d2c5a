#include "core/interaction/gizmo.h"

#include "core/geometry/segment_distance.h"
#include "core/interaction/snapping.h"
#include "core/model/origin.h"
#include "core/operations/moving_model.h"
#include "core/templates/flat_template.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace fff {

namespace {

/// |cosine| between an axis and the line of sight above which its arrow is too short to hold, and
/// below which a ring about it is seen as a line.
constexpr double kOnEnd = 0.97, kRingOnEdge = 0.12;
/// A slit's section that leans by no less than this (sine) has a direction in its guest's plane.
constexpr double kLeans = 1e-3;
/// Where the box for both ways is between those of the axes, of their distance.
constexpr double kDiagonal = 0.72;

/// The plane's axes, or those between them by right angles, as people see them: y is the more
/// upright one, up rather than down, x to the right. The arrows are named so.
Frame asSeen(Frame frame, const Eigen::Quaterniond &orientation)
{
    const Vec3 right = orientation * Vec3::UnitX(), above = orientation * Vec3::UnitY();
    if (std::abs(frame.x.dot(above)) > std::abs(frame.y.dot(above)))
        std::swap(frame.x, frame.y);
    if (frame.y.dot(above) < 0.0)
        frame.y = -frame.y;
    if (frame.x.dot(right) < 0.0)
        frame.x = -frame.x;
    return frame;
}

Frame ownFrame(const Section &section, const Section *host, const Eigen::Quaterniond &orientation)
{
    const Vec3 normal = section.frame.normal();
    Frame frame = canvasGrid(section.frame, orientation);
    if (host) {
        const Vec3 across = host->frame.normal();
        const Vec3 up = across - across.dot(normal) * normal;
        if (up.norm() > kLeans) {
            frame.y = up.normalized();
            frame.x = frame.y.cross(normal);
            frame = asSeen(frame, orientation);
        }
        frame.origin =
            host->frame.toWorld(0.5 * (section.parent->slitFrom + section.parent->slitTo));
        frame.origin -= section.frame.height(frame.origin) * normal;
        return frame;
    }
    frame.origin = section.frame.toWorld(section.shape->bounds().center());
    return frame;
}

} // namespace

int axisOf(GizmoPart part)
{
    switch (part) {
    case GizmoPart::MoveX:
    case GizmoPart::TurnX:
    case GizmoPart::ScaleX:
        return 0;
    case GizmoPart::MoveY:
    case GizmoPart::TurnY:
    case GizmoPart::ScaleY:
        return 1;
    case GizmoPart::MoveZ:
    case GizmoPart::TurnZ:
        return 2;
    case GizmoPart::None:
    case GizmoPart::MoveFree:
    case GizmoPart::ScaleAll:
        break;
    }
    return -1;
}

bool isTurn(GizmoPart part)
{
    return part == GizmoPart::TurnX || part == GizmoPart::TurnY || part == GizmoPart::TurnZ;
}

bool isScale(GizmoPart part)
{
    return part == GizmoPart::ScaleX || part == GizmoPart::ScaleY || part == GizmoPart::ScaleAll;
}

bool Gizmo::has(GizmoPart part) const
{
    return std::find(parts.begin(), parts.end(), part) != parts.end();
}

Gizmo gizmoOf(const Model &model, const std::vector<SectionRef> &sections, bool isInSpace,
              const Eigen::Quaterniond &orientation)
{
    Gizmo gizmo;
    Box3 box;
    std::vector<SectionId> drawn;
    for (const SectionRef &ref : sections) {
        const std::optional<Origin> origin = originOf(model, ref);
        if (!origin)
            return gizmo;
        const Section &shown = *model.find(ref);
        box.extend(worldBounds(*shown.shape, shown.frame));
        if (std::find(drawn.begin(), drawn.end(), origin->section->id) == drawn.end())
            drawn.push_back(origin->section->id);
    }
    if (drawn.empty())
        return gizmo;
    using enum GizmoPart;
    const bool isSingle = sections.size() == 1;
    const Section &first = *model.find(sections.front());
    const Section *host = isSingle ? holderOf(model, first) : nullptr;
    gizmo.isInSpace = isInSpace || !isSingle;
    gizmo.frame = isSingle ? ownFrame(first, host, orientation) : Frame{box.center()};
    gizmo.parts = {MoveX, MoveY, MoveZ, MoveFree, ScaleAll, TurnZ};
    if (gizmo.isInSpace)
        gizmo.frame = {gizmo.frame.origin};
    else
        gizmo.parts.insert(gizmo.parts.end(), {ScaleX, ScaleY});
    // About its holder's normal it turns on that one's face; about the other axis it would tilt.
    const bool isFree = !host || gizmo.isInSpace;
    const auto across = [&](int axis) {
        return std::abs(gizmo.axis(axis).dot(host->frame.normal()));
    };
    if (isFree || across(0) > across(1))
        gizmo.parts.push_back(TurnX);
    if (isFree || across(0) <= across(1))
        gizmo.parts.push_back(TurnY);
    return gizmo;
}

Gizmo gizmoOf(const Model &model, const Template &one, const Eigen::Quaterniond &orientation)
{
    using enum GizmoPart;
    Gizmo gizmo;
    const std::optional<Frame> world = worldFrame(one, model);
    if (!world || !one.isRead())
        return gizmo;
    if (!one.isFlat()) {
        gizmo.isInSpace = true;
        gizmo.frame = {world->origin};
        gizmo.parts = {MoveX, MoveY, MoveZ, MoveFree, ScaleAll, TurnX, TurnY, TurnZ};
        return gizmo;
    }
    gizmo.frame = asSeen(*world, orientation);
    gizmo.parts = {MoveX, MoveY, MoveFree, ScaleAll, TurnZ};
    if (one.on == SectionRef())
        gizmo.parts.push_back(MoveZ);
    return gizmo;
}

GizmoLook::GizmoLook(const Gizmo &gizmo, const Camera &camera, const Vec2 &viewport)
    : m_gizmo(gizmo), m_camera(camera), m_viewport(viewport),
      m_scale(camera.scaleAt(gizmo.frame.origin, viewport)),
      m_centre(camera.toScreen(gizmo.frame.origin, viewport))
{
    const Vec3 eye = camera.towardsEye(gizmo.frame.origin, viewport);
    for (int axis : {0, 1, 2})
        m_facing[static_cast<std::size_t>(axis)] = std::abs(eye.dot(gizmo.axis(axis)));
}

bool GizmoLook::isSeen(GizmoPart part) const
{
    if (!m_gizmo.has(part))
        return false;
    const int axis = axisOf(part);
    if (axis < 0)
        return true;
    const double facing = m_facing[static_cast<std::size_t>(axis)];
    return isTurn(part) ? facing >= kRingOnEdge : facing <= kOnEnd;
}

Vec2 GizmoLook::at(double distance, int axis) const
{
    return m_camera.toScreen(m_gizmo.frame.origin + distance * m_scale * m_gizmo.axis(axis),
                             m_viewport);
}

Vec2 GizmoLook::box(GizmoPart part) const
{
    if (part == GizmoPart::ScaleAll && m_gizmo.isInSpace)
        return m_centre + kDiagonal * kGizmoBox * Vec2(1.0, -1.0);
    if (part == GizmoPart::ScaleAll)
        return m_camera.toScreen(m_gizmo.frame.origin + kDiagonal * kGizmoBox * m_scale *
                                                            (m_gizmo.axis(0) + m_gizmo.axis(1)),
                                 m_viewport);
    return at(kGizmoBox, axisOf(part));
}

std::vector<Vec2> GizmoLook::ring(int axis) const
{
    const Vec3 u = kGizmoRing * m_scale * m_gizmo.axis((axis + 1) % 3);
    const Vec3 v = kGizmoRing * m_scale * m_gizmo.axis((axis + 2) % 3);
    std::vector<Vec2> line;
    for (int i = 0; i < kRingSides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kRingSides;
        line.push_back(m_camera.toScreen(
            m_gizmo.frame.origin + std::cos(angle) * u + std::sin(angle) * v, m_viewport));
    }
    return line;
}

GizmoPart GizmoLook::partAt(const Vec2 &position, double reach) const
{
    using enum GizmoPart;
    GizmoPart best = None;
    double nearest = std::numeric_limits<double>::infinity();
    const auto offer = [&](GizmoPart part, double distance, double within) {
        if (isSeen(part) && distance <= within && distance < nearest) {
            best = part;
            nearest = distance;
        }
    };
    for (const GizmoPart part : {ScaleX, ScaleY, ScaleAll})
        if (m_gizmo.has(part))
            offer(part, (box(part) - position).norm(), reach);
    offer(MoveFree, (m_centre - position).norm(), std::max(reach, kGizmoDisc));
    if (best != None)
        return best;
    const GizmoPart moves[] = {MoveX, MoveY, MoveZ}, turns[] = {TurnX, TurnY, TurnZ};
    for (int axis : {0, 1, 2})
        offer(moves[axis], distanceToSegment(position, m_centre, tip(axis)), reach);
    // An arrow crosses rings: near its tip and its root it is the arrow's.
    for (int axis : {0, 1, 2}) {
        if (!isSeen(turns[axis]))
            continue;
        const std::vector<Vec2> line = ring(axis);
        double distance = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < line.size(); ++i)
            distance = std::min(distance,
                                distanceToSegment(position, line[i], line[(i + 1) % line.size()]));
        offer(turns[axis], distance, reach);
    }
    return best;
}

} // namespace fff
