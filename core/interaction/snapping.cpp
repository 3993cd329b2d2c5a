#include "core/interaction/snapping.h"

#include "core/base/tolerances.h"
#include "core/geometry/curve_crossing.h"
#include "core/geometry/segment_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

/// A plane that rises by less than this (its sine) has its line with the ground far away from what
/// is drawn: it counts as level.
constexpr double kLevel = 0.02;

/// A line of the grid's axes: all points whose coordinate `axis` is `value`.
struct Line
{
    int axis = 0; // 0: upright, 1: level
    double value = 0.0;
    std::optional<Vec2> anchor; // canvas; none: the ground
};

bool isLevel(const Vec3 &normal)
{
    return std::hypot(normal.x(), normal.z()) <= kLevel;
}

double rounded(double value, double step)
{
    return std::round(value / step) * step;
}

std::vector<Line> linesOf(const SnapTargets &targets)
{
    std::vector<Line> lines;
    for (const Vec2 &point : targets.aligned()) {
        const Vec2 at = targets.toGrid(point);
        lines.push_back({0, at.x(), point});
        lines.push_back({1, at.y(), point});
    }
    if (targets.meetsGround())
        lines.push_back({1, *targets.ground(), {}});
    return lines;
}

/// Whether it was caught by this line last.
bool holds(const Snap &before, const Line &line)
{
    return line.anchor ? std::find(before.anchors.begin(), before.anchors.end(), *line.anchor) !=
                             before.anchors.end()
                       : before.isOnGround;
}

/// The nearest line of an axis within reach.
const Line *caughtBy(const std::vector<Line> &lines, int axis, double value, double reach,
                     const Snap &before)
{
    const Line *best = nullptr;
    double least = 0.0;
    for (const Line &line : lines) {
        const double distance = std::abs(line.value - value);
        if (line.axis != axis || distance > (holds(before, line) ? kSnapRelease : 1.0) * reach ||
            (best && distance >= least))
            continue;
        best = &line;
        least = distance;
    }
    return best;
}

void note(const Line &line, Snap &snap)
{
    if (line.anchor)
        snap.anchors.push_back(*line.anchor);
    else
        snap.isOnGround = true;
}

std::optional<Vec2> nearestPoint(const Vec2 &point, const SnapTargets &targets, double reach,
                                 const Snap &before)
{
    std::optional<Vec2> best;
    for (const Vec2 &target : targets.points()) {
        const bool held = before.kind == Snap::Kind::Point && before.point == target;
        const double distance = (target - point).norm();
        if (distance <= (held ? kSnapRelease : 1.0) * reach &&
            (!best || distance < (*best - point).norm()))
            best = target;
    }
    return best;
}

} // namespace

Frame canvasGrid(const Frame &canvas, const Eigen::Quaterniond &orientation)
{
    const Vec3 normal = canvas.normal().normalized();
    const Vec3 backward = orientation * Vec3::UnitZ();
    const double height = normal.dot(canvas.origin);
    Frame grid;
    grid.origin = height * normal;
    const Vec3 uphill = Vec3::UnitY() - normal.y() * normal;
    if (!isLevel(normal)) {
        grid.y = uphill.normalized();
        grid.origin -= (height * normal.y() / grid.y.y()) * grid.y;
        grid.x = grid.y.cross(normal).normalized();
        if (grid.x.cross(grid.y).dot(backward) < 0.0)
            grid.x = -grid.x;
    } else {
        grid.x = (Vec3::UnitX() - normal.x() * normal).normalized();
        grid.y = normal.cross(grid.x);
        if (grid.x.cross(grid.y).dot(backward) < 0.0)
            grid.y = -grid.y;
    }
    return grid;
}

double gridStep(double millimetresPerPixel)
{
    const double least = kGridPixels * millimetresPerPixel;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double lead : {1.0, 2.0, 5.0}) {
        if (lead * power >= least)
            return lead * power;
    }
    return 10.0 * power;
}

Frame ownGrid(const Frame &canvas, const Eigen::Quaterniond &orientation)
{
    Frame grid = canvasGrid(canvas, orientation);
    grid.origin = canvas.origin;
    return grid;
}

