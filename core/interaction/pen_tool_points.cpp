// Where the pen's points go: by numbers, by what is near the cursor.
#include "core/base/tolerances.h"
#include "core/interaction/pen_tool.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// Points and handles are taken hold of within this, px.
constexpr double kPointReach = 8.0;

} // namespace

// Numbers.

std::vector<ToolNumber> PenTool::numbers() const
{
    using Kind = ToolNumber::Kind;
    std::vector<ToolNumber> numbers;
    if (!m_canvas)
        return numbers;
    if (m_canvas->choice.distance && m_path.isEmpty())
        numbers.push_back({Kind::Distance, *m_canvas->choice.distance});
    const Vec2 at = m_canvas->targets.toGrid(nextPoint());
    numbers.push_back({Kind::X, at.x()});
    numbers.push_back({Kind::Y, at.y()});
    if (!m_path.isEmpty()) {
        const Vec2 way = at - m_canvas->targets.toGrid(m_path.points().back().at);
        numbers.push_back({Kind::Length, way.norm()});
        numbers.push_back({Kind::Angle, way.isZero() ? 0.0 : std::atan2(way.y(), way.x())});
    }
    return numbers;
}

/// By numbers, where the cursor is, or where the path ends.
Vec2 PenTool::nextPoint() const
{
    if (m_typed)
        return *m_typed;
    if (m_snap)
        return m_snap->point;
    return m_path.isEmpty() ? m_canvas->targets.fromGrid(Vec2::Zero()) : m_path.points().back().at;
}

GestureReply PenTool::setNumbers(const std::vector<ToolNumber> &numbers, GestureContext &context)
{
    using Kind = ToolNumber::Kind;
    if (!m_canvas)
        return {};
    const SnapTargets &targets = m_canvas->targets;
    Vec2 at = targets.toGrid(nextPoint());
    const Vec2 last =
        m_path.isEmpty() ? Vec2(Vec2::Zero()) : targets.toGrid(m_path.points().back().at);
    for (const ToolNumber &number : numbers) {
        const Vec2 way = at - last;
        const double value = std::clamp(number.value, -kMaxCoordinate, kMaxCoordinate);
        switch (number.kind) {
        case Kind::X:
            at.x() = value;
            break;
        case Kind::Y:
            at.y() = value;
            break;
        case Kind::DeltaX:
            at.x() = last.x() + value;
            break;
        case Kind::DeltaY:
            at.y() = last.y() + value;
            break;
        case Kind::Length:
            at = last + value * (way.isZero() ? Vec2(Vec2::UnitX()) : way.normalized());
            break;
        case Kind::Angle:
            at = last + way.norm() * Vec2(std::cos(value), std::sin(value));
            break;
        case Kind::Distance:
            if (m_canvas->choice.distance && m_path.isEmpty()) {
                moveToDistance(m_canvas->choice, value);
                setCanvas(m_canvas->choice, false, context);
            }
            return shown();
        default: // those of other tools
            break;
        }
    }
    m_typed = targets.fromGrid(at);
    return shown();
}

GestureReply PenTool::dropNumbers(GestureContext &)
{
    m_typed.reset();
    return shown();
}

// The path and what is near it.

void PenTool::forgetPath()
{
    m_path = {};
    m_closed = {};
    m_drawn.reset();
    m_lastPress.reset();
    m_typed.reset();
    m_place = {};
    if (m_press)
        m_press->isOver = true;
}

void PenTool::pathChanged(const GestureContext &context)
{
    m_closed = closedPath(m_path.points());
    m_drawn.reset();
    if (m_closed.contour)
        m_drawn = drawContour(context.model.document, m_canvas->choice.target, *m_closed.contour,
                              {context.settings.cutsAtGround, context.settings.naming});
}

GestureReply PenTool::shown() const
{
    GestureReply reply;
    if (m_drawn && *m_drawn)
        reply.preview = (*m_drawn)->document;
    return reply;
}

std::optional<Vec2> PenTool::pointUnder(const Vec2 &position, const GestureContext &context) const
{
    return pointOnPlane(context.camera, context.viewport, m_canvas->choice.target.canvas, position);
}

double PenTool::scaleAt(const Vec2 &point, const GestureContext &context) const
{
    return context.camera.scaleAt(m_canvas->choice.target.canvas.toWorld(point), context.viewport);
}

PenTool::Place PenTool::placeAt(const Vec2 &position, const GestureContext &context) const
{
    const Frame &canvas = m_canvas->choice.target.canvas;
    const auto distance = [&](const Vec2 &point) {
        return (context.camera.toScreen(canvas.toWorld(point), context.viewport) - position).norm();
    };
    Place best;
    double least = kPointReach;
    const auto offer = [&](const Vec2 &point, const Place &place) {
        if (const double away = distance(point); away <= least) {
            best = place;
            least = away;
        }
    };
    const std::vector<PathPoint> &points = m_path.points();
    for (std::size_t i = 0; i < points.size(); ++i)
        offer(points[i].at, {Place::Kind::Point, i, PenPath::End::Out});
    if (best.kind == Place::Kind::Point)
        return best; // before handles that lie as near
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].out)
            offer(points[i].at + *points[i].out, {Place::Kind::Handle, i, PenPath::End::Out});
        if (points[i].in)
            offer(points[i].at + *points[i].in, {Place::Kind::Handle, i, PenPath::End::In});
    }
    return best;
}

/// The point that directions are held from: the one before.
std::optional<Vec2> PenTool::pointBefore(std::optional<std::size_t> moved) const
{
    const std::size_t count = m_path.size(), next = moved.value_or(count);
    if (next > 0)
        return m_path.points()[next - 1].at;
    return count > 1 ? std::optional(m_path.points()[1].at) : std::nullopt;
}

/// moved: the point that is there already; none: the next one.
Snap PenTool::snapTo(const Vec2 &point, std::optional<std::size_t> moved,
                     const GestureContext &context) const
{
    const bool snaps = context.settings.snaps && !m_event.modifiers.control;
    const std::optional<Vec2> from = pointBefore(moved);
    const double scale = scaleAt(point, context);
    SnapTargets targets = m_canvas->targets;
    const std::vector<PathPoint> &points = m_path.points();
    if (!moved && !points.empty())
        targets.alignWith(points.front().at);
    if (moved && *moved + 1 < points.size())
        targets.alignWith(points[*moved + 1].at);
    if (from && !(points.size() == 1 && !moved))
        targets.alignWith(*from);
    if (m_event.modifiers.shift && from)
        return held(point, *from, targets, scale, snaps);
    if (!snaps)
        return {Snap::Kind::None, point, {}, false};
    return snapped(point, targets, scale, m_snap.value_or(Snap()));
}

} // namespace fff
