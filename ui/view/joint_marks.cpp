#include "ui/view/joint_marks.h"

#include <cmath>

namespace fff::ui {

namespace {

constexpr double kSize = 4.5, kHoveredSize = 6.5; // px, half of a mark's diagonal
constexpr double kArrow = 34.0, kArrowHead = 8.0; // px
constexpr double kAhead = 20.0;     // px, to see where a direction leads on the screen
constexpr double kTowardsEye = 0.2; // of its length that a direction must keep on the screen
constexpr double kNumberOff = 12.0; // px, of a number beside its mark

/// The rectangle of a slit, seen through everything.
void paintSlit(MarkPen &pen, const JointLook::Outline &slit)
{
    QPainterPath path;
    for (const Vec3 &corner : slit.corners) {
        if (path.elementCount() == 0)
            path.moveTo(pen.screen(corner));
        else
            path.lineTo(pen.screen(corner));
    }
    path.closeSubpath();
    pen.painter().fillPath(path, faded(pen.style().slit, 0.45));
    pen.cased(path, roundPen(pen.style().slit, 2.0));
}

/// Where the slits of the second section open to.
void paintArrow(MarkPen &pen, const Vec3 &at, const Vec3 &direction)
{
    const QPointF from = pen.screen(at);
    const double scale = pen.camera().scaleAt(at, pen.viewport());
    const QPointF way = (pen.screen(at + kAhead * scale * direction) - from) / kAhead;
    const double length = std::hypot(way.x(), way.y());
    if (length < kTowardsEye)
        return; // one looks along it
    const QPointF along = way / length, across(-along.y(), along.x());
    const QPointF tip = from + kArrow * along;
    QPainterPath arrow(from);
    arrow.lineTo(tip);
    arrow.moveTo(tip - kArrowHead * along + 0.7 * kArrowHead * across);
    arrow.lineTo(tip);
    arrow.lineTo(tip - kArrowHead * along - 0.7 * kArrowHead * across);
    pen.cased(arrow, roundPen(pen.style().slit, 2.4));
}

/// A diamond; of two sections that collide a cross.
void paintMark(MarkPen &pen, const QPointF &at, bool isProblem, bool grows)
{
    QPainter &painter = pen.painter();
    const double size = grows ? kHoveredSize : kSize;
    QPainterPath shape;
    if (isProblem) {
        shape.moveTo(at + QPointF(-size, -size));
        shape.lineTo(at + QPointF(size, size));
        shape.moveTo(at + QPointF(size, -size));
        shape.lineTo(at + QPointF(-size, size));
        pen.cased(shape, roundPen(pen.style().problem, grows ? 3.4 : 2.6));
        return;
    }
    shape.addPolygon(QPolygonF({at + QPointF(0.0, -size), at + QPointF(size, 0.0),
                                at + QPointF(0.0, size), at + QPointF(-size, 0.0)}));
    shape.closeSubpath();
    painter.strokePath(shape, roundPen(pen.style().panel, 3.6));
    painter.fillPath(shape, grows ? pen.style().panel : pen.style().slit);
    painter.strokePath(shape, roundPen(pen.style().slit, grows ? 2.2 : 1.4));
}

} // namespace

void paintJoints(MarkPen &pen, const Overlay::Joints &joints, const QLocale &locale)
{
    pen.painter().save();
    pen.painter().setBrush(Qt::NoBrush);
    for (const JointLook &look : joints.lit) {
        for (const JointLook::Outline &slit : look.slits)
            paintSlit(pen, slit);
        if (!look.opens.isZero())
            for (const Vec3 &at : look.meetingPoints)
                paintArrow(pen, at, look.opens);
    }
    for (std::size_t i = 0; i < joints.marks.size(); ++i)
        paintMark(pen, pen.screen(joints.marks[i].at), joints.marks[i].isProblem,
                  static_cast<int>(i) == joints.hovered);
    // The fields of a joint with several places go by these numbers.
    for (const JointLook &look : joints.lit)
        for (std::size_t i = 0; look.meetingPoints.size() > 1 && i < look.meetingPoints.size(); ++i)
            pen.chip(pen.screen(look.meetingPoints[i]) + QPointF(kNumberOff, 0.0),
                     MarkPen::Anchor::Left, locale.toString(static_cast<int>(i) + 1),
                     pen.style().slit);
    pen.painter().restore();
}

} // namespace fff::ui
