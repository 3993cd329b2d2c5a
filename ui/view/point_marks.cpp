#include "ui/view/point_marks.h"

#include "core/base/tolerances.h"
#include "core/model/symmetric_section.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace fff::ui {

namespace {

constexpr double kSize = 7.0, kHoveredSize = 9.0; // px
constexpr double kHandleSize = 6.0;
constexpr double kBeyond = 24.0;   // px, of an axis over the section
constexpr double kNearView = 20.0; // px beyond its edge: nothing there is drawn

class Points
{
public:
    Points(MarkPen &pen, const Section &section, const sign::Points &points)
        : m_pen(pen), m_painter(pen.painter()), m_section(section), m_points(points),
          m_view(QRectF(0.0, 0.0, pen.viewport().x(), pen.viewport().y())
                     .adjusted(-kNearView, -kNearView, kNearView, kNearView)),
          m_lit(points.selected)
    {
        addImages();
    }
    void axis();
    void contour();
    void neighbours();
    void handles();
    void anchors();
    void placeOnLine();

private:
    QPointF screen(const Vec2 &p) const { return m_pen.screen(m_section.frame.toWorld(p)); }
    bool isSelected(const PointAddress &point) const
    {
        return std::binary_search(m_lit.begin(), m_lit.end(), point);
    }
    bool isHovered(PointTarget::Kind kind, const PointAddress &point) const
    {
        return m_points.hovered && m_points.hovered->kind == kind &&
               m_points.hovered->point == point;
    }
    void addImages();
    void mark(const QPointF &at, PointKind kind, double size);

