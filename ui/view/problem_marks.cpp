#include "ui/view/problem_marks.h"

#include <QCoreApplication>

#include <cmath>
#include <numbers>

namespace fff::ui {

namespace {

struct ProblemMarksTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::ProblemMarks)
};

constexpr double kLink = 2.0, kSymbol = 2.6;          // px, widths of lines
constexpr double kArrow = 15.0, kHead = 5.0;          // px, from the middle to a tip, and its head
constexpr double kBar = 7.0, kBeyond = 4.0;           // px, half of a bar, and how far off the tip
constexpr double kAhead = 20.0, kTowardsEye = 0.25;   // as for the arrows of joints
constexpr double kCentre = 8.0;                       // px, radius of a centre of mass
constexpr double kChipBelow = 16.0, kShortest = 24.0; // px

bool isBeforeEye(const MarkPen &pen, const Vec3 &world)
{
    const Camera &camera = pen.camera();
    return !camera.isPerspective() ||
           camera.forward().dot(world - camera.eye(pen.viewport())) > 0.0;
}

bool isInView(const MarkPen &pen, const QPointF &at)
{
    return QRectF(0.0, 0.0, pen.viewport().x(), pen.viewport().y()).contains(at);
}

QPen dashed(const QColor &colour, double width, double on, double off)
{
    QPen pen(colour, width, Qt::CustomDashLine, Qt::FlatCap, Qt::RoundJoin);
    pen.setDashPattern({on / width, off / width});
    return pen;
}

QPainterPath line(const QPointF &from, const QPointF &to)
{
    QPainterPath path(from);
    path.lineTo(to);
    return path;
}

/// Arrows both ways, each stopped by a bar; seen along the way, or where there is none, a cross.
void paintBlock(MarkPen &pen, const ProblemLink &link)
{
    const QPointF at = pen.screen(link.at);
    const double scale = pen.camera().scaleAt(link.at, pen.viewport());
    const QPointF way = (pen.screen(link.at + kAhead * scale * link.way) - at) / kAhead;
    const double length = std::hypot(way.x(), way.y());
    QPainterPath symbol;
    if (length < kTowardsEye) {
        for (const double side : {1.0, -1.0}) {
            symbol.moveTo(at + kBar * QPointF(-1.0, side));
            symbol.lineTo(at + kBar * QPointF(1.0, -side));
        }
    } else {
        const QPointF along = way / length, across(-along.y(), along.x());
        for (const double side : {1.0, -1.0}) {
            const QPointF tip = at + side * kArrow * along;
            symbol.moveTo(at);
            symbol.lineTo(tip);
            symbol.moveTo(tip - side * kHead * along + kHead * across);
            symbol.lineTo(tip);
            symbol.lineTo(tip - side * kHead * along - kHead * across);
            const QPointF bar = tip + side * kBeyond * along;
            symbol.moveTo(bar + kBar * across);
            symbol.lineTo(bar - kBar * across);
        }
    }
    pen.cased(symbol, roundPen(pen.style().problem, kSymbol));
}

/// A disc in quarters, as drawings have it: in the plane of two directions, each a radius long.
void paintCentre(MarkPen &pen, const QPointF &at, const QPointF &right, const QPointF &up,
                 const QColor &colour)
{
    constexpr int kChords = 12; // of a quarter
    QPainterPath disc, quarters;
    for (int quarter = 0; quarter < 4; ++quarter) {
        QPolygonF piece{at};
        for (int i = 0; i <= kChords; ++i) {
            const double angle = 0.5 * std::numbers::pi * (quarter + double(i) / kChords);
            piece += at + std::cos(angle) * right + std::sin(angle) * up;
        }
        QPainterPath path;
        path.addPolygon(piece);
        path.closeSubpath();
        disc.addPath(path);
        if (quarter % 2 == 0)
            quarters.addPath(path);
    }
    QPainter &painter = pen.painter();
    painter.strokePath(disc, roundPen(pen.style().panel, 4.0));
    painter.fillPath(disc, pen.style().panel);
    painter.fillPath(quarters, colour);
    painter.strokePath(disc, roundPen(colour, 1.2));
}

