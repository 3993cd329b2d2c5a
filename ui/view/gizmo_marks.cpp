#include "ui/view/gizmo_marks.h"

#include "core/base/units.h"

#include <QCoreApplication>

#include <cmath>

namespace fff::ui {

namespace {

struct GizmoMarksTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::GizmoMarks)
};

constexpr double kWidth = 2.0, kLitWidth = 3.4; // px
constexpr double kRingAlpha = 0.7;              // of rings that nobody holds
constexpr double kHead = 11.0, kHeadHalf = 5.5; // px, of an arrow
constexpr double kBox = 9.0, kLitBox = 12.0;    // px, a side
constexpr double kLetterOff = 14.0;             // px beyond an arrow's tip
constexpr double kSideways = 0.4;               // cosine: an arrow to the side has its name there
constexpr double kRoomBeside = 2.0;             // px that words keep off
constexpr double kChipOff = 18.0;               // px from the middle, left and up
constexpr double kGuideWidth = 1.4, kGuideMark = 4.0; // px
constexpr double kShortest = 2.0 * kHead;             // px, of an arrow that has a shaft

class GizmoDrawing
{
public:
    GizmoDrawing(MarkPen &pen, const GizmoMarks &marks)
        : m_pen(pen), m_painter(pen.painter()), m_marks(marks),
          m_look(marks.gizmo, pen.camera(), pen.viewport())
    {
    }

    void guides();
    void ring(GizmoPart part);
    void arrow(GizmoPart part);
    void name(int axis, const Vec2 &along);
    void box(GizmoPart part);
    void disc();
    void value(LengthUnit unit, const QLocale &locale);

private:
    bool isLit(GizmoPart part) const { return m_marks.lit == part; }
    QPen penOf(GizmoPart part, double alpha = 1.0) const
    {
        const bool lit = isLit(part);
        return roundPen(faded(m_pen.style().accent, lit ? 1.0 : alpha), lit ? kLitWidth : kWidth);
    }
    static QPointF point(const Vec2 &p) { return {p.x(), p.y()}; }

    MarkPen &m_pen;
    QPainter &m_painter;
    const GizmoMarks &m_marks;
    const GizmoLook m_look;
};

/// What is level with what.
void GizmoDrawing::guides()
{
    const QColor &colour = m_pen.style().guide;
    QPen dashed(colour, kGuideWidth);
    dashed.setDashPattern({4.0, 3.0});
    for (const auto &[own, other] : m_marks.guides) {
        m_painter.setPen(dashed);
        m_painter.drawLine(m_pen.screen(own), m_pen.screen(other));
        m_pen.ring(m_pen.screen(other), kGuideMark, colour);
        m_pen.ring(m_pen.screen(own), kGuideMark, colour);
    }
}

void GizmoDrawing::ring(GizmoPart part)
{
    if (!m_look.isSeen(part))
        return;
    QPolygonF line;
    for (const Vec2 &p : m_look.ring(axisOf(part)))
        line.append(point(p));
    QPainterPath path;
    path.addPolygon(line);
    path.closeSubpath();
    m_pen.cased(path, penOf(part, kRingAlpha));
    constexpr int kPerPiece = 4; // sides of a piece that words keep off
    for (qsizetype i = 0; i < line.size(); i += kPerPiece)
        m_pen.keepFree(line[i], line[(i + kPerPiece) % line.size()], kRoomBeside);
}

void GizmoDrawing::arrow(GizmoPart part)
{
    if (!m_look.isSeen(part))
        return;
    const int axis = axisOf(part);
    const Vec2 from = m_look.centre(), tip = m_look.tip(axis), way = tip - from;
    const double length = way.norm();
    const Vec2 along = way / length, across(-along.y(), along.x());
    if (length > kShortest) {
        QPainterPath shaft(point(from + kGizmoDisc * along));
        shaft.lineTo(point(tip - kHead * along));
        m_pen.cased(shaft, penOf(part));
    }
    QPainterPath head(point(tip));
    head.lineTo(point(tip - kHead * along + kHeadHalf * across));
    head.lineTo(point(tip - kHead * along - kHeadHalf * across));
    head.closeSubpath();
    m_painter.strokePath(head, roundPen(m_pen.style().panel, 2.4));
    m_painter.fillPath(head, m_pen.style().accent);
    if (isLit(part))
        m_painter.strokePath(head, roundPen(m_pen.style().accent, 2.0));
    m_pen.keepFree(point(from), point(tip), kHeadHalf + kRoomBeside);
    name(axis, along);
}

