#include "ui/view/guide_marks.h"

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

constexpr double kCutWidth = 2.0, kCaughtMore = 0.5;          // px
constexpr double kGuideTickEvery = 10.0;                      // mm
constexpr int kLongEvery = 5;                                 // every so many
constexpr double kShortGuideTick = 4.0, kLongGuideTick = 7.0; // px, to each side
constexpr double kLeastTickPixels = 5.0;                  // nearer to each other they are left out
constexpr double kCaughtRadius = 6.0, kTurnoutHalf = 3.5; // px
constexpr double kFreeBeside = 4.0, kFreePiece = 20.0;    // px

void addTicks(const MarkPen &pen, const Frame &canvas, const sign::Guides::Loop &loop,
              QPainterPath &path)
{
    const Polygon &points = loop.points;
    double along = 0.0, next = 0.0;
    int count = 0;
    for (std::size_t i = 0; i + (loop.isOpen ? 1 : 0) < points.size(); ++i) {
        const Vec2 &p = points[i], &q = points[(i + 1) % points.size()];
        const double length = (q - p).norm();
        for (; length > 0.0 && next < along + length; next += kGuideTickEvery, ++count) {
            const QPointF at = pen.screen(canvas.toWorld(p + (next - along) / length * (q - p)));
            const QPointF way = pen.screen(canvas.toWorld(q)) - pen.screen(canvas.toWorld(p));
            const double pixels = std::hypot(way.x(), way.y());
            if (pixels / length * kGuideTickEvery < kLeastTickPixels)
                continue;
            const QPointF across = QPointF(-way.y(), way.x()) / pixels;
            const double reach = count % kLongEvery == 0 ? kLongGuideTick : kShortGuideTick;
            path.moveTo(at - reach * across);
            path.lineTo(at + reach * across);
        }
        along += length;
    }
}

/// No words come onto it.
void keepFree(MarkPen &pen, const Frame &canvas, const sign::Guides::Loop &loop)
{
    QPointF from = pen.screen(canvas.toWorld(loop.points.front()));
    const std::size_t count = loop.points.size();
    for (std::size_t i = 1; i < count + (loop.isOpen ? 0 : 1); ++i) {
        const QPointF to = pen.screen(canvas.toWorld(loop.points[i % count]));
        const QPointF way = to - from;
        if (i + 1 < count && std::hypot(way.x(), way.y()) < kFreePiece)
            continue;
        pen.keepFree(from, to, kFreeBeside);
        from = to;
    }
}

} // namespace

void paintGuides(MarkPen &pen, const sign::Guides &guides)
{
    const QColor &colour = pen.style().guide;
    const double width = kCutWidth + (guides.caught ? kCaughtMore : 0.0);
    for (const sign::Guides::Loop &loop : *guides.loops) {
        if (loop.points.empty())
            continue;
        const Polygon &points = loop.points;
        QPainterPath line(pen.screen(guides.canvas.toWorld(points.front())));
        for (std::size_t i = 1; i < points.size(); ++i)
            line.lineTo(pen.screen(guides.canvas.toWorld(points[i])));
        if (!loop.isOpen)
            line.closeSubpath();
        QPen stroke = roundPen(colour, width);
        if (loop.isHole) {
            stroke.setCapStyle(Qt::FlatCap);
            stroke.setDashPattern({4.0, 3.0});
        }
        pen.cased(line, stroke);
        keepFree(pen, guides.canvas, loop);
        QPainterPath ticks;
        addTicks(pen, guides.canvas, loop, ticks);
        pen.painter().strokePath(ticks, roundPen(colour, 0.7 * kCutWidth));
    }
    QPainter &painter = pen.painter();
    for (const Vec2 &turnout : guides.turnouts) {
        const QPointF at = pen.screen(guides.canvas.toWorld(turnout));
        painter.setPen(QPen(pen.style().accent, 1.6));
        painter.setBrush(pen.style().panel);
        painter.drawRect(QRectF(at.x() - kTurnoutHalf, at.y() - kTurnoutHalf, 2.0 * kTurnoutHalf,
                                2.0 * kTurnoutHalf));
    }
    if (guides.caught) {
        painter.setPen(QPen(pen.style().panel, 1.5));
        painter.setBrush(colour);
        painter.drawEllipse(pen.screen(guides.canvas.toWorld(*guides.caught)), kCaughtRadius,
                            kCaughtRadius);
    }
}

} // namespace fff::ui