std::optional<Vec2> nearestOnLoops(const Vec2 &point, const GuideLoops &loops, double reach)
{
    std::optional<Vec2> best;
    double least = reach;
    for (std::size_t k = 0; loops && k < loops->size(); ++k) {
        const auto &[loop, isOpen] = (*loops)[k];
        for (std::size_t to = isOpen ? 1 : 0, from = isOpen ? 0 : loop.size() - 1; to < loop.size();
             from = to++) {
            const Vec2 place = nearestOfSegment(point, loop[from], loop[to]);
            if (const double distance = (place - point).norm(); distance < least) {
                least = distance;
                best = place;
            }
        }
    }
    return best;
}

SnapTargets::SnapTargets(const Frame &canvas, const Frame &grid) : m_canvas(canvas), m_grid(grid)
{
    if (!isLevel(canvas.normal()))
        m_ground = -grid.origin.y() / grid.y.y();
}

void SnapTargets::addIfOn(const Vec3 &world)
{
    if (std::abs(m_canvas.height(world)) <= kClipGrid)
        m_points.push_back(m_canvas.toLocal(world));
}

void SnapTargets::addSection(const Section &section)
{
    std::vector<const Contour *> contours{&section.shape->contour()};
    for (const Contour &hole : section.shape->holes())
        contours.push_back(&hole);

    // The canvas seen in the section's plane is the line normal · p = offset.
    const Vec2 across = section.frame.directionToLocal(m_canvas.normal());
    const bool isParallel = across.norm() < std::sin(kMinDrawAngle);
    const double offset = -m_canvas.height(section.frame.origin);
    for (const Contour *contour : contours) {
        const int count = contour->segmentCount();
        for (int i = 0; isParallel && i < count; ++i)
            addIfOn(section.frame.toWorld(contour->segment(i).p0));
        if (isParallel)
            continue;
        const Vec2 normal = across.normalized();
        const Vec2 foot = normal * (offset / across.norm());
        const Polyline chords =
            contour == contours.front() ? section.shape->chords() : contour->flatten(kCutChord);
        for (std::size_t k = 0, n = chords.points.size(); k < n; ++k) {
            const std::size_t next = (k + 1) % n;
            const double here = normal.dot(chords.points[k] - foot);
            const double there = normal.dot(chords.points[next] - foot);
            if (here != 0.0 && (here > 0.0) == (there > 0.0))
                continue;
            const CurvePoint &from = chords.origins[k], &to = chords.origins[next];
            const double end = to.segment == from.segment && to.t > from.t ? to.t : 1.0;
            const CubicBezier curve = contour->segment(from.segment);
            const std::optional<double> t =
                crossLine({curve, from.t, end}, foot, normal, kClipGrid);
            if (t)
                m_points.push_back(m_canvas.toLocal(section.frame.toWorld(curve.at(*t))));
        }
    }
}

void SnapTargets::addModel(const Model &model, const ViewState &view, const SectionRef &except)
{
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        const SectionRef ref = model.ref(i);
        const Section &section = *model.section(i);
        if (ref == except || !view.isPicked(ref))
            continue;
        addSection(section);
        if (!section.parent)
            continue;
        if (const int parent = model.indexOf(section.parent->section); parent >= 0) {
            const Frame &frame = model.section(static_cast<std::size_t>(parent))->frame;
            addIfOn(frame.toWorld(section.parent->slitFrom));
            addIfOn(frame.toWorld(section.parent->slitTo));
        }
    }
}

void SnapTargets::addGuideCrossings(const Model &model, const ViewState &view,
                                    const SectionRef &except)
{
    if (!m_guides)
        return;
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        const SectionRef ref = model.ref(i);
        const Frame &frame = model.section(i)->frame;
        const Vec2 slope = m_canvas.directionToLocal(frame.normal());
        if (ref == except || !view.isPicked(ref) || slope.norm() < std::sin(kMinJointAngle))
            continue;
        const double offset = frame.height(m_canvas.origin);
        for (const GuideLine &line : *m_guides) {
            const std::size_t count = line.points.size();
            for (std::size_t k = line.isOpen ? 1 : 0; k < count; ++k) {
                const Vec2 &from = line.points[(k + count - 1) % count], &to = line.points[k];
                const double here = offset + slope.dot(from), there = offset + slope.dot(to);
                if ((here > 0.0) != (there > 0.0))
                    m_points.push_back(from + here / (here - there) * (to - from));
            }
        }
    }
}