void paintGround(MarkPen &pen, const GroundMark &mark, LengthUnit unit, const QLocale &locale)
{
    const Vec3 below(mark.centreOfMass.x(), 0.0, mark.centreOfMass.z());
    const Vec3 edge(mark.edge.x(), 0.0, mark.edge.y());
    if (!isBeforeEye(pen, mark.centreOfMass) || !isBeforeEye(pen, below))
        return;
    const QColor &problem = mark.isWarning ? pen.style().warning : pen.style().problem;
    const QColor &colour = mark.isProblem ? problem : pen.style().guide;
    QPainterPath support;
    for (const Vec2 &corner : mark.support) {
        const Vec3 world(corner.x(), 0.0, corner.y());
        if (!isBeforeEye(pen, world))
            return;
        if (support.elementCount() == 0)
            support.moveTo(pen.screen(world));
        else
            support.lineTo(pen.screen(world));
    }
    support.closeSubpath();
    pen.painter().fillPath(support, faded(colour, 0.10));
    pen.cased(support, roundPen(colour, 1.6));

    const QPointF centre = pen.screen(mark.centreOfMass), foot = pen.screen(below),
                  to = pen.screen(edge);
    pen.cased(line(centre, foot), dashed(colour, 1.6, 3.0, 3.0));
    pen.cased(line(foot, to), dashed(colour, 1.6, 6.0, 3.0));
    const double radius = kCentre * pen.camera().scaleAt(below, pen.viewport());
    paintCentre(pen, foot, pen.screen(below + radius * Vec3::UnitX()) - foot,
                pen.screen(below - radius * Vec3::UnitZ()) - foot, colour);
    paintCentre(pen, centre, {kCentre, 0.0}, {0.0, -kCentre}, colour);

    const QString far = lengthText(std::abs(mark.margin), unit, 0, 1, locale);
    //: %1 is a length: how far the centre of mass lies from the edge of the feet
    const QString text = mark.margin < 0.0 ? ProblemMarksTexts::tr("%1 outside").arg(far)
                                           //: %1 is a length: how far it lies from their edge
                                           : ProblemMarksTexts::tr("%1 inside").arg(far);
    const QPointF middle = 0.5 * (foot + to);
    const bool isShort = std::hypot(to.x() - foot.x(), to.y() - foot.y()) < kShortest;
    if (!isInView(pen, isShort ? foot : middle))
        return; // it would be about something else at the view's edge
    pen.chip((isShort ? foot : middle) + QPointF(0.0, kCentre + kChipBelow),
             MarkPen::Anchor::Middle, text, colour);
}

/// A line down to a bar on the ground, as wide as the foot is a mark.
void paintHigh(MarkPen &pen, const HighMark &mark, LengthUnit unit, const QLocale &locale)
{
    const Vec3 below(mark.at.x(), 0.0, mark.at.z());
    if (!isBeforeEye(pen, mark.at) || !isBeforeEye(pen, below))
        return;
    const QColor &colour = pen.style().problem;
    const QPointF from = pen.screen(mark.at), to = pen.screen(below);
    QPainterPath path = line(from, to);
    path.addPath(line(to - QPointF(kBar, 0.0), to + QPointF(kBar, 0.0)));
    pen.cased(path, roundPen(colour, kSymbol));
    const QString high = lengthText(mark.height, unit, 0, 1, locale);
    if (!isInView(pen, to))
        return;
    pen.chip(to + QPointF(0.0, kChipBelow), MarkPen::Anchor::Middle,
             //: %1 is a length: how far a foot ends above the ground
             ProblemMarksTexts::tr("%1 too high").arg(high), colour);
}

} // namespace

void paintProblems(MarkPen &pen, const ProblemLook &look, LengthUnit unit, const QLocale &locale)
{
    QPainter &painter = pen.painter();
    painter.save();
    painter.setBrush(Qt::NoBrush);
    for (const GroundMark &mark : look.grounds)
        paintGround(pen, mark, unit, locale);
    for (const HighMark &mark : look.feet)
        paintHigh(pen, mark, unit, locale);
    std::vector<const ProblemLink *> links;
    for (const ProblemLink &link : look.links)
        if (isBeforeEye(pen, link.fromA) && isBeforeEye(pen, link.at) &&
            isBeforeEye(pen, link.fromB))
            links.push_back(&link);
    for (const ProblemLink *link : links) {
        QPainterPath path = line(pen.screen(link->fromA), pen.screen(link->at));
        path.lineTo(pen.screen(link->fromB));
        pen.cased(path, dashed(pen.style().problem, kLink, 6.0, 4.0));
    }
    for (const ProblemLink *link : links)
        for (const Vec3 &end : {link->fromA, link->fromB})
            pen.ring(pen.screen(end), 4.0, pen.style().problem);
    painter.setBrush(Qt::NoBrush);
    for (const ProblemLink *link : links)
        paintBlock(pen, *link);
    painter.restore();
}

} // namespace fff::ui
