#include "ui/view/step_marks.h"

#include "ui/view/heading_weight.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

constexpr double kWidth = 3.0, kHead = 13.0;         // px, of the arrow
constexpr double kShortest = 30.0;                   // px, of arrows
constexpr double kSmallPart = 34.0;                  // px
constexpr double kSeenOnEnd = 10.0;                  // px: shorter arrows have no direction
constexpr double kLabel = 12.0, kMovingLabel = 14.0; // px, of digits

double lengthOf(const QPointF &v)
{
    return std::hypot(v.x(), v.y());
}

/// One that points at whoever looks, or away: a ring with a dot in it.
void paintEndOn(MarkPen &pen, const QPointF &at)
{
    pen.ring(at, 8.0, pen.style().accent);
    pen.painter().setBrush(pen.style().accent);
    pen.painter().setPen(Qt::NoPen);
    pen.painter().drawEllipse(at, 2.8, 2.8);
}

void paintArrow(MarkPen &pen, const std::vector<Vec3> &way)
{
    std::vector<QPointF> points;
    for (const Vec3 &corner : way)
        points.push_back(pen.screen(corner));
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += lengthOf(points[i] - points[i - 1]);
    if (points.size() < 2)
        return;
    const QPointF tip = points.back(), last = tip - points[points.size() - 2];
    if (length < kSeenOnEnd || lengthOf(last) < 1.0) {
        paintEndOn(pen, tip);
        return;
    }
    // A short one would be hidden by its part: it begins further back.
    if (const QPointF first = points[1] - points[0]; length < kShortest && lengthOf(first) > 1.0)
        points[0] -= (kShortest - length) / lengthOf(first) * first;
    length = std::max(length, kShortest);
    const QPointF along = last / lengthOf(last), across(-along.y(), along.x());
    const double head = std::min(kHead, 0.6 * length);
    QPainterPath line(points.front());
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        line.lineTo(points[i]);
    line.lineTo(tip - std::min(head, lengthOf(last)) * 0.7 * along);
    QPainterPath arrow(tip);
    arrow.lineTo(tip - head * along + 0.5 * head * across);
    arrow.lineTo(tip - head * along - 0.5 * head * across);
    arrow.closeSubpath();
    QPainter &painter = pen.painter();
    painter.setBrush(Qt::NoBrush);
    const QPen casing = roundPen(pen.style().panel, kWidth + 3.0);
    painter.strokePath(line, casing);
    painter.strokePath(arrow, roundPen(pen.style().panel, 3.0));
    painter.strokePath(line, roundPen(pen.style().accent, kWidth));
    painter.fillPath(arrow, pen.style().accent);
    painter.strokePath(arrow, roundPen(pen.style().accent, 1.0));
}

/// Where a number stands: round for one digit, longer for more.
QRectF boxOf(const QPointF &at, const QString &text, const QFont &font)
{
    const double height = font.pixelSize() + 6.0;
    const double width = std::max(height, QFontMetricsF(font).horizontalAdvance(text) + 9.0);
    return {at.x() - 0.5 * width, at.y() - 0.5 * height, width, height};
}

/// A number would hide a small part that comes: it stands behind it, where it comes from.
QPointF besidePart(MarkPen &pen, const StepMarks &marks, const StepMarks::Number &number)
{
    const QPointF at = pen.screen(number.at);
    const double extent = number.extent / pen.camera().scaleAt(number.at, pen.viewport()); // px
    if (!number.isMoving || extent > kSmallPart)
        return at;
    QPointF from(0.0, -1.0);
    if (marks.way.size() > 1) {
        const QPointF first = pen.screen(marks.way[0]) - pen.screen(marks.way[1]);
        if (lengthOf(first) > 1.0)
            from = first / lengthOf(first);
    }
    const QPointF beside = at + (0.5 * extent + 22.0) * from;
    QPainterPath line(at);
    line.lineTo(beside);
    pen.painter().setBrush(Qt::NoBrush);
    pen.cased(line, roundPen(pen.style().accent, 1.4));
    return beside;
}

void paintNumber(MarkPen &pen, const QRectF &box, const QString &text, const QFont &font,
                 bool isMoving)
{
    const ViewStyle &style = pen.style();
    QPainter &painter = pen.painter();
    const double radius = 0.5 * box.height();
    painter.setPen(QPen(isMoving ? style.panel : style.strong, isMoving ? 1.5 : 1.0));
    painter.setBrush(isMoving ? style.accent : faded(style.panel, 0.92));
    painter.drawRoundedRect(box, radius, radius);
    painter.setFont(font);
    painter.setPen(isMoving ? style.panel : style.text);
    painter.drawText(box, Qt::AlignCenter, text);
}

} // namespace

void paintSteps(MarkPen &pen, const StepMarks &marks, const QLocale &locale)
{
    pen.painter().save();
    if (marks.way.size() > 1)
        paintArrow(pen, marks.way);
    std::vector<QRectF> taken;
    for (const bool isMoving : {true, false}) {
        QFont font = pen.painter().font();
        font.setPixelSize(static_cast<int>(isMoving ? kMovingLabel : kLabel));
        font.setWeight(isMoving ? QFont::Bold : headingWeight());
        for (const StepMarks::Number &number : marks.numbers) {
            if (number.isMoving != isMoving)
                continue;
            const QString text = locale.toString(number.number);
            QRectF box = boxOf(besidePart(pen, marks, number), text, font);
            if (isMoving) { // the one that is looked for is whole at the view's edge, too
                constexpr double kEdge = 6.0;
                box.moveLeft(std::clamp(box.left(), kEdge,
                                        std::max(kEdge, pen.viewport().x() - box.width() - kEdge)));
                box.moveTop(std::clamp(box.top(), kEdge,
                                       std::max(kEdge, pen.viewport().y() - box.height() - kEdge)));
            }
            if (std::any_of(taken.begin(), taken.end(), [&](const QRectF &other) {
                    return other.adjusted(-2.0, -2.0, 2.0, 2.0).intersects(box);
                }))
                continue;
            taken.push_back(box);
            paintNumber(pen, box, text, font, isMoving);
        }
    }
    pen.painter().restore();
}

} // namespace fff::ui
