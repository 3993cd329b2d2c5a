// What a point on a canvas is drawn to: other points, the cuts of templates, lines level and
// upright with points, the ground, a grid. For every tool that sets or moves points:
//
//     SnapTargets targets(canvas, camera.orientation);        when the canvas or the model changes
//     targets.addModel(model, view, {});
//     targets.addPoint(p); targets.alignWith(p);
//     ...
//     m_snap = snapped(point, targets, camera.millimetresPerPixel, m_snap);     with each event
//
// and sets the point to m_snap.point; the overlay shows what else it says. All points are in the
// canvas' coordinates, mm; the lines and the grid are those of the world, whatever way the canvas
// lies in its plane.
#pragma once

#include "core/interaction/view_state.h"
#include "core/model/model.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace fff {

/// The axes that a canvas is measured in: x level and to the right as the camera sees it, y uphill.
/// The origin is where the world's origin is nearest on the line in which the plane meets the
/// ground, so that on an upright canvas y is the height above the ground; on a level canvas, where
/// there is no such line, it is nearest to the world's origin, and x is the world's.
Frame canvasGrid(const Frame &canvas, const Eigen::Quaterniond &orientation);

/// The same axes, counted from the canvas' own origin: of a section that is there, and of a slit.
/// Where a plane rises by a few degrees only, it meets the ground metres away.
Frame ownGrid(const Frame &canvas, const Eigen::Quaterniond &orientation);

/// Distance of the grid's lines, mm: the smallest of 1, 2, 5 · 10ⁿ that is kGridPixels or more.
double gridStep(double millimetresPerPixel);
inline constexpr double kGridPixels = 8.0;

/// How near a point comes before it is caught, px, and how much further it must go to get away.
inline constexpr double kSnapReach = 8.0, kSnapRelease = 1.3;

/// The same of where the canvas cuts a template: mm, where a person wants nothing else, but never
/// more than so many px.
inline constexpr double kGuideReach = 12.7, kGuidePixels = 24.0;
inline double guideReach(double wanted, double millimetresPerPixel, double pixels = kGuidePixels)
{
    return std::min(wanted, pixels * millimetresPerPixel);
}

/// Lines on a canvas, mm; null: none.
struct GuideLine
{
    Polygon points;
    bool isOpen = false; // it does not go on from its last point to the first
};
using GuideLoops = std::shared_ptr<const std::vector<GuideLine>>;
/// The nearest place on one of them, less than `reach` mm away.
std::optional<Vec2> nearestOnLoops(const Vec2 &point, const GuideLoops &loops, double reach);

class SnapTargets
{
public:
    /// orientation: of the camera, for which way the grid's x goes.
    SnapTargets(const Frame &canvas, const Eigen::Quaterniond &orientation)
        : SnapTargets(canvas, canvasGrid(canvas, orientation))
    {
    }
    /// grid: canvasGrid() or ownGrid().
    SnapTargets(const Frame &canvas, const Frame &grid);

    /// A point to be drawn to.
    void addPoint(const Vec2 &point) { m_points.push_back(point); }
    /// The level and the upright line through a point.
    void alignWith(const Vec2 &point) { m_aligned.push_back(point); }
    /// Where what is seen of the model meets the canvas: contours that cross it, on the curve; of
    /// sections that lie in it their points; ends of slits that lie in it. `except` adds nothing.
    void addModel(const Model &model, const ViewState &view, const SectionRef &except);

    /// What the canvas cuts of templates, which catches what is less than `reach` mm and so many px
    /// away.
    void setGuides(GuideLoops loops, double reach, double pixels = kGuidePixels)
    {
        m_guides = std::move(loops);
        m_guideReach = reach;
        m_guidePixels = pixels;
    }

    /// Where planes of sections that are seen cross the guides, as far away as they may be: there a
    /// contour that follows the template meets one that is drawn in such a plane. Not of planes
    /// that make no joint with the canvas (kMinJointAngle).
    void addGuideCrossings(const Model &model, const ViewState &view, const SectionRef &except);

    const Frame &canvas() const { return m_canvas; }
    const Frame &grid() const { return m_grid; }
    const GuideLoops &guides() const { return m_guides; }
    /// mm, as it is seen.
    double guideReach(double millimetresPerPixel) const
    {
        return fff::guideReach(m_guideReach, millimetresPerPixel, m_guidePixels);
    }
    const std::vector<Vec2> &points() const { return m_points; }
    const std::vector<Vec2> &aligned() const { return m_aligned; }
    bool meetsGround() const { return m_ground.has_value(); }
    /// Where it does, at the grid's y, mm.
    const std::optional<double> &ground() const { return m_ground; }
    Vec2 toGrid(const Vec2 &point) const { return m_grid.toLocal(m_canvas.toWorld(point)); }
    Vec2 fromGrid(const Vec2 &point) const { return m_canvas.toLocal(m_grid.toWorld(point)); }

private:
    void addSection(const Section &section);
    void addIfOn(const Vec3 &world);

    Frame m_canvas, m_grid;
    std::vector<Vec2> m_points, m_aligned;
    double m_guideReach = kGuideReach, m_guidePixels = kGuidePixels; // mm, px
    GuideLoops m_guides;
    std::optional<double> m_ground;
};

/// A point, and what caught it.
struct Snap
{
    /// The stronger the later.
    enum class Kind { None, Grid, Line, Crossing, Guide, Point };

    Kind kind = Kind::None;
    Vec2 point = Vec2::Zero();
    /// Of Line and Crossing: the lines go from here to the point. Ends in nothing for the ground.
    std::vector<Vec2> anchors;
    bool isOnGround = false; // the ground's line is one of those that caught it

    bool operator==(const Snap &) const = default;
};

/// Where the point goes, strongest first: a point within reach, a guide within guideReach(), where
/// two lines cross that are both within reach, one such line (and on it the grid), the grid.
/// `before`: what caught it last, which holds it a little longer.
Snap snapped(const Vec2 &point, const SnapTargets &targets, double millimetresPerPixel,
             const Snap &before);

/// Only the first two of these, where there is one: for what is dragged freely but for them.
std::optional<Snap> caught(const Vec2 &point, const SnapTargets &targets,
                           double millimetresPerPixel, const Snap &before);

/// As snapped(), in one of the eight directions of the compass from `from`, the nearest one: on
/// that line only. Without targets it goes nowhere else.
Snap held(const Vec2 &point, const Vec2 &from, const SnapTargets &targets,
          double millimetresPerPixel, bool snaps);

} // namespace fff
