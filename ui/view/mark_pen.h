// What all that is painted over the view has in common: where world points are on it, lines with a
// casing, rings and chips with words.
#pragma once

#include "core/geometry/contour.h"
#include "core/geometry/frame.h"
#include "core/interaction/camera.h"
#include "ui/view/view_style.h"

#include <QPainter>
#include <QPainterPath>

#include <vector>

namespace fff::ui {

QPen roundPen(const QColor &colour, double width);
QColor faded(QColor colour, double alpha);

/// Leaves the painter's state changed. Painter, camera and style outlive it.
class MarkPen
{
public:
    MarkPen(QPainter &painter, const Camera &camera, const Vec2 &viewport, const ViewStyle &style)
        : m_painter(painter), m_camera(camera), m_viewport(viewport), m_style(style)
    {
    }

    QPainter &painter() { return m_painter; }
    const ViewStyle &style() const { return m_style; }
    const Vec2 &viewport() const { return m_viewport; }
    const Camera &camera() const { return m_camera; }

    QPointF screen(const Vec3 &world) const;
    /// A chain of curves in a frame's plane; in perspective chords of them.
    QPainterPath path(const std::vector<CubicBezier> &curves, const Frame &frame) const;
    QPainterPath path(const Contour &contour, const Frame &frame) const;

    /// The line on a wider one in the panels' colour, so that it is seen on every stock.
    void cased(const QPainterPath &line, const QPen &pen);
    void ring(const QPointF &centre, double radius, const QColor &colour);

    /// Which point of a chip is given.
    enum class Anchor { Left, Right, Middle };
    /// Words in a box with a frame in their colour, whole also at the view's edge. `place`: of the
    /// middle of that side. Where others are already it steps aside, up or down, if that is near.
    /// Where it is, px.
    QRectF chip(const QPointF &place, Anchor anchor, const QString &text, const QColor &colour);

    /// No words come there.
    void keepFree(const QRectF &box) { m_taken.push_back(box); }
    /// The nearest free one above or below the box; itself where none is near.
    QRectF freeFrom(const QRectF &box) const;

private:
    QPainter &m_painter;
    const Camera &m_camera;
    const Vec2 m_viewport;
    const ViewStyle &m_style;
    std::vector<QRectF> m_taken; // by words, and what else is not to be covered
};

} // namespace fff::ui
