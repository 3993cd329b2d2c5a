#include "ui/view/joint_marks.h"

#include "ui/view/sign_painter.h"

namespace fff::ui {

namespace {

constexpr double kSize = 4.5, kHoveredSize = 6.5; // px, half of a mark's diagonal
constexpr double kNumberOff = 12.0;               // px, of a number beside its mark

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

void paintJoints(MarkPen &pen, const sign::Joints &joints, const QLocale &locale)
{
    pen.painter().save();
    pen.painter().setBrush(Qt::NoBrush);
    for (const JointLook &look : joints.lit) {
        for (const JointLook::Outline &slit : look.slits)
            paintSign(pen, sign::Region{SignRole::Slit, slit.corners});
        if (!look.opens.isZero())
            for (const Vec3 &at : look.meetingPoints)
                paintSign(pen, sign::Arrow{SignRole::Slit, at, look.opens});
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