/// What the way is called, beyond the arrow's tip.
void GizmoDrawing::name(int axis, const Vec2 &along)
{
    if (m_marks.value)
        return; // while it is dragged that alone is read
    // As the fields over the view have them.
    const QString inSpace[] = {GizmoMarksTexts::tr("X"), GizmoMarksTexts::tr("Y"),
                               GizmoMarksTexts::tr("Z")};
    const QString inPlane[] = {
        //: the way to the right, along an arrow
        GizmoMarksTexts::tr("Right"),
        //: the way up, along an arrow
        GizmoMarksTexts::tr("Up"),
        //: the way out of the plane, towards whoever looks, along an arrow
        GizmoMarksTexts::tr("Out"),
    };
    // Beyond the box at the arrow's end, where there is one.
    const GizmoPart boxes[] = {GizmoPart::ScaleX, GizmoPart::ScaleY, GizmoPart::None};
    const GizmoPart box = boxes[axis];
    const Vec2 end = m_marks.gizmo.has(box) ? m_look.box(box) : m_look.tip(axis);
    const MarkPen::Anchor anchor = along.x() > kSideways    ? MarkPen::Anchor::Left
                                   : along.x() < -kSideways ? MarkPen::Anchor::Right
                                                            : MarkPen::Anchor::Middle;
    m_pen.chip({.place = point(end + kLetterOff * along),
                .anchor = anchor,
                .text = m_marks.gizmo.isInSpace ? inSpace[axis] : inPlane[axis],
                .colour = m_pen.style().accent,
                .rank = MarkPen::Rank::InHand,
                .isFramed = false});
}

void GizmoDrawing::box(GizmoPart part)
{
    if (!m_look.isSeen(part))
        return;
    const double side = isLit(part) ? kLitBox : kBox;
    QRectF square(0, 0, side, side);
    square.moveCenter(point(m_look.box(part)));
    m_painter.setBrush(isLit(part) ? m_pen.style().accent : m_pen.style().panel);
    m_painter.setPen(QPen(m_pen.style().accent, kWidth));
    m_painter.drawRect(square);
    m_pen.keepFree(square);
}

void GizmoDrawing::disc()
{
    const bool lit = isLit(GizmoPart::MoveFree);
    m_pen.ring(point(m_look.centre()), kGizmoDisc, m_pen.style().accent);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(m_pen.style().accent);
    const double radius = lit ? kGizmoDisc : 0.4 * kGizmoDisc;
    m_painter.drawEllipse(point(m_look.centre()), radius, radius);
    m_pen.keepFree(QRectF(point(m_look.centre()), QSizeF())
                       .adjusted(-kGizmoDisc, -kGizmoDisc, kGizmoDisc, kGizmoDisc));
}

void GizmoDrawing::value(LengthUnit unit, const QLocale &locale)
{
    if (!m_marks.value)
        return;
    const double number = m_marks.value->number;
    QString text;
    if (isTurn(m_marks.lit))
        text = GizmoMarksTexts::tr("%1°").arg(numberText(degrees(number), 0, 1, locale));
    else if (isScale(m_marks.lit))
        text = GizmoMarksTexts::tr("%1\u202f%").arg(numberText(100.0 * number, 0, 1, locale));
    else
        text = lengthText(number, unit, 1, 1, locale);
    if (m_marks.copies > 0)
        text = GizmoMarksTexts::tr("Copy: %1").arg(text);
    m_pen.chip(point(m_look.centre()) - QPointF(kChipOff, kChipOff), MarkPen::Anchor::Right, text,
               m_pen.style().accent, MarkPen::Rank::InHand);
}

} // namespace

void paintGizmo(MarkPen &pen, const GizmoMarks &marks, LengthUnit unit, const QLocale &locale)
{
    pen.painter().save();
    GizmoDrawing drawing(pen, marks);
    drawing.guides();
    for (const GizmoPart part : {GizmoPart::TurnX, GizmoPart::TurnY, GizmoPart::TurnZ})
        drawing.ring(part);
    for (const GizmoPart part : {GizmoPart::MoveX, GizmoPart::MoveY, GizmoPart::MoveZ})
        drawing.arrow(part);
    for (const GizmoPart part : {GizmoPart::ScaleX, GizmoPart::ScaleY, GizmoPart::ScaleAll})
        if (marks.gizmo.has(part))
            drawing.box(part);
    drawing.disc();
    drawing.value(unit, locale);
    pen.painter().restore();
}

} // namespace fff::ui
