#include "core/interaction/slit_guides.h"

#include "core/base/tolerances.h"
#include "core/geometry/directions.h"
#include "core/interaction/snapping.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fff {

namespace {

/// Pieces of a curve in each of which the way from a point to it is square to it once at most.
constexpr int kPieces = 16;
/// Halvings that find where: down to the last bit.
constexpr int kHalvings = 60;
/// Of the slit's length, how far along the contour a guide may move its end: one that leaves almost
/// along the edge would end up somewhere else.
constexpr double kFarthest = 0.25;
/// Radians: an edge that a hand drew is off level or upright by so much without meaning it.
constexpr double kOfWorld = 0.035;
/// Of the slit's length, from which on what was drawn of it in the section says where it goes.
constexpr double kSure = 0.5;
/// How far a guide is seen beyond the slit, px.
constexpr double kBeyond = 60.0;

/// Places of the curve to which the way from a point is square to the curve.
void addFeet(const CubicBezier &curve, const Vec2 &from, std::vector<Vec2> &feet)
{
    const auto along = [&](double t) { return curve.derivative(t).dot(curve.at(t) - from); };
    for (int i = 0; i < kPieces; ++i) {
        double t0 = static_cast<double>(i) / kPieces, t1 = static_cast<double>(i + 1) / kPieces;
        const bool isBefore = along(t0) < 0.0;
        if (isBefore == (along(t1) < 0.0))
            continue;
        for (int k = 0; k < kHalvings; ++k) {
            const double middle = 0.5 * (t0 + t1);
            ((along(middle) < 0.0) == isBefore ? t0 : t1) = middle;
        }
        feet.push_back(curve.at(0.5 * (t0 + t1)));
    }
}

} // namespace

SlitGuides::SlitGuides(const Model &model, SectionPointer section, const Vec2 &from,
                       const Eigen::Quaterniond &orientation)
    : m_section(std::move(section)), m_from(from)
{
    const Frame grid = canvasGrid(m_section->frame, orientation);
    const Vec2 level = m_section->frame.directionToLocal(grid.x).normalized();
    const Vec2 upright = m_section->frame.directionToLocal(grid.y).normalized();
    for (const double sign : {1.0, -1.0}) {
        m_directions.push_back({SlitGuide::Kind::Level, sign * level});
        m_directions.push_back({SlitGuide::Kind::Upright, sign * upright});
    }
    addRightAngles();
    addLastSlit(model);
}

void SlitGuides::addRightAngles()
{
    std::vector<Vec2> feet;
    const auto addBoundary = [&](const Contour &contour) {
        for (int i = 0; i < contour.segmentCount(); ++i)
            addFeet(contour.segment(i), m_from, feet);
    };
    addBoundary(m_section->shape->contour());
    for (const Contour &hole : m_section->shape->holes())
        addBoundary(hole);
    for (const Vec2 &foot : feet)
        if ((foot - m_from).norm() >= kMinOverlap)
            m_directions.push_back({SlitGuide::Kind::RightAngle, (foot - m_from).normalized()});
}

void SlitGuides::addLastSlit(const Model &model)
{
    const std::vector<SectionPointer> &sections = model.document.sections;
    const auto last = std::find_if(sections.rbegin(), sections.rend(),
                                   [](const SectionPointer &s) { return s->parent.has_value(); });
    const Section *ground =
        last == sections.rend() ? nullptr : model.find((*last)->parent->section);
    if (!ground)
        return;
    const std::array<Vec3, 2> ends{ground->frame.toWorld((*last)->parent->slitFrom),
                                   ground->frame.toWorld((*last)->parent->slitTo)};
    const Vec3 way = ends[1] - ends[0];
    if (way.norm() < kMinOverlap ||
        std::abs(way.normalized().dot(m_section->frame.normal())) > kPracticallyParallel)
        return;
    m_last = ends;
    const Vec2 along = m_section->frame.directionToLocal(way).normalized();
    for (const double sign : {1.0, -1.0})
        m_directions.push_back({SlitGuide::Kind::Parallel, sign * along});
}

std::optional<SlitGuide> SlitGuides::lead(Stroke &stroke, bool snaps) const
{
    stroke.leadSlit({});
    const bool hasLeft = stroke.state() == Stroke::State::Turn;
    const Vec2 way = stroke.slitTo() - m_from;
    const Vec2 inside = stroke.lastInside() - m_from;
    const double length = way.norm();
    if (!snaps || length < kMinOverlap)
        return {};
    std::optional<SlitGuide> nearest;
    double least = 0.0; // of the nearest
    for (const Direction &direction : m_directions) {
        double angle = turnBetween(direction.along, way);
        if (inside.norm() > kSure * length)
            angle = std::min(angle, turnBetween(direction.along, inside));
        // What is as near as the one before is no better.
        // One that nearly fits and is the world's goes before one that a hand drew.
        const bool isOfWorld =
            direction.kind == SlitGuide::Kind::Level || direction.kind == SlitGuide::Kind::Upright;
        const double rank = isOfWorld ? angle - kOfWorld : angle;
        if (angle > kReach || (nearest && rank > least - kSameDirection))
            continue;
        const double reach = hasLeft ? (1.0 + kFarthest) * length : way.dot(direction.along);
        Vec2 to = m_from + reach * direction.along;
        if (hasLeft) {
            const std::optional<Vec2> leaving = stroke.interior().leavingPoint(m_from, to);
            if (!leaving || (*leaving - stroke.slitTo()).norm() > kFarthest * length)
                continue;
            to = *leaving;
        }
        nearest = {direction.kind, to};
        least = rank;
    }
    if (nearest)
        stroke.leadSlit(nearest->to);
    return nearest;
}

Text nameOf(SlitGuide::Kind kind)
{
    switch (kind) {
    case SlitGuide::Kind::Level:
        return FFF_TEXT("Cue", "level");
    case SlitGuide::Kind::Upright:
        return FFF_TEXT("Cue", "upright");
    case SlitGuide::Kind::RightAngle:
        return FFF_TEXT("Cue", "square to the edge");
    case SlitGuide::Kind::Parallel:
        break;
    }
    return FFF_TEXT("Cue", "parallel to the last one");
}

void SlitGuides::show(const SlitGuide &guide, const Camera &camera, const Vec2 &viewport,
                      Signs &signs) const
{
    const Vec3 from = m_section->frame.toWorld(m_from), to = m_section->frame.toWorld(guide.to);
    const Vec3 beyond = kBeyond * camera.scaleAt(to, viewport) * (to - from).normalized();
    signs.add(sign::Line{SignRole::Guide, {from - beyond, from}});
    signs.add(sign::Line{SignRole::Guide, {to, to + beyond}});
    if (guide.kind == SlitGuide::Kind::Parallel)
        signs.add(sign::Line{SignRole::Guide, {m_last->front(), m_last->back()}});
}

} // namespace fff