std::optional<Snap> caught(const Vec2 &point, const SnapTargets &targets,
                           double millimetresPerPixel, const Snap &before)
{
    const double reach = kSnapReach * millimetresPerPixel;
    if (const std::optional<Vec2> target = nearestPoint(point, targets, reach, before))
        return Snap{Snap::Kind::Point, *target, {}, false};
    const double holding = before.kind == Snap::Kind::Guide ? kSnapRelease : 1.0;
    const double guiding = holding * targets.guideReach(millimetresPerPixel);
    if (const std::optional<Vec2> place = nearestOnLoops(point, targets.guides(), guiding))
        return Snap{Snap::Kind::Guide, *place, {}, false};
    return std::nullopt;
}

Snap snapped(const Vec2 &point, const SnapTargets &targets, double millimetresPerPixel,
             const Snap &before)
{
    if (std::optional<Snap> strongest = caught(point, targets, millimetresPerPixel, before))
        return *std::move(strongest);
    const double reach = kSnapReach * millimetresPerPixel;
    const std::vector<Line> lines = linesOf(targets);
    const double step = gridStep(millimetresPerPixel);
    Vec2 at = targets.toGrid(point);
    Snap snap;
    int caught = 0;
    for (const int axis : {0, 1}) {
        if (const Line *line = caughtBy(lines, axis, at[axis], reach, before)) {
            at[axis] = line->value;
            note(*line, snap);
            ++caught;
        } else {
            at[axis] = rounded(at[axis], step);
        }
    }
    constexpr std::array<Snap::Kind, 3> kinds{Snap::Kind::Grid, Snap::Kind::Line,
                                              Snap::Kind::Crossing};
    snap.kind = kinds[static_cast<std::size_t>(caught)];
    snap.point = targets.fromGrid(at);
    return snap;
}

Snap held(const Vec2 &point, const Vec2 &from, const SnapTargets &targets,
          double millimetresPerPixel, bool snaps)
{
    const Vec2 start = targets.toGrid(from);
    const Vec2 way = targets.toGrid(point) - start;
    constexpr double kStep = std::numbers::pi / 4.0;
    const int direction =
        (static_cast<int>(std::lround(std::atan2(way.y(), way.x()) / kStep)) + 8) % 8;
    // In steps along the axes, so that what is level stays so to the last bit.
    constexpr std::array<int, 8> xs{1, 1, 0, -1, -1, -1, 0, 1};
    const Vec2 along(xs[static_cast<std::size_t>(direction)],
                     xs[static_cast<std::size_t>((direction + 6) % 8)]);
    double length = along.dot(way) / along.squaredNorm();

    Snap snap;
    snap.kind = Snap::Kind::Line;
    snap.anchors = {from};
    if (snaps) {
        const double reach = kSnapReach * millimetresPerPixel;
        const Line *best = nullptr;
        const std::vector<Line> lines = linesOf(targets);
        double least = reach, caught = 0.0;
        for (const Line &line : lines) {
            if (along[line.axis] == 0.0 || line.anchor == from)
                continue;
            const double crossing = (line.value - start[line.axis]) / along[line.axis];
            if (std::abs(crossing - length) > least)
                continue;
            best = &line;
            least = std::abs(crossing - length);
            caught = crossing;
        }
        const int axis = along.x() != 0.0 ? 0 : 1;
        const double step = gridStep(millimetresPerPixel);
        length =
            best ? caught
                 : (rounded(start[axis] + length * along[axis], step) - start[axis]) / along[axis];
        if (best) {
            snap.kind = Snap::Kind::Crossing;
            note(*best, snap);
        }
    }
    snap.point = targets.fromGrid(start + length * along);
    return snap;
}

} // namespace fff
