#include "ui/view/point_marks.h"

#include <algorithm>

namespace fff::ui {

namespace {

constexpr double kSize = 7.0, kHoveredSize = 9.0; // px
constexpr double kHandleSize = 6.0;
constexpr double kNearView = 20.0; // px beyond its edge: nothing there is drawn

class Points
{
public:
    Points(MarkPen &pen, const Section &section, const sign::Points &points)
        : m_pen(pen), m_painter(pen.painter()), m_section(section), m_points(points),
          m_view(QRectF(0.0, 0.0, pen.viewport().x(), pen.viewport().y())
                     .adjusted(-kNearView, -kNearView, kNearView, kNearView))
    {
    }
    void contour();
    void neighbours();
    void handles();
    void anchors();
    void placeOnLine();

private:
    QPointF screen(const Vec2 &p) const { return m_pen.screen(m_section.frame.toWorld(p)); }
    bool isSelected(const PointAddress &point) const
    {
        return std::binary_search(m_points.selected.begin(), m_points.selected.end(), point);
    }
    bool isHovered(PointTarget::Kind kind, const PointAddress &point) const
    {
        return m_points.hovered && m_points.hovered->kind == kind &&
               m_points.hovered->point == point;
    }
    void mark(const QPointF &at, PointKind kind, double size);

    MarkPen &m_pen;
    QPainter &m_painter;
    const Section &m_section;
    const sign::Points &m_points;
    const QRectF m_view;
};

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
    drawing.contour();
    drawing.neighbours();
    drawing.handles();
    drawing.anchors();
    drawing.placeOnLine();
    pen.painter().restore();
}

} // namespace fff::ui
