#include "ui/view/mark_pen.h"

#include <QFontMetricsF>

#include <algorithm>

namespace fff::ui {

QPen roundPen(const QColor &colour, double width)
{
    return QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
}

QColor faded(QColor colour, double alpha)
{
    colour.setAlphaF(static_cast<float>(alpha));
    return colour;
}

QPointF MarkPen::screen(const Vec3 &world) const
{
    const Vec2 p = m_camera.toScreen(world, m_viewport);
    return {p.x(), p.y()};
}

QPainterPath MarkPen::path(const std::vector<CubicBezier> &curves, const Frame &frame) const
{
    QPainterPath path;
    for (const CubicBezier &piece : curves) {
        const QPointF from = screen(frame.toWorld(piece.p0));
        if (path.elementCount() == 0)
            path.moveTo(from);
        if (m_camera.isPerspective()) {
            // A cubic is none any more in perspective: chords of it.
            constexpr int kChords = 12;
            for (int i = 1; i <= kChords; ++i)
                path.lineTo(screen(frame.toWorld(piece.at(double(i) / kChords))));
            continue;
        }
        path.cubicTo(screen(frame.toWorld(piece.p1)), screen(frame.toWorld(piece.p2)),
                     screen(frame.toWorld(piece.p3)));
    }
    return path;
}

QPainterPath MarkPen::path(const Contour &contour, const Frame &frame) const
{
    std::vector<CubicBezier> pieces;
    for (int i = 0; i < contour.segmentCount(); ++i)
        pieces.push_back(contour.segment(i));
    QPainterPath closed = path(pieces, frame);
    closed.closeSubpath();
    return closed;
}

void MarkPen::cased(const QPainterPath &line, const QPen &pen)
{
    m_painter.strokePath(line, roundPen(m_style.panel, pen.widthF() + 2.4));
    m_painter.strokePath(line, pen);
}

void MarkPen::ring(const QPointF &centre, double radius, const QColor &colour)
{
    m_painter.setBrush(m_style.panel);
    m_painter.setPen(QPen(colour, 2.0));
    m_painter.drawEllipse(centre, radius, radius);
}

QRectF MarkPen::freeFrom(const QRectF &box) const
{
    constexpr int kSteps = 3;      // up and down
    constexpr double kApart = 2.0; // px
    const QRectF view(0.0, 0.0, m_viewport.x(), m_viewport.y());
    for (int step = 0; step <= kSteps; ++step)
        for (const double way : {-1.0, 1.0}) {
            const QRectF moved = box.translated(0.0, way * step * (box.height() + kApart));
            if ((step == 0 || view.contains(moved)) &&
                std::none_of(m_taken.begin(), m_taken.end(),
                             [&](const QRectF &other) { return moved.intersects(other); }))
                return moved;
        }
    return box; // better over another one than far from what it says
}

QRectF MarkPen::chip(const QPointF &place, Anchor anchor, const QString &text, const QColor &colour)
{
    m_painter.save();
    QFont font = m_painter.font();
    font.setPixelSize(12);
    font.setWeight(QFont::DemiBold);
    m_painter.setFont(font);
    const double width = QFontMetricsF(font).horizontalAdvance(text) + 16.0, height = 22.0;
    const double before = anchor == Anchor::Left ? 0.0 : anchor == Anchor::Right ? 1.0 : 0.5;
    QRectF box(place.x() - before * width, place.y() - 0.5 * height, width, height);
    box.moveLeft(std::clamp(box.left(), 4.0, std::max(4.0, m_viewport.x() - width - 4.0)));
    box.moveTop(std::clamp(box.top(), 4.0, std::max(4.0, m_viewport.y() - height - 4.0)));
    box = freeFrom(box);
    keepFree(box);
    m_painter.setPen(QPen(colour, 1.0));
    m_painter.setBrush(faded(m_style.panel, 0.94));
    m_painter.drawRoundedRect(QRectF(box.toAlignedRect()).adjusted(0.5, 0.5, -0.5, -0.5), 3.0, 3.0);
    m_painter.drawText(box, Qt::AlignCenter, text);
    m_painter.restore();
    return box;
}

} // namespace fff::ui