    MarkPen &m_pen;
    QPainter &m_painter;
    const Section &m_section;
    const sign::Points &m_points;
    const QRectF m_view;
    std::vector<PointAddress> m_lit; // sorted: those that are selected, and what moves with them
};

/// Of a symmetric section, where the images of the selected points are, which move as these do.
void Points::addImages()
{
    const MirrorAxis *axis = symmetryOf(m_section);
    if (!axis)
        return;
    for (const PointAddress &point : m_points.selected) {
        if (!isPoint(*m_section.shape, point))
            continue;
        const Vec2 image =
            axis->mirrored(anchor(boundary(*m_section.shape, point.boundary), point.index));
        for (int b = 0; b < boundaryCount(*m_section.shape); ++b)
            for (int i = 0; i < boundary(*m_section.shape, b).segmentCount(); ++i)
                if ((anchor(boundary(*m_section.shape, b), i) - image).norm() < kEqualEnds)
                    m_lit.push_back({b, i});
    }
    std::sort(m_lit.begin(), m_lit.end());
    m_lit.erase(std::unique(m_lit.begin(), m_lit.end()), m_lit.end());
}

/// That it stays symmetric to, a little longer than the section is.
void Points::axis()
{
    const MirrorAxis *axis = symmetryOf(m_section);
    if (!axis)
        return;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    const Box2 box = m_section.shape->bounds();
    for (const Vec2 &corner :
         {box.min, box.max, Vec2(box.min.x(), box.max.y()), Vec2(box.max.x(), box.min.y())}) {
        const double along = axis->direction.dot(corner - axis->point);
        least = std::min(least, along);
        most = std::max(most, along);
    }
    const double beyond =
        kBeyond * m_pen.camera().scaleAt(m_section.frame.toWorld(axis->point), m_pen.viewport());
    QPainterPath line(screen(axis->point + (least - beyond) * axis->direction));
    line.lineTo(screen(axis->point + (most + beyond) * axis->direction));
    m_painter.setBrush(Qt::NoBrush);
    m_pen.cased(line, axisPen(m_pen.style()));
}

void Points::contour()
{
    m_painter.setBrush(Qt::NoBrush);
    for (int b = 0; b < boundaryCount(*m_section.shape); ++b)
        m_painter.strokePath(m_pen.path(boundary(*m_section.shape, b), m_section.frame),
                             roundPen(m_pen.style().accent, 1.2));
}

/// The two segments beside what is selected or hovered, bold.
void Points::neighbours()
{
    std::vector<PointAddress> bold = m_points.selected;
    if (m_points.hovered && m_points.hovered->kind != PointTarget::Kind::Line)
        bold.push_back(m_points.hovered->point);
    std::vector<PointAddress> segments; // by where they start
    for (const PointAddress &point : bold) {
        if (!isPoint(*m_section.shape, point))
            continue;
        const int count = boundary(*m_section.shape, point.boundary).segmentCount();
        segments.push_back(point);
        segments.push_back({point.boundary, (point.index + count - 1) % count});
    }
    if (m_points.hovered && m_points.hovered->kind == PointTarget::Kind::Line &&
        isPoint(*m_section.shape, m_points.hovered->point))
        segments.push_back(m_points.hovered->point);
    std::sort(segments.begin(), segments.end());
    segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
    for (const PointAddress &start : segments)
        m_painter.strokePath(
            m_pen.path({boundary(*m_section.shape, start.boundary).segment(start.index)},
                       m_section.frame),
            roundPen(m_pen.style().accent, 3.2));
}

void Points::handles()
{
    for (const PointAddress &point : m_points.selected) {
        if (!isPoint(*m_section.shape, point))
            continue;
        const Contour &contour = boundary(*m_section.shape, point.boundary);
        const QPointF at = screen(anchor(contour, point.index));
        for (const HandleSide side : {HandleSide::In, HandleSide::Out}) {
            const QPointF end = screen(handle(contour, point.index, side));
            QPainterPath line(at);
            line.lineTo(end);
            m_pen.cased(line, roundPen(m_pen.style().accent, 1.2));
            const bool isHoveredHere =
                isHovered(PointTarget::Kind::Handle, point) && m_points.hovered->side == side;
            m_pen.ring(end, 0.5 * (isHoveredHere ? kHoveredSize : kHandleSize),
                       m_pen.style().accent);
        }
    }
}

void Points::mark(const QPointF &at, PointKind kind, double size)
{
    const double half = 0.5 * size;
    switch (kind) {
    case PointKind::Corner:
        m_painter.drawRect(QRectF(at.x() - half, at.y() - half, size, size));
        break;
    case PointKind::Smooth:
        m_painter.drawEllipse(at, half, half);
        break;
    case PointKind::Symmetric: {
        const double reach = 1.25 * half; // so that it looks as large
        const QPointF corners[] = {at + QPointF(0, -reach), at + QPointF(reach, 0),
                                   at + QPointF(0, reach), at + QPointF(-reach, 0)};
        m_painter.drawConvexPolygon(corners, 4);
        break;
    }
    }
}

void Points::anchors()
{
    const QColor accent = m_pen.style().accent, panel = m_pen.style().panel;
    for (const PointAddress &point :
         shownPoints(m_section, m_points.selected, m_pen.camera(), m_pen.viewport())) {
        const Contour &contour = boundary(*m_section.shape, point.boundary);
        const QPointF at = screen(anchor(contour, point.index));
        if (!m_view.contains(at))
            continue;
        const bool isChosen = isSelected(point);
        m_painter.setPen(QPen(isChosen ? panel : accent, isChosen ? 1.2 : 1.6));
        m_painter.setBrush(isChosen ? accent : panel);
        const bool grows = isHovered(PointTarget::Kind::Anchor, point);
        mark(at, kindOf(contour, point.index),
             grows ? kHoveredSize + 1.0 : kSize + (isChosen ? 1.0 : 0.0));
    }
}

/// Where a double click puts a point in.
void Points::placeOnLine()
{
    if (!m_points.hovered || m_points.hovered->kind != PointTarget::Kind::Line)
        return;
    m_painter.setPen(QPen(m_pen.style().panel, 1.4));
    m_painter.setBrush(m_pen.style().accent);
    m_painter.drawEllipse(screen(m_points.hovered->place), 4.0, 4.0);
}

} // namespace

void paintPoints(MarkPen &pen, const Section &section, const sign::Points &points)
{
    pen.painter().save();
    Points drawing(pen, section, points);
    drawing.axis();
    drawing.contour();
    drawing.neighbours();
    drawing.handles();
    drawing.anchors();
    drawing.placeOnLine();
    pen.painter().restore();
}

} // namespace fff::ui
